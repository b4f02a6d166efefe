// A binding changes the texture and the sampler of its own units, two or four, and the uniforms of its program; when it
// is let go, nothing. Whatever state the host has left its context in.
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

#include <cmath>
#include <cstdio>
#include <limits>
#include <type_traits>

using namespace mirrorball;

// It would put the units back while the new textures are wanted.
static_assert(!std::is_move_assignable_v<ProbeBinding::Bound>);

namespace {

constexpr int firstUnit = 5;

struct Fixture
{
    tests::SixWalls walls{glm::vec3(0.0f), 8};
    ReflectionProbe probe;
    GLuint program;
    int units;

    explicit Fixture(Lookup lookup, MapKind map = MapKind::tennisBall)
        : probe({.map = map,
                 .n = 16,
                 .near = 0.1f,
                 .far = 50.0f,
                 .layersOfDepth = lookup == Lookup::layered ? 2 : 1}),
          program(tests::makeProgram(tests::fullScreenVertexSource,
                                     "#version 330 core\n" + reflectionGlsl({.map = map, .lookup = lookup}) +
                                         "in vec2 uv; out vec4 colour;\n"
                                         "void main() { colour = mirrorball_reflection(vec3(uv - 0.5, 0.5), "
                                         "vec3(uv - 0.5, 1), vec3(0, 0, 5)); }\n")),
          units(lookup == Lookup::layered ? 4 : 2)
    {
        const CaptureMesh mesh = walls.mesh();
        probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw&) { walls.draw(); });
    }
    ~Fixture() { glDeleteProgram(program); }
    Fixture(const Fixture&) = delete;
    Fixture& operator=(const Fixture&) = delete;

    // Whether a line of GlState is of a texture or sampler of this binding's units.
    bool owns(const std::string& line) const
    {
        for (int unit = firstUnit; unit < firstUnit + units; ++unit)
            for (const char* const item :
                 {"GL_TEXTURE_2D_ARRAY", "GL_TEXTURE_BINDING_2D_ARRAY", "GL_SAMPLER_BINDING"})
                if (line.starts_with(item + ("[" + std::to_string(unit) + "]")))
                    return true;
        return false;
    }
};

void report(const std::vector<std::string>& changes, const std::string& when)
{
    for (const std::string& change : changes)
        std::printf("%s: %s\n", when.c_str(), change.c_str());
    CHECK(changes.empty());
}

int integer(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

// The textures of the map lie on the units in order, and nothing else of the context has changed.
void checkBound(const Fixture& fixture, const ProbeBinding& binding, const std::string& state)
{
    const tests::GlState before = tests::GlState::capture();
    {
        const auto bound = binding.bind(fixture.probe.map());
        std::vector<std::string> others;
        for (const std::string& line : tests::differences(before, tests::GlState::capture()))
            if (!fixture.owns(line))
                others.push_back(line);
        report(others, state + ", bound");

        const ReflectionMap& map = fixture.probe.map();
        const unsigned int expected[] = {map.filteredColourTexture, map.distanceTexture,
                                         map.hiddenColourTexture, map.hiddenDistanceTexture};
        const int active = integer(GL_ACTIVE_TEXTURE);
        for (int unit = 0; unit < fixture.units; ++unit) {
            glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + firstUnit + unit));
            CHECK(expected[unit] != 0);
            CHECK(integer(GL_TEXTURE_BINDING_2D_ARRAY) == static_cast<int>(expected[unit]));
            CHECK(integer(GL_SAMPLER_BINDING) != 0);
        }
        glActiveTexture(static_cast<GLenum>(active));
    }
    report(tests::differences(before, tests::GlState::capture()), state + ", let go");
    report(tests::takeErrors(), state + ", errors");
}

