// The second layer of depth against the tracer, texel by texel: the nearest surface that is farther, by the separation,
// than the nearest of the first layer's texels which that texel covers.
#include "support/check.h"
#include "support/exactness.h"
#include "support/gl_image.h"
#include "support/gl_state.h"

#include "gl_scene.h"
#include "reference.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/maps/maps.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mutex>
#include <string>

using namespace mirrorball;

namespace {

constexpr double nearest = 0.05, farthest = 1000.0;
constexpr float separation = 0.3f;

// One component of a map as read back: of RGBA the first number.
struct Layers
{
    const MapInfo& info;
    int n;
    std::vector<float> rgba;

    int width() const { return info.widthInN * n; }
    int height() const { return info.heightInN * n; }
    float at(int component, int x, int y) const
    {
        return rgba[4 * static_cast<std::size_t>((component * height() + y) * width() + x)];
    }
};

// Of one axis: whether a texel of the first layer shares more than an end with one of the second.
bool meets(int first, int firstSize, int second, int secondSize)
{
    return first * secondSize < (second + 1) * firstSize && (first + 1) * secondSize > second * firstSize;
}

double nearestAround(const Layers& first, const Layers& second, int component, int x, int y)
{
    constexpr int reach = 10; // texels, from the one in the corner
    const int left = x * first.width() / second.width(), top = y * first.height() / second.height();
    float result = std::numeric_limits<float>::infinity();
    for (int row = std::max(top - reach, 0); row < std::min(top + reach, first.height()); ++row)
        for (int column = std::max(left - reach, 0); column < std::min(left + reach, first.width()); ++column)
            if (meets(row, first.height(), y, second.height()) &&
                meets(column, first.width(), x, second.width()))
                result = std::min(result, first.at(component, column, row));
    return static_cast<double>(result);
}

ReflectionProbe captured(const examples::Scene& scene, const glm::dvec3& at, MapKind map, int n,
                         int supersample = 1)
{
    ReflectionProbe::Desc desc{.map = map, .n = n};
    desc.worldFromProbe[3] = glm::dvec4(at, 1.0);
    desc.captureOrigin = at;
    desc.near = static_cast<float>(nearest);
    desc.far = static_cast<float>(farthest);
    desc.colour = ColourFormat::rgba32f;
    desc.supersample = supersample;
    desc.method = CaptureMethod::exact;
    desc.layersOfDepth = 2;
    desc.layerSeparation = separation;
    ReflectionProbe probe(desc);
    const examples::GlScene drawable(scene, at);
    CaptureProgram program = examples::phongCaptureProgram(examples::View::triangle);
    probe.capture(drawable.captureMeshes(program), [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        drawable.drawMesh(mesh.id, draw.program, {});
    });
    return probe;
}

// k: of samples a texel, an odd number, so that the middle one is the texel's.
void check(const examples::Scene& scene, const glm::dvec3& at, MapKind map, int n, int k = 1)
{
    const ReflectionProbe probe = captured(scene, at, map, n, k), samples = captured(scene, at, map, n * k);
    const ReflectionMap& result = probe.map();
    const MapInfo& info = mapInfo(map);
    const auto read = [&](unsigned int texture, int size) {
        return Layers{info, size, tests::readMap(texture, map, size)};
    };
    CHECK(result.hiddenN == n / 2);
    const Layers first = read(samples.map().distanceTexture, n * k);
    const Layers triangles = read(result.hiddenColourTexture, n / 2);
    const Layers distances = read(result.hiddenDistanceTexture, n / 2);
    const examples::ReferenceTracer tracer(scene, at);
    tests::Exactness total;
    std::size_t onThreshold = 0;
    std::mutex mutex;
    examples::forEachRow(distances.height() * info.components, [&](int job) {
        const int component = job / distances.height(), y = job % distances.height();
        tests::Exactness row;
        for (int x = 0; x < distances.width(); ++x) {
            const double around = nearestAround(first, distances, component, x, y);
            const double u = (x + 0.5) / distances.width(), v = (y + 0.5) / distances.height();
            // Beyond the disc of a paraboloid is no direction of its own.
            if (map == MapKind::dualParaboloid && std::hypot(u - 0.5, v - 0.5) > 0.5)
                continue;
            const glm::dvec3 direction = examples::referenceDirection(info.name, component, u, v);
            const double threshold = (1.0 + static_cast<double>(separation)) * around;
            tests::Seen shown, traced;
            shown.distance = static_cast<double>(distances.at(component, x, y));
            if (std::isfinite(shown.distance))
                shown.triangle = static_cast<std::uint32_t>(triangles.at(component, x, y));
            if (std::isfinite(threshold))
                if (const examples::Hit hit = tracer.trace(at, direction, threshold, farthest); hit.found)
                    traced = {hit.triangle, hit.distance};
            const auto isOnThreshold = [&](const tests::Seen& seen) {
                return seen.triangle && std::abs(seen.distance / threshold - 1.0) < 1e-4;
            };
            if (isOnThreshold(shown) || isOnThreshold(traced)) {
                const std::lock_guard lock(mutex);
                ++onThreshold;
                continue;
            }
            tests::compare(row, scene, at, direction, shown, traced);
        }
        const std::lock_guard lock(mutex);
        tests::add(total, row);
    });
    std::printf("%-18s n = %d, x%d: %zu of %zu texels show something, %zu wrong, %zu of them off an edge, "
                "%zu on the threshold\n",
                std::string(info.name).c_str(), n, k, total.shown, total.texels, total.wrong,
                total.wrongFarOff, onThreshold);
    CHECK(total.shown * 50 > total.texels); // something is hidden
    CHECK(total.wrongFarOff == 0);
    CHECK(total.wrong * 1000 <= total.texels);
    CHECK(total.worstDistance < 1e-4);
    CHECK(onThreshold * 100 < total.texels);
}

} // namespace

// "few": what a slow driver gets through in seconds.
int main(int argc, char** argv)
{
    const headless::Context context;
    const examples::Scene crowd = examples::loadScene("builtin:crowd:3000");
    const glm::dvec3 at(0.1, 0.333, 0.01);
    check(crowd, at, MapKind::tennisBall, 15, 1); // blocks of 2 x 2 or 3 x 3
    check(crowd, at, MapKind::cube, 15, 3);
    if (argc < 2 || std::string(argv[1]) != "few") {
        for (const MapKind map : {MapKind::tennisBall, MapKind::tennisBallEven, MapKind::dualParaboloid,
                                  MapKind::cube, MapKind::octahedral, MapKind::equirectangular})
            check(crowd, at, map, 48);
        check(crowd, at, MapKind::tennisBall, 24, 3);
        check(crowd, at, MapKind::cube, 33);
    }
    CHECK(tests::takeErrors().empty());
}
