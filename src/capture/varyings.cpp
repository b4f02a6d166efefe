#include "capture/varyings.h"

#include "capture/packing.h"

#include "gl/context.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace mirrorball::capture {

namespace {

// Scalars of a varying as the host's shaders hand it on.
int scalarsOf(const Varying& varying)
{
    const std::optional<TypeShape> shape = shapeOf(varying.type);
    return (shape ? shape->scalars() : 4) * std::max(varying.elements, 1);
}

// Branches of an #if may declare one name twice: the first counts.
bool isCounted(std::span<const Varying> varyings, std::size_t index)
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

std::string onlyWhereDeclared(const Varying& varying, const std::string& lines,
                              const std::string& otherwise = "")
{
    return "#ifdef " + declarationMark + std::to_string(varying.declaration) + "\n" + lines +
           (otherwise.empty() ? "" : "#else\n" + otherwise) + "#endif\n";
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
    return prefix + "varying" + std::to_string(varying.declaration) +
           (varying.block.empty() ? "" : "_member" + std::to_string(varying.member));
}

// What declares the vertex shader's output in the stage after it, an array over the corners.
std::string fromVertex(const Varying& varying)
{
    if (varying.block.empty())
        return qualifiers(varying) + "in " + varying.type + " " + varying.vertexName + "[]" +
               varying.arraySuffix + ";\n";
    if (varying.blockBody.empty())
        return "";
    return "in " + varying.block + "\n{\n" + varying.blockBody + "} " + prefix + "block" +
           std::to_string(varying.declaration) + "[];\n";
}

std::string atCorner(const Varying& varying, const std::string& corner)
{
    return varying.block.empty() ? varying.vertexName + "[" + corner + "]"
                                 : prefix + "block" + std::to_string(varying.declaration) + "[" + corner +
                                       "]." + varying.vertexName;
}

// A statement for each element of an array, handed the element's number and what selects it; one for anything else. With
// constant indices and never of a whole array at once: the simplest for every driver.
template <class Statement>
std::string forElements(const Varying& varying, Statement statement)
{
    if (varying.arraySuffix.empty())
        return statement(0, std::string());
    std::string lines;
    for (int element = 0; element < varying.elements; ++element)
        lines += statement(element, "[" + std::to_string(element) + "]");
    return lines;
}

// The mean of three corners by a vector of weights; of a flat varying, the provoking vertex's value.
template <class Corner>
std::string mixed(const Varying& varying, const std::string& weight, Corner corner)
{
    if (isFlat(varying))
        return corner(2);
    std::string sum;
    for (int index = 0; index < 3; ++index)
        sum += (index == 0 ? "" : " + ") + weight + "." + "xyz"[index] + " * " + corner(index);
    return sum;
}

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

std::string described(const Varying& varying, const std::string& programName)
{
    return "varying '" + varying.type + " " + varying.name + varying.arraySuffix + "' of '" + programName +
           "'";
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
    return outputs;
}

int ownScalars(Carriage carriage)
{
    constexpr int position = 4, layer = 1, primitive = 1;
    switch (carriage) {
    case Carriage::exact:
        return position + layer + 9 + 4 + 2; // three edges, a plane, two numbers
    case Carriage::copied:
        return ownScalars(Carriage::direct) + layer + primitive;
    default:
        return position + 3 + 3; // the position in the probe's frame, three clip distances
    }
}

int scalarsOf(std::span<const Varying> varyings, Carriage carriage)
{
    if (carriage == Carriage::exact)
        return ownScalars(carriage) + Packing(varyings).scalars();
    int sum = ownScalars(carriage);
    for (std::size_t index = 0; index < varyings.size(); ++index)
        sum += isCounted(varyings, index) ? scalarsOf(varyings[index]) : 0;
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
    for (std::size_t index = 0; index < varyings.size(); ++index) {
        const Varying& varying = varyings[index];
        const std::string asked = described(varying, programName);
        std::string trouble = carriage == Carriage::direct ? "" : varying.trouble;
        // The stage after the vertex shader's reads arrays of arrays; within a block it does not.
        if (carriage != Carriage::direct && !varying.arraySuffix.empty() && varying.block.empty() &&
            epoxy_gl_version() < 43 && !epoxy_has_gl_extension("GL_ARB_arrays_of_arrays"))
            trouble = "this driver has no arrays of arrays";
        if (!trouble.empty())
            throw Error(ErrorKind::badShader, asked, trouble + ", and this capture carries no others",
                        "split it up or capture with perVertex");
        const std::span<const Varying> soFar = std::span(varyings).first(index + 1);
        const int before = scalarsOf(soFar, Carriage::direct), after = scalarsOf(soFar, carriage);
        const bool isTooLong = before > limits.before;
        if (isTooLong || (carriage != Carriage::direct && after > limits.after))
            throw Error(ErrorKind::badShader, asked,
                        "capture needs " + std::to_string(isTooLong ? before : after) +
                            " scalars a vertex up to it and this driver has " +
                            std::to_string(isTooLong ? limits.before : limits.after),
                        "hand over fewer varyings");
    }
}

void requireNoneWithoutResource(const std::vector<Varying>& varyings, Carriage carriage,
                                const std::string& linkError, const std::string& programName)
{
    const std::size_t begin = linkError.find("does not link");
    const std::string log = begin == std::string::npos ? "" : linkError.substr(begin);
    if (log.find("resource") == std::string::npos)
        return;
    const auto isNamed = [&](const std::string& name) {
        return log.find("\"" + name + "\"") != std::string::npos ||
               log.find("\"" + name + "[") != std::string::npos;
    };
    const auto found = std::ranges::find_if(varyings, [&](const Varying& varying) {
        return isNamed(varying.vertexName) || isNamed(carriedName(varying));
    });
    const bool isPacked =
        carriage == Carriage::exact && log.find("\"" + prefix + "packed") != std::string::npos;
    if (found == varyings.end() && !(isPacked && !varyings.empty()))
        return;
    const Varying& varying = found != varyings.end() ? *found : varyings.back();
    throw Error(ErrorKind::badShader, described(varying, programName),
                "this driver has no room for it beside those before", "hand over fewer varyings");
}

std::string geometryVaryings(const std::vector<Varying>& varyings, Carriage carriage)
{
    const bool isExact = carriage == Carriage::exact;
    const Packing packing(varyings);
    std::string declarations = isExact ? packing.declarations("out") : "", copies;
    for (std::size_t index = 0; index < varyings.size(); ++index) {
        const Varying& varying = varyings[index];
        std::string declaration = fromVertex(varying);
        if (!isExact)
            declaration += qualifiers(varying) + "out " + varying.type + " " + carriedName(varying) +
                           varying.arraySuffix + ";\n";
        const std::string copy = forElements(varying, [&](int element, const std::string& at) {
            if (!isExact)
                return carriedName(varying) + at + " = " + atCorner(varying, prefix + "corner") + at + ";\n";
            std::string lines;
            for (int corner = isFlat(varying) ? 2 : 0; corner < 3; ++corner)
                lines +=
                    packing.write(index, corner, element, atCorner(varying, std::to_string(corner)) + at);
            return lines;
        });
        declarations += onlyWhereDeclared(varying, declaration);
        copies += onlyWhereDeclared(varying, copy);
    }
    const std::string parameters = isExact ? "()" : "(int " + prefix + "corner)";
    return declarations + "void " + prefix + "copyVaryings" + parameters + "\n{\n" + copies + "}\n";
}

std::string controlVaryings(const std::vector<Varying>& varyings)
{
    std::string declarations, copies;
    const std::string corner = "gl_InvocationID"; // outputs may be written at no other
    for (const Varying& varying : varyings) {
        const std::string name = carriedName(varying) + "_control";
        declarations += onlyWhereDeclared(varying, fromVertex(varying) + "out " + varying.type + " " + name +
                                                       "[]" + varying.arraySuffix + ";\n");
        copies += onlyWhereDeclared(varying, forElements(varying, [&](int, const std::string& at) {
                                        return name + "[" + corner + "]" + at + " = " +
                                               atCorner(varying, corner) + at + ";\n";
                                    }));
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
            onlyWhereDeclared(varying, "in " + varying.type + " " + name + "[]" + varying.arraySuffix +
                                           ";\n" + qualifiers(varying) + "out " + varying.type + " " +
                                           carriedName(varying) + varying.arraySuffix + ";\n");
        mixes += onlyWhereDeclared(varying, forElements(varying, [&](int, const std::string& at) {
                                       const auto ofCorner = [&](int corner) {
                                           return name + "[" + std::to_string(corner) + "]" + at;
                                       };
                                       return carriedName(varying) + at + " = " +
                                              mixed(varying, weight, ofCorner) + ";\n";
                                   }));
    }
    return declarations + "void " + prefix + "mixVaryings(vec3 " + weight + ")\n{\n" + mixes + "}\n";
}

std::string fragmentVaryings(const std::vector<Varying>& varyings, Carriage carriage)
{
    if (carriage == Carriage::direct)
        return "void " + prefix + "readVaryings() {}\n";
    const bool isExact = carriage == Carriage::exact;
    const Packing packing(varyings);
    std::string declarations = isExact ? packing.declarations("in") : "", reads;
    for (std::size_t index = 0; index < varyings.size(); ++index) {
        const Varying& varying = varyings[index];
        if (!isExact)
            declarations +=
                onlyWhereDeclared(varying, qualifiers(varying) + "in " + varying.type + " " +
                                               carriedName(varying) + varying.arraySuffix + ";\n");
        reads += onlyWhereDeclared(
            varying, forElements(varying, [&](int element, const std::string& at) {
                const auto ofCorner = [&](int corner) { return packing.read(index, corner, element); };
                return varying.name + at + " = " +
                       (isExact ? mixed(varying, prefix + "weight", ofCorner) : carriedName(varying) + at) +
                       ";\n";
            }));
    }
    return declarations + "void " + prefix + "readVaryings()\n{\n" + reads + "}\n";
}

std::string fragmentPosition(const Varying* position)
{
    const std::string own = "return " + prefix + "position;\n";
    const std::string hosts =
        position == nullptr
            ? own
            : onlyWhereDeclared(*position, "return " + position->name + " - " + prefix + "centre;\n", own);
    return "vec3 " + prefix + "fromCentre()\n{\n" + hosts + "}\n";
}

} // namespace mirrorball::capture
