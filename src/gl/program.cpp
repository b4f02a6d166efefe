#include "gl/program.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <sstream>

namespace mirrorball::gl {

namespace {

// A log without the line ends and blanks at its end.
std::string trimmed(std::string log)
{
    while (!log.empty() && (log.back() == '\n' || log.back() == ' ' || log.back() == '\0'))
        log.pop_back();
    return log;
}

// Warnings of a shader that has errors, too, hide these.
std::string withoutWarnings(const std::string& log)
{
    if (log.find("error") == std::string::npos)
        return log;
    std::istringstream lines(log);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (line.find("warning") == std::string::npos)
            kept += (kept.empty() ? "" : "\n") + line;
    return kept;
}

std::string shaderLog(GLuint shader)
{
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return withoutWarnings(trimmed(log));
}

std::string programLog(GLuint program)
{
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return trimmed(log);
}

Shader compileShader(const ShaderSource& source)
{
    Shader shader(glCreateShader(source.stage));
    const char* const text = source.text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint compiled = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == 0)
        throw Error(ErrorKind::badShader, source.name, "it does not compile: " + shaderLog(shader.name()));
    return shader;
}

} // namespace

Program linkProgram(const std::vector<ShaderSource>& sources, const std::string& name,
                    const std::function<void(unsigned int)>& beforeLink)
{
    Program program = Program::create();
    std::vector<Shader> shaders;
    for (const ShaderSource& source : sources) {
        shaders.push_back(compileShader(source));
        glAttachShader(program.name(), shaders.back().name());
    }
    if (beforeLink)
        beforeLink(program.name());
    glLinkProgram(program.name());
    GLint linked = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == 0)
        throw Error(ErrorKind::badShader, name, "it does not link: " + programLog(program.name()));
    for (const Shader& shader : shaders)
        glDetachShader(program.name(), shader.name());
    return program;
}

} // namespace mirrorball::gl
