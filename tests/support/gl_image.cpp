#include "support/gl_image.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace tests {

const std::string_view fullScreenVertexSource = R"(#version 330 core
out vec2 uv;
void main()
{
    uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
)";

namespace {

int query(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

[[noreturn]] void fail(const std::string& message)
{
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(1);
}

std::string withLineNumbers(std::string_view source)
{
    std::istringstream lines{std::string(source)};
    std::string numbered;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        numbered += std::to_string(number) + ": " + line + "\n";
    return numbered;
}

GLuint compile(GLenum stage, std::string_view source)
{
    const GLuint shader = glCreateShader(stage);
    const GLchar* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        char log[4096] = "";
        glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        fail(withLineNumbers(source) + log);
    }
    return shader;
}

// While it lives, glReadPixels packs tightly into client memory, does not clamp, and reads from a framebuffer
// of ours.
class ReadBack
{
public:
    ReadBack()
    {
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        for (const Parameter& parameter : parameters_)
            glPixelStorei(parameter.name, parameter.name == GL_PACK_ALIGNMENT ? 1 : 0);
        glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    }
    ~ReadBack()
    {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(hostFramebuffer_));
        glDeleteFramebuffers(1, &framebuffer_);
        glClampColor(GL_CLAMP_READ_COLOR, static_cast<GLenum>(hostClamp_));
        for (const Parameter& parameter : parameters_)
            glPixelStorei(parameter.name, parameter.hostValue);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(hostBuffer_));
    }
    ReadBack(const ReadBack&) = delete;
    ReadBack& operator=(const ReadBack&) = delete;

    std::vector<float> pixels(int width, int height) const
    {
        if (glCheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            fail("the texture to read cannot be attached to a framebuffer");
        std::vector<float> rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
        return rgba;
    }

private:
    struct Parameter
    {
        GLenum name;
        int hostValue;
    };

    static std::vector<Parameter> packing()
    {
        std::vector<Parameter> parameters;
        for (GLenum name : {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                            GL_PACK_SKIP_PIXELS, GL_PACK_ALIGNMENT})
            parameters.push_back({name, query(name)});
        if (epoxy_has_gl_extension("GL_MESA_pack_invert"))
            parameters.push_back({GL_PACK_INVERT_MESA, query(GL_PACK_INVERT_MESA)});
        return parameters;
    }

    const std::vector<Parameter> parameters_ = packing();
    const int hostBuffer_ = query(GL_PIXEL_PACK_BUFFER_BINDING);
    const int hostClamp_ = query(GL_CLAMP_READ_COLOR);
    const int hostFramebuffer_ = query(GL_READ_FRAMEBUFFER_BINDING);
    GLuint framebuffer_ = 0;
};

} // namespace

GLuint makeProgram(std::string_view vertexSource, std::string_view fragmentSource,
                   const std::vector<const char*>& captured)
{
    const GLuint program = glCreateProgram();
    const GLuint shaders[] = {compile(GL_VERTEX_SHADER, vertexSource),
                              compile(GL_FRAGMENT_SHADER, fragmentSource)};
    for (GLuint shader : shaders)
        glAttachShader(program, shader);
    if (!captured.empty())
        glTransformFeedbackVaryings(program, static_cast<GLsizei>(captured.size()), captured.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    for (GLuint shader : shaders) {
        glDetachShader(program, shader);
        glDeleteShader(shader);
    }
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        char log[4096] = "";
        glGetProgramInfoLog(program, sizeof log, nullptr, log);
        fail(withLineNumbers(vertexSource) + "\n" + withLineNumbers(fragmentSource) + log);
    }
    return program;
}

void drawFullScreenTriangle()
{
    const int hostVertexArray = query(GL_VERTEX_ARRAY_BINDING);
    GLuint vertexArray = 0;
    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(static_cast<GLuint>(hostVertexArray));
    glDeleteVertexArrays(1, &vertexArray);
}

ColourTarget::ColourTarget(int width, int height) : width_(width), height_(height)
{
    const int hostTexture = query(GL_TEXTURE_BINDING_2D);
    const int hostFramebuffer = query(GL_DRAW_FRAMEBUFFER_BINDING);
    const std::vector<float> zero(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                  0.0f);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, zero.data());
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(hostTexture));

    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail("a framebuffer with one RGBA32F texture is incomplete");
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(hostFramebuffer));
}

ColourTarget::~ColourTarget()
{
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void ColourTarget::bind() const
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
}

std::vector<float> ColourTarget::read() const
{
    return readTexture(texture_, width_, height_);
}

std::vector<float> readTexture(GLuint texture2d, int width, int height, int level)
{
    const ReadBack readBack;
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture2d, level);
    return readBack.pixels(width, height);
}

std::vector<float> readTextureLayer(GLuint texture, int layer, int width, int height, int level)
{
    const ReadBack readBack;
    glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, level, layer);
    return readBack.pixels(width, height);
}

std::vector<float> readMap(GLuint texture, mirrorball::MapKind map, int n)
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(map);
    std::vector<float> all;
    for (int layer = 0; layer < info.components; ++layer) {
        const auto texels = readTextureLayer(texture, layer, info.widthInN * n, info.heightInN * n);
        all.insert(all.end(), texels.begin(), texels.end());
    }
    return all;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

} // namespace tests
