// Whatever state the host has left its context in, a capture gives the same map, bit for bit, and leaves that
// state as it was: each hostile state alone, many at random, when the callback throws, and when the call is
// refused.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/gl_state.h"
#include "support/hostile_state.h"
#include "support/six_walls.h"

#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>
#include <mirrorball/reflect/image_map.h>
#include <mirrorball/reflect/probe_binding.h>
#include <mirrorball/reflect/reflection_material.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace mirrorball;

namespace {

constexpr int n = 16;

std::vector<float> image(const ReflectionProbe& probe)
{
    std::vector<float> all;
    for (const unsigned int texture : {probe.map().colourTexture, probe.map().distanceTexture}) {
        const auto texels = tests::readMap(texture, probe.desc().map, n);
        all.insert(all.end(), texels.begin(), texels.end());
    }
    return all;
}

void report(const std::vector<std::string>& changes, const std::string& when)
{
    for (const std::string& change : changes)
        std::printf("%s: %s\n", when.c_str(), change.c_str());
    CHECK(changes.empty());
}

struct Fixture
{
    tests::SixWalls walls{glm::vec3(0.0f), 8};
    ReflectionProbe probe;
    std::vector<float> expected;

    Fixture(MapKind map, CaptureMethod method, LayerOrder layers)
        : probe({.map = map, .n = n, .near = 0.1f, .far = 50.0f, .method = method, .layers = layers})
    {
        capture();
        expected = image(probe);
    }

    void capture()
    {
        const CaptureMesh mesh = walls.mesh();
        probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw&) { walls.draw(); });
    }
};

void checkHostile(Fixture& fixture, tests::HostileState& hostile, const std::vector<std::string>& chosen,
                  const std::string& name)
{
    hostile.apply(chosen);
    report(tests::changesBy([&] { fixture.capture(); }), name);
    hostile.undo();
    if (!tests::sameBits(image(fixture.probe), fixture.expected)) {
        std::printf("%s: another image\n", name.c_str());
        CHECK(false);
    }
}

void checkRefusals(Fixture& fixture, tests::HostileState& hostile)
{
    struct Thrown
    {
    };
    const CaptureMesh mesh = fixture.walls.mesh();
    const auto throwing = [&](const CaptureMesh&, const CaptureDraw&) { throw Thrown(); };
    report(tests::changesBy([&] {
               try {
                   fixture.probe.capture({&mesh, 1}, throwing);
                   CHECK(false);
               } catch (const Thrown&) {
               }
           }),
           "a callback that throws");
    CHECK(tests::sameBits(image(fixture.probe), fixture.expected)); // the last good map stays

    const auto reentrant = [&](const CaptureMesh&, const CaptureDraw&) {
        CHECK_THROWS(fixture.capture(), ErrorKind::hostBusy);
    };
    fixture.probe.capture({&mesh, 1}, reentrant);
    fixture.capture();

    CaptureMesh unprogrammed = mesh;
    unprogrammed.program = nullptr;
    report(tests::changesBy([&] {
               CHECK_THROWS(fixture.probe.capture({&unprogrammed, 1}, throwing), ErrorKind::badArgument);
           }),
           "a mesh without a program");

    hostile.beginTransformFeedback();
    report(tests::changesBy([&] { CHECK_THROWS(fixture.capture(), ErrorKind::hostBusy); }),
           "transform feedback");
    hostile.undo();
    CHECK(tests::sameBits(image(fixture.probe), fixture.expected));
}

void checkDescs()
{
    const auto refused = [](const ReflectionProbe::Desc& desc) {
        report(tests::changesBy([&] { CHECK_THROWS(ReflectionProbe{desc}, ErrorKind::badArgument); }),
               "a bad Desc");
    };
    refused({.n = 0});
    refused({.n = -5});
    refused({.n = 1 << 20});
    refused({.near = 0.0f});
    refused({.near = 2.0f, .far = 1.0f});
    refused({.near = std::nanf("")});
    refused({.halfExtent = -1.0});
    refused({.epsilon = 0.0f});
    refused({.worldFromProbe = glm::dmat4(std::nan(""))});
    refused({.worldFromProbe = glm::dmat4(0.0)});
    refused({.captureOrigin = glm::dvec3(std::nan(""))});
    refused({.background = {0.0f, std::nanf(""), 0.0f, 1.0f}});
    refused({.background = {0.0f, 0.0f, 0.0f, std::numeric_limits<float>::infinity()}});
    refused({.map = MapKind::cube, .method = CaptureMethod::perVertex, .depthTerm = DepthTerm::textbook});
}

void checkBinding(Fixture& fixture)
{
    const std::string fragment =
        "#version 330 core\n" + reflectionGlsl({.map = fixture.probe.desc().map}) +
        "in vec2 uv; out vec4 colour;\n"
        "void main() { colour = mirrorball_reflection(vec3(0), vec3(uv, 1), vec3(0, 0, 5)); }\n";
    const GLuint program = tests::makeProgram(tests::fullScreenVertexSource, fragment);
    report(tests::changesBy([&] { const ProbeBinding binding(program); }), "making a binding");
    const ProbeBinding binding(program, 5);
    // The uniforms of the host's program change on purpose; nothing else does once the bound textures are let
    // go.
    report(tests::changesBy([&] { const auto bound = binding.bind(fixture.probe.map()); }), "binding");
    CHECK_THROWS(ProbeBinding(program, 100000), ErrorKind::badArgument);
    CHECK_THROWS(ProbeBinding(0), ErrorKind::badArgument);
    const std::vector<float> pixels(6 * 4, 0.5f);
    report(tests::changesBy([&] { const ImageMap map(MapKind::cube, 1, pixels); }), "an image map");
    report(
        tests::changesBy([&] { CHECK_THROWS(ImageMap(MapKind::cube, 2, pixels), ErrorKind::badArgument); }),
        "an image map of the wrong size");
    glDeleteProgram(program);
}

} // namespace

int main(int argc, char** argv)
{
    // Random combinations of states a case; fewer where drawing is slow.
    const std::uint32_t seeds = argc > 1 ? static_cast<std::uint32_t>(std::atoi(argv[1])) : 60;
    const char* const profile = std::getenv("MIRRORBALL_TEST_COMPATIBILITY");
    const headless::Context context({.compatibility = profile != nullptr});
    tests::HostileState hostile;
    struct Case
    {
        MapKind map;
        CaptureMethod method;
        LayerOrder layers;
    };
    const Case cases[] = {{MapKind::tennisBall, CaptureMethod::automatic, LayerOrder::oneAtATime},
                          {MapKind::octahedral, CaptureMethod::automatic, LayerOrder::allAtOnce},
                          {MapKind::dualParaboloid, CaptureMethod::perVertex, LayerOrder::oneAtATime},
                          {MapKind::equiAngularCube, CaptureMethod::exact, LayerOrder::allAtOnce}};
    for (const Case& each : cases) {
        Fixture fixture(each.map, each.method, each.layers);
        for (const std::string& name : hostile.names())
            checkHostile(fixture, hostile, {name}, name);
        for (std::uint32_t seed = 0; seed < seeds; ++seed)
            checkHostile(fixture, hostile, hostile.random(seed),
                         "random states, seed " + std::to_string(seed));
        checkRefusals(fixture, hostile);
        checkBinding(fixture);
    }
    checkDescs();
    CHECK(tests::takeErrors().empty());
    std::printf("%zu hostile states, each alone and at random\n", hostile.names().size());
    return 0;
}
