#define GLM_ENABLE_EXPERIMENTAL
// Nothing is flipped or mirrored: six coloured walls around a probe come out at the right texel of every map
// and in the right place of a mirror, with the probe, the material and the camera all turned.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/gl_state.h"
#include "support/six_walls.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/headless/context.h>
#include <mirrorball/reflect/probe_binding.h>
#include <mirrorball/reflect/reflection_material.h>

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/gtx/component_wise.hpp>

#include <cstdio>

using namespace mirrorball;

namespace {

constexpr int n = 64;
// A texel is about 1.4 degrees at n = 64; nearer than three of them to a change of colour nothing is asked.
// The tangent coordinates of SixWalls change by at most 2 a radian.
constexpr double margin = 3 * 0.05;

const glm::dvec3 centre(0.3, -0.2, 0.1);

glm::dmat4 turnedPose()
{
    glm::dmat4 pose = glm::translate(glm::dmat4(1.0), centre);
    pose = glm::rotate(pose, 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
    return glm::scale(pose, glm::dvec3(0.5));
}

glm::dmat3 turned(double angle, const glm::dvec3& axis)
{
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), angle, glm::normalize(axis)));
}

// perVertex cannot draw a triangle across the cut or a singular point of these two maps.
bool isNearCut(MapKind map, const glm::dvec3& unitDirection)
{
    if (map == MapKind::sphereMap)
        return unitDirection.z < -0.3;
    // A sixteenth of the map is 22.5 degrees of longitude on both sides of the cut at +z.
    return map == MapKind::equirectangular &&
           (std::abs(unitDirection.y) > 0.9 || std::abs(unitDirection.x) < 0.42 * unitDirection.z);
}

bool isNear(const glm::vec3& a, const glm::vec3& b)
{
    return glm::length(a - b) < 0.01f;
}

void checkMap(const ReflectionProbe& probe, const char* what)
{
    const MapInfo& info = mapInfo(probe.desc().map);
    const int width = info.widthInN * n, height = info.heightInN * n;
    const glm::dmat3 worldFromProbe = glm::dmat3(probe.map().worldFromProbe);
    int compared = 0, wrong = 0;
    for (int layer = 0; layer < info.components; ++layer) {
        const std::vector<float> colour =
            tests::readTextureLayer(probe.map().colourTexture, layer, width, height);
        const std::vector<float> distance =
            tests::readTextureLayer(probe.map().distanceTexture, layer, width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::dvec2 uv((x + 0.5) / width, (y + 0.5) / height);
                const glm::dvec3 direction = directionFromSquare(info.kind, layer, uv);
                if (componentOf(info.kind, direction) != layer)
                    continue;
                const glm::dvec3 inWorld = worldFromProbe * direction;
                if (isNearCut(info.kind, direction))
                    continue;
                if (tests::SixWalls::marginInDirection(inWorld) < margin)
                    continue;
                const std::size_t texel = 4 * static_cast<std::size_t>(y * width + x);
                const glm::vec3 shown(colour[texel], colour[texel + 1], colour[texel + 2]);
                // The walls stand at distance 2.
                const double expected = 2.0 / glm::compMax(glm::abs(inWorld));
                ++compared;
                wrong += isNear(shown, tests::SixWalls::colourInDirection(inWorld)) ? 0 : 1;
                wrong += std::abs(static_cast<double>(distance[texel]) - expected) < 0.02 ? 0 : 1;
            }
    }
    std::printf("%s, %s: %d texels compared, %d wrong\n", std::string(info.name).c_str(), what, compared,
                wrong);
    CHECK(compared > info.components * width * height / 8);
    CHECK(wrong == 0);
}

// A mirror ball seen by an orthographic camera: pixel (x, y) in [-1, 1]² of the disc has the normal (x, y,
// z).
const char* const mirrorFragment = R"(
in vec2 uv;
uniform mat3 worldFromView;
uniform bool inView;
out vec4 colour;
void main()
{
    vec2 p = 2.0 * uv - 1.0;
    vec3 normal = vec3(p, sqrt(max(1.0 - dot(p, p), 0.0)));
    vec3 position = vec3(p, -5.0);
    colour = inView ? mirrorball_reflectionInView(position, 3.0 * normal)
                    : mirrorball_reflection(worldFromView * position, worldFromView * normal, vec3(0.0));
}
)";

