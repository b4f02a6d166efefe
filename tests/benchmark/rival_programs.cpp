#include "rival_programs.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <string>

namespace tests::benchmark {

namespace {

constexpr std::string_view fragmentMain = R"(
out float distanceFromCentre;

void main()
{
    phongMain();
    distanceFromCentre = length(positionInWorld);
}
)";

constexpr std::string_view instancedMain = R"(
uniform mat4 clipFromFace[6];
uniform int faceList[6];

void main()
{
    phongMain();
    int face = faceList[gl_InstanceID];
    gl_Position = clipFromFace[face] * vec4(position, 1.0);
    gl_Layer = face;
}
)";

constexpr std::string_view layeredGeometry = R"(#version 330 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 18) out;
uniform mat4 clipFromFace[6];
uniform int faceList[6];
uniform int faceListLength;
in vec3 vertexPosition[];
in vec3 vertexNormal[];
in vec2 vertexUv[];
out vec3 positionInWorld;
out vec3 normalInWorld;
out vec2 uv;

bool outside(vec4 a, vec4 b, vec4 c)
{
    return (a.x > a.w && b.x > b.w && c.x > c.w) || (a.x < -a.w && b.x < -b.w && c.x < -c.w) ||
           (a.y > a.w && b.y > b.w && c.y > c.w) || (a.y < -a.w && b.y < -b.w && c.y < -c.w);
}

void main()
{
    for (int entry = 0; entry < faceListLength; ++entry) {
        int face = faceList[entry];
        vec4 clip[3];
        for (int corner = 0; corner < 3; ++corner)
            clip[corner] = clipFromFace[face] * vec4(vertexPosition[corner], 1.0);
        if (outside(clip[0], clip[1], clip[2]))
            continue;
        for (int corner = 0; corner < 3; ++corner) {
            positionInWorld = vertexPosition[corner];
            normalInWorld = vertexNormal[corner];
            uv = vertexUv[corner];
            gl_Position = clip[corner];
            gl_Layer = face;
            PRIMITIVE_NUMBER
            EmitVertex();
        }
        EndPrimitive();
    }
}
)";

void replace(std::string& text, std::string_view from, std::string_view to)
{
    const std::size_t at = text.find(from);
    if (at == std::string::npos)
        throw mirrorball::Error(mirrorball::ErrorKind::badShader, "a shader of the rivals",
                                "the Phong shader has no '" + std::string(from) + "'",
                                "adapt rival_programs.cpp to it");
    text.replace(at, from.size(), to);
}

void insertAfterVersion(std::string& text, std::string_view lines)
{
    text.insert(text.find('\n') + 1, lines);
}

std::string vertexSource(Rival rival)
{
    std::string text = examples::phongVertexSource();
    if (rival == Rival::layeredGeometry) {
        insertAfterVersion(text,
                           "#define positionInWorld vertexPosition\n#define normalInWorld vertexNormal\n"
                           "#define uv vertexUv\n");
    } else if (rival == Rival::layeredInstanced) {
        insertAfterVersion(text, "#extension GL_ARB_shader_viewport_layer_array : require\n");
        replace(text, "void main()", "void phongMain()");
        text += instancedMain;
    }
    return text;
}

std::string fragmentSource(examples::View view, RivalFormats formats)
{
    std::string text = examples::phongFragmentSource(view);
    if (formats == RivalFormats::eightBit)
        return text;
    replace(text, "void main()", "void phongMain()");
    return text + std::string(fragmentMain);
}

std::string geometrySource(examples::View view)
{
    std::string text(layeredGeometry);
    // Only where it is read: a primitive number that crosses stages makes some drivers un-share vertices.
    replace(text, "PRIMITIVE_NUMBER",
            view == examples::View::triangle ? "gl_PrimitiveID = gl_PrimitiveIDIn;" : "");
    return text;
}

void attach(GLuint program, GLenum stage, const std::string& source)
{
    const GLuint shader = glCreateShader(stage);
    const char* const text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    glDeleteShader(shader); // goes with the program
    if (compiled != GL_TRUE)
        throw mirrorball::Error(mirrorball::ErrorKind::badShader, "a shader of the rivals",
                                log.substr(0, static_cast<std::size_t>(length)));
}

} // namespace

mirrorball::gl::Program rivalProgram(Rival rival, examples::View view, RivalFormats formats)
{
    mirrorball::gl::Program program = mirrorball::gl::Program::create();
    attach(program.name(), GL_VERTEX_SHADER, vertexSource(rival));
    if (rival == Rival::layeredGeometry)
        attach(program.name(), GL_GEOMETRY_SHADER, geometrySource(view));
    attach(program.name(), GL_FRAGMENT_SHADER, fragmentSource(view, formats));
    glBindFragDataLocation(program.name(), 0, "colour");
    if (formats == RivalFormats::asTheLibrary)
        glBindFragDataLocation(program.name(), 1, "distanceFromCentre");
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE)
        throw mirrorball::Error(mirrorball::ErrorKind::badShader, "a program of the rivals",
                                "it does not link");
    return program;
}

} // namespace tests::benchmark
