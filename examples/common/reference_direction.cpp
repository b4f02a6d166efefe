#include "reference_direction.h"

#include <mirrorball/error.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace examples {
namespace {

constexpr double pi = std::numbers::pi;

// A band around a great circle: `across` is the sine of the latitude, `along` the angle on the circle,
// measured from the middle of the component.
glm::dvec3 tennisBallFrom(int component, double across, double along)
{
    const double cosine = std::sqrt(1.0 - across * across);
    const double s = cosine * std::sin(along);
    const double c = cosine * std::cos(along);
    return component == 0 ? glm::dvec3(s, across, c) : glm::dvec3(across, s, -c);
}

// The real root t of q t³ + (1 − q) t = a. With p = (1 − q) / q > 0 the cubic t³ + p t = a / q has one real
// root, which the substitution t = 2 √(p/3) sinh(w) turns into sinh(3 w) = 3 a / (2 q p) · √(3/p).
double evenLatitude(double a)
{
    constexpr double q = 0.042; // the map's constant
    constexpr double p = (1.0 - q) / q;
    const double w = std::asinh(1.5 * a / (q * p) * std::sqrt(3.0 / p)) / 3.0;
    return 2.0 * std::sqrt(p / 3.0) * std::sinh(w);
}

// These are homogeneous: a, b and n may be multiplied by any number alike.
glm::dvec3 paraboloidFrom(int component, double a, double b, double n)
{
    const double z = n * n - a * a - b * b;
    return {2.0 * a * n, 2.0 * b * n, component == 0 ? -z : z};
}

// OpenGL 4.6, table 8.19, solved for the direction.
glm::dvec3 cubeFrom(int component, double a, double b, double n)
{
    const glm::dvec3 sides[] = {{n, -b, -a}, {-n, -b, a}, {a, n, b}, {a, -n, -b}, {a, -b, n}, {-a, -b, -n}};
    return sides[component];
}

glm::dvec3 octahedralFrom(double a, double b, double n)
{
    const double z = n - std::abs(a) - std::abs(b);
    if (z >= 0.0) {
        return {a, b, z};
    }
    return {std::copysign(n - std::abs(b), a), std::copysign(n - std::abs(a), b), z};
}

glm::dvec3 equirectangularFrom(double u, double v)
{
    const double longitude = 2.0 * pi * (u - 0.5);
    const double latitude = pi * (0.5 - v);
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude),
            -std::cos(latitude) * std::cos(longitude)};
}

// With p = u − 1/2 = a / 2 n, q = v − 1/2 = b / 2 n on the unit sphere m² = 8 (1 + z), so p² + q² = (1 − z) / 8; here
// over m / 2 n.
glm::dvec3 sphereMapFrom(double a, double b, double n)
{
    const double inside = n * n - a * a - b * b;
    if (inside <= 0.0) {
        return {0.0, 0.0, -1.0};
    }
    return {a, b, (inside - a * a - b * b) / (2.0 * std::sqrt(inside))};
}

// For (a, b) in [-n, n]; nothing of maps that need the angle itself.
std::optional<glm::dvec3> homogeneousRay(std::string_view mapName, int component, double a, double b,
                                         double n)
{
    if (mapName == "dual-paraboloid") {
        return paraboloidFrom(component, a, b, n);
    }
    if (mapName == "cube") {
        return cubeFrom(component, a, b, n);
    }
    if (mapName == "octahedral") {
        return octahedralFrom(a, b, n);
    }
    if (mapName == "sphere-map") {
        return sphereMapFrom(a, b, n);
    }
    return std::nullopt;
}

} // namespace

glm::dvec3 referenceRay(std::string_view mapName, int component, int column, int row, int width, int height)
{
    if (const auto ray =
            homogeneousRay(mapName, component, 2 * column + 1 - width, 2 * row + 1 - height, width)) {
        return *ray;
    }
    return referenceDirection(mapName, component, (column + 0.5) / width, (row + 0.5) / height);
}

glm::dvec3 referenceDirection(std::string_view mapName, int component, double u, double v)
{
    const double a = 2.0 * u - 1.0;
    const double b = 2.0 * v - 1.0;
    if (const auto ray = homogeneousRay(mapName, component, a, b, 1.0)) {
        return glm::normalize(*ray);
    }
    if (mapName == "tennis-ball") {
        return tennisBallFrom(component, std::sin(a * pi / 4.0), b * 0.75 * pi);
    }
    if (mapName == "tennis-ball-even") {
        return tennisBallFrom(component, evenLatitude(a) / std::numbers::sqrt2, b * 0.75 * pi);
    }
    if (mapName == "equi-angular-cube") {
        return glm::normalize(cubeFrom(component, std::tan(a * pi / 4.0), std::tan(b * pi / 4.0), 1.0));
    }
    if (mapName == "equirectangular") {
        return equirectangularFrom(u, v);
    }
    throw mirrorball::Error(mirrorball::ErrorKind::unknownName, "map " + std::string(mapName),
                            "the reference knows no map of this name");
}

} // namespace examples
