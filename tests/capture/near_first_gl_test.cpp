// Where a host allows it, many meshes that are drawn exactly are drawn from near to far, and what lies behind is left
// out: no primitive of it reaches the rasteriser, every texel is the same bit for bit, and the host finds its state
// between draws as it left it.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/gl_state.h"

#include "gl_scene.h"

#include <mirrorball/headless/context.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstdio>
#include <map>
#include <set>
#include <utility>

using namespace mirrorball;

namespace {

constexpr int n = 128;

examples::Mesh boxAt(const std::string& name, const glm::vec3& centre, const glm::vec3& half)
{
    examples::Mesh mesh;
    mesh.name = name;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 side(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f);
        mesh.positions.push_back(centre + half * side);
        mesh.normals.push_back(glm::normalize(side));
        mesh.textureCoordinates.push_back({0.0f, 0.0f});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

// From the origin: 8 boxes below, a wall in +z and far behind it 12 x 12 boxes, which come first in the host's order;
// the outermost columns are seen past the wall's edges.
examples::Scene wallAndBoxes()
{
    examples::Scene scene;
    scene.materials.push_back({.name = "grey"});
    for (int row = 0; row < 12; ++row)
        for (int column = 0; column < 12; ++column)
            scene.meshes.push_back(
                boxAt("behind", {1.6f * column - 8.8f, 0.9f * row - 4.95f, 20.0f}, glm::vec3(0.3f)));
    scene.meshes.push_back(boxAt("beside", {-20.0f, 0.3f, 0.2f}, glm::vec3(2.0f)));
    for (int index = 0; index < 8; ++index)
        scene.meshes.push_back(boxAt("before", {0.3f * index - 1.05f, -1.0f, 0.1f}, glm::vec3(0.1f)));
    scene.meshes.push_back(boxAt("wall", {0.0f, 0.0f, 3.0f}, {1.2f, 4.0f, 0.1f}));
    return scene;
}

struct Captured
{
    std::vector<float> texels;      // colours and distances, those of the second layer too
    std::vector<std::size_t> order; // of meshes, as they were drawn into view 0
    std::map<std::pair<std::size_t, int>, long>
        drawn; // primitives that left the geometry stage: by mesh and view
};

Captured captured(const examples::Scene& scene, ReflectionProbe::Desc desc, bool nearFirst)
{
    desc.nearFirst = nearFirst;
    ReflectionProbe probe(desc);
    const examples::GlScene drawable(scene, desc.captureOrigin);
    CaptureProgram program = examples::phongCaptureProgram();
    GLuint query = 0;
    glGenQueries(1, &query);
    Captured result;
    probe.capture(drawable.captureMeshes(program), [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        if (draw.view == 0)
            result.order.push_back(mesh.id);
        glBeginQuery(GL_CLIPPING_INPUT_PRIMITIVES_ARB, query);
        drawable.drawMesh(mesh.id, draw.program, {});
        glEndQuery(GL_CLIPPING_INPUT_PRIMITIVES_ARB);
        GLint64 primitives = 0;
        glGetQueryObjecti64v(query, GL_QUERY_RESULT, &primitives);
        result.drawn[{mesh.id, draw.view}] += primitives;
    });
    glDeleteQueries(1, &query);
    const ReflectionMap& map = probe.map();
    for (const auto& [texture, size] :
         {std::pair(map.colourTexture, map.n), std::pair(map.distanceTexture, map.n),
          std::pair(map.hiddenColourTexture, map.hiddenN), std::pair(map.hiddenDistanceTexture, map.hiddenN)})
    {
        const auto texels = texture == 0 ? std::vector<float>() : tests::readMap(texture, desc.map, size);
        result.texels.insert(result.texels.end(), texels.begin(), texels.end());
    }
    return result;
}

void checkSkips(const examples::Scene& scene, MapKind map, int supersample)
{
    const ReflectionProbe::Desc desc{.map = map,
                                     .n = n,
                                     .near = 0.05f,
                                     .supersample = supersample,
                                     .mipLevels = false,
                                     .method = CaptureMethod::exact};
    const Captured all = captured(scene, desc, false), skipped = captured(scene, desc, true);
    CHECK(all.texels == skipped.texels);
    std::set<std::size_t> left; // meshes behind the wall of which something is drawn
    long fewer = 0;
    for (const auto& [draw, primitives] : all.drawn) {
        const long those = skipped.drawn.at(draw);
        CHECK(those <= primitives);
        fewer += primitives - those;
        const bool isBehind = scene.meshes[draw.first].name == "behind";
        CHECK(isBehind || those == primitives || scene.meshes[draw.first].name == "wall");
        if (isBehind && those > 0)
            left.insert(draw.first);
    }
    std::printf("%-18s x%d: %ld primitives fewer, %zu of 144 boxes behind the wall are drawn\n",
                std::string(mapInfo(map).name).c_str(), supersample, fewer, left.size());
    // Two columns are seen; blocks of 8 texels, of 6 to 14 degrees, hold others beside the wall's edges.
    CHECK(left.size() >= 24);
    CHECK(left.size() <= 108);
}

void checkSecondLayer(const examples::Scene& scene)
{
    const ReflectionProbe::Desc desc{
        .n = n, .near = 0.05f, .mipLevels = false, .method = CaptureMethod::exact, .layersOfDepth = 2};
    CHECK(captured(scene, desc, false).texels == captured(scene, desc, true).texels);
}

void checkOrder(const examples::Scene& scene)
{
    const ReflectionProbe::Desc desc{
        .n = n, .near = 0.05f, .mipLevels = false, .method = CaptureMethod::exact};
    const auto distanceOf = [&](std::size_t index) {
        const std::vector<glm::vec3>& corners = scene.meshes[index].positions;
        return glm::length(0.5f * (corners[0] + corners[7]));
    };
    const std::vector<std::size_t> host = captured(scene, desc, false).order;
    CHECK(host.size() >= 32 && std::is_sorted(host.begin(), host.end()));
    const std::vector<std::size_t> near = captured(scene, desc, true).order;
    CHECK(near.size() == host.size());
    CHECK(std::is_sorted(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
        return distanceOf(a) < distanceOf(b) - 1e-4f;
    }));
    // Of few meshes the host's order is kept, and of all unless a host asks.
    CHECK(!ReflectionProbe::Desc().nearFirst);
    examples::Scene few = scene;
    few.meshes.erase(few.meshes.begin(), few.meshes.begin() + 136);
    const std::vector<std::size_t> order = captured(few, desc, true).order;
    CHECK(order.size() > 8 && std::is_sorted(order.begin(), order.end()));
}

// What the host sets once, in its first draw, it finds in every other one.
void checkStateBetweenDraws(const examples::Scene& scene)
{
    ReflectionProbe probe(
        {.n = n, .near = 0.05f, .method = CaptureMethod::exact, .nearFirst = true, .layersOfDepth = 2});
    const examples::GlScene drawable(scene, glm::dvec3(0.0));
    CaptureProgram program = examples::phongCaptureProgram();
    GLuint texture = 0, sampler = 0;
    glGenTextures(1, &texture);
    glGenSamplers(1, &sampler);
    int calls = 0;
    probe.capture(drawable.captureMeshes(program), [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        glActiveTexture(GL_TEXTURE0);
        if (calls++ == 0) {
            glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
            glBindSampler(0, sampler);
            glDepthFunc(GL_GEQUAL);
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
        }
        GLint array = 0, bound = 0, function = 0, depthTest = 0;
        GLboolean mask[4];
        glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &array);
        glGetIntegerv(GL_SAMPLER_BINDING, &bound);
        glGetIntegerv(GL_DEPTH_FUNC, &function);
        glGetIntegerv(GL_DEPTH_TEST, &depthTest);
        glGetBooleanv(GL_COLOR_WRITEMASK, mask);
        CHECK(array == static_cast<GLint>(texture) && bound == static_cast<GLint>(sampler));
        CHECK(function == GL_GEQUAL && depthTest == GL_TRUE && mask[2] == GL_TRUE && mask[3] == GL_FALSE);
        drawable.drawMesh(mesh.id, draw.program, {});
    });
    CHECK(calls > 300); // both layers of depth, 154 meshes in view 0 alone
    glBindSampler(0, 0);
    glDeleteTextures(1, &texture);
    glDeleteSamplers(1, &sampler);
}

// All of the host's state is the same after a capture that asks what is hidden.
void checkStateAfterwards(const examples::Scene& scene)
{
    ReflectionProbe probe(
        {.n = n, .near = 0.05f, .method = CaptureMethod::exact, .nearFirst = true, .layersOfDepth = 2});
    const examples::GlScene drawable(scene, glm::dvec3(0.0));
    CaptureProgram program = examples::phongCaptureProgram();
    const std::vector<CaptureMesh> meshes = drawable.captureMeshes(program);
    const auto bindNothing = [] {
        glBindVertexArray(0);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, 0);
    };
    bindNothing();
    const auto changes = tests::changesBy([&] {
        probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
            drawable.drawMesh(mesh.id, draw.program, {});
            bindNothing();
        });
    });
    for (const std::string& change : changes)
        std::printf("%s\n", change.c_str());
    CHECK(changes.empty());
}

} // namespace

int main()
{
    const headless::Context context;
    const examples::Scene scene = wallAndBoxes();
    for (const MapInfo& info : maps())
        for (const int supersample : {1, 2})
            checkSkips(scene, info.kind, supersample);
    checkSecondLayer(scene);
    checkOrder(scene);
    checkStateBetweenDraws(scene);
    checkStateAfterwards(scene);
}