void checkUnderHostileStates(Lookup lookup, tests::HostileState& hostile)
{
    const Fixture fixture(lookup);
    const auto check = [&](const std::vector<std::string>& chosen, const std::string& name) {
        hostile.apply(chosen);
        report(tests::changesBy([&] { const ProbeBinding made(fixture.program, firstUnit); }),
               name + ", made");
        const ProbeBinding binding(fixture.program, firstUnit);
        checkBound(fixture, binding, name);
        hostile.undo();
    };
    check({}, "calm");
    for (const std::string& name : hostile.names())
        check({name}, name);
    for (std::uint32_t seed = 0; seed < 20; ++seed)
        check(hostile.random(seed), "random states, seed " + std::to_string(seed));
}

// In which OpenGL forbids to change the program.
void checkRefused(tests::HostileState& hostile)
{
    const Fixture fixture(Lookup::layered);
    const ProbeBinding binding(fixture.program, firstUnit);
    hostile.beginTransformFeedback();
    report(tests::changesBy(
               [&] { CHECK_THROWS(ProbeBinding(fixture.program, firstUnit), ErrorKind::hostBusy); }),
           "transform feedback, made");
    report(tests::changesBy([&] {
               CHECK_THROWS(const auto bound = binding.bind(fixture.probe.map()), ErrorKind::hostBusy);
           }),
           "transform feedback, bound");
    hostile.undo();
}

// Numbers that their enumerations do not name.
void checkNumbersWithoutName()
{
    const Fixture fixture(Lookup::infinite);
    const ProbeBinding binding(fixture.program, firstUnit);
    ReflectionMap map = fixture.probe.map();
    map.map = static_cast<MapKind>(77);
    report(
        tests::changesBy([&] { CHECK_THROWS(const auto bound = binding.bind(map), ErrorKind::badArgument); }),
        "a map without a name, bound");
    CHECK_THROWS(ImageMap(map.map, 4, {}), ErrorKind::badArgument);
    CHECK_THROWS(reflectionGlsl({.lookup = static_cast<Lookup>(77)}), ErrorKind::badArgument);
    CHECK_THROWS(reflectionGlsl({.detail = static_cast<LevelOfDetail>(-1)}), ErrorKind::badArgument);
}

// A map of another kind than the program looks up would be a wrong picture.
void checkOtherMaps(Lookup lookup)
{
    for (const MapInfo& made : maps()) {
        const Fixture fixture(lookup, made.kind);
        const ProbeBinding binding(fixture.program, firstUnit);
        ReflectionMap map = fixture.probe.map();
        for (const MapInfo& given : maps()) {
            map.map = given.kind;
            if (given.kind == made.kind)
                checkBound(fixture, binding, std::string(given.name));
            else
                report(tests::changesBy([&] {
                           CHECK_THROWS(const auto bound = binding.bind(map), ErrorKind::badArgument);
                       }),
                       std::string(given.name) + " for a program of " + std::string(made.name));
        }
    }
}

// A program that uses no look-up of the prefix would show what the units happen to hold.
void checkOtherPrograms()
{
    const std::string snippet = "#version 330 core\n" + reflectionGlsl({.lookup = Lookup::distance}) +
                                "in vec2 uv; out vec4 colour;\n";
    const auto check = [&](const std::string& main, bool isUsed) {
        const GLuint program = tests::makeProgram(tests::fullScreenVertexSource,
                                                  snippet + "void main() { colour = " + main + "; }\n");
        report(tests::changesBy([&] {
                   if (isUsed)
                       const ProbeBinding binding(program);
                   else
                       CHECK_THROWS(ProbeBinding{program}, ErrorKind::badArgument);
               }),
               main);
        CHECK_THROWS(ProbeBinding(program, firstUnit, "mirror_"), ErrorKind::badArgument);
        CHECK_THROWS(ProbeBinding(program, firstUnit, ""), ErrorKind::badArgument);
        glDeleteProgram(program);
    };
    const Fixture layered(Lookup::layered); // of four units
    for (const int unit : {-1, 1 << 20, std::numeric_limits<int>::max() - 3, std::numeric_limits<int>::max()})
        CHECK_THROWS(ProbeBinding(layered.program, unit), ErrorKind::badArgument);
    check("uv.xyxy", false);
    check("vec4(mirrorball_reflected(vec3(uv, 1), vec3(1)), 1)", false);
    check("false ? mirrorball_lookUp(vec3(uv, 1), vec3(1)) : vec4(1)", false);
    check("mirrorball_lookUp(vec3(uv, 1), vec3(1))", true);
    check("mirrorball_lookUpLevel(vec3(uv, 1), vec3(1), 0.0)", true);
    check("mirrorball_shownPosition(vec3(uv, 1), vec3(1), vec3(2))", true);
    check("mirrorball_material(uv.xyxy, vec4(1))", true); // beside a look-up of the host's own
}

