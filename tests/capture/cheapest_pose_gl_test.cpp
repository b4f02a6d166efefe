// A probe turned by cheapestPose sends fewer triangles, as counted, from the same place, and sees the same.
#include "support/check.h"
#include "support/exactness.h"

#include "gl_scene.h"

#include <mirrorball/headless/context.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cstdio>

using namespace mirrorball;

namespace {

CaptureReport captured(ReflectionProbe& probe, const examples::GlScene& scene,
                       const std::vector<CaptureMesh>& meshes)
{
    return probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        scene.drawMesh(mesh.id, draw.program, {});
    });
}

struct Found
{
    CaptureReport before, after;
    glm::dmat4 pose;
};

Found turned(const examples::Scene& scene, const ReflectionProbe::Desc& desc)
{
    const examples::GlScene drawable(scene, desc.captureOrigin);
    CaptureProgram program = examples::phongCaptureProgram();
    const std::vector<CaptureMesh> meshes = drawable.captureMeshes(program);
    ReflectionProbe probe(desc);
    Found found;
    found.before = captured(probe, drawable, meshes);
    found.pose = probe.cheapestPose(meshes);
    CHECK(probe.desc().worldFromProbe == desc.worldFromProbe); // nothing is set
    probe.setPose(found.pose);
    found.after = captured(probe, drawable, meshes);
    CHECK(probe.cheapestPose({}) == found.pose); // of nothing, nothing is better
    return found;
}

// Place and scale stay; what is left is a rotation.
void checkPose(const glm::dmat4& before, const glm::dmat4& after)
{
    CHECK(before[3] == after[3]);
    const glm::dmat3 turn = glm::inverse(glm::dmat3(before)) * glm::dmat3(after);
    const glm::dmat3 unit = glm::transpose(turn) * turn;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            CHECK_NEAR(unit[column][row], column == row ? 1.0 : 0.0, 1e-12);
    CHECK(glm::determinant(turn) > 0.0);
}

void checkSendsLess(const std::string& name, MapKind map)
{
    const examples::Scene scene = examples::loadScene(name);
    const glm::dmat4 pose =
        glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.2, 0.3)), glm::dvec3(1.5));
    const Found found =
        turned(scene, {.map = map, .n = 32, .worldFromProbe = pose, .near = 0.1f, .mipLevels = false});
    std::printf("%-20s %-18s %zu triangles sent, %zu turned; %d draws, %d\n", name.c_str(),
                std::string(mapInfo(map).name).c_str(), found.before.triangles, found.after.triangles,
                found.before.draws, found.after.draws);
    checkPose(pose, found.pose);
    CHECK(found.after.triangles <= found.before.triangles);
    // At least a tenth of what the seams make dearer than one draw of each.
    const auto excess = [&](const CaptureReport& report) {
        return static_cast<double>(report.triangles) - static_cast<double>(scene.triangleCount());
    };
    if (mapInfo(map).components > 1)
        CHECK(excess(found.after) < 0.9 * excess(found.before));
}

// What the turned probe shows is what the trace sees in the texels' turned directions.
void checkSeesTheSame()
{
    const examples::Scene scene = examples::loadScene("builtin:room");
    const Found found = turned(scene, {.map = MapKind::tennisBall, .n = 32, .near = 0.1f});
    CHECK(found.pose != glm::dmat4(1.0));
    const tests::Exactness exactness = tests::exactnessOf(scene, glm::dvec3(0.0),
                                                          {.map = MapKind::tennisBall,
                                                           .n = 64,
                                                           .worldFromProbe = found.pose,
                                                           .near = 0.1f,
                                                           .method = CaptureMethod::exact});
    CHECK(exactness.wrongPercent() <= 0.01 && exactness.wrongFarOff == 0 && exactness.shown > 0);
}

} // namespace

int main()
{
    const headless::Context context;
    for (const MapKind map : {MapKind::tennisBall, MapKind::dualParaboloid, MapKind::cube,
                              MapKind::octahedral, MapKind::equirectangular})
        for (const char* const name : {"builtin:crowd:12000", "builtin:room"})
            checkSendsLess(name, map);
    checkSeesTheSame();
}
