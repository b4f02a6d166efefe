// The second layer of depth is drawn only where something may hide something: the same layer comes out, of fewer draws.
#include "gl_scene.h"
#include "support/check.h"
#include "support/gl_image.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <cmath>
#include <cstdio>

using namespace mirrorball;

namespace {

struct Result
{
    CaptureReport report;
    std::vector<float> hidden; // distances
};

// What engines do that keep no state between draws.
void unbindTexturesOfAllUnits()
{
    GLint units = 0;
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    for (GLint unit = 0; unit < units; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    }
}

Result captureTwoLayers(const examples::GlScene& scene, const std::vector<CaptureMesh>& meshes,
                        bool unbinds = false)
{
    ReflectionProbe probe({.map = MapKind::tennisBall,
                           .n = 48,
                           .near = 0.1f,
                           .far = 100.0f,
                           .method = CaptureMethod::exact,
                           .layersOfDepth = 2});
    Result result;
    result.report = probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        scene.drawMesh(mesh.id, draw.program, {}, 1, draw.primitive);
        if (unbinds)
            unbindTexturesOfAllUnits();
    });
    result.hidden =
        tests::readMap(probe.map().hiddenDistanceTexture, MapKind::tennisBall, probe.map().hiddenN);
    return result;
}

// The objects of a crowd that are small from the probe, within walls 14 away: some of them hide others.
void checkCrowd()
{
    const examples::Scene scene = examples::loadScene("builtin:crowd:12000");
    const examples::GlScene drawable(scene, glm::dvec3(0.0));
    CaptureProgram program = examples::phongCaptureProgram();
    std::vector<CaptureMesh> meshes = drawable.captureMeshes(program);
    std::erase_if(meshes, [&](const CaptureMesh& mesh) {
        return scene.meshes[mesh.id].name != "walls" &&
               mesh.bounds->radius > 0.09f * glm::length(mesh.bounds->centre);
    });
    const Result some = captureTwoLayers(drawable, meshes);
    CHECK(captureTwoLayers(drawable, meshes, true).hidden == some.hidden);
    for (CaptureMesh& mesh : meshes) {
        CHECK(scene.meshes[mesh.id].name != "walls" || mesh.nearestDistance > 13.9f);
        mesh.nearestDistance.reset(); // the walls' sphere holds the probe: nothing is known
    }
    const Result all = captureTwoLayers(drawable, meshes);
    std::printf(
        "crowd: %zu meshes, %d draws of two layers, %d where only what may be hidden is drawn twice\n",
        meshes.size(), all.report.draws, some.report.draws);
    CHECK(all.hidden == some.hidden);
    std::size_t found = 0;
    for (std::size_t texel = 0; texel < some.hidden.size(); texel += 4)
        found += std::isfinite(some.hidden[texel]) ? 1 : 0;
    CHECK(found > 0); // something is hidden in this scene
    CHECK(some.report.draws < all.report.draws);
    CHECK(some.report.draws + some.report.drawsCulled == all.report.draws + all.report.drawsCulled);
}

// Spheres side by side hide nothing from the probe but their own backs, which lie within the separation.
void checkSideBySide()
{
    examples::Scene scene = examples::loadScene("builtin:crowd:12000");
    std::erase_if(scene.meshes, [](const examples::Mesh& mesh) { return mesh.name == "walls"; });
    const examples::GlScene drawable(scene, glm::dvec3(0.0));
    CaptureProgram program = examples::phongCaptureProgram();
    const std::vector<CaptureMesh> every = drawable.captureMeshes(program);
    std::vector<CaptureMesh> apart; // six far apart in direction, at most
    for (const CaptureMesh& mesh : every) {
        bool isFree = mesh.bounds->radius < 0.1f * glm::length(mesh.bounds->centre);
        for (const CaptureMesh& other : apart)
            isFree = isFree && glm::dot(glm::normalize(mesh.bounds->centre),
                                        glm::normalize(other.bounds->centre)) < 0.5f;
        if (isFree)
            apart.push_back(mesh);
    }
    CHECK(apart.size() >= 4);
    const Result result = captureTwoLayers(drawable, apart);
    std::printf("side by side: %zu meshes, %d draws\n", apart.size(), result.report.draws);
    // One layer's draws: at most one a mesh and view, and none for the second.
    CHECK(result.report.draws <= static_cast<int>(2 * apart.size()));
    CHECK(result.report.drawsCulled >= static_cast<int>(2 * apart.size()));
}

} // namespace

int main()
{
    const headless::Context context;
    checkCrowd();
    checkSideBySide();
}
