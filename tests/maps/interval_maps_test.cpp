// A map run on intervals contains what it gives in float and in double for every direction inside, and is not
// so wide as to be useless.
#include "maps/directions.h"
#include "support/check.h"

#include <mirrorball/maps/visit.h>
#include <mirrorball/math/interval.h>

#include <cstdio>

namespace {

using mirrorball::IndexSet;
using mirrorball::Interval;
using mirrorball::MapKind;
using mirrorball::Vec2;
using mirrorball::Vec3;
using tests::Direction;

constexpr int directionsPerMap = 130000; // a million trials in all

Interval around(float x, double radius)
{
    return {double(x) - radius, double(x) + radius};
}

void checkContains(const Interval& interval, double number)
{
    if (!interval.contains(number))
        std::fprintf(stderr, "[%a, %a] lacks %a\n", interval.lower, interval.upper, number);
    CHECK(interval.contains(number));
}

// A direction with coordinates below 2^-60 of its largest reaches numbers so small that float and double
// disagree on what is zero; those are left out here and held by special_values_test.
bool isSpread(const Direction<float>& d)
{
    const float largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    for (int i = 0; i < 3; ++i)
        if (d[i] != 0 && std::abs(d[i]) < largest * 0x1p-60f)
            return true;
    return largest > 0x1p60f || largest < 0x1p-60f;
}

// All components in reach of the box around d, and in each of them (u, v).
template <class Map>
void checkForward(const Direction<float>& d, double radius)
{
    const Vec3<Interval> box{around(d.x, radius), around(d.y, radius), around(d.z, radius)};
    const Vec3<Interval> regular = regularDirection(box, Map::front);
    const IndexSet components = Map::componentOf(regular);
    const Direction<double> inDouble(d);
    const MapKind map = Map::info.kind;
    CHECK(components.contains(mirrorball::componentOf(map, d)));
    CHECK(components.contains(mirrorball::componentOf(map, inDouble)));

    const int component = mirrorball::componentOf(map, d);
    const Vec2<Interval> uv = Map::squareFromDirection(IndexSet(component), regular);
    const glm::vec2 single = mirrorball::squareFromDirection(map, component, d);
    const glm::dvec2 precise = mirrorball::squareFromDirection(map, component, inDouble);
    checkContains(uv.x, double(single.x));
    checkContains(uv.x, precise.x);
    checkContains(uv.y, double(single.y));
    checkContains(uv.y, precise.y);
}

template <class Map>
void checkInverse(const glm::vec2& uv, int component, double radius)
{
    const Vec2<Interval> box{around(uv.x, radius), around(uv.y, radius)};
    const Vec3<Interval> d = Map::directionFromSquare(IndexSet(component), regularSquare(box));
    const glm::vec3 single = mirrorball::directionFromSquare(Map::info.kind, component, uv);
    const glm::dvec3 precise = mirrorball::directionFromSquare(Map::info.kind, component, glm::dvec2(uv));
    checkContains(d.x, double(single.x));
    checkContains(d.y, double(single.y));
    checkContains(d.z, double(single.z));
    checkContains(d.x, precise.x);
    checkContains(d.y, precise.y);
    checkContains(d.z, precise.z);
}

// A direction in the middle of an octant, known exactly: rounding alone leaves less than 2^-18 of the square,
// sixteen times the bound that each single rounding error stays below.
template <class Map>
void checkNarrow()
{
    const glm::vec3 d(0.4f, 0.5f, 0.9f);
    const int component = mirrorball::componentOf(Map::info.kind, d);
    const Vec3<Interval> box{around(d.x, 0), around(d.y, 0), around(d.z, 0)};
    const Vec2<Interval> uv =
        Map::squareFromDirection(IndexSet(component), regularDirection(box, Map::front));
    CHECK(uv.x.upper - uv.x.lower < 0x1p-18);
    CHECK(uv.y.upper - uv.y.lower < 0x1p-18);
}

template <class Map>
void checkMap(const std::vector<Direction<float>>& directions)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(-0.25f, 1.25f);
    checkNarrow<Map>();
    for (std::size_t i = 0; i < directions.size(); ++i) {
        // Exactly known, within one float's rounding, and within more than a texel.
        const double radius = std::array{0.0, 0x1p-24, 0x1p-9}[i % 3];
        if (!isSpread(directions[i]))
            checkForward<Map>(directions[i], radius);
        checkInverse<Map>({unit(random), unit(random)}, static_cast<int>(i) % Map::info.components, radius);
    }
}

} // namespace

int main()
{
    const std::vector<Direction<float>> directions = tests::hardDirections<float>(directionsPerMap);
    for (const mirrorball::MapInfo& map : mirrorball::maps())
        mirrorball::visitMap(map.kind, [&](auto formula) { checkMap<decltype(formula)>(directions); });
}
