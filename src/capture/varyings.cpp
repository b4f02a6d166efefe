#include "capture/varyings.h"

#include "gl/context.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <map>
#include <optional>

namespace mirrorball::capture {

namespace {

bool isFlat(const Varying& varying)
{
    return varying.interpolation == "flat";
}

// Scalars of a numeric type, or nothing for a type that capture does not carry.
std::optional<int> scalarsOf(const std::string& type)
{
    static const std::map<std::string, int> known = [] {
        std::map<std::string, int> all = {{"float", 1}, {"int", 1}, {"uint", 1}};
        for (int size = 2; size <= 4; ++size) {
            const std::string suffix = std::to_string(size);
            for (const char* const vector : {"vec", "ivec", "uvec"})
                all[vector + suffix] = size;
            all["mat" + suffix] = size * size;
            for (int rows = 2; rows <= 4; ++rows)
                all["mat" + suffix + "x" + std::to_string(rows)] = size * rows;
        }
        return all;
    }();
    const auto found = known.find(type);
    return found == known.end() ? std::nullopt : std::optional(found->second);
}

// Scalars of a varying in one vertex of the stage that writes most.
int scalarsOf(const Varying& varying, Carriage carriage)
{
    const int one = scalarsOf(varying.type).value_or(4);
    return carriage == Carriage::exact && !isFlat(varying) ? 3 * one : one;
}

// Branches of an #if may declare one name twice: the greater counts, once.
bool isCounted(const std::vector<Varying>& varyings, std::size_t index)
{
    return std::none_of(varyings.begin(), varyings.begin() + static_cast<std::ptrdiff_t>(index),
                        [&](const Varying& before) { return before.name == varyings[index].name; });
}

struct Limits
{
    int before; // into the geometry stage, or between vertex and fragment stage
    int after;  // out of the geometry stage
};

Limits limitsOf(Carriage carriage, int vertices)
{
    const int vertex = gl::integer(GL_MAX_VERTEX_OUTPUT_COMPONENTS);
    const int fragment = gl::integer(GL_MAX_FRAGMENT_INPUT_COMPONENTS);
    if (carriage == Carriage::direct)
        return {std::min(vertex, fragment), 0};
    return {std::min(vertex, gl::integer(GL_MAX_GEOMETRY_INPUT_COMPONENTS)),
            std::min({gl::integer(GL_MAX_GEOMETRY_OUTPUT_COMPONENTS), fragment,
                      gl::integer(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS) / vertices})};
}

std::string onlyWhereDeclared(const Varying& varying, const std::string& lines)
{
    return "#ifdef " + declarationMark + std::to_string(varying.declaration) + "\n" + lines + "#endif\n";
}

std::string qualifiers(const Varying& varying)
{
    return (varying.interpolation.empty() ? "" : varying.interpolation + " ") +
           (varying.auxiliary.empty() ? "" : varying.auxiliary + " ");
}

// A varying between the geometry and the fragment stage. Numbered, since a host's name with the library's
// prefix could be a name of the library's.
std::string carriedName(const Varying& varying)
{
    return prefix + "varying" + std::to_string(varying.declaration);
}

std::string carriedName(const Varying& varying, int corner)
{
    return carriedName(varying) + "_" + std::to_string(corner);
}

} // namespace

std::vector<Varying> varyingsOf(const HostShader& vertex, const HostShader& fragment)
{
    std::vector<Varying> varyings;
    const auto& declarations = fragment.declarations();
    for (std::size_t index = 0; index < declarations.size(); ++index) {
        const Declaration& input = declarations[index];
        if (input.storage != "in" || input.type.empty() || input.name.rfind("gl_", 0) == 0)
            continue;
        if (input.isBlock)
            throw Error(ErrorKind::badShader, fragment.name(),
                        "it reads the interface block '" + input.name + "'",
                        "declare its members as varyings of their own");
        const auto& outputs = vertex.declarations();
        const auto output = std::find_if(outputs.begin(), outputs.end(), [&](const Declaration& candidate) {
            const bool joined = input.location.empty() || candidate.location.empty()
                                    ? candidate.name == input.name
                                    : candidate.location == input.location;
            return candidate.storage == "out" && joined;
        });
        // What nobody writes may be declared all the same; the driver complains if it is read.
        if (output != outputs.end())
            varyings.push_back({index, input.type, input.name, input.arraySuffix, input.interpolation,
                                input.auxiliary, output->name});
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
    return outputs;
}

int ownScalars(Carriage carriage)
{
    constexpr int position = 4;
    // Exact: three edges, a plane, two numbers. Otherwise: the position in the probe's frame and three clip
    // distances.
    return position + (carriage == Carriage::exact ? 9 + 4 + 2 : 3 + 3);
}

int scalarsOf(const std::vector<Varying>& varyings, Carriage carriage)
{
    int sum = ownScalars(carriage);
    for (std::size_t index = 0; index < varyings.size(); ++index)
        sum += isCounted(varyings, index) ? scalarsOf(varyings[index], carriage) : 0;
    return sum;
}

bool hasRoom(const std::vector<Varying>& varyings, Carriage carriage, int vertices)
{
    return carriage == Carriage::direct ||
           scalarsOf(varyings, carriage) <= limitsOf(carriage, vertices).after;
}

void requireRoom(const std::vector<Varying>& varyings, Carriage carriage, int vertices,
                 const std::string& programName)
{
    const Limits limits = limitsOf(carriage, vertices);
    int before = ownScalars(Carriage::copied), after = ownScalars(carriage);
    for (std::size_t index = 0; index < varyings.size(); ++index) {
        const Varying& varying = varyings[index];
        const std::string asked = "varying '" + varying.type + " " + varying.name + varying.arraySuffix +
                                  "' of '" + programName + "'";
        if (carriage == Carriage::exact && (!scalarsOf(varying.type) || !varying.arraySuffix.empty()))
            throw Error(ErrorKind::badShader, asked,
                        "exact capture carries scalars, vectors and matrices of float, int and uint only",
                        "split it up or capture with perVertex");
        if (!isCounted(varyings, index) || !varying.arraySuffix.empty())
            continue;
        before += scalarsOf(varying, Carriage::direct);
        after += scalarsOf(varying, carriage);
        const bool isTooLong = before > limits.before;
        if (isTooLong || (carriage != Carriage::direct && after > limits.after))
            throw Error(ErrorKind::badShader, asked,
                        "capture needs " + std::to_string(isTooLong ? before : after) +
                            " scalars a vertex up to it and this driver has " +
                            std::to_string(isTooLong ? limits.before : limits.after),
                        "hand over fewer varyings");
    }
}

std::string geometryVaryings(const std::vector<Varying>& varyings, Carriage carriage)
{
    const bool isExact = carriage == Carriage::exact;
    std::string declarations, copies;
    for (const Varying& varying : varyings) {
        std::string declaration = qualifiers(varying) + "in " + varying.type + " " + varying.vertexName +
                                  "[]" + varying.arraySuffix + ";\n";
        std::string copy;
        if (!isExact) {
            declaration += qualifiers(varying) + "out " + varying.type + " " + carriedName(varying) +
                           varying.arraySuffix + ";\n";
            copy = carriedName(varying) + " = " + varying.vertexName + "[" + prefix + "corner];\n";
        }
        for (int corner = isFlat(varying) ? 2 : 0; isExact && corner < 3; ++corner) {
            const std::string name = carriedName(varying, corner);
            declaration += "flat out " + varying.type + " " + name + ";\n";
            copy += name + " = " + varying.vertexName + "[" + std::to_string(corner) + "];\n";
        }
        declarations += onlyWhereDeclared(varying, declaration);
        copies += onlyWhereDeclared(varying, copy);
    }
    const std::string parameters = isExact ? "()" : "(int " + prefix + "corner)";
    return declarations + "void " + prefix + "copyVaryings" + parameters + "\n{\n" + copies + "}\n";
}

std::string controlVaryings(const std::vector<Varying>& varyings)
{
    std::string declarations, copies;
    const std::string corner = "[gl_InvocationID]"; // outputs may be written at no other
    for (const Varying& varying : varyings) {
        const std::string name = carriedName(varying) + "_control";
        declarations += onlyWhereDeclared(varying, "in " + varying.type + " " + varying.vertexName +
                                                       "[];\nout " + varying.type + " " + name + "[];\n");
        copies += onlyWhereDeclared(varying, name + corner + " = " + varying.vertexName + corner + ";\n");
    }
    return declarations + "void " + prefix + "copyVaryings()\n{\n" + copies + "}\n";
}

std::string evaluationVaryings(const std::vector<Varying>& varyings)
{
    std::string declarations, mixes;
    const std::string weight = prefix + "weight";
    for (const Varying& varying : varyings) {
        const std::string name = carriedName(varying) + "_control";
        declarations +=
            onlyWhereDeclared(varying, "in " + varying.type + " " + name + "[];\n" + qualifiers(varying) +
                                           "out " + varying.type + " " + carriedName(varying) + ";\n");
        std::string value = name + "[2]"; // of a flat one: the provoking vertex is the last
        if (!isFlat(varying))
            value = weight + ".x * " + name + "[0] + " + weight + ".y * " + name + "[1] + " + weight +
                    ".z * " + value;
        mixes += onlyWhereDeclared(varying, carriedName(varying) + " = " + value + ";\n");
    }
    return declarations + "void " + prefix + "mixVaryings(vec3 " + weight + ")\n{\n" + mixes + "}\n";
}

std::string fragmentVaryings(const std::vector<Varying>& varyings, Carriage carriage)
{
    if (carriage == Carriage::direct)
        return "void " + prefix + "readVaryings() {}\n";
    const std::string weight = prefix + "weight";
    std::string declarations, reads;
    for (const Varying& varying : varyings) {
        std::string declaration, value;
        if (carriage == Carriage::copied) {
            declaration = qualifiers(varying) + "in " + varying.type + " " + carriedName(varying) +
                          varying.arraySuffix + ";\n";
            value = carriedName(varying);
        }
        for (int corner = isFlat(varying) ? 2 : 0; carriage == Carriage::exact && corner < 3; ++corner) {
            declaration += "flat in " + varying.type + " " + carriedName(varying, corner) + ";\n";
            value += (value.empty() ? "" : " + ") +
                     (isFlat(varying) ? "" : weight + "." + "xyz"[corner] + " * ") +
                     carriedName(varying, corner);
        }
        declarations += onlyWhereDeclared(varying, declaration);
        reads += onlyWhereDeclared(varying, varying.name + " = " + value + ";\n");
    }
    return declarations + "void " + prefix + "readVaryings()\n{\n" + reads + "}\n";
}

} // namespace mirrorball::capture
