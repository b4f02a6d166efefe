#include <mirrorball/maps/maps.h>

#include "enumeration.h"

#include <mirrorball/maps/visit.h>

#include <algorithm>
#include <array>

namespace mirrorball {
namespace {

template <class Number>
using GlmVec2 = glm::vec<2, Number, glm::defaultp>;
template <class Number>
using GlmVec3 = glm::vec<3, Number, glm::defaultp>;

constexpr std::array mapList{
    TennisBall::info,      TennisBallEven::info, DualParaboloid::info,  Cube::info,
    EquiAngularCube::info, Octahedral::info,     Equirectangular::info, SphereMap::info};

template <class Map, class Number>
Vec3<Number> regular(const GlmVec3<Number>& d)
{
    return regularDirection(Vec3<Number>{d.x, d.y, d.z}, Map::front);
}

template <class Number>
int componentOfRegular(MapKind map, const GlmVec3<Number>& direction)
{
    return visitMap(map, [&](auto formula) {
        using Map = decltype(formula);
        return Map::componentOf(regular<Map>(direction));
    });
}

template <class Number>
GlmVec2<Number> squareFromRegular(MapKind map, int component, const GlmVec3<Number>& direction)
{
    assert(component >= 0 && component < mapInfo(map).components);
    return visitMap(map, [&](auto formula) {
        using Map = decltype(formula);
        const auto uv = Map::squareFromDirection(component, regular<Map>(direction));
        return GlmVec2<Number>(uv.x, uv.y);
    });
}

template <class Number>
GlmVec3<Number> directionFromRegular(MapKind map, int component, const GlmVec2<Number>& uv)
{
    assert(component >= 0 && component < mapInfo(map).components);
    return visitMap(map, [&](auto formula) {
        const auto d = formula.directionFromSquare(component, regularSquare(Vec2<Number>{uv.x, uv.y}));
        return GlmVec3<Number>(d.x, d.y, d.z);
    });
}

template <class Number>
MapCoordinate<Number> clampedCoordinate(MapKind map, const GlmVec3<Number>& direction)
{
    const int component = componentOfRegular(map, direction);
    const GlmVec2<Number> uv = squareFromRegular(map, component, direction);
    return {component, {std::clamp(uv.x, Number(0), Number(1)), std::clamp(uv.y, Number(0), Number(1))}};
}

} // namespace

std::span<const MapInfo> maps()
{
    return mapList;
}

const MapInfo& mapInfo(MapKind map)
{
    requireOneOf(map, mapList.back().kind, "a map", "MapKind");
    return mapList[static_cast<std::size_t>(map)];
}

std::optional<MapKind> mapFromName(std::string_view name)
{
    const auto found = std::ranges::find(mapList, name, &MapInfo::name);
    return found == mapList.end() ? std::nullopt : std::optional(found->kind);
}

int componentOf(MapKind map, const glm::vec3& direction)
{
    return componentOfRegular(map, direction);
}
int componentOf(MapKind map, const glm::dvec3& direction)
{
    return componentOfRegular(map, direction);
}

glm::vec2 squareFromDirection(MapKind map, int component, const glm::vec3& direction)
{
    return squareFromRegular(map, component, direction);
}
glm::dvec2 squareFromDirection(MapKind map, int component, const glm::dvec3& direction)
{
    return squareFromRegular(map, component, direction);
}

glm::vec3 directionFromSquare(MapKind map, int component, const glm::vec2& uv)
{
    return directionFromRegular(map, component, uv);
}
glm::dvec3 directionFromSquare(MapKind map, int component, const glm::dvec2& uv)
{
    return directionFromRegular(map, component, uv);
}

MapCoordinate<float> coordinateFromDirection(MapKind map, const glm::vec3& direction)
{
    return clampedCoordinate(map, direction);
}
MapCoordinate<double> coordinateFromDirection(MapKind map, const glm::dvec3& direction)
{
    return clampedCoordinate(map, direction);
}

} // namespace mirrorball
