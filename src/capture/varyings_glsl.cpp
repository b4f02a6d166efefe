#include "capture/varyings_glsl.h"

#include "capture/packing.h"

namespace mirrorball::capture {

namespace {

std::string onlyWhereDeclared(const Varying& varying, const std::string& lines,
                              const std::string& otherwise = "")
{
    return "#ifdef " + declarationMark + std::to_string(varying.declaration) + "\n" + lines +
           (otherwise.empty() ? "" : "#else\n" + otherwise) + "#endif\n";
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

// A statement for each element of an array, handed the element's number and what selects it; one for anything else.
// With constant indices and never of a whole array at once: the simplest for every driver.
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

} // namespace

std::string carriedName(const Varying& varying)
{
    return prefix + "varying" + std::to_string(varying.declaration) +
           (varying.block.empty() ? "" : "_member" + std::to_string(varying.member));
}

std::string geometryVaryings(const std::vector<Varying>& varyings, Carriage carriage)
{
    const bool isExact = carriage == Carriage::exact;
    const Packing packing(isExact ? std::span(varyings) : std::span<const Varying>());
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
    const Packing packing(isExact ? std::span(varyings) : std::span<const Varying>());
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