void checkMirror(const ReflectionProbe& probe)
{
    constexpr int pixels = 128;
    const MapKind map = probe.desc().map;
    const std::string fragment = "#version 330 core\n" + reflectionGlsl({.map = map}) + mirrorFragment;
    const GLuint program = tests::makeProgram(tests::fullScreenVertexSource, fragment);
    const tests::ColourTarget target(pixels, pixels);
    const glm::dmat3 worldFromView = turned(-1.1, {0.2, 1.0, 0.3});
    const glm::dmat3 material = turned(0.9, {1.0, -0.4, 0.6});
    ProbeBinding binding(program, 3);
    for (const bool inView : {false, true}) {
        target.bind();
        glUseProgram(program);
        glUniformMatrix3fv(glGetUniformLocation(program, "worldFromView"), 1, GL_FALSE,
                           glm::value_ptr(glm::mat3(worldFromView)));
        glUniform1i(glGetUniformLocation(program, "inView"), inView ? 1 : 0);
        {
            const auto bound =
                binding.bind(probe.map(), {.probeFromWorld = glm::mat3(material),
                                           .worldFromView = glm::mat4(glm::mat3(worldFromView)),
                                           .filtering = Filtering::nearest});
            tests::drawFullScreenTriangle();
        }
        const std::vector<float> image = target.read();
        int compared = 0, wrong = 0;
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) {
                const glm::dvec2 p(2.0 * (x + 0.5) / pixels - 1.0, 2.0 * (y + 0.5) / pixels - 1.0);
                if (glm::length(p) > 0.95)
                    continue;
                const glm::dvec3 normal(p, std::sqrt(1.0 - glm::dot(p, p)));
                const glm::dvec3 toEye = -glm::dvec3(p, -5.0);
                const glm::dvec3 inViewSpace = 2.0 * glm::dot(normal, toEye) * normal - toEye;
                // What the map holds in direction d of the probe is the wall in worldFromProbe d; the
                // material turns the world before it enters the map.
                const glm::dvec3 inMap = material * (worldFromView * inViewSpace);
                const glm::dvec3 inProbe = glm::transpose(glm::dmat3(probe.map().worldFromProbe)) * inMap;
                const glm::dvec3 unit = glm::normalize(inProbe);
                if (tests::SixWalls::marginInDirection(inMap) < margin || isNearCut(map, unit))
                    continue;
                const std::size_t pixel = 4 * static_cast<std::size_t>(y * pixels + x);
                ++compared;
                wrong += isNear({image[pixel], image[pixel + 1], image[pixel + 2]},
                                tests::SixWalls::colourInDirection(inMap))
                             ? 0
                             : 1;
            }
        CHECK(compared > pixels * pixels / 8);
        CHECK(wrong == 0);
    }
    glUseProgram(0);
    glDeleteProgram(program);
}

} // namespace

int main()
{
    const headless::Context context;
    const tests::SixWalls walls{glm::vec3(centre)};
    for (const MapInfo& info : maps())
        for (const LayerOrder layers : {LayerOrder::oneAtATime, LayerOrder::allAtOnce}) {
            ReflectionProbe probe({.map = info.kind,
                                   .n = n,
                                   .worldFromProbe = turnedPose(),
                                   .near = 0.1f,
                                   .far = 50.0f,
                                   .layers = layers});
            const CaptureMesh mesh = walls.mesh();
            const auto changes = tests::changesBy([&] {
                probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw&) { walls.draw(); });
            });
            for (const std::string& change : changes)
                std::printf("state changed: %s\n", change.c_str());
            CHECK(changes.empty());
            checkMap(probe, layers == LayerOrder::oneAtATime ? "one at a time" : "all at once");
            checkMirror(probe);
        }
    CHECK(tests::takeErrors().empty());
    return 0;
}
