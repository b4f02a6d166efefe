// The judge judged: GlState sees every hostile state and nothing else, HostileState puts everything back, and
// neither raises a GL error. CTest runs it for several drivers and versions; the argument "compatibility"
// chooses that profile.
#include "support/check.h"
#include "support/gl_state.h"
#include "support/hostile_state.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace {

using Lines = std::vector<std::string>;
using tests::changesBy;
using tests::differences;
using tests::GlState;

bool hasDebugOutput()
{
    return epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug");
}

// Says which call was wrong, where glGetError says only that there was one.
void failOnError(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void*)
{
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) {
        std::fprintf(stderr, "GL error: %s\n", message);
        std::abort(); // so that a debugger shows the call
    }
}

void watchForErrors()
{
    if (!hasDebugOutput())
        return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(failOnError, nullptr);
}

void checkNone(const Lines& lines, const std::string& where)
{
    for (const std::string& line : lines)
        std::fprintf(stderr, "%s: %s\n", where.c_str(), line.c_str());
    CHECK(lines.empty());
}

// "GL_BLEND" of "GL_BLEND[2]: off → on"; what is asked of a bound object keeps both names.
std::string kindOf(std::string_view line)
{
    std::string kind(line.substr(0, line.find(": ")));
    for (std::size_t open = kind.find('['); open != std::string::npos; open = kind.find('['))
        kind.erase(open, kind.find(']') - open + 1);
    return kind;
}

void capturesManyItems()
{
    const GlState state = GlState::capture();
    std::set<std::string> names;
    std::set<std::string> kinds;
    for (const GlState::Item& item : state.items()) {
        CHECK(names.insert(item.name).second);
        kinds.insert(kindOf(item.name));
    }
    std::printf("%zu items of %zu kinds\n", names.size(), kinds.size());
    // What is left of it where OpenGL 3.3 has no extensions at all.
    CHECK(kinds.size() >= (epoxy_gl_version() >= 43 ? 150 : 130));
    checkNone(differences(state, GlState::capture()), "two captures in a row");
    checkNone(tests::takeErrors(), "capture");
}

void namesWhatChanged()
{
    checkNone(changesBy([] {}), "nothing done");
    CHECK(changesBy([] { glDepthFunc(GL_EQUAL); }) == Lines{"GL_DEPTH_FUNC: 0x201 → 0x202"});
    CHECK(changesBy([] { glDepthFunc(GL_LESS); }) == Lines{"GL_DEPTH_FUNC: 0x202 → 0x201"});
    CHECK(changesBy([] { glBlendColor(0.5f, 0.0f, 0.0f, 1.0f); }) ==
          Lines{"GL_BLEND_COLOR: (0, 0, 0, 0) → (0.5, 0, 0, 1)"});
    glBlendColor(0.0f, 0.0f, 0.0f, 0.0f);
}

void seesErrors()
{
    if (hasDebugOutput())
        glDisable(GL_DEBUG_OUTPUT); // this error is meant
    CHECK(changesBy([] { glEnable(GL_TEXTURE_2D_ARRAY); }) == Lines{"glGetError: 0x0 → 0x500"});
    checkNone(tests::takeErrors(), "taken already");
    watchForErrors();
}

void seesAnotherContext(const mirrorball::headless::Context& context)
{
    const mirrorball::headless::Context other({.debug = true});
    context.makeCurrent();
    const Lines lines = changesBy([&] { other.makeCurrent(); });
    CHECK(!lines.empty() && lines[0].starts_with("eglGetCurrentContext: "));
    context.makeCurrent();
}

void seesEditsOfBoundObjects()
{
    GLuint texture = 0, sampler = 0, buffer = 0, framebuffer = 0, vertexArray = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glGenSamplers(1, &sampler);
    glBindSampler(0, sampler);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);

    CHECK(changesBy([] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 3); }) ==
          Lines{"GL_TEXTURE_2D[0] GL_TEXTURE_BASE_LEVEL: 0 → 3"});
    CHECK(changesBy([&] { glSamplerParameterf(sampler, GL_TEXTURE_LOD_BIAS, 0.5f); }) ==
          Lines{"GL_SAMPLER_BINDING[0] GL_TEXTURE_LOD_BIAS: 0 → 0.5"});
    CHECK(changesBy([] { glBufferData(GL_ARRAY_BUFFER, 12, nullptr, GL_STATIC_DRAW); }) ==
          Lines{"GL_ARRAY_BUFFER GL_BUFFER_SIZE: 0x0 → 0xc"});
    CHECK(changesBy([] { glVertexAttribDivisor(2, 1); }).size() >= 1);
    CHECK(changesBy([] { glEnableVertexAttribArray(1); }) ==
          Lines{"GL_VERTEX_ATTRIB_ARRAY_ENABLED[1]: 0x0 → 0x1"});
    CHECK(changesBy([] { glReadBuffer(GL_NONE); }) == Lines{"GL_READ_BUFFER: 0x8ce0 → 0x0"});
    CHECK(changesBy([] {
              const std::vector<GLenum> drawBuffers(8, GL_NONE); // every context has 8
              glDrawBuffers(8, drawBuffers.data());
          }) == Lines{"GL_DRAW_BUFFER[0]: 0x8ce0 → 0x0"});
    const Lines attached = changesBy([&] {
        glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT3, GL_TEXTURE_2D, texture, 0);
    });
    CHECK(std::find(attached.begin(), attached.end(),
                    "GL_DRAW_FRAMEBUFFER GL_COLOR_ATTACHMENT[3] GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE: 0x0 → "
                    "0x1702") != attached.end());

    glBindVertexArray(0);
    glDeleteVertexArrays(1, &vertexArray);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteBuffers(1, &buffer);
    glDeleteSamplers(1, &sampler);
    glDeleteTextures(1, &texture);
    checkNone(tests::takeErrors(), "edits of bound objects");
}

