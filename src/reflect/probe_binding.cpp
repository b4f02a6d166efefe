#include <mirrorball/reflect/probe_binding.h>

#include "finite.h"
#include "gl/context.h"
#include "gl/state_guard.h"
#include "reflect/uniform_names.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mirrorball {

namespace {

constexpr int mostUnits = 4; // colour, distance, and both of the second layer of depth

// 0 where the proxy has no inverse, or where floats cannot hold it.
glm::mat4 proxyFromWorld(const glm::dmat4& worldFromProxy, const glm::dvec3& origin)
{
    glm::dmat4 relative = worldFromProxy;
    relative[3] = glm::dvec4(glm::dvec3(relative[3]) - origin, 1.0);
    const glm::mat4 inverse(glm::inverse(relative));
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(inverse[column][row]))
                return glm::mat4(0.0f);
    return inverse;
}

// Of worldFromProxy and anisotropy anything means something.
void requireUsable(const MaterialSettings& settings)
{
    requireFinite(glm::value_ptr(settings.tint), 3, "a material's tint");
    requireFinite(&settings.blend, 1, "a material's blend");
    requireFinite(glm::value_ptr(settings.probeFromWorld), 9, "a material's turn of the map");
    requireFinite(glm::value_ptr(settings.worldFromView), 16, "a material's view");
    requireFinite(glm::value_ptr(settings.origin), 3, "a material's origin");
}

gl::Sampler makeSampler(GLenum minified, GLenum magnified)
{
    gl::Sampler sampler = gl::Sampler::create();
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minified));
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnified));
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return sampler;
}

float mostAnisotropy()
{
    float most = 1.0f;
    if (epoxy_gl_version() >= 46 || epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    return most;
}

// Nearest texels are the map's own.
bool isFiltered(const ReflectionMap& map, const MaterialSettings& settings)
{
    return map.filteredColourTexture != 0 && settings.filtering == Filtering::linear;
}

} // namespace

struct ProbeBinding::Implementation
{
    unsigned int program;
    int firstUnit, units;
    std::string prefix;
    gl::Sampler filtered, linear, nearest;
    float mostAnisotropy;            // 1: not asked for, or the driver has none
    std::optional<MapKind> lookedUp; // by the program, if any

    int location(const std::string& name) const
    {
        return glGetUniformLocation(program, (prefix + name).c_str());
    }
    void requireMadeFor(MapKind given) const;
    void setUniforms(const ReflectionMap& map, const MaterialSettings& settings) const;
    unsigned int colourSampler(const ReflectionMap& map, const MaterialSettings& settings) const;
};

struct ProbeBinding::Bound::Saved
{
    struct Unit
    {
        int texture, sampler;
    };
    int firstUnit, units;
    Unit unit[mostUnits];
};

ProbeBinding::ProbeBinding(unsigned int program, int firstUnit, std::string prefix)
{
    gl::requireContext();
    const std::string asked = "a probe binding";
    GLint linked = GL_FALSE;
    if (glIsProgram(program) == GL_TRUE)
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE)
        throw Error(ErrorKind::badArgument, asked, "program " + std::to_string(program) + " is not linked",
                    "link it first");
    const auto isUsed = [&](const std::string& name) {
        return glGetUniformLocation(program, (prefix + name).c_str()) >= 0;
    };
    const bool isLayered = isUsed("hiddenDistanceMap");
    // llvmpipe filters anisotropically where the shader itself gives the level, too.
    const bool isAnisotropic = isUsed("widest");
    const int units = isLayered ? mostUnits : 2;
    const int limit = gl::integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    if (firstUnit < 0 || firstUnit > limit - units)
        throw Error(ErrorKind::badArgument, asked,
                    std::to_string(units) + " texture units from " + std::to_string(firstUnit) +
                        " on do not lie within the driver's " + std::to_string(limit),
                    "name another first unit");
    std::optional<MapKind> lookedUp;
    for (const MapInfo& info : maps())
        if (isUsed(reflect::mapFromWorld(info.kind)))
            lookedUp = info.kind;
    // The material function may stand beside a look-up of the host's own.
    if (!lookedUp && !isUsed("reflective"))
        throw Error(ErrorKind::badArgument, asked,
                    "program " + std::to_string(program) + " uses no look-up with the prefix \"" + prefix +
                        "\"",
                    "give the prefix of its reflectionGlsl");
    implementation_ = std::make_unique<Implementation>(Implementation{
        program, firstUnit, units, std::move(prefix), makeSampler(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR),
        makeSampler(GL_LINEAR, GL_LINEAR), makeSampler(GL_NEAREST, GL_NEAREST),
        isAnisotropic ? mostAnisotropy() : 1.0f, lookedUp});
}

ProbeBinding::~ProbeBinding() = default;
ProbeBinding::ProbeBinding(ProbeBinding&&) noexcept = default;
ProbeBinding& ProbeBinding::operator=(ProbeBinding&&) noexcept = default;

void ProbeBinding::Implementation::requireMadeFor(MapKind given) const
{
    if (lookedUp && *lookedUp != given)
        throw Error(ErrorKind::badArgument, "a binding of a reflection map",
                    "it is " + std::string(mapInfo(given).name) + " and the program looks up " +
                        std::string(mapInfo(*lookedUp).name),
                    "make the program with reflectionGlsl of the same map");
}

