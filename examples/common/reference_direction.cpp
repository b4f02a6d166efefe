#include "reference_direction.h"

#include <mirrorball/error.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
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

glm::dvec3 paraboloidFrom(int component, double a, double b)
{
    const double s = a * a + b * b;
    const double z = (1.0 - s) / (1.0 + s);
    return {2.0 * a / (1.0 + s), 2.0 * b / (1.0 + s), component == 0 ? -z : z};
}

// OpenGL 4.6, table 8.19, solved for the direction.
glm::dvec3 cubeFrom(int component, double a, double b)
{
    const glm::dvec3 sides[] = {{1, -b, -a}, {-1, -b, a}, {a, 1, b}, {a, -1, -b}, {a, -b, 1}, {-a, -b, -1}};
    return sides[component];
}

glm::dvec3 octahedralFrom(double a, double b)
{
    const double z = 1.0 - std::abs(a) - std::abs(b);
    if (z >= 0.0) {
        return {a, b, z};
    }
    return {std::copysign(1.0 - std::abs(b), a), std::copysign(1.0 - std::abs(a), b), z};
}

glm::dvec3 equirectangularFrom(double u, double v)
{
    const double longitude = 2.0 * pi * (u - 0.5);
    const double latitude = pi * (0.5 - v);
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude),
            -std::cos(latitude) * std::cos(longitude)};
}

// With p = u − 1/2, q = v − 1/2 on the unit sphere m² = 8 (1 + z), so p² + q² = (1 − z) / 8.
glm::dvec3 sphereMapFrom(double p, double q)
{
    const double s = std::fmin(p * p + q * q, 0.25);
    const double m = 4.0 * std::sqrt(1.0 - 4.0 * s);
    return {p * m, q * m, 1.0 - 8.0 * s};
}

} // namespace

glm::dvec3 referenceDirection(std::string_view mapName, int component, double u, double v)
{
    const double a = 2.0 * u - 1.0;
    const double b = 2.0 * v - 1.0;
    if (mapName == "tennis-ball") {
        return tennisBallFrom(component, std::sin(a * pi / 4.0), b * 0.75 * pi);
    }
    if (mapName == "tennis-ball-even") {
        return tennisBallFrom(component, evenLatitude(a) / std::numbers::sqrt2, b * 0.75 * pi);
    }
    if (mapName == "dual-paraboloid") {
        return paraboloidFrom(component, a, b);
    }
    if (mapName == "cube") {
        return glm::normalize(cubeFrom(component, a, b));
    }
    if (mapName == "equi-angular-cube") {
        return glm::normalize(cubeFrom(component, std::tan(a * pi / 4.0), std::tan(b * pi / 4.0)));
    }
    if (mapName == "octahedral") {
        return glm::normalize(octahedralFrom(a, b));
    }
    if (mapName == "equirectangular") {
        return equirectangularFrom(u, v);
    }
    if (mapName == "sphere-map") {
        return sphereMapFrom(u - 0.5, v - 0.5);
    }
    throw mirrorball::Error(mirrorball::ErrorKind::unknownName, "map " + std::string(mapName),
                            "the reference knows no map of this name");
}

} // namespace examples
