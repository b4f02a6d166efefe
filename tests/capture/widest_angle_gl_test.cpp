// A host's word that no triangle spans more than a few degrees, where bounds cannot tell, chooses another program and
// changes no bit of the map: not where it is true, of walls around the probe in small triangles, and not where it is false,
// of walls of twelve.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/wall_patches.h"

#include "gl_scene.h"

#include <mirrorball/headless/context.h>

#include <limits>
#include <set>

using namespace mirrorball;

namespace {

struct Captured
{
    std::vector<float> colour, distance;
    std::set<unsigned int> programs;
};

template <typename Draw>
Captured captured(MapKind map, std::vector<CaptureMesh> meshes, std::optional<float> widestAngle,
                  const Draw& draw)
{
    ReflectionProbe probe({.map = map,
                           .n = 32,
                           .near = 0.1f,
                           .colour = ColourFormat::rgba32f,
                           .mipLevels = false,
                           .method = CaptureMethod::exact});
    for (CaptureMesh& mesh : meshes) {
        mesh.bounds.reset();
        mesh.widestAngle = widestAngle;
    }
    Captured result;
    probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& asked) {
        result.programs.insert(asked.program);
        draw(mesh, asked);
    });
    result.colour = tests::readMap(probe.map().colourTexture, map, probe.map().n);
    result.distance = tests::readMap(probe.map().distanceTexture, map, probe.map().n);
    return result;
}

template <typename Draw>
void check(MapKind map, const std::vector<CaptureMesh>& meshes, float promise, const Draw& draw)
{
    const Captured untold = captured(map, meshes, std::nullopt, draw);
    const Captured told = captured(map, meshes, promise, draw);
    CHECK(tests::sameBits(told.colour, untold.colour) && tests::sameBits(told.distance, untold.distance));
    CHECK(untold.programs.size() == 1 && told.programs.size() == 1);
    CHECK(told.programs != untold.programs);
    // What is too wide, or no number, is as good as nothing.
    for (const float useless : {0.27f, std::numeric_limits<float>::quiet_NaN()})
        CHECK(captured(map, meshes, useless, draw).programs == untold.programs);
}

} // namespace

int main()
{
    const headless::Context context;
    const tests::WallPatches walls;
    CaptureProgram plain({.vertexSource = tests::plainVertex, .fragmentSource = R"(#version 330 core
in vec3 positionInWorld;
out vec4 colour;
void main() { colour = vec4(positionInWorld, 1.0); }
)"});
    const examples::Scene scene = examples::loadScene("builtin:room");
    const examples::GlScene room(scene, {0.1, 0.333, 0.01}); // where no texel lies on an edge
    CaptureProgram phong = examples::phongCaptureProgram();
    for (const MapInfo& info : maps()) {
        // The longest edge is 0.48 long and 2 away at least.
        check(info.kind, tests::WallPatches::meshes(plain), 0.24f,
              [&](const CaptureMesh& mesh, const CaptureDraw& draw) { walls.draw(mesh.id, draw.primitive); });
        check(info.kind, room.captureMeshes(phong), 0.0f,
              [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
                  room.drawMesh(mesh.id, draw.program, {});
              });
    }
    return 0;
}
