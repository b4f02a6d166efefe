// Whether this driver draws into several layers at once without a mistake.
#pragma once

namespace mirrorball::capture {

// Draws a few texels and reads one back. Mesa's softpipe (22.3 is one that does) sends the rest of a row of
// blocks of texels to the first layer when discard or the depth test has removed the row's first block.
// Call inside a StateGuard that is neutralised.
bool drawsIntoLayers();

} // namespace mirrorball::capture
