#include "capture/varyings.h"

#include "capture/packing.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <cctype>

namespace mirrorball::capture {

namespace {

// The number in [N], where N is written there or is a constant of the shader's.
int elementsOf(const std::string& suffix, const HostShader& shader)
{
    if (suffix.empty())
        return 1;
    const std::string inner = suffix.substr(1, suffix.size() - 2);
    if (std::all_of(inner.begin(), inner.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
        return inner.empty() ? 0 : std::atoi(inner.c_str());
    return shader.constant(inner).value_or(0);
}

std::string troubleOf(const Varying& varying)
{
    if (!shapeOf(varying.type))
        return "it is no scalar, vector or matrix of float, int or uint, nor an array of them";
    return varying.elements < 1 ? "its size '" + varying.arraySuffix + "' is no number" : "";
}

Varying varyingOf(std::size_t index, const Declaration& input, const Declaration& output,
                  const HostShader& fragment)
{
    Varying varying{index,           input.type, input.name, input.arraySuffix, input.interpolation,
                    input.auxiliary, output.name};
    varying.elements = elementsOf(input.arraySuffix, fragment);
    if (!input.arraySuffix.empty() && varying.elements > 0)
        varying.arraySuffix = "[" + std::to_string(varying.elements) + "]";
    varying.trouble = troubleOf(varying);
    return varying;
}

// The members of a block that both shaders have.
void addMembers(std::vector<Varying>& varyings, std::size_t index, const Declaration& input,
                const Declaration& output, const HostShader& vertex, const HostShader& fragment)
{
    std::string body;
    for (const Declaration& member : output.members) {
        const Varying written = varyingOf(index, member, member, vertex);
        body += qualifiers(written) + written.type + " " + written.name + written.arraySuffix + ";\n";
    }
    for (std::size_t member = 0; member < input.members.size(); ++member) {
        const Declaration& declared = input.members[member];
        Varying varying = varyingOf(index, declared, declared, fragment);
        varying.name = (input.instance.empty() ? "" : input.instance + ".") + declared.name;
        varying.block = input.name;
        varying.blockBody = member == 0 ? body : "";
        varying.member = static_cast<int>(member);
        if (input.hasConditions || output.hasConditions)
            varying.trouble = "its block has preprocessor lines inside";
        if (!input.arraySuffix.empty() || !output.arraySuffix.empty())
            varying.trouble = "its block is an array";
        varyings.push_back(varying);
    }
}

} // namespace

std::string qualifiers(const Varying& varying)
{
    return (varying.interpolation.empty() ? "" : varying.interpolation + " ") +
           (varying.auxiliary.empty() ? "" : varying.auxiliary + " ");
}

std::vector<Varying> varyingsOf(const HostShader& vertex, const HostShader& fragment)
{
    std::vector<Varying> varyings;
    const auto& declarations = fragment.declarations();
    for (std::size_t index = 0; index < declarations.size(); ++index) {
        const Declaration& input = declarations[index];
        if (input.storage != "in" || input.type.empty() || input.name.rfind("gl_", 0) == 0)
            continue;
        const auto& outputs = vertex.declarations();
        const auto output = std::find_if(outputs.begin(), outputs.end(), [&](const Declaration& candidate) {
            const bool joined = input.isBlock || input.location.empty() || candidate.location.empty()
                                    ? candidate.name == input.name
                                    : candidate.location == input.location;
            return candidate.storage == "out" && candidate.isBlock == input.isBlock && joined;
        });
        // What nobody writes may be declared all the same; the driver complains if it is read.
        if (output == outputs.end())
            continue;
        if (input.isBlock)
            addMembers(varyings, index, input, *output, vertex, fragment);
        else
            varyings.push_back(varyingOf(index, input, *output, fragment));
    }
    return varyings;
}

Outputs outputsOf(const HostShader& fragment)
{
    Outputs outputs;
    for (const Declaration& declaration : fragment.declarations()) {
        if (declaration.storage != "out" || declaration.name.rfind("gl_", 0) == 0)
            continue;
        if (declaration.location == "0" && !outputs.colour.empty()) {
            outputs.others.push_back(outputs.colour);
            outputs.colour = declaration.name;
        } else if (outputs.colour.empty()) {
            outputs.colour = declaration.name;
        } else if (declaration.name != outputs.colour) {
            outputs.others.push_back(declaration.name);
        }
        if (!declaration.arraySuffix.empty())
            throw Error(ErrorKind::badShader, fragment.name(),
                        "its output '" + declaration.name + "' is an array",
                        "declare the colour by itself: out vec4 colour;");
    }
    if (outputs.colour.empty())
        throw Error(ErrorKind::badShader, fragment.name(), "it has no output",
                    "declare one: out vec4 colour;");
    // Of several branches one may be compiled.
    const auto mayBeOfFloats = [&](const Declaration& declaration) {
        const std::string& type = declaration.type;
        return declaration.storage == "out" && declaration.name == outputs.colour && type != "int" &&
               type != "uint" && !type.starts_with("ivec") && !type.starts_with("uvec");
    };
    if (std::ranges::none_of(fragment.declarations(), mayBeOfFloats))
        throw Error(ErrorKind::badShader, fragment.name(),
                    "its output '" + outputs.colour + "' is of integers",
                    "declare one of floats: out vec4 colour;");
    return outputs;
}

} // namespace mirrorball::capture
