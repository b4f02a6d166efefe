#include "gl/clear_guard.h"

#include <epoxy/gl.h>

namespace mirrorball::gl {

namespace {

// Of the first viewport, which is the one that clears obey; others keep theirs.
void setScissorTest(bool enabled)
{
    if (epoxy_gl_version() >= 41 || epoxy_has_gl_extension("GL_ARB_viewport_array"))
        (enabled ? glEnablei : glDisablei)(GL_SCISSOR_TEST, 0);
    else
        (enabled ? glEnable : glDisable)(GL_SCISSOR_TEST);
}

} // namespace

ClearGuard::ClearGuard()
    : scissorTest_(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE), // tells of the first
      rasterizerDiscard_(glIsEnabled(GL_RASTERIZER_DISCARD) == GL_TRUE)
{
    for (GLuint buffer = 0; buffer < colourMasks_.size(); ++buffer) {
        glGetBooleani_v(GL_COLOR_WRITEMASK, buffer, colourMasks_[buffer].data());
        glColorMaski(buffer, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    glDepthMask(GL_TRUE);
    if (scissorTest_)
        setScissorTest(false);
    if (rasterizerDiscard_)
        glDisable(GL_RASTERIZER_DISCARD);
}

ClearGuard::~ClearGuard()
{
    if (rasterizerDiscard_)
        glEnable(GL_RASTERIZER_DISCARD);
    if (scissorTest_)
        setScissorTest(true);
    glDepthMask(depthMask_);
    for (GLuint buffer = 0; buffer < colourMasks_.size(); ++buffer) {
        const auto& mask = colourMasks_[buffer];
        glColorMaski(buffer, mask[0], mask[1], mask[2], mask[3]);
    }
}

} // namespace mirrorball::gl
