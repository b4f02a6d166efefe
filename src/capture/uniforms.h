// The uniforms of capture programs.
#pragma once

#include "capture/frame.h"
#include "capture/map_textures.h"

namespace mirrorball::capture {

// Of the program in use, for a view or all at once (view < 0). `size` is what is drawn into, in samples.
void setUniforms(const LinkedProgram& linked, const Frame& frame, MapKind map, int view, const MapSize& size,
                 bool clipControl);

} // namespace mirrorball::capture
