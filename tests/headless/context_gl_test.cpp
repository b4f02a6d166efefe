// Contexts without a window: made, moved, shared among threads one at a time, and refused with the right
// kind.
#include <mirrorball/headless/context.h>

#include <mirrorball/error.h>

#include "support/check.h"

#include <EGL/egl.h>

#include <optional>
#include <string>
#include <thread>
#include <utility>

using mirrorball::ErrorKind;
using mirrorball::headless::Context;

namespace {

constexpr unsigned int glMajorVersion = 0x821B;
constexpr unsigned int glMinorVersion = 0x821C;
constexpr unsigned int glContextFlags = 0x821E;
constexpr int glContextFlagDebugBit = 0x2;

int integer(unsigned int name)
{
    using GetIntegerv = void (*)(unsigned int, int*);
    const auto get = reinterpret_cast<GetIntegerv>(eglGetProcAddress("glGetIntegerv"));
    int value = -1;
    get(name, &value);
    return value;
}

void makesAtLeastTheVersion()
{
    const Context context;
    const int version = 10 * integer(glMajorVersion) + integer(glMinorVersion);
    CHECK(version >= 33);
    const std::string spelled = std::to_string(version / 10) + "." + std::to_string(version % 10);
    CHECK(context.description().rfind("OpenGL " + spelled, 0) == 0);

    const Context es({.major = 3, .minor = 0, .es = true});
    CHECK(es.description().rfind("OpenGL ES 3.", 0) == 0);

    const Context debug({.debug = true});
    CHECK((integer(glContextFlags) & glContextFlagDebugBit) != 0);
}

void releasesWhatItMade()
{
    CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);
    {
        const Context outer;
        const EGLContext outerName = eglGetCurrentContext();
        {
            const Context inner;
            CHECK(eglGetCurrentContext() != outerName);
        }
        CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);
        outer.makeCurrent(); // its display outlives the inner one's
        CHECK(eglGetCurrentContext() == outerName);
        CHECK(integer(glMajorVersion) >= 3);
    }
    CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);
}

void moves()
{
    Context first;
    const EGLContext firstName = eglGetCurrentContext();
    Context second;
    second = std::move(first); // releases what second held, which was current
    CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);
    second.makeCurrent();
    CHECK(eglGetCurrentContext() == firstName);
    const Context third = std::move(second);
    CHECK(eglGetCurrentContext() == firstName);
    CHECK(!third.description().empty());
}

void isCurrentOnOneThreadAtATime()
{
    const Context context;
    std::thread([&] { CHECK_THROWS(context.makeCurrent(), ErrorKind::noContext); }).join();
    CHECK(eglGetCurrentContext() != EGL_NO_CONTEXT);
}

void refusesWithNothingChanged()
{
    const Context context;
    const EGLContext before = eglGetCurrentContext();
    const EGLenum apiBefore = eglQueryAPI();
    CHECK_THROWS(Context({.major = 3, .minor = 9}), ErrorKind::badArgument);
    CHECK_THROWS(Context({.major = -1, .minor = 0}), ErrorKind::badArgument);
    CHECK_THROWS(Context({.major = 3, .minor = 3, .es = true}), ErrorKind::badArgument);
    CHECK(eglGetCurrentContext() == before);
    CHECK(eglQueryAPI() == apiBefore);
}

// With an argument: only this, in an environment that makes it fail so (CMakeLists.txt beside this file).
int fails(const std::string& kind)
{
    const ErrorKind expected = kind == "unsupported" ? ErrorKind::unsupported : ErrorKind::noContext;
    CHECK_THROWS(Context(), expected);
    CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);
    return 0;
}

} // namespace

int main(int argumentCount, char** arguments)
{
    if (argumentCount == 2)
        return fails(arguments[1]);
    releasesWhatItMade();
    makesAtLeastTheVersion();
    moves();
    isCurrentOnOneThreadAtATime();
    refusesWithNothingChanged();
}
