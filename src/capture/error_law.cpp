#include "capture/error_law.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorball::capture {

namespace {

constexpr double quarterTurn = std::numbers::pi / 2.0;

// The largest sine of the angle between a coordinate plane and directions within the sphere: |height| over
// distance at best, widened by the sphere's angular radius.
double steepestSine(double height, double distance, double radius)
{
    const double angle = std::asin(std::min(std::abs(height) / distance, 1.0)) + std::asin(radius / distance);
    return std::sin(std::min(angle, quarterTurn));
}

// Latitude p and longitude l obey p'' = -sin p cos p l'², l'' = 2 tan p p' l' along a great circle; the
// largest sqrt(p''² + l''²) over all headings is tan p * k / (2 sqrt(k - 1)) with k = 4 / cos² p.
double latitudeLongitudeBend(double sine)
{
    const double cosineSquared = 1.0 - sine * sine;
    const double k = 4.0 / cosineSquared;
    return sine / std::sqrt(cosineSquared) * k / (2.0 * std::sqrt(k - 1.0)) / 8.0;
}

// Nothing steeper than this is mapped: the bend grows without bound towards the poles.
const double steepestMapped = std::sin(std::numbers::pi / 3.0);

// How far a sphere lies from the half-plane x = 0, z < 0, in which a longitude around y is cut.
double distanceToCut(const glm::dvec3& centre)
{
    return centre.z < 0.0 ? std::abs(centre.x) : std::hypot(centre.x, centre.z);
}

std::optional<double> tennisBallBend(const glm::dvec3& local, double radius, bool even)
{
    const double sine = steepestSine(local.y, glm::length(local), radius);
    if (sine > steepestMapped || distanceToCut(local) <= radius)
        return std::nullopt;
    const double bend = latitudeLongitudeBend(sine) / quarterTurn;
    // The even map's cubic in sin p adds at most a seventh, and at the equator its own small bend.
    return even ? 1.15 * bend + 0.002 : bend;
}

std::optional<double> stereographicBend(const glm::dvec3& local, double radius)
{
    const double distance = glm::length(local);
    const double angle = std::acos(std::clamp(local.z / distance, -1.0, 1.0)) + std::asin(radius / distance);
    const double limit = 2.0 * std::atan(1.6);
    if (angle > limit)
        return std::nullopt;
    // |f''| = rho (1 + rho²) / 2 at radius rho = tan(angle / 2), whatever the heading, in halves of n.
    const double rho = std::tan(0.5 * angle);
    return 0.5 * rho * (1.0 + rho * rho) / 2.0 / 8.0;
}

std::optional<double> equiAngularBend(const glm::dvec3& local, double radius)
{
    // Each coordinate is a longitude around the other axis: its |f''| is at most tan p / cos p at latitude p.
    const double distance = glm::length(local);
    const double sines[2] = {steepestSine(local.x, distance, radius),
                             steepestSine(local.y, distance, radius)};
    if (local.z - radius < 0.3 * distance || std::max(sines[0], sines[1]) > steepestMapped)
        return std::nullopt;
    const auto bend = [](double sine) { return sine / (1.0 - sine * sine); };
    return std::hypot(bend(sines[0]), bend(sines[1])) / quarterTurn / 8.0;
}

std::optional<double> sphereMapBend(const glm::dvec3& centre, double radius)
{
    const double distance = glm::length(centre);
    const double angle = std::acos(std::clamp(centre.z / distance, -1.0, 1.0)) + std::asin(radius / distance);
    if (angle > 2.0 * std::numbers::pi / 3.0)
        return std::nullopt;
    // The supremum within 120 degrees of the centre; tests/capture/error_law_test.cpp holds it.
    return 0.0855;
}

} // namespace

std::optional<double> bendOf(MapKind map, int view, const glm::dvec3& centre, double radius)
{
    if (!(glm::length(centre) > radius))
        return std::nullopt;
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
        return tennisBallBend(view == 0 ? centre : glm::dvec3(centre.y, centre.x, -centre.z), radius,
                              map == MapKind::tennisBallEven);
    case MapKind::dualParaboloid:
        return stereographicBend(view == 0 ? glm::dvec3(centre.x, centre.y, -centre.z) : centre, radius);
    case MapKind::equiAngularCube: {
        const int axis = view / 2;
        const double side = view % 2 == 0 ? 1.0 : -1.0;
        return equiAngularBend({centre[(axis + 1) % 3], centre[(axis + 2) % 3], side * centre[axis]}, radius);
    }
    case MapKind::equirectangular: {
        // The cut is at +z, and 2n texels go round.
        const glm::dvec3 turned(centre.x, centre.y, -centre.z);
        const double sine = steepestSine(turned.y, glm::length(turned), radius);
        if (sine > steepestMapped || distanceToCut(turned) <= radius)
            return std::nullopt;
        return latitudeLongitudeBend(sine) / std::numbers::pi;
    }
    case MapKind::sphereMap:
        return sphereMapBend(centre, radius);
    case MapKind::cube:
    case MapKind::octahedral:
        return 0.0;
    }
    return std::nullopt;
}

double tessellationSteps(int n, double epsilon)
{
    // The largest bend at the borders of views: 0.16 n a radian², at an equi-angular face's corner.
    return std::sqrt(0.16 * n / epsilon);
}

bool mappingSuffices(MapKind map, int view, const MeshBounds& mesh, int n, double epsilon)
{
    const double nearest = glm::length(mesh.centre) - mesh.radius;
    if (!(nearest > 0.0) || !(mesh.longestEdge < nearest))
        return false;
    const std::optional<double> bend = bendOf(map, view, mesh.centre, mesh.radius);
    // An edge of length L at distance D spans an angle of at most 2 asin(L / 2D), and a change of distance of
    // at most L / D: lengthways error over the edge's length, times that change, bounds the distance.
    const double angle = 2.0 * std::asin(0.5 * mesh.longestEdge / nearest);
    return bend && *bend * angle * angle * n <= epsilon;
}

} // namespace mirrorball::capture
