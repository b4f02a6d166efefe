// Names and numbers that others rely on: the worked example of the cube map, ties, zero, subnormal, infinite
// and NaN directions, coordinates outside the square, and texel centres.
#include "support/check.h"

#include <mirrorball/maps/maps.h>

#include <glm/geometric.hpp>

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace {

using mirrorball::MapKind;

constexpr float infinity = std::numeric_limits<float>::infinity();

template <class Number>
using Direction = glm::vec<3, Number, glm::defaultp>;

void checkNames()
{
    CHECK(mirrorball::maps().size() == 8);
    for (const mirrorball::MapInfo& map : mirrorball::maps()) {
        CHECK(mirrorball::mapFromName(map.name) == map.kind);
        CHECK(&mirrorball::mapInfo(map.kind) == &map);
    }
    CHECK(!mirrorball::mapFromName("Cube"));
    CHECK(!mirrorball::mapFromName(""));
}

// OpenGL's table; the textbook version that takes s from y and t from z has (0.875, 0.375).
template <class Number>
void checkWorkedCubeExample()
{
    const auto coordinate = mirrorball::coordinateFromDirection(MapKind::cube, Direction<Number>(-4, 3, -1));
    CHECK(coordinate.component == 1);
    CHECK(coordinate.uv.x == Number(0.375) && coordinate.uv.y == Number(0.125));
}

// Of equally large coordinates x goes before y before z, whatever their signs.
void checkTies()
{
    for (const MapKind map : {MapKind::cube, MapKind::equiAngularCube})
        for (const float x : {-1.0f, 1.0f})
            for (const float y : {-1.0f, 1.0f})
                for (const float z : {-1.0f, 1.0f}) {
                    CHECK(mirrorball::componentOf(map, glm::vec3(x, y, z)) == (x > 0 ? 0 : 1));
                    CHECK(mirrorball::componentOf(map, glm::vec3(x, y, 0)) == (x > 0 ? 0 : 1));
                    CHECK(mirrorball::componentOf(map, glm::vec3(0, y, z)) == (y > 0 ? 2 : 3));
                }
    for (const float zero : {0.0f, -0.0f}) {
        CHECK(mirrorball::componentOf(MapKind::dualParaboloid, glm::vec3(1, 0, zero)) == 1);
        CHECK(mirrorball::componentOf(MapKind::tennisBall, glm::vec3(1, 0, zero)) == 0);
        CHECK(mirrorball::componentOf(MapKind::tennisBall, glm::vec3(0, 1, zero)) == 1);
    }
}

bool sameCoordinate(MapKind map, const glm::vec3& a, const glm::vec3& b)
{
    const auto first = mirrorball::coordinateFromDirection(map, a);
    const auto second = mirrorball::coordinateFromDirection(map, b);
    return first.component == second.component && first.uv == second.uv;
}

// The middle of component 0.
template <class Number>
void checkFront(MapKind map, const Direction<Number>& direction)
{
    const auto coordinate = mirrorball::coordinateFromDirection(map, direction);
    CHECK(coordinate.component == 0);
    CHECK(coordinate.uv.x == Number(0.5) && coordinate.uv.y == Number(0.5));
}

void checkNanAndZero(MapKind map)
{
    checkFront(map, glm::vec3(0.0f, -0.0f, 0.0f));
    checkFront(map, glm::vec3(1e-40f, -1e-45f, 1.1e-38f));
    checkFront(map, glm::dvec3(0.0));
    checkFront(map, glm::dvec3(0x1p-1023, 0, -0x1p-1060));
    // Quiet, signalling, negative and with a payload.
    for (const std::uint32_t bits : {0x7fc00000u, 0x7f800001u, 0xffc00000u, 0x7fffffffu}) {
        const float nan = std::bit_cast<float>(bits);
        checkFront(map, glm::vec3(nan, 1, 2));
        checkFront(map, glm::vec3(1, nan, infinity));
        checkFront(map, glm::vec3(0, 0, nan));
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    checkFront(map, glm::dvec3(1, nan, 2));
}

void checkInfiniteAndTiny(MapKind map)
{
    const float largest = std::numeric_limits<float>::max();
    const float smallest = std::numeric_limits<float>::min();
    for (const float sign : {-1.0f, 1.0f}) {
        CHECK(sameCoordinate(map, {sign * infinity, 1e38f, -2}, {sign, 0, 0}));
        CHECK(sameCoordinate(map, {infinity, sign * infinity, 5}, {1, sign, 0}));
        CHECK(sameCoordinate(map, {-infinity, infinity, sign * infinity}, {-1, 1, sign}));
        CHECK(sameCoordinate(map, {largest, sign * largest, -largest}, {1, sign, -1}));
        CHECK(sameCoordinate(map, {smallest, sign * smallest, -smallest}, {1, sign, -1}));
        // A subnormal coordinate counts as zero, before and after the division by the largest.
        CHECK(sameCoordinate(map, {1e-39f, sign, 0.5f}, {0, sign, 0.5f}));
        CHECK(sameCoordinate(map, {1e-10f, 1e30f, sign * 5e29f}, {0, 1, sign * 0.5f}));
    }
    CHECK(sameCoordinate(map, {0.0f, -0.0f, 1}, {-0.0f, 0.0f, 1}));
}

// Beyond a quarter of the square the chart stays; NaN is the middle; whatever comes, the direction has
// length 1.
void checkCoordinatesOutside(MapKind map)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int component = 0; component < mirrorball::mapInfo(map).components; ++component) {
        const auto direction = [&](float u, float v) {
            return mirrorball::directionFromSquare(map, component, glm::vec2(u, v));
        };
        CHECK(direction(2.5f, -1e38f) == direction(1.25f, -0.25f));
        CHECK(direction(-infinity, infinity) == direction(-0.25f, 1.25f));
        CHECK(direction(nan, 0.25f) == direction(0.5f, 0.25f));
        for (const float u : {-0.25f, -0.0f, 0.0f, 0.5f, 1.0f, 1.0000001f, 1.25f})
            for (const float v : {-0.25f, -1e-7f, 0.0f, 0.5f, 1.0f, 1.25f})
                CHECK_NEAR(glm::length(direction(u, v)), 1, 1e-6);
    }
}

