// The objects of a host, made so that using one of them by mistake shows.
#include "support/hostile_state_entries.h"

#include "support/gl_image.h"

#include <cstdint>

namespace tests {

namespace {

struct TextureTarget
{
    GLenum target;
    Gate gate = always;
};

constexpr TextureTarget textureTargets[] = {
    {GL_TEXTURE_1D},
    {GL_TEXTURE_2D},
    {GL_TEXTURE_3D},
    {GL_TEXTURE_1D_ARRAY},
    {GL_TEXTURE_2D_ARRAY},
    {GL_TEXTURE_RECTANGLE},
    {GL_TEXTURE_CUBE_MAP},
    {GL_TEXTURE_CUBE_MAP_ARRAY, cubeMapArray},
    {GL_TEXTURE_BUFFER},
    {GL_TEXTURE_2D_MULTISAMPLE},
    {GL_TEXTURE_2D_MULTISAMPLE_ARRAY},
};

// Storage for one texel, or two layers of two by two where framebuffers are made of it.
void allocate(GLenum target, GLuint buffer)
{
    constexpr GLenum format = GL_RGBA8;
    switch (target) {
    case GL_TEXTURE_1D:
        glTexImage1D(target, 0, format, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        break;
    case GL_TEXTURE_2D:
    case GL_TEXTURE_RECTANGLE:
    case GL_TEXTURE_1D_ARRAY:
        glTexImage2D(target, 0, format, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        break;
    case GL_TEXTURE_2D_ARRAY:
        glTexImage3D(target, 0, format, 2, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        break;
    case GL_TEXTURE_3D:
        glTexImage3D(target, 0, format, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        break;
    case GL_TEXTURE_CUBE_MAP:
        for (GLuint face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, format, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         nullptr);
        break;
    case GL_TEXTURE_CUBE_MAP_ARRAY:
        glTexImage3D(target, 0, format, 1, 1, 6, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        break;
    case GL_TEXTURE_BUFFER:
        glTexBuffer(target, format, buffer);
        break;
    case GL_TEXTURE_2D_MULTISAMPLE:
        glTexImage2DMultisample(target, 1, format, 1, 1, GL_TRUE);
        break;
    case GL_TEXTURE_2D_MULTISAMPLE_ARRAY:
        glTexImage3DMultisample(target, 1, format, 1, 1, 1, GL_TRUE);
        break;
    }
}

std::vector<HostTexture> makeTextures(GLuint buffer)
{
    std::vector<HostTexture> textures;
    for (const TextureTarget& entry : textureTargets)
        if (has(entry.gate)) {
            HostTexture texture{entry.target, 0};
            glGenTextures(1, &texture.name);
            glBindTexture(texture.target, texture.name);
            allocate(texture.target, buffer);
            glBindTexture(texture.target, 0);
            textures.push_back(texture);
        }
    return textures;
}

// Compares depths and clamps to a magenta border: whoever samples colours through it sees it.
GLuint makeSampler()
{
    constexpr GLfloat magenta[] = {1.0f, 0.0f, 1.0f, 1.0f};
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glSamplerParameteri(sampler, wrap, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, magenta);
    return sampler;
}

const void* offset(std::uintptr_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}

// Attributes of every kind from the buffer, one for each instance, and the buffer for the indices.
GLuint makeVertexArray(GLuint buffer)
{
    GLuint vertexArray = 0;
    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    glVertexAttribPointer(0, 3, GL_SHORT, GL_TRUE, 40, offset(8));
    glVertexAttribIPointer(1, 2, GL_UNSIGNED_BYTE, 40, offset(16));
    if (has(vertexAttrib64))
        glVertexAttribLPointer(2, 1, GL_DOUBLE, 40, offset(24));
    if (has(vertexAttribBinding)) {
        glVertexAttribFormat(3, 2, GL_HALF_FLOAT, GL_FALSE, 4);
        glVertexAttribBinding(3, 0);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return vertexArray;
}

// Draws to a layer of a texture at attachment 1, and to depth and stencil.
GLuint makeFramebuffer(GLuint texture2dArray, GLint layer, GLuint renderbuffer)
{
    GLuint framebuffer = 0;
    constexpr GLenum drawBuffers[] = {GL_NONE, GL_COLOR_ATTACHMENT1};
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, texture2dArray, 0, layer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, renderbuffer);
    glDrawBuffers(2, drawBuffers);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return framebuffer;
}

GLuint makeRenderbuffer()
{
    GLuint renderbuffer = 0;
    glGenRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 2,
                          2); // as large as the textures of makeFramebuffer
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return renderbuffer;
}

} // namespace

HostObjects::HostObjects()
{
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glGetIntegerv(GL_SCISSOR_BOX, scissor.data());
    GLint64 mask = 0; // 64 bits, since glGetIntegerv may clamp 32 ones
    glGetInteger64v(GL_STENCIL_WRITEMASK, &mask);
    stencilMask = static_cast<GLuint>(mask);
    attributeValues.resize(static_cast<std::size_t>(limit(GL_MAX_VERTEX_ATTRIBS)), {0.0f, 0.0f, 0.0f, 1.0f});
    for (GLuint i = has(compatibility) ? 1 : 0; i < attributeValues.size(); ++i)
        glGetVertexAttribfv(i, GL_CURRENT_VERTEX_ATTRIB, attributeValues[i].data());

    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, hostBufferSize, nullptr, GL_STREAM_COPY);
    glBindBuffer(GL_ARRAY_BUFFER, 0);

    textures = makeTextures(buffer);
    renderbuffer = makeRenderbuffer();
    for (const HostTexture& texture : textures)
        if (texture.target == GL_TEXTURE_2D_ARRAY) {
            drawFramebuffer = makeFramebuffer(texture.name, 0, renderbuffer);
            readFramebuffer = makeFramebuffer(texture.name, 1, renderbuffer);
        }
    sampler = makeSampler();
    vertexArray = makeVertexArray(buffer);
    program = makeProgram(
        fullScreenVertexSource,
        "#version 330 core\nout vec4 colour;\nvoid main() { colour = vec4(1.0, 0.0, 1.0, 1.0); }\n",
        {"gl_Position"});
    glGenQueries(static_cast<GLsizei>(queries.size()), queries.data());
    if (has(separateShaders))
        glGenProgramPipelines(1, &pipeline);
    if (has(transformFeedback2))
        glGenTransformFeedbacks(1, &transformFeedback);
}

HostObjects::~HostObjects()
{
    if (transformFeedback != 0)
        glDeleteTransformFeedbacks(1, &transformFeedback);
    if (pipeline != 0)
        glDeleteProgramPipelines(1, &pipeline);
    glDeleteQueries(static_cast<GLsizei>(queries.size()), queries.data());
    glDeleteProgram(program);
    glDeleteVertexArrays(1, &vertexArray);
    glDeleteSamplers(1, &sampler);
    glDeleteRenderbuffers(1, &renderbuffer);
    glDeleteFramebuffers(1, &readFramebuffer);
    glDeleteFramebuffers(1, &drawFramebuffer);
    for (const HostTexture& texture : textures)
        glDeleteTextures(1, &texture.name);
    glDeleteBuffers(1, &buffer);
}

} // namespace tests
