#include <mirrorball/gl/objects.h>

#include "gl/context.h"

#include <epoxy/gl.h>

namespace mirrorball::gl {

template <ObjectKind kind>
Object<kind> Object<kind>::create()
{
    GLuint name = 0;
    if constexpr (kind == ObjectKind::texture)
        glGenTextures(1, &name);
    else if constexpr (kind == ObjectKind::framebuffer)
        glGenFramebuffers(1, &name);
    else if constexpr (kind == ObjectKind::buffer)
        glGenBuffers(1, &name);
    else if constexpr (kind == ObjectKind::vertexArray)
        glGenVertexArrays(1, &name);
    else if constexpr (kind == ObjectKind::program)
        name = glCreateProgram();
    else if constexpr (kind == ObjectKind::sampler)
        glGenSamplers(1, &name);
    else
        static_assert(kind == ObjectKind::shader);
    return Object(name);
}

template <ObjectKind kind>
void Object<kind>::destroy(unsigned int name) noexcept
{
    if (name == 0 || !contextIsCurrent())
        return;
    if constexpr (kind == ObjectKind::texture)
        glDeleteTextures(1, &name);
    else if constexpr (kind == ObjectKind::framebuffer)
        glDeleteFramebuffers(1, &name);
    else if constexpr (kind == ObjectKind::buffer)
        glDeleteBuffers(1, &name);
    else if constexpr (kind == ObjectKind::vertexArray)
        glDeleteVertexArrays(1, &name);
    else if constexpr (kind == ObjectKind::program)
        glDeleteProgram(name);
    else if constexpr (kind == ObjectKind::sampler)
        glDeleteSamplers(1, &name);
    else
        glDeleteShader(name);
}

template class Object<ObjectKind::texture>;
template class Object<ObjectKind::framebuffer>;
template class Object<ObjectKind::buffer>;
template class Object<ObjectKind::vertexArray>;
template class Object<ObjectKind::program>;
template class Object<ObjectKind::shader>;
template class Object<ObjectKind::sampler>;

} // namespace mirrorball::gl
