#include "gl/clear_guard.h"

#include <epoxy/gl.h>

namespace mirrorball::gl {

// Of the first viewport, which is the one that clears obey; others keep theirs.
void ClearGuard::setScissorTest(bool enabled) const
{
    if (abilities_.viewportArrays)
        (enabled ? glEnablei : glDisablei)(GL_SCISSOR_TEST, 0);
    else
        (enabled ? glEnable : glDisable)(GL_SCISSOR_TEST);
}

ClearGuard::ClearGuard(const Abilities& abilities)
    : abilities_(abilities), scissorTest_(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE), // tells of the first
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
