#include "gl/context.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <string>

namespace mirrorball::gl {

bool contextIsCurrent() noexcept
{
    // epoxy reports version 0 when glGetString answers nothing, which is what a thread without a context
    // gets.
    return epoxy_gl_version() != 0;
}

void requireContext()
{
    const std::string asked = "OpenGL 3.3";
    if (!contextIsCurrent())
        throw Error(ErrorKind::noContext, asked, "no context is current on this thread",
                    "make one current first");
    const std::string found = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (!epoxy_is_desktop_gl() || epoxy_gl_version() < 33)
        throw Error(ErrorKind::unsupported, asked, "the current context is " + found,
                    "make a desktop context of version 3.3 or later");
    const bool hasTransformFeedbackState =
        epoxy_gl_version() >= 40 || epoxy_has_gl_extension("GL_ARB_transform_feedback2");
    if (hasTransformFeedbackState && integer(GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 &&
        integer(GL_TRANSFORM_FEEDBACK_PAUSED) == 0)
        throw Error(ErrorKind::hostBusy, "a capture", "transform feedback is active",
                    "end or pause it first");
}

int integer(unsigned int name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

} // namespace mirrorball::gl
