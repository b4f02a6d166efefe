// What the C library does with memory that the driver frees.
#pragma once

namespace tests::benchmark {

// Keeps it in the process. A software rasteriser takes megabytes for each frame's triangles and frees them; glibc gives
// them back to the kernel, which hands them out again page by page, at up to a quarter of a frame's time. Nothing
// where the C library is another one.
void keepFreedMemory();

} // namespace tests::benchmark
