// The Jacobian against differences, and the measures against figures computed elsewhere.
#include "support/check.h"

#include <mirrorball/maps/measures.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>
#include <random>

namespace {

using mirrorball::MapKind;

glm::dvec3 difference(MapKind map, int component, const glm::dvec2& uv, const glm::dvec2& step)
{
    return mirrorball::directionFromSquare(map, component, uv + step) -
           mirrorball::directionFromSquare(map, component, uv - step);
}

// (u, v) change by what the direction was changed for, whatever its length, and not with the length. Where the
// direction belongs to another place, as past the sphere map's rim, there is no inverse.
void checkInverse(MapKind map, int component, const mirrorball::Jacobian& j)
{
    constexpr double bound = 1e-9; // some roundings, times the longest derivative there and back
    const auto change = [&](const glm::dvec3& along) {
        return mirrorball::squareDerivative(map, component, 3.0 * j.direction, 3.0 * along);
    };
    CHECK_NEAR(glm::length(change(j.alongU) - glm::dvec2(1, 0)), 0, bound);
    CHECK_NEAR(glm::length(change(j.alongV) - glm::dvec2(0, 1)), 0, bound);
    CHECK_NEAR(glm::length(change(j.direction)), 0, bound);
}

// Central differences with step h err by h² / 6 times the third derivative, which is largest for the sphere
// map: with s = sqrt(1 - r²), that of 2 a s along the radius is 2 (3 r² / s^5 + 3 / s^3), 400 at r = 0.9,
// times 2³ for u = a / 2; and by rounding, 4e-16 / h.
void checkJacobian(MapKind map, std::mt19937& random)
{
    constexpr double h = 1e-5;
    constexpr double bound = h * h / 6 * 3200 + 4e-16 / h;
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 10000; ++i) {
        const glm::dvec2 uv(unit(random), unit(random));
        const glm::dvec2 ab = 2.0 * uv - 1.0;
        // Kinks: the sphere map's rim, the octahedral map's folds.
        if (map == MapKind::sphereMap && glm::length(ab) > 0.9)
            continue;
        if (map == MapKind::octahedral &&
            std::min({std::abs(ab.x), std::abs(ab.y), std::abs(1 - std::abs(ab.x) - std::abs(ab.y))}) < 4 * h)
            continue;
        const int component = i % mirrorball::mapInfo(map).components;
        const mirrorball::Jacobian j = mirrorball::jacobian(map, component, uv);
        CHECK(j.direction == mirrorball::directionFromSquare(map, component, uv));
        CHECK_NEAR(glm::length(difference(map, component, uv, {h, 0}) / (2 * h) - j.alongU), 0, bound);
        CHECK_NEAR(glm::length(difference(map, component, uv, {0, h}) / (2 * h) - j.alongV), 0, bound);
        checkInverse(map, component, j);
    }
}

// Sums over texels of the solid angle at their centre approach the sphere's 4 pi by the midpoint rule.
void checkSolidAngle(MapKind map, int n, double bound)
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(map);
    const glm::ivec2 size(n * info.widthInN, n * info.heightInN);
    double sum = 0;
    for (int component = 0; component < info.components; ++component)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec2 centre = (glm::dvec2(x, y) + 0.5) / glm::dvec2(size);
                const mirrorball::Jacobian j = mirrorball::jacobian(map, component, centre);
                const auto owner = mirrorball::coordinateFromDirection(map, j.direction);
                if (owner.component == component && glm::length(owner.uv - centre) * n < 0.25)
                    sum += mirrorball::solidAngleDensity(j) / size.x / size.y;
            }
    CHECK_NEAR(sum / (4 * std::numbers::pi), 1, bound);
}

struct Expected
{
    double worstDiagonal; // degrees
    double meanDiagonal;
    double usedPercent;
    double largestSolidAngle;
    double worstStretch; // 0: unbounded
    double meanStretch;
};

// At 6 * 256² texels in all, computed by other code (numpy, per texel) for the comparison of maps in
// docs/maps.md; a side is a whole number of texels here, so areas differ by up to 2 / 443.
void checkMeasures(MapKind map, const Expected& expected)
{
    const int n = mirrorball::shortSideFromTexels(map, 393216);
    const mirrorball::MapMeasures m = mirrorball::mapMeasures(map, n);
    const double degrees = 180 / std::numbers::pi;
    const double percent = 100.0 * double(m.used) / double(m.texels);
    CHECK_NEAR(m.worstDiagonal * degrees / expected.worstDiagonal, 1, 0.01);
    CHECK_NEAR(m.meanDiagonal * degrees / expected.meanDiagonal, 1, 0.01);
    CHECK_NEAR(percent, expected.usedPercent, 0.1);
    CHECK_NEAR(m.largestSolidAngle / expected.largestSolidAngle, 1, 0.01);
    CHECK_NEAR(m.meanStretch / expected.meanStretch, 1, 0.01);
    if (expected.worstStretch > 0)
        CHECK_NEAR(m.worstStretch / expected.worstStretch, 1, 0.01);
    else
        CHECK(m.worstStretch > 1000);
}

} // namespace

int main()
{
    std::mt19937 random(7);
    for (const mirrorball::MapInfo& map : mirrorball::maps())
        checkJacobian(map.kind, random);

    // Whole squares: the midpoint rule's error is of order 1 / n². Where a border crosses texels, they count
    // whole or not at all: about 10 n border texels of 6 n², each wrong by up to one half at random, far
    // below 1 / n.
    for (const MapKind map :
         {MapKind::cube, MapKind::equiAngularCube, MapKind::octahedral, MapKind::equirectangular})
        checkSolidAngle(map, 256, 1.0 / (256 * 256));
    for (const MapKind map :
         {MapKind::tennisBall, MapKind::tennisBallEven, MapKind::dualParaboloid, MapKind::sphereMap})
        checkSolidAngle(map, 256, 1.0 / 256);

    checkMeasures(MapKind::tennisBall, {0.4972, 0.4770, 93.6, 1.178, 1.41, 1.103});
    checkMeasures(MapKind::tennisBallEven, {0.4824, 0.4760, 94.1, 1.107, 1.65, 1.137});
    checkMeasures(MapKind::dualParaboloid, {0.7310, 0.5482, 78.6, 2.546, 1.00, 1.000});
    checkMeasures(MapKind::cube, {0.6330, 0.5143, 100, 1.910, 1.73, 1.221});
    checkMeasures(MapKind::equiAngularCube, {0.5729, 0.4937, 100, 1.178, 1.73, 1.221});
    checkMeasures(MapKind::octahedral, {0.7753, 0.6305, 100, 1.654, 2.61, 1.774});
    checkMeasures(MapKind::equirectangular, {0.5741, 0.5218, 100, 1.571, 282, 1.571});
    checkMeasures(MapKind::sphereMap, {10.9, 0.934, 78.6, 1.273, 0, 34});
}
