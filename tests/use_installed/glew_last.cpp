#include "all_headers.h"

#include <GL/glew.h>

bool probeAndGlewShareAContext()
{
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    mirrorball::ReflectionProbe::Desc desc;
    desc.n = 16;
    mirrorball::ReflectionProbe probe(desc);
    const mirrorball::CaptureReport report = probe.capture({}, {});
    GLint bound = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    return report.draws == 0 && static_cast<GLuint>(bound) == framebuffer && glGetError() == GL_NO_ERROR;
}