void ProbeBinding::Implementation::setUniforms(const ReflectionMap& map,
                                               const MaterialSettings& settings) const
{
    const GLint current = gl::integer(GL_CURRENT_PROGRAM);
    if (static_cast<unsigned int>(current) != program)
        glUseProgram(program);
    glUniform1i(location("colourMap"), firstUnit);
    glUniform1i(location("distanceMap"), firstUnit + 1);
    glUniform1i(location("hiddenColourMap"), firstUnit + 2);
    glUniform1i(location("hiddenDistanceMap"), firstUnit + 3);
    glUniform1i(location("nearestLevel"), map.nearestLevel);
    const glm::mat3 probeFromWorld(glm::transpose(glm::dmat3(map.worldFromProbe))); // a rotation
    const glm::mat3 mapFromWorld = probeFromWorld * settings.probeFromWorld;
    glUniformMatrix3fv(location(reflect::mapFromWorld(map.map)), 1, GL_FALSE, glm::value_ptr(mapFromWorld));
    const glm::vec3 centre(glm::dvec3(map.worldFromProbe[3]) - settings.origin);
    glUniform3fv(location("centreInWorld"), 1, glm::value_ptr(centre));
    const glm::vec4 textureFromSquare =
        isFiltered(map, settings) ? map.filteredFromSquare : glm::vec4(1.0f, 1.0f, 0.0f, 0.0f);
    glUniform4fv(location("textureFromSquare"), 1, glm::value_ptr(textureFromSquare));
    const MapInfo& info = mapInfo(map.map);
    glUniform2f(location("texels"), static_cast<float>(info.widthInN * map.n),
                static_cast<float>(info.heightInN * map.n));
    glUniform1f(location("widest"), 1.0f);
    glUniformMatrix4fv(location("worldFromView"), 1, GL_FALSE, glm::value_ptr(settings.worldFromView));
    const glm::mat4 proxy = proxyFromWorld(settings.worldFromProxy, settings.origin);
    glUniformMatrix4fv(location("proxyFromWorld"), 1, GL_FALSE, glm::value_ptr(proxy));
    glUniform1i(location("reflective"), settings.reflective ? 1 : 0);
    glUniform3fv(location("tint"), 1, glm::value_ptr(settings.tint));
    glUniform1f(location("blend"), settings.blend);
    if (static_cast<unsigned int>(current) != program)
        glUseProgram(static_cast<GLuint>(current));
}

unsigned int ProbeBinding::Implementation::colourSampler(const ReflectionMap& map,
                                                         const MaterialSettings& settings) const
{
    if (!isFiltered(map, settings))
        return (settings.filtering == Filtering::linear ? linear : nearest).name();
    if (mostAnisotropy > 1.0f)
        glSamplerParameterf(filtered.name(), GL_TEXTURE_MAX_ANISOTROPY_EXT,
                            std::max(1.0f, std::min(mostAnisotropy, settings.anisotropy))); // NaN: the most
    return filtered.name();
}

ProbeBinding::Bound ProbeBinding::bind(const ReflectionMap& map, const MaterialSettings& settings) const
{
    gl::requireContext();
    mapInfo(map.map); // throws
    const Implementation& self = *implementation_;
    self.requireMadeFor(map.map);
    requireUsable(settings);
    if (glIsTexture(map.colourTexture) != GL_TRUE)
        throw Error(ErrorKind::badArgument, "a binding of a reflection map", "it has no colour texture",
                    "capture or upload a map first");
    auto saved = std::make_unique<Bound::Saved>();
    saved->firstUnit = self.firstUnit;
    saved->units = self.units;
    const GLint active = gl::integer(GL_ACTIVE_TEXTURE);
    const unsigned int textures[mostUnits] = {
        isFiltered(map, settings) ? map.filteredColourTexture : map.colourTexture, map.distanceTexture,
        map.hiddenColourTexture, map.hiddenDistanceTexture};
    // Around what is hidden there is nothing: filtering would mix it in.
    const unsigned int samplers[mostUnits] = {self.colourSampler(map, settings), self.nearest.name(),
                                              self.nearest.name(), self.nearest.name()};
    for (int unit = 0; unit < self.units; ++unit) {
        const auto index = static_cast<GLuint>(self.firstUnit + unit);
        glActiveTexture(GL_TEXTURE0 + index);
        saved->unit[unit] = {gl::integer(GL_TEXTURE_BINDING_2D_ARRAY), gl::integer(GL_SAMPLER_BINDING)};
        glBindTexture(GL_TEXTURE_2D_ARRAY, textures[unit]);
        glBindSampler(index, samplers[unit]);
    }
    glActiveTexture(static_cast<GLenum>(active));
    self.setUniforms(map, settings);
    return Bound(std::move(saved));
}

ProbeBinding::Bound::Bound(std::unique_ptr<Saved> saved) : saved_(std::move(saved)) {}
ProbeBinding::Bound::Bound(Bound&&) noexcept = default;

ProbeBinding::Bound::~Bound()
{
    if (!saved_ || !gl::contextIsCurrent())
        return;
    const GLint active = gl::integer(GL_ACTIVE_TEXTURE);
    for (int unit = 0; unit < saved_->units; ++unit) {
        const auto index = static_cast<GLuint>(saved_->firstUnit + unit);
        const auto texture = static_cast<GLuint>(saved_->unit[unit].texture);
        const auto sampler = static_cast<GLuint>(saved_->unit[unit].sampler);
        glActiveTexture(GL_TEXTURE0 + index);
        glBindTexture(GL_TEXTURE_2D_ARRAY, glIsTexture(texture) == GL_TRUE ? texture : 0u);
        glBindSampler(index, glIsSampler(sampler) == GL_TRUE ? sampler : 0u);
    }
    glActiveTexture(static_cast<GLenum>(active));
}

} // namespace mirrorball