// Each texel's centre comes back to that texel: of its component by the chart, and where the direction
// belongs to the component, also by coordinateFromDirection.
void checkTexelCentres(MapKind map, int n)
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(map);
    const glm::ivec2 size(n * info.widthInN, n * info.heightInN);
    for (int component = 0; component < info.components; ++component)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::vec2 centre = (glm::vec2(x, y) + 0.5f) / glm::vec2(size);
                if (map == MapKind::sphereMap && glm::length(2.0f * centre - 1.0f) >= 1)
                    continue; // outside the disc there is no direction
                const glm::vec3 d = mirrorball::directionFromSquare(map, component, centre);
                const glm::vec2 uv = mirrorball::squareFromDirection(map, component, d);
                CHECK(int(uv.x * float(size.x)) == x && int(uv.y * float(size.y)) == y);
                const auto owner = mirrorball::coordinateFromDirection(map, d);
                CHECK(owner.component != component || owner.uv == uv);
            }
}

} // namespace

int main()
{
    checkNames();
    checkWorkedCubeExample<float>();
    checkWorkedCubeExample<double>();
    checkTies();
    for (const mirrorball::MapInfo& map : mirrorball::maps()) {
        checkNanAndZero(map.kind);
        checkInfiniteAndTiny(map.kind);
        checkCoordinatesOutside(map.kind);
        for (const int n : {1, 2, 3, 5, 7, 64, 255, 256})
            checkTexelCentres(map.kind, n);
    }
}
