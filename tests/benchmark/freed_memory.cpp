#include "freed_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <limits>
#include <malloc.h>
#endif

namespace tests::benchmark {

void keepFreedMemory()
{
#ifdef __GLIBC__
    // The largest that glibc takes. What is larger is mapped and unmapped one by one: textures, not a frame's
    // triangles.
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    // Never trim the heap's end; grow it by steps that many frames' triangles fit into.
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    mallopt(M_TOP_PAD, 64 << 20);
#endif
}

} // namespace tests::benchmark
