#include "capture/cheapest_pose.h"

#include "capture/frame.h"
#include "capture/views.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace mirrorball::capture {

namespace {

constexpr int turnCount = 256;

// The index-th of rotations that are spread evenly (Alexa, "Super-Fibonacci spirals: fast, low-discrepancy sampling of
// SO(3)", 2022).
glm::dmat4 turnOf(int index)
{
    constexpr double psi = 1.533751168755204288118041;
    const double s = index + 0.5, t = s / turnCount;
    const double a = glm::two_pi<double>() * s / glm::root_two<double>(), b = glm::two_pi<double>() * s / psi;
    const double inner = std::sqrt(t), outer = std::sqrt(1.0 - t);
    return glm::mat4_cast(
        glm::dquat(outer * std::cos(b), inner * std::sin(a), inner * std::cos(a), outer * std::sin(b)));
}

struct Work
{
    std::size_t triangles = 0, draws = 0;
    auto operator<=>(const Work&) const = default;
};

Work workOf(const Frame& frame, MapKind map, std::span<const CaptureMesh> meshes)
{
    Work work;
    for (const CaptureMesh& mesh : meshes)
        for (int view = 0; view < viewCount(map); ++view)
            if (!mesh.bounds || frame.touches(view, *mesh.bounds)) {
                work.triangles += mesh.triangles;
                ++work.draws;
            }
    return work;
}

} // namespace

glm::dmat4 cheapestPose(const ReflectionProbe::Desc& desc, std::span<const CaptureMesh> meshes)
{
    ReflectionProbe::Desc turned = desc;
    glm::dmat4 cheapest = desc.worldFromProbe;
    Work least = workOf(Frame(desc), desc.map, meshes);
    for (int index = 0; index < turnCount; ++index) {
        turned.worldFromProbe = desc.worldFromProbe * turnOf(index);
        const Work work = workOf(Frame(turned), desc.map, meshes);
        if (work < least) {
            least = work;
            cheapest = turned.worldFromProbe;
        }
    }
    return cheapest;
}

} // namespace mirrorball::capture
