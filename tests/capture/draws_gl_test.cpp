// What draws of a view have in common is set once. It holds for the next draw where the callback ends with no program,
// and captures with another probe and the same program meanwhile; where meshes differ in culling; and is the same that
// a host gets that has everything set for each draw.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/gl_state.h"
#include "support/wall_patches.h"

#include <mirrorball/headless/context.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace mirrorball;

namespace {

std::vector<float> colours(const ReflectionProbe& probe)
{
    return tests::readMap(probe.map().colourTexture, probe.map().map, probe.map().n);
}

std::vector<float> distances(const ReflectionProbe& probe)
{
    return tests::readMap(probe.map().distanceTexture, probe.map().map, probe.map().n);
}

void checkDrawsInARow(const tests::WallPatches& walls, const tests::CapturePath& path)
{
    CaptureProgram program({.vertexSource = tests::plainVertex, .fragmentSource = R"(#version 330 core
in vec3 positionInWorld;
out vec4 colour;
void main() { colour = vec4(positionInWorld, gl_FrontFacing ? 1.0 : 0.5); }
)"});
    std::vector<CaptureMesh> meshes = tests::WallPatches::meshes(program);
    for (std::size_t index = 0; index < meshes.size(); index += 2)
        meshes[index].cullBackFaces = true; // of every second wall all are seen from behind
    ReflectionProbe quiet(tests::descOf(path)), busy(tests::descOf(path)), own(tests::descOf(path));
    ReflectionProbe::Desc desc = tests::descOf(path, 4);
    desc.worldFromProbe[3] = glm::dvec4(0.3, 0.2, -0.1, 1.0);
    ReflectionProbe other(desc);
    const auto draw = [&](const CaptureMesh& mesh, const CaptureDraw& asked) {
        walls.draw(mesh.id, asked.primitive);
    };
    quiet.capture(meshes, draw);
    busy.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& asked) {
        draw(mesh, asked);
        if (mesh.id % 8 == 0)
            other.capture(std::span(meshes).first(3), draw);
        glUseProgram(0);
    });
    own.capture([&](CaptureView& view) {
        for (const CaptureMesh& mesh : meshes)
            if (view.touches(*mesh.bounds)) {
                view.use(mesh);
                walls.draw(mesh.id, path.method == CaptureMethod::tessellated ? GL_PATCHES : GL_TRIANGLES);
            }
    });
    const std::vector<float> expected = distances(own);
    CHECK(std::ranges::count_if(expected, [](float d) { return std::isinf(d); }) > 0);
    for (const ReflectionProbe* const probe : {&quiet, &busy}) {
        const bool isSame =
            tests::sameBits(colours(*probe), colours(own)) && tests::sameBits(distances(*probe), expected);
        if (!isSame)
            std::printf("%s, method %d, layers %d: %s\n", std::string(mapInfo(path.map).name).c_str(),
                        static_cast<int>(path.method), static_cast<int>(path.layers),
                        probe == &quiet ? "quiet" : "busy");
        CHECK(isSame);
    }
}

} // namespace

int main()
{
    const headless::Context context;
    const tests::WallPatches walls;
    for (const tests::CapturePath& path : tests::capturePaths())
        checkDrawsInARow(walls, path);
    CHECK(tests::takeErrors().empty());
    return 0;
}
