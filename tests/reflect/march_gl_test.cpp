// The march of `distance` and `layered` finds the same whether it begins at the mirror or where the map's nearest
// distances let it, for rays that come nearer to the centre first exactly so; and every function of the snippet shows
// what it found.
#include "support/check.h"
#include "support/sampling.h"

#include "gl_scene.h"

#include <mirrorball/headless/context.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>
#include <random>

using namespace mirrorball;

namespace {

// Crowded: 128 objects in a room, 4 to 13 from the centre.
ReflectionProbe crowdAround(int layersOfDepth)
{
    const examples::Scene scene = examples::loadScene("builtin:crowd:3000");
    ReflectionProbe probe({.n = 128, .near = 0.1f, .layersOfDepth = layersOfDepth});
    const examples::GlScene drawable(scene, glm::dvec3(0.0));
    CaptureProgram program = examples::phongCaptureProgram();
    probe.capture(drawable.captureMeshes(program), [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        drawable.drawMesh(mesh.id, draw.program, {});
    });
    return probe;
}

std::vector<glm::vec4> randomDirections(std::size_t count)
{
    std::mt19937 random(7);
    std::normal_distribution<float> part;
    std::vector<glm::vec4> directions;
    while (directions.size() < count)
        directions.emplace_back(glm::normalize(glm::vec3(part(random), part(random), part(random))), 0.0f);
    return directions;
}

// From the middle of a mirror's side and from the far end of a long mirror.
const glm::vec3 starts[] = {{0.5f, 0.0f, 0.0f}, {0.0f, 2.0f, 2.0f}, {0.0f, -3.5f, 0.0f}, {-6.0f, 0.5f, 1.0f}};

void testBegins(const ReflectionMap& map, Lookup lookup, const std::vector<glm::vec4>& directions)
{
    CHECK(map.nearestLevel > 0);
    ReflectionMap fromMirror = map;
    fromMirror.nearestLevel = 0;
    const tests::SamplingProgram program({.lookup = lookup},
                                         "vec4(normalize(mirrorball_shown(start, direction.xyz).xyz), 1.0)",
                                         "uniform vec3 start;\n");
    for (const glm::vec3& start : starts) {
        glUseProgram(program.name());
        glUniform3f(glGetUniformLocation(program.name(), "start"), start.x, start.y, start.z);
        const std::vector<glm::vec4> ahead = program.draw(map, directions, 128);
        const std::vector<glm::vec4> atMirror = program.draw(fromMirror, directions, 128);
        int inwards = 0, outwards = 0, others = 0, moved = 0;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const float off = glm::length(glm::vec3(ahead[i] - atMirror[i]));
            if (glm::dot(start, glm::vec3(directions[i])) < 0.0f) {
                ++inwards;
                CHECK(off == 0.0f);
            } else {
                ++outwards;
                others += off > 0.02f ? 1 : 0;
                moved += off > 0.0f ? 1 : 0;
            }
        }
        std::printf("from %4.1f %4.1f %4.1f: %d rays inwards, %d outwards, %d of them end elsewhere\n",
                    static_cast<double>(start.x), static_cast<double>(start.y), static_cast<double>(start.z),
                    inwards, outwards, others);
        CHECK(inwards > 1000 && outwards > 1000);
        // At edges, and what is thinner than a step: 2.3 % at most were found.
        CHECK(others * 33 < outwards);
        // Near the centre the nearest distances do let rays begin later.
        CHECK(glm::length(start) > 3.0f || moved > 0);
    }
}

void testFunctionsAgree(const ReflectionMap& map, const std::vector<glm::vec4>& directions)
{
    const ReflectionMaterial layered{.lookup = Lookup::layered, .detail = LevelOfDetail::first};
    const std::string start = "vec3(0.0, 2.0, 2.0)";
    const tests::SamplingProgram layer(layered, "vec4(mirrorball_shown(" + start + ", direction.xyz).w)");
    const tests::SamplingProgram byLevel(layered,
                                         "mirrorball_lookUpLevel(" + start + ", direction.xyz, 0.0)");
    const tests::SamplingProgram plain(layered, "mirrorball_lookUp(" + start + ", direction.xyz)");
    const std::vector<glm::vec4> layers = layer.draw(map, directions, 128);
    CHECK(std::count_if(layers.begin(), layers.end(), [](const glm::vec4& each) { return each.x > 0.5f; }) >
          50);
    CHECK(byLevel.draw(map, directions, 128) == plain.draw(map, directions, 128));
}

} // namespace

int main()
{
    const headless::Context context;
    const ReflectionProbe probe = crowdAround(2), oneLayer = crowdAround(1);
    const std::vector<glm::vec4> directions = randomDirections(16384);
    testBegins(oneLayer.map(), Lookup::distance, directions);
    testBegins(probe.map(), Lookup::distance, directions);
    testBegins(probe.map(), Lookup::layered, directions);
    testFunctionsAgree(probe.map(), directions);
    return 0;
}
