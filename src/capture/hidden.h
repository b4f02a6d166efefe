// Which meshes the second layer of depth needs: those that something nearer may hide.
#pragma once

#include "capture/frame.h"

#include <span>
#include <vector>

namespace mirrorball::capture {

// For each mesh, false where all of it is certain to lie within (1 + separation) of what is nearest in its direction,
// or within a texel of it, by the distances and directions that the bounds leave to the other meshes and to itself.
std::vector<bool> mayBeHidden(std::span<const CaptureMesh> meshes, const Frame& frame, double separation);

} // namespace mirrorball::capture
