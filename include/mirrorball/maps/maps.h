// The maps by name, compiled once for float and double: what a host calls. Each map's formula stands in its
// own header beside this one; this is the one list that every loop over maps uses.
//
// A map cuts the sphere of directions into congruent components (texture-array layers) and lays each onto the
// unit square (u, v). Row 0 of a texture is the v = 0 side. Directions need no unit length.
#pragma once

#include <mirrorball/export.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string_view>

namespace mirrorball {

enum class MapKind {
    tennisBall,
    tennisBallEven,
    dualParaboloid,
    cube,
    equiAngularCube,
    octahedral,
    equirectangular,
    sphereMap
};

struct MapInfo
{
    MapKind kind;
    std::string_view name; // as programs spell it: "tennis-ball"
    int components;        // layers
    int widthInN;          // a layer is widthInN * n by heightInN * n texels
    int heightInN;
};

// Where a direction lies: uv in [0, 1]², closed.
template <class Number>
struct MapCoordinate
{
    int component;
    glm::vec<2, Number, glm::defaultp> uv;
};

// All maps, in the order of MapKind.
MIRRORBALL_EXPORT std::span<const MapInfo> maps();
// Throws Error badArgument for a number that MapKind has no name for.
MIRRORBALL_EXPORT const MapInfo& mapInfo(MapKind map);
MIRRORBALL_EXPORT std::optional<MapKind> mapFromName(std::string_view name);

// The component that owns a direction. Every direction has one, and a coordinate in it: maps/direction.h says
// which for zero, infinite and NaN. `component` below must be one of the map's.
MIRRORBALL_EXPORT int componentOf(MapKind map, const glm::vec3& direction);
MIRRORBALL_EXPORT int componentOf(MapKind map, const glm::dvec3& direction);

// The chart of one component, continued beyond its border (not clamped), as pass 1 needs it for vertices.
MIRRORBALL_EXPORT glm::vec2 squareFromDirection(MapKind map, int component, const glm::vec3& direction);
MIRRORBALL_EXPORT glm::dvec2 squareFromDirection(MapKind map, int component, const glm::dvec3& direction);

// The unit direction at (u, v) of a component, continued by a quarter of the square beyond each side: a
// coordinate further out is taken there, NaN in the middle.
MIRRORBALL_EXPORT glm::vec3 directionFromSquare(MapKind map, int component, const glm::vec2& uv);
MIRRORBALL_EXPORT glm::dvec3 directionFromSquare(MapKind map, int component, const glm::dvec2& uv);

// componentOf and squareFromDirection together, clamped to the closed unit square.
MIRRORBALL_EXPORT MapCoordinate<float> coordinateFromDirection(MapKind map, const glm::vec3& direction);
MIRRORBALL_EXPORT MapCoordinate<double> coordinateFromDirection(MapKind map, const glm::dvec3& direction);

} // namespace mirrorball
