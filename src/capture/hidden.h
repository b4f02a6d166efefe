// Which meshes the second layer of depth needs: those that something nearer may hide.
#pragma once

#include "capture/frame.h"

#include <span>
#include <vector>

namespace mirrorball::capture {

// For each mesh, false where all of it is certain to lie within (1 + separation) of the first surface in its direction,
// by the distances and directions that the bounds leave to the other meshes and to itself.
std::vector<bool> mayBeHidden(std::span<const CaptureMesh> meshes, const Frame& frame, double separation);

} // namespace mirrorball::capture
