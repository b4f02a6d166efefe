// Compiles and links; failures become Error with the driver's log.
#pragma once

#include <mirrorball/gl/objects.h>

#include <functional>
#include <string>
#include <vector>

namespace mirrorball::gl {

struct ShaderSource
{
    unsigned int stage; // GL_VERTEX_SHADER, …
    std::string text;
    std::string name; // for messages: "the vertex shader of 'phong'"
};

// beforeLink runs on the program's name between attaching and linking (attribute and output locations).
// Throws Error badShader; nothing of the host's state changes.
Program linkProgram(const std::vector<ShaderSource>& sources, const std::string& name,
                    const std::function<void(unsigned int)>& beforeLink = {});

} // namespace mirrorball::gl
