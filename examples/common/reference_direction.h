// The directions of a map's texels, written a second time: plain double formulas for the inverse of each map,
// sharing nothing with the library, so that the reference tracer can judge it.
#pragma once

#include <glm/vec3.hpp>

#include <string_view>

namespace examples {

// A direction through the centre of a texel of a layer, of the length at which it has the fewest digits: on a cube's
// face of n texels (a, b, n) in whole numbers, so that a surface's edge that runs through a texel's centre can be met
// to the last bit. Throws as referenceDirection does.
glm::dvec3 referenceRay(std::string_view mapName, int component, int column, int row, int width, int height);

// The unit direction at (u, v) of a component of the map ("tennis-ball", …). Outside the disc of the sphere
// map it is the direction of the disc's rim, (0, 0, −1). Throws mirrorball::Error: unknownName.
glm::dvec3 referenceDirection(std::string_view mapName, int component, double u, double v);

} // namespace examples
