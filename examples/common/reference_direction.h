// The directions of a map's texels, written a second time: plain double formulas for the inverse of each map,
// sharing nothing with the library, so that the reference tracer can judge it.
#pragma once

#include <glm/vec3.hpp>

#include <string_view>

namespace examples {

// The unit direction at (u, v) of a component of the map ("tennis-ball", …). Outside the disc of the sphere
// map it is the direction of the disc's rim, (0, 0, −1). Throws mirrorball::Error: unknownName.
glm::dvec3 referenceDirection(std::string_view mapName, int component, double u, double v);

} // namespace examples
