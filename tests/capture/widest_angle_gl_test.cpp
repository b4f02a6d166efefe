// A host's word that no triangle spans more than a few degrees, where bounds cannot tell, chooses another program and
// changes no bit of the map: not where it is true, of walls around the probe in small triangles, and not where it is
// false, of walls of twelve.
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
    // Colours and distances, of both layers of depth where there are two.
    std::vector<std::vector<float>> textures;
    std::set<unsigned int> programs;
};

ReflectionProbe::Desc descOf(MapKind map)
{
    return {.map = map,
            .n = 32,
            .near = 0.1f,
            .colour = ColourFormat::rgba32f,
            .mipLevels = false,
            .method = CaptureMethod::exact};
}

template <typename Draw>
Captured captured(const ReflectionProbe::Desc& desc, std::vector<CaptureMesh> meshes,
                  std::optional<float> widestAngle, const Draw& draw)
{
    ReflectionProbe probe(desc);
    for (CaptureMesh& mesh : meshes) {
        mesh.bounds.reset();
        mesh.widestAngle = widestAngle;
    }
    Captured result;
    probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& asked) {
        result.programs.insert(asked.program);
        draw(mesh, asked);
    });
    const ReflectionMap& map = probe.map();
    for (const unsigned int texture : {map.colourTexture, map.distanceTexture})
        result.textures.push_back(tests::readMap(texture, map.map, map.n));
    if (desc.layersOfDepth == 2)
        for (const unsigned int texture : {map.hiddenColourTexture, map.hiddenDistanceTexture})
            result.textures.push_back(tests::readMap(texture, map.map, map.hiddenN));
    return result;
}

template <typename Draw>
void check(const ReflectionProbe::Desc& desc, const std::vector<CaptureMesh>& meshes, float promise,
           const Draw& draw)
{
    const Captured untold = captured(desc, meshes, std::nullopt, draw);
    const Captured told = captured(desc, meshes, promise, draw);
    for (std::size_t index = 0; index < untold.textures.size(); ++index)
        CHECK(tests::sameBits(told.textures[index], untold.textures[index]));
    CHECK(told.programs.size() == untold.programs.size());
    CHECK(told.programs != untold.programs);
    // What is too wide, or no number, is as good as nothing.
    for (const float useless : {0.27f, std::numeric_limits<float>::quiet_NaN()})
        CHECK(captured(desc, meshes, useless, draw).programs == untold.programs);
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
    const auto checkBoth = [&](const ReflectionProbe::Desc& desc) {
        // The longest edge is 0.48 long and 2 away at least.
        check(desc, tests::WallPatches::meshes(plain), 0.24f,
              [&](const CaptureMesh& mesh, const CaptureDraw& draw) { walls.draw(mesh.id, draw.primitive); });
        check(desc, room.captureMeshes(phong), 0.0f, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
            room.drawMesh(mesh.id, draw.program, {});
        });
    };
    for (const MapInfo& info : maps())
        checkBoth(descOf(info.kind));
    ReflectionProbe::Desc desc = descOf(MapKind::tennisBall);
    desc.layers = LayerOrder::allAtOnce;
    checkBoth(desc);
    desc.layers = LayerOrder::oneAtATime;
    desc.layersOfDepth = 2;
    desc.nearFirst = true;
    checkBoth(desc);
    return 0;
}
