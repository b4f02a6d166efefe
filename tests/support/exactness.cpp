#include "support/exactness.h"

#include "map_file.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace tests {

namespace {

// Two surfaces count as one where their distances differ by no more than float accuracy promises.
constexpr double sameDistance = 1e-4;
// Nearer to an edge, either of the two may be on the wrong side in float.
constexpr double atEdge = 1e-5;
// Nearer than this a direction in float does not know on which side it is.
constexpr double onEdge = 6e-8;

double angleToEdgesOf(const examples::Scene& scene, const glm::dvec3& at, const glm::dvec3& direction,
                      std::uint32_t triangle)
{
    for (const examples::Mesh& mesh : scene.meshes) {
        if (triangle < mesh.triangles.size()) {
            const auto& corners = mesh.triangles[triangle];
            const auto relative = [&](std::size_t corner) {
                return glm::dvec3(mesh.positions[corners[corner]]) + (scene.offset - at);
            };
            return examples::angleToEdges(direction, relative(0), relative(1), relative(2));
        }
        triangle -= static_cast<std::uint32_t>(mesh.triangles.size());
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

void compare(Exactness& result, const examples::Scene& scene, const glm::dvec3& at,
             const glm::dvec3& direction, const Seen& shown, const Seen& traced)
{
    ++result.texels;
    result.shown += shown.triangle ? 1 : 0;
    if (!shown.triangle && !traced.triangle)
        return;
    result.holes += traced.triangle && !shown.triangle ? 1 : 0;
    const double relative = shown.triangle && traced.triangle
                                ? std::abs(shown.distance / traced.distance - 1.0)
                                : std::numeric_limits<double>::infinity();
    if (relative <= sameDistance) {
        result.worstDistance = std::max(result.worstDistance, relative);
        return;
    }
    ++result.wrong;
    double edgeAngle = std::numeric_limits<double>::infinity();
    for (const Seen& seen : {shown, traced})
        if (seen.triangle)
            edgeAngle = std::min(edgeAngle, angleToEdgesOf(scene, at, direction, *seen.triangle));
    result.wrongFarOff += edgeAngle > atEdge ? 1 : 0;
    result.ties += edgeAngle < onEdge ? 1 : 0;
}

void add(Exactness& total, const Exactness& part)
{
    total.texels += part.texels;
    total.shown += part.shown;
    total.wrong += part.wrong;
    total.wrongFarOff += part.wrongFarOff;
    total.ties += part.ties;
    total.holes += part.holes;
    total.worstDistance = std::max(total.worstDistance, part.worstDistance);
}

Exactness exactnessOf(const examples::Scene& scene, const glm::dvec3& at,
                      mirrorball::ReflectionProbe::Desc desc)
{
    const glm::dmat3 worldFromProbe(desc.worldFromProbe);
    desc.worldFromProbe[3] = glm::dvec4(at, 1.0);
    desc.captureOrigin = at;
    desc.colour = mirrorball::ColourFormat::rgba32f;
    desc.pastSeams = true; // every texel is judged
    mirrorball::ReflectionProbe probe(desc);
    const examples::GlScene drawable(scene, at);
    mirrorball::CaptureProgram program = examples::phongCaptureProgram(examples::View::triangle);
    const auto meshes = drawable.captureMeshes(program);
    probe.capture(meshes, [&](const mirrorball::CaptureMesh& mesh, const mirrorball::CaptureDraw& draw) {
        drawable.drawMesh(mesh.id, draw.program, {}, 1, draw.primitive);
    });
    const auto layers =
        examples::readMap(probe.map(), examples::View::triangle, glm::dvec3(0.0), scene.background);

    const examples::ReferenceTracer tracer(scene, at);
    const mirrorball::MapInfo& info = mirrorball::mapInfo(desc.map);
    const int width = info.widthInN * desc.n, height = info.heightInN * desc.n;
    Exactness total;
    std::mutex mutex;
    for (int layer = 0; layer < info.components; ++layer)
        examples::forEachRow(height, [&](int row) {
            Exactness part;
            for (int column = 0; column < width; ++column) {
                const glm::dvec3 ray =
                    worldFromProbe * examples::referenceRay(info.name, layer, column, row, width, height);
                const glm::dvec3 direction = glm::normalize(ray);
                const examples::Hit hit =
                    tracer.trace(at, ray, static_cast<double>(probe.near()), static_cast<double>(desc.far));
                const std::size_t texel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(column);
                const examples::Sample& sample = layers[static_cast<std::size_t>(layer)][texel];
                Seen shown, traced;
                // As near as float tells, what lies at `near` or `far` may be drawn or not.
                const auto isAtLimit = [&](double distance) {
                    return std::abs(distance - static_cast<double>(probe.near())) <
                               1e-6 * static_cast<double>(probe.near()) ||
                           std::abs(distance - static_cast<double>(desc.far)) <
                               1e-6 * static_cast<double>(desc.far);
                };
                if (isAtLimit(hit.distance) || isAtLimit(static_cast<double>(sample.distance))) {
                    part.texels += 1;
                    continue;
                }
                if (!std::isinf(sample.distance))
                    shown = {static_cast<std::uint32_t>(sample.colour.x + 0.5),
                             static_cast<double>(sample.distance)};
                if (hit.found)
                    traced = {hit.triangle, hit.distance};
                compare(part, scene, at, direction, shown, traced);
            }
            const std::lock_guard lock(mutex);
            add(total, part);
        });
    return total;
}

} // namespace tests
