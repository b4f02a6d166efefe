// The Phong shaders of the example programs, extended by hand for cube maps: a distance beside the colour,
// and for one layered draw the choice of the layer.
#pragma once

#include "rivals.h"

namespace tests::benchmark {

// Uniforms: clipFromWorld, or where the draw is layered clipFromFace[6], faceList[6] and (geometry shader)
// faceListLength. Outputs: colour 0, and distance 1 unless the
// formats have none. Throws mirrorball::Error, badShader.
mirrorball::gl::Program rivalProgram(Rival rival, examples::View view, RivalFormats formats);

} // namespace tests::benchmark
