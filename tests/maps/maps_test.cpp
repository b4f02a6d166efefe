// Every map against 1280-bit arithmetic, forward and there and back, in float and double.
#include "maps/directions.h"
#include "maps/reference.h"
#include "support/check.h"

#include <mirrorball/maps/visit.h>

#include <algorithm>
#include <cstdio>

namespace {

using mirrorball::MapKind;
using tests::Direction;
using tests::Exact;

template <class Number>
struct Bounds;
// (u, v) by the issue: 1/16 texel at 2^18 texels, and two roundings of a double near 1. There and back: at
// most the map's longest extent, 2 pi radians for the panorama's u, times the error of u and v, which the
// measured maxima of 1.2e-7 and 2.1e-16 keep below these.
template <>
struct Bounds<float>
{
    static constexpr double square = 0x1p-22;
    static constexpr double direction = 1e-6;
};
template <>
struct Bounds<double>
{
    static constexpr double square = 4e-16;
    static constexpr double direction = 1e-15;
};

// The direction with what counts as zero set to zero.
template <class Number>
std::array<Exact, 3> exactDirection(const Direction<Number>& d)
{
    const Exact smallestNormal = double(std::numeric_limits<Number>::min());
    const Exact largest = double(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
    std::array<Exact, 3> exact;
    for (int i = 0; i < 3; ++i) {
        const Exact coordinate = double(d[i]);
        const bool isZero = abs(coordinate) < smallestNormal || abs(coordinate) < largest * smallestNormal;
        exact[static_cast<std::size_t>(i)] = isZero ? Exact(0) : coordinate;
    }
    return exact;
}

template <class Vector>
Exact dot(const std::array<Exact, 3>& a, const Vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The sine of the angle between them, in radians for small ones.
template <class Number>
double sineBetween(const std::array<Exact, 3>& a, const Direction<Number>& direction)
{
    const std::array<Exact, 3> b{double(direction.x), double(direction.y), double(direction.z)};
    const Exact x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    return sqrt((x * x + y * y + z * z) / dot(a, a) / dot(b, b)).rounded();
}

// The sphere map spreads one direction over its rim. With r = sin(theta / 2) the distance from the middle and
// c = cos(theta / 2) = sqrt(1 - r²), an error e of r changes c by at most min(sqrt(2 e), 2 e / c), and theta
// by 2 / r times that; near the middle, where r < 1/2, theta changes by 2 e / c only.
template <class Number>
double directionBound(MapKind map, const std::array<Exact, 3>& d)
{
    if (map != MapKind::sphereMap)
        return Bounds<Number>::direction;
    const Exact length = sqrt(dot(d, d));
    const double c = sqrt((Exact(1) + d[2] / length) / 2).rounded();
    const double e = std::numbers::sqrt2 * 2 * Bounds<Number>::square;
    return Bounds<Number>::direction + 4 * std::min(std::sqrt(2 * e), 2 * e / c);
}

template <class Number>
void checkDirection(MapKind map, const Direction<Number>& d)
{
    const std::array<Exact, 3> exact = exactDirection(d);
    const int component = mirrorball::componentOf(map, d);
    // Within four roundings of a border either side is right, if it maps back; elsewhere only one is.
    if (component != tests::exactComponent(map, exact))
        CHECK_NEAR(tests::distanceFromBorder(map, exact), 0,
                   4 * double(std::numeric_limits<Number>::epsilon()));

    const auto coordinate = mirrorball::coordinateFromDirection(map, d);
    CHECK(coordinate.component == component);
    const auto square = tests::exactSquare(map, component, exact);
    for (int i = 0; i < 2; ++i) {
        const auto expected = std::clamp(square[static_cast<std::size_t>(i)].rounded(), 0.0, 1.0);
        CHECK(coordinate.uv[i] >= 0 && coordinate.uv[i] <= 1);
        CHECK_NEAR(coordinate.uv[i], expected, Bounds<Number>::square);
        CHECK_NEAR(mirrorball::squareFromDirection(map, component, d)[i], expected, Bounds<Number>::square);
    }

    const Direction<Number> back = mirrorball::directionFromSquare(map, component, coordinate.uv);
    const std::array<Exact, 3> backExact{double(back.x), double(back.y), double(back.z)};
    CHECK(dot(exact, backExact) > 0);
    CHECK_NEAR(sineBetween(exact, back), 0, directionBound<Number>(map, exact));
    // Each coordinate is right to about that bound, and so is the length.
    CHECK_NEAR(sqrt(dot(backExact, backExact)).rounded(), 1, Bounds<Number>::direction);
}

template <class Number>
void checkAll(int count)
{
    const std::vector<Direction<Number>> directions = tests::hardDirections<Number>(count);
    for (const mirrorball::MapInfo& map : mirrorball::maps())
        for (const Direction<Number>& direction : directions)
            checkDirection<Number>(map.kind, direction);
}

// A texel's ray has its direction, and float finds it without rounding, but for the sphere map's z.
template <class Map>
void checkRays()
{
    using mirrorball::Vec2;
    for (const int n : {64, 157, 4096})
        for (int component = 0; component < Map::info.components; ++component)
            for (int texel = 0; texel < n * n; texel += n < 4096 ? 1 : 997) {
                const int column = texel % n, row = texel / n;
                const Vec2<double> p{column + 0.5 - 0.5 * n, row + 0.5 - 0.5 * n};
                const auto ray = Map::template rayFromCentre<double>(component, p, 0.5 * n);
                const auto direction = Map::template directionFromSquare<double>(
                    component, Vec2<double>{(column + 0.5) / n, (row + 0.5) / n});
                const double length = std::sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
                // Near the sphere map's rim directionFromSquare loses digits.
                const double bound = Map::info.kind == MapKind::sphereMap ? 1e-13 : Bounds<double>::direction;
                CHECK_NEAR(ray.x / length, direction.x, bound);
                CHECK_NEAR(ray.y / length, direction.y, bound);
                CHECK_NEAR(ray.z / length, direction.z, bound);
                const auto inFloat = Map::template rayFromCentre<float>(
                    component, Vec2<float>{static_cast<float>(p.x), static_cast<float>(p.y)},
                    0.5f * static_cast<float>(n));
                CHECK(double(inFloat.x) == ray.x && double(inFloat.y) == ray.y);
                CHECK_NEAR(inFloat.z, ray.z, Map::info.kind == MapKind::sphereMap ? 2e-7 * length : 0.0);
            }
}

} // namespace

int main()
{
    checkRays<mirrorball::Cube>();
    checkRays<mirrorball::Octahedral>();
    checkRays<mirrorball::DualParaboloid>();
    checkRays<mirrorball::SphereMap>();
    checkAll<float>(20000);
    checkAll<double>(20000);
}