void seesEachHostileStateAndItsUndoing(tests::HostileState& hostile)
{
    const GlState calm = GlState::capture();
    for (const std::string& name : hostile.names()) {
        hostile.apply({name});
        checkNone(tests::takeErrors(), name);
        const GlState disturbed = GlState::capture();
        checkNone(tests::takeErrors(), "capture in: " + name);
        CHECK(!differences(calm, disturbed).empty());
        checkNone(differences(disturbed, GlState::capture()), "two captures in: " + name);
        hostile.undo();
        checkNone(tests::takeErrors(), "undoing: " + name);
        checkNone(differences(calm, GlState::capture()), "undone: " + name);
    }
}

void seesRandomHostileStatesAndTheirUndoing(tests::HostileState& hostile)
{
    const GlState calm = GlState::capture();
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        const std::string where = "seed " + std::to_string(seed);
        CHECK(hostile.random(seed) == hostile.random(seed));
        CHECK(hostile.random(seed) != hostile.random(seed + 1));
        hostile.apply(hostile.random(seed));
        checkNone(tests::takeErrors(), "applying " + where);
        checkNone(changesBy([] {}), "captures in " + where);
        hostile.undo();
        checkNone(tests::takeErrors(), "undoing " + where);
        checkNone(differences(calm, GlState::capture()), "undone " + where);
    }
}

// Kinds of items that change in no hostile state.
const std::set<std::string> seenNowhere = {
    // seesAnotherContext and seesEditsOfBoundObjects see them
    "eglGetCurrentContext", "GL_DRAW_BUFFER",
    // what the debug callback of this test stands on
    "GL_DEBUG_CALLBACK_FUNCTION", "GL_DEBUG_CALLBACK_USER_PARAM", "GL_DEBUG_OUTPUT",
    "GL_DEBUG_OUTPUT_SYNCHRONOUS",
    // exclude each other and GL_SAMPLES_PASSED
    "GL_CURRENT_QUERY GL_ANY_SAMPLES_PASSED", "GL_CURRENT_QUERY GL_ANY_SAMPLES_PASSED_CONSERVATIVE",
    // a context without a window has no surface
    "eglGetCurrentSurface(EGL_DRAW)", "eglGetCurrentSurface(EGL_READ)",
    // modes of a compatibility context in which nothing is drawn
    "GL_LIST_INDEX", "GL_LIST_MODE", "GL_NAME_STACK_DEPTH", "GL_RENDER_MODE"};

// No item is blind: in a core profile every single one changes in some hostile state, in a compatibility
// profile one of every kind (its vertex array 0 and texture stages are asked for, but not set, index by
// index).
void seesEveryItem(tests::HostileState& hostile, bool compatibility)
{
    const auto label = [&](const std::string& name) {
        return compatibility ? kindOf(name) : name.substr(0, name.find(": "));
    };
    std::set<std::string> seen;
    const auto look = [&](const GlState& from) {
        for (const std::string& line : differences(from, GlState::capture()))
            seen.insert(label(line));
    };
    const GlState calm = GlState::capture();
    for (const std::string& name : hostile.names()) {
        hostile.apply({name});
        look(calm);
        hostile.undo();
    }
    hostile.apply({"host's framebuffers bound"}); // which have a stencil, without which its reference reads 0
    const GlState withStencil = GlState::capture();
    hostile.apply({"stencil test never passes"});
    look(withStencil);
    hostile.undo();

    Lines blind;
    for (const GlState::Item& item : calm.items())
        if (seen.count(label(item.name)) == 0 && seenNowhere.count(kindOf(item.name)) == 0)
            blind.push_back(item.name);
    checkNone(blind, "blind");
}

void seesActiveTransformFeedback(tests::HostileState& hostile)
{
    const GlState calm = GlState::capture();
    hostile.beginTransformFeedback();
    CHECK(!differences(calm, GlState::capture()).empty());
    hostile.undo();
    checkNone(differences(calm, GlState::capture()), "after transform feedback");
    checkNone(tests::takeErrors(), "transform feedback");
}

} // namespace

int main(int argc, char** argv)
{
    const bool compatibility = argc > 1 && std::string_view(argv[1]) == "compatibility";
    const mirrorball::headless::Context context({.debug = true, .compatibility = compatibility});
    std::printf("%s\n", context.description().c_str());
    watchForErrors();
    capturesManyItems();
    namesWhatChanged();
    seesErrors();
    seesAnotherContext(context);
    seesEditsOfBoundObjects();

    tests::HostileState hostile;
    seesEachHostileStateAndItsUndoing(hostile);
    seesRandomHostileStatesAndTheirUndoing(hostile);
    seesEveryItem(hostile, compatibility);
    seesActiveTransformFeedback(hostile);
}
