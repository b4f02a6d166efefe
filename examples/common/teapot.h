// The Utah teapot: Martin Newell's 32 bicubic Bézier patches (The Utilization of Procedure Models in Digital
// Image Synthesis, PhD thesis, 1975; in the usual height of 3.15 with the bottom that was added later).
#pragma once

#include "scene.h"

namespace examples {

// Each patch as subdivisions² squares with analytic normals that point outward; y up, the bottom at y = 0,
// the spout towards +x. Made of four surfaces: body with rim and bottom, lid, handle, spout; the lid does not
// touch the rim, handle and spout run into the body without a joint.
Mesh teapot(int subdivisions);

} // namespace examples
