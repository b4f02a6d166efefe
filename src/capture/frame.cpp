#include "capture/frame.h"

#include "capture/error_law.h"
#include "capture/map_textures.h"
#include "capture/pose.h"
#include "capture/views.h"
#include "number_text.h"

#include <mirrorball/error.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace mirrorball::capture {

namespace {

float nearOf(const ReflectionProbe::Desc& desc, double scale)
{
    if (!(desc.halfExtent >= 0.0) || !std::isfinite(desc.halfExtent))
        throw Error(ErrorKind::badArgument, "a probe's half extent", "it is " + numberText(desc.halfExtent),
                    "give a finite number that is not negative");
    const float near = desc.near ? *desc.near : static_cast<float>(desc.halfExtent * scale);
    const std::string found = "near is " + numberText(near) + " and far is " + numberText(desc.far);
    if (!(near > 0.0f) || !std::isfinite(near) || !(desc.far > near))
        throw Error(ErrorKind::badArgument, "the range of a probe", found, "give 0 < near < far");
    return near;
}

glm::dmat4 inverseRelativeTo(const glm::dvec3& origin, glm::dmat4 worldFromProbe)
{
    worldFromProbe[3] = glm::dvec4(glm::dvec3(worldFromProbe[3]) - origin, 1.0);
    return glm::inverse(worldFromProbe);
}

} // namespace

bool capturesPastSeams(const ReflectionProbe::Desc& desc)
{
    const bool areRead = desc.mipLevels || desc.layersOfDepth == 2;
    return desc.pastSeams || (areRead && desc.method != CaptureMethod::perVertex);
}

Frame::Frame(const ReflectionProbe::Desc& desc)
    : map_(desc.map), n_(desc.n), method_(desc.method), depthTerm_(desc.depthTerm),
      epsilon_(static_cast<double>(desc.epsilon)), pastSeams_(capturesPastSeams(desc)),
      worldFromProbe_(rigidPose(desc.worldFromProbe).worldFromProbe),
      probeFromWorld_(inverseRelativeTo(desc.captureOrigin, worldFromProbe_)),
      captureOrigin_(desc.captureOrigin), near_(nearOf(desc, rigidPose(desc.worldFromProbe).scale)),
      far_(desc.far)
{
}

glm::dvec3 Frame::centre() const
{
    return glm::dvec3(worldFromProbe_[3]) - captureOrigin_;
}

bool Frame::touches(int view, const Sphere& bounds) const
{
    const glm::dvec3 centre(probeFromWorld_ * glm::dvec4(glm::dvec3(bounds.centre), 1.0));
    const double distance = glm::length(centre);
    // The host's bounds and vertices are floats: allow for the rounding of both.
    const double radius = static_cast<double>(bounds.radius) * (1.0 + 1e-5) + distance * 1e-6;
    if (std::isnan(distance) || std::isnan(radius))
        return true;
    if (distance + radius < static_cast<double>(near_) || distance - radius > static_cast<double>(far_))
        return false;
    // Linear filtering at a seam reads texels beside it. Two, from corner to corner, are 4.5 / n radians wide at the
    // tennis-ball maps' seams and 5.7 / n at the dual paraboloid's. Of the second layer, whose texels are twice as
    // wide, the nearest texel is read.
    return viewTouches(map_, view, centre, radius) &&
           (pastSeams_ || ownedTouches(map_, view, centre, radius, 6.0 / n_));
}

bool Frame::touches(int view, const Box& bounds) const
{
    // Spheres around parts of a box fit closely where one around a long or flat box would not.
    constexpr double partsAlongLongest = 8.0;
    const glm::dvec3 low(bounds.low), extent = glm::dvec3(bounds.high) - low;
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (!(std::min({extent.x, extent.y, extent.z}) >= 0.0) || !std::isfinite(longest))
        return true; // no box: nothing is known
    glm::ivec3 parts(1);
    for (int axis = 0; axis < 3 && longest > 0.0; ++axis)
        parts[axis] = std::max(1, static_cast<int>(std::ceil(extent[axis] * partsAlongLongest / longest)));
    const glm::dvec3 part = extent / glm::dvec3(parts);
    for (int x = 0; x < parts.x; ++x)
        for (int y = 0; y < parts.y; ++y)
            for (int z = 0; z < parts.z; ++z) {
                const glm::dvec3 centre = low + part * (glm::dvec3(x, y, z) + 0.5);
                // The centre is rounded to float: half an ulp of it, in three coordinates.
                const double rounding = 1.1e-7 * glm::length(centre);
                const double radius = (0.5 * glm::length(part) + rounding) * (1.0 + 1e-6);
                if (touches(view, Sphere{glm::vec3(centre), static_cast<float>(radius)}))
                    return true;
            }
    return false;
}

Variant Frame::variantOf(const CaptureMesh& mesh, int view, bool peels) const
{
    Variant variant{map_, Path::exact, view < 0 ? LayerOrder::allAtOnce : LayerOrder::oneAtATime, depthTerm_,
                    true};
    variant.peels = peels;
    // Triangles that span less than this (15 degrees) are nearly straight on the map, and a simple polygon covers
    // each closely: within 60 degrees of a component's equator, and what lies farther up does not reach the layer.
    constexpr double largeSpan = 0.26;
    MeshBounds seen{};
    if (mesh.bounds) {
        seen = {glm::dvec3(probeFromWorld_ * glm::dvec4(glm::dvec3(mesh.bounds->centre), 1.0)),
                static_cast<double>(mesh.bounds->radius), static_cast<double>(mesh.longestEdge)};
        variant.large = !(seen.longestEdge < largeSpan * (glm::length(seen.centre) - seen.radius));
    }
    if (mesh.widestAngle && static_cast<double>(*mesh.widestAngle) < largeSpan)
        variant.large = false;
    if (method_ == CaptureMethod::exact)
        return variant;
    if (isPiecewiseLinear(map_)) {
        variant.path = Path::linear;
        const double distance = glm::length(seen.centre);
        const double nearest =
            std::max(distance - seen.radius, static_cast<double>(mesh.nearestDistance.value_or(0.0f)));
        variant.withinRange = mesh.bounds && nearest > static_cast<double>(near_) * (1.0 + 1e-5) &&
                              distance + seen.radius < static_cast<double>(far_) * (1.0 - 1e-5);
    } else if (method_ == CaptureMethod::perVertex)
        variant.path = Path::textbook;
    else if (method_ == CaptureMethod::tessellated)
        variant.path = Path::tessellated;
    else if (mesh.bounds && view >= 0 && // a draw into all layers at once has no one view to judge by
             mappingSuffices(map_, view, seen, peels ? hiddenN(n_) : n_, epsilon_))
        variant.path = Path::mapped;
    if (variant.path != Path::exact)
        variant.large = false;
    // A position in the host's frame, interpolated before the centre is subtracted, is rounded to the centre's
    // last digits: to 1e-5 of any distance, as near as this.
    const bool isClose = glm::length(centre()) < 32.0 * static_cast<double>(near_);
    const bool isInterpolated = variant.path == Path::linear || variant.path == Path::mapped;
    variant.ownPosition = !isInterpolated || !isClose || variant.layers == LayerOrder::allAtOnce;
    return variant;
}

double Frame::distanceTo(const CaptureMesh& mesh) const
{
    const double distance = mesh.bounds ? glm::distance(glm::dvec3(mesh.bounds->centre), centre()) : 0.0;
    return std::isnan(distance) ? 0.0 : distance;
}

double Frame::tessellationSteps() const
{
    return capture::tessellationSteps(n_, epsilon_);
}

} // namespace mirrorball::capture
