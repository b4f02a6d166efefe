#include "capture/varyings_room.h"

#include "capture/packing.h"
#include "capture/varyings_glsl.h"
#include "gl/context.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <algorithm>
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

std::string described(const Varying& varying, const std::string& programName)
{
    return "varying '" + varying.type + " " + varying.name + varying.arraySuffix + "' of '" + programName +
           "'";
}

} // namespace

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

} // namespace mirrorball::capture
