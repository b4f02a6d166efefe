// The reference's inverse formulas against the forward formulas of the maps' definition, in long double.
#include "reference_direction.h"

#include <mirrorball/error.h>

#include "support/check.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

using examples::referenceDirection;

namespace {

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

struct Square
{
    Real a, b; // in [−1, 1]
};

Square band(const Real across, const Real along)
{
    return {across, along / (0.75L * pi)};
}

Square forwardTennisBall(bool even, int component, Real x, Real y, Real z)
{
    const Real sine = component == 0 ? y : x;
    const Real t = std::sqrt(2.0L) * sine;
    const Real across = even ? t * (1.0L - 0.042L + 0.042L * t * t) : std::asin(sine) / (0.25L * pi);
    return band(across, component == 0 ? std::atan2(x, z) : std::atan2(y, -z));
}

// OpenGL's table: the coordinates s and t of each face, over the magnitude of the major axis.
Square forwardCube(int component, Real x, Real y, Real z)
{
    switch (component) {
    case 0:
        return {-z / x, -y / x};
    case 1:
        return {z / -x, -y / -x};
    case 2:
        return {x / y, z / y};
    case 3:
        return {x / -y, -z / -y};
    case 4:
        return {x / z, -y / z};
    default:
        return {-x / -z, -y / -z};
    }
}

Square forwardOctahedral(Real x, Real y, Real z)
{
    const Real sum = std::abs(x) + std::abs(y) + std::abs(z);
    const Real a = x / sum;
    const Real b = y / sum;
    if (z >= 0.0L) {
        return {a, b};
    }
    return {std::copysign(1.0L - std::abs(b), a), std::copysign(1.0L - std::abs(a), b)};
}

Square forward(std::string_view map, int component, Real x, Real y, Real z)
{
    if (map == "tennis-ball" || map == "tennis-ball-even") {
        return forwardTennisBall(map == "tennis-ball-even", component, x, y, z);
    }
    if (map == "dual-paraboloid") {
        const Real below = component == 0 ? 1.0L - z : 1.0L + z;
        return {x / below, y / below};
    }
    if (map == "cube") {
        return forwardCube(component, x, y, z);
    }
    if (map == "equi-angular-cube") {
        const Square cube = forwardCube(component, x, y, z);
        return {4.0L / pi * std::atan(cube.a), 4.0L / pi * std::atan(cube.b)};
    }
    if (map == "octahedral") {
        return forwardOctahedral(x, y, z);
    }
    if (map == "equirectangular") {
        return {std::atan2(x, -z) / pi, -2.0L * std::asin(y) / pi};
    }
    const Real m = 2.0L * std::sqrt(x * x + y * y + (z + 1.0L) * (z + 1.0L));
    return {2.0L * x / m, 2.0L * y / m};
}

void testRoundTrip(std::string_view map, int components)
{
    constexpr int n = 16;
    for (int component = 0; component < components; ++component) {
        for (int i = 0; i < n * n; ++i) {
            const double u = (i % n + 0.5) / n;
            const double v = (std::floor(i / n) + 0.5) / n;
            const Real a = 2.0L * static_cast<Real>(u) - 1.0L;
            const Real b = 2.0L * static_cast<Real>(v) - 1.0L;
            // The sphere map ends at its disc, and loses digits towards its rim as 1 / (1 − r²).
            const Real inside = map == "sphere-map" ? 1.0L - a * a - b * b : 1.0L;
            if (inside <= 0.0L) {
                continue;
            }
            const glm::dvec3 d = referenceDirection(map, component, u, v);
            CHECK_NEAR(glm::length(d), 1.0, 4e-16); // two units in the last place of 1
            const glm::dvec3 ray = examples::referenceRay(map, component, i % n, i / n, n, n);
            CHECK(glm::distance(glm::normalize(ray), d) <= 4e-16);
            const Square back = forward(map, component, Real(d.x), Real(d.y), Real(d.z));
            // A direction is right to a few units in the last place; on this grid, half a cell from every
            // border, the worst slope of a forward formula is that of the longitude, 1 / cos(84°) ≈ 10, next
            // to a pole.
            const double tolerance = 64.0 * 1.2e-16 / static_cast<double>(inside);
            CHECK_NEAR(back.a, a, tolerance);
            CHECK_NEAR(back.b, b, tolerance);
        }
    }
}

void checkDirection(std::string_view map, int component, double u, double v, const glm::dvec3& expected)
{
    const glm::dvec3 d = referenceDirection(map, component, u, v);
    if (!(glm::distance(d, expected) <= 4e-16)) {
        std::fprintf(stderr, "%.*s %d (%g, %g): (%g, %g, %g)\n", static_cast<int>(map.size()), map.data(),
                     component, u, v, d.x, d.y, d.z);
        std::exit(1);
    }
}

// Read off the table of the maps, not from any formula.
void testLandmarks()
{
    for (const std::string_view map : {"tennis-ball", "tennis-ball-even"}) {
        checkDirection(map, 0, 0.5, 0.5, {0, 0, 1});
        checkDirection(map, 1, 0.5, 0.5, {0, 0, -1});
        const double r = std::sqrt(0.5);
        checkDirection(map, 0, 1.0, 0.5, {0, r, r});
        checkDirection(map, 1, 1.0, 0.5, {r, 0, -r});
        checkDirection(map, 0, 0.5, 5.0 / 6.0, {1, 0, 0}); // a third of the way on to 135°, that is 90°
        checkDirection(map, 1, 0.5, 5.0 / 6.0, {0, 1, 0});
    }
    checkDirection("dual-paraboloid", 0, 0.5, 0.5, {0, 0, -1});
    checkDirection("dual-paraboloid", 1, 0.5, 0.5, {0, 0, 1});
    checkDirection("dual-paraboloid", 0, 1.0, 0.5, {1, 0, 0});
    checkDirection("dual-paraboloid", 1, 0.5, 1.0, {0, 1, 0});
    const glm::dvec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face) {
        checkDirection("cube", face, 0.5, 0.5, axes[face]);
        checkDirection("equi-angular-cube", face, 0.5, 0.5, axes[face]);
    }
    checkDirection("cube", 1, 0.375, 0.125, glm::normalize(glm::dvec3(-4, 3, -1)));
    checkDirection("octahedral", 0, 0.5, 0.5, {0, 0, 1});
    checkDirection("octahedral", 0, 1.0, 0.5, {1, 0, 0});
    checkDirection("octahedral", 0, 0.5, 1.0, {0, 1, 0});
    checkDirection("octahedral", 0, 0.0, 0.0, {0, 0, -1});
    checkDirection("equirectangular", 0, 0.5, 0.5, {0, 0, -1});
    checkDirection("equirectangular", 0, 0.75, 0.5, {1, 0, 0});
    checkDirection("equirectangular", 0, 0.5, 0.0, {0, 1, 0});
    checkDirection("sphere-map", 0, 0.5, 0.5, {0, 0, 1});
    checkDirection("sphere-map", 0, 0.5 + std::sqrt(0.125), 0.5, {1, 0, 0});
    checkDirection("sphere-map", 0, 1.0, 0.5, {0, 0, -1});
    checkDirection("sphere-map", 0, 0.0, 0.0, {0, 0, -1}); // outside the disc
}

} // namespace

int main()
{
    testRoundTrip("tennis-ball", 2);
    testRoundTrip("tennis-ball-even", 2);
    testRoundTrip("dual-paraboloid", 2);
    testRoundTrip("cube", 6);
    testRoundTrip("equi-angular-cube", 6);
    testRoundTrip("octahedral", 1);
    testRoundTrip("equirectangular", 1);
    testRoundTrip("sphere-map", 1);
    testLandmarks();
    CHECK_THROWS(referenceDirection("tennis-bat", 0, 0.5, 0.5), mirrorball::ErrorKind::unknownName);
}