std::vector<float> picture(const Fixture& program, const ReflectionMap& map)
{
    const ProbeBinding binding(program.program, firstUnit);
    const tests::ColourTarget target(64, 64);
    target.bind();
    glUseProgram(program.program);
    const auto bound = binding.bind(map);
    tests::drawFullScreenTriangle();
    return target.read();
}

double meanDifference(const std::vector<float>& a, const std::vector<float>& b)
{
    double sum = 0.0;
    for (std::size_t index = 0; index < a.size(); ++index)
        sum += std::abs(static_cast<double>(a[index]) - static_cast<double>(b[index]));
    return sum / static_cast<double>(a.size());
}

// A look-up that needs more than the map has does without: without distances it is `infinite`, to rounding; without the
// second layer about `distance`, which marches in other steps.
void checkPoorerMaps()
{
    const Fixture infinite(Lookup::infinite), distance(Lookup::distance), layered(Lookup::layered);
    const ReflectionMap& rich = layered.probe.map();
    ReflectionMap one = rich;
    one.hiddenColourTexture = one.hiddenDistanceTexture = 0;
    one.hiddenN = 0;
    ReflectionMap none = one;
    none.distanceTexture = 0;
    none.nearestLevel = 0;
    const std::vector<float> infinitelyFar = picture(infinite, rich), traced = picture(distance, rich);
    const double parallax = meanDifference(infinitelyFar, traced);
    CHECK(parallax > 0.01);
    CHECK(meanDifference(picture(distance, none), infinitelyFar) < 1e-6);
    CHECK(meanDifference(picture(layered, none), infinitelyFar) < 1e-6);
    CHECK(meanDifference(picture(layered, one), traced) < 0.1 * parallax);
    std::printf("parallax %g, without distances %g %g, without a second layer %g\n", parallax,
                meanDifference(picture(distance, none), infinitelyFar),
                meanDifference(picture(layered, none), infinitelyFar),
                meanDifference(picture(layered, one), traced));
}

void checkSettingsThatAreNotFinite()
{
    const Fixture fixture(Lookup::distance);
    const ProbeBinding binding(fixture.program, firstUnit);
    for (const float wrong :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        const MaterialSettings refused[] = {{.tint = {1.0f, wrong, 1.0f}},
                                            {.blend = wrong},
                                            {.probeFromWorld = glm::mat3(wrong)},
                                            {.worldFromView = glm::mat4(wrong)},
                                            {.origin = {0.0, 0.0, static_cast<double>(wrong)}}};
        for (const MaterialSettings& settings : refused)
            report(tests::changesBy([&] {
                       CHECK_THROWS(const auto bound = binding.bind(fixture.probe.map(), settings),
                                    ErrorKind::badArgument);
                   }),
                   "settings that are not finite");
        const auto bound = binding.bind(fixture.probe.map(), {.anisotropy = wrong});
        report(tests::takeErrors(), "anisotropy without end");
    }
}

} // namespace

int main()
{
    const headless::Context context;
    tests::HostileState hostile;
    for (const Lookup lookup : {Lookup::infinite, Lookup::distance, Lookup::layered})
        checkUnderHostileStates(lookup, hostile);
    checkRefused(hostile);
    checkNumbersWithoutName();
    checkOtherPrograms();
    checkPoorerMaps();
    checkSettingsThatAreNotFinite();
    for (const Lookup lookup : {Lookup::infinite, Lookup::box, Lookup::layered})
        checkOtherMaps(lookup);
    std::printf("%zu hostile states\n", hostile.names().size());
    return 0;
}
