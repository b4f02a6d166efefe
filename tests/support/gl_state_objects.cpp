// The state of the objects that are bound: a guest that edits the host's framebuffer, vertex array or buffer
// has changed the host's state, even if every binding is as it was.
#include "support/gl_state_recorder.h"

#include <array>
#include <cstdint>

namespace tests {

namespace {

struct Query
{
    Enum name;
    Gate gate = always;
};

void recordAttachment(StateRecorder& recorder, const std::string& name, GLenum target, GLenum attachment)
{
    constexpr Enum ofTextures[] = {GL_ENUM(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL),
                                   GL_ENUM(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE),
                                   GL_ENUM(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER),
                                   GL_ENUM(GL_FRAMEBUFFER_ATTACHMENT_LAYERED)};
    const auto get = [&](GLenum what) {
        GLint value = 0;
        glGetFramebufferAttachmentParameteriv(target, attachment, what, &value);
        return value;
    };
    const GLint type = get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    recorder.addSymbol(name + " GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE", type);
    if (type == GL_NONE)
        return; // nothing else may be asked
    recorder.addSymbol(name + " GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME",
                       get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    if (type == GL_TEXTURE)
        for (const Enum& what : ofTextures)
            recorder.addSymbol(name + " " + what.text, get(what.value));
}

void recordFramebuffer(StateRecorder& recorder, const Enum& target)
{
    constexpr Enum defaults[] = {
        GL_ENUM(GL_FRAMEBUFFER_DEFAULT_WIDTH), GL_ENUM(GL_FRAMEBUFFER_DEFAULT_HEIGHT),
        GL_ENUM(GL_FRAMEBUFFER_DEFAULT_LAYERS), GL_ENUM(GL_FRAMEBUFFER_DEFAULT_SAMPLES),
        GL_ENUM(GL_FRAMEBUFFER_DEFAULT_FIXED_SAMPLE_LOCATIONS)};
    const std::string owner = target.text;
    for (int i = 0; i < limit(GL_MAX_COLOR_ATTACHMENTS); ++i)
        recordAttachment(recorder, owner + " " + indexed("GL_COLOR_ATTACHMENT", i), target.value,
                         GL_COLOR_ATTACHMENT0 + static_cast<GLuint>(i));
    recordAttachment(recorder, owner + " GL_DEPTH_ATTACHMENT", target.value, GL_DEPTH_ATTACHMENT);
    recordAttachment(recorder, owner + " GL_STENCIL_ATTACHMENT", target.value, GL_STENCIL_ATTACHMENT);
    if (has(noAttachments))
        for (const Enum& name : defaults) {
            GLint value = 0;
            glGetFramebufferParameteriv(target.value, name.value, &value);
            recorder.addSymbol(owner + " " + name.text, value);
        }
}

void recordAttribute(StateRecorder& recorder, int attribute)
{
    constexpr Query names[] = {
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_ENABLED)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_SIZE)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_STRIDE)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_TYPE)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_INTEGER)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_DIVISOR)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING)},
        {GL_ENUM(GL_VERTEX_ATTRIB_ARRAY_LONG), vertexAttrib64},
        {GL_ENUM(GL_VERTEX_ATTRIB_BINDING), vertexAttribBinding},
        {GL_ENUM(GL_VERTEX_ATTRIB_RELATIVE_OFFSET), vertexAttribBinding},
    };
    const auto index = static_cast<GLuint>(attribute);
    for (const Query& query : names)
        if (has(query.gate)) {
            GLint value = 0;
            glGetVertexAttribiv(index, query.name.value, &value);
            recorder.addSymbol(indexed(query.name.text, attribute), value);
        }
    void* pointer = nullptr;
    glGetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
    recorder.addNumber(indexed("GL_VERTEX_ATTRIB_ARRAY_POINTER", attribute),
                       static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer)));
}

void recordVertexBindings(StateRecorder& recorder)
{
    constexpr Enum names[] = {GL_ENUM(GL_VERTEX_BINDING_BUFFER), GL_ENUM(GL_VERTEX_BINDING_DIVISOR),
                              GL_ENUM(GL_VERTEX_BINDING_STRIDE)};
    const int count = has(vertexAttribBinding) ? limit(GL_MAX_VERTEX_ATTRIB_BINDINGS) : 0;
    for (int i = 0; i < count; ++i) {
        for (const Enum& name : names) {
            GLint value = 0;
            glGetIntegeri_v(name.value, static_cast<GLuint>(i), &value);
            recorder.addSymbol(indexed(name.text, i), value);
        }
        GLint64 offset = 0;
        glGetInteger64i_v(GL_VERTEX_BINDING_OFFSET, static_cast<GLuint>(i), &offset);
        recorder.addNumber(indexed("GL_VERTEX_BINDING_OFFSET", i), static_cast<double>(offset));
    }
}

} // namespace

void recordBoundFramebuffers(StateRecorder& recorder)
{
    if (limit(GL_DRAW_FRAMEBUFFER_BINDING) != 0)
        recordFramebuffer(recorder, GL_ENUM(GL_DRAW_FRAMEBUFFER));
    if (limit(GL_READ_FRAMEBUFFER_BINDING) != 0)
        recordFramebuffer(recorder, GL_ENUM(GL_READ_FRAMEBUFFER));
}

void recordBoundVertexArray(StateRecorder& recorder)
{
    if (limit(GL_VERTEX_ARRAY_BINDING) == 0 && !has(compatibility))
        return; // a core profile has no vertex array 0
    for (int i = 0; i < limit(GL_MAX_VERTEX_ATTRIBS); ++i)
        recordAttribute(recorder, i);
    recordVertexBindings(recorder);
}

void recordBoundBuffers(StateRecorder& recorder)
{
    struct Target
    {
        Enum name;
        GLenum binding;
    };
    constexpr Target targets[] = {
        {GL_ENUM(GL_ARRAY_BUFFER), GL_ARRAY_BUFFER_BINDING},
        {GL_ENUM(GL_ELEMENT_ARRAY_BUFFER), GL_ELEMENT_ARRAY_BUFFER_BINDING},
        {GL_ENUM(GL_COPY_READ_BUFFER), GL_COPY_READ_BUFFER_BINDING},
        {GL_ENUM(GL_COPY_WRITE_BUFFER), GL_COPY_WRITE_BUFFER_BINDING},
        {GL_ENUM(GL_PIXEL_PACK_BUFFER), GL_PIXEL_PACK_BUFFER_BINDING},
        {GL_ENUM(GL_PIXEL_UNPACK_BUFFER), GL_PIXEL_UNPACK_BUFFER_BINDING},
        {GL_ENUM(GL_UNIFORM_BUFFER), GL_UNIFORM_BUFFER_BINDING},
        {GL_ENUM(GL_TRANSFORM_FEEDBACK_BUFFER), GL_TRANSFORM_FEEDBACK_BUFFER_BINDING},
    };
    constexpr Enum parameters[] = {GL_ENUM(GL_BUFFER_SIZE), GL_ENUM(GL_BUFFER_USAGE),
                                   GL_ENUM(GL_BUFFER_MAPPED)};
    for (const Target& target : targets) {
        if (limit(target.binding) == 0)
            continue;
        for (const Enum& parameter : parameters) {
            GLint value = 0;
            glGetBufferParameteriv(target.name.value, parameter.value, &value);
            recorder.addSymbol(std::string(target.name.text) + " " + parameter.text, value);
        }
    }
}

} // namespace tests
