// What is bound to every texture unit; and of the first units, the parameters of the textures and samplers
// too.
#include "support/gl_state_recorder.h"

#include <array>

namespace tests {

namespace {

// Parameters are read on these units only: with all of them (192 on llvmpipe) full of textures a capture
// would take 40,000 queries.
constexpr int unitsWithParameters = 8;

struct Target
{
    Enum name;
    GLenum binding;
    Gate gate = always;
    bool hasSamplerParameters = true; // buffer and multisample textures have none
};

constexpr Target targets[] = {
    {GL_ENUM(GL_TEXTURE_1D), GL_TEXTURE_BINDING_1D},
    {GL_ENUM(GL_TEXTURE_2D), GL_TEXTURE_BINDING_2D},
    {GL_ENUM(GL_TEXTURE_3D), GL_TEXTURE_BINDING_3D},
    {GL_ENUM(GL_TEXTURE_1D_ARRAY), GL_TEXTURE_BINDING_1D_ARRAY},
    {GL_ENUM(GL_TEXTURE_2D_ARRAY), GL_TEXTURE_BINDING_2D_ARRAY},
    {GL_ENUM(GL_TEXTURE_RECTANGLE), GL_TEXTURE_BINDING_RECTANGLE},
    {GL_ENUM(GL_TEXTURE_CUBE_MAP), GL_TEXTURE_BINDING_CUBE_MAP},
    {GL_ENUM(GL_TEXTURE_CUBE_MAP_ARRAY), GL_TEXTURE_BINDING_CUBE_MAP_ARRAY, cubeMapArray},
    {GL_ENUM(GL_TEXTURE_BUFFER), GL_TEXTURE_BINDING_BUFFER, always, false},
    {GL_ENUM(GL_TEXTURE_2D_MULTISAMPLE), GL_TEXTURE_BINDING_2D_MULTISAMPLE, always, false},
    {GL_ENUM(GL_TEXTURE_2D_MULTISAMPLE_ARRAY), GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY, always, false},
};

struct Parameter
{
    Enum name;
    int count = 1;
    Gate gate = always;
};

// Of textures and of samplers.
constexpr Parameter samplerParameters[] = {
    {GL_ENUM(GL_TEXTURE_MIN_FILTER)},
    {GL_ENUM(GL_TEXTURE_MAG_FILTER)},
    {GL_ENUM(GL_TEXTURE_WRAP_S)},
    {GL_ENUM(GL_TEXTURE_WRAP_T)},
    {GL_ENUM(GL_TEXTURE_WRAP_R)},
    {GL_ENUM(GL_TEXTURE_MIN_LOD)},
    {GL_ENUM(GL_TEXTURE_MAX_LOD)},
    {GL_ENUM(GL_TEXTURE_LOD_BIAS)},
    {GL_ENUM(GL_TEXTURE_COMPARE_MODE)},
    {GL_ENUM(GL_TEXTURE_COMPARE_FUNC)},
    {GL_ENUM(GL_TEXTURE_BORDER_COLOR), 4},
    {GL_ENUM(GL_TEXTURE_MAX_ANISOTROPY), 1, anisotropy},
    {GL_ENUM(GL_TEXTURE_CUBE_MAP_SEAMLESS), 1, seamlessPerTexture},
    {GL_ENUM(GL_TEXTURE_SRGB_DECODE_EXT), 1, srgbDecode},
};

constexpr Parameter textureParameters[] = {
    {GL_ENUM(GL_TEXTURE_BASE_LEVEL)},
    {GL_ENUM(GL_TEXTURE_MAX_LEVEL)},
    {GL_ENUM(GL_TEXTURE_SWIZZLE_RGBA), 4},
    {GL_ENUM(GL_TEXTURE_IMMUTABLE_FORMAT), 1, textureStorage},
    {GL_ENUM(GL_DEPTH_STENCIL_TEXTURE_MODE), 1, stencilTexturing},
};

constexpr Enum levelParameters[] = {GL_ENUM(GL_TEXTURE_WIDTH), GL_ENUM(GL_TEXTURE_HEIGHT),
                                    GL_ENUM(GL_TEXTURE_DEPTH), GL_ENUM(GL_TEXTURE_INTERNAL_FORMAT)};

// `get` is glGetTexParameterfv or glGetSamplerParameterfv, which pass enumerants and levels unchanged.
template <class Get, std::size_t n>
void recordParameters(StateRecorder& recorder, const std::string& owner, const Parameter (&parameters)[n],
                      Get get)
{
    for (const Parameter& parameter : parameters)
        if (has(parameter.gate)) {
            std::array<GLfloat, 4> values{};
            get(parameter.name.value, values.data());
            recorder.addFloats(owner + parameter.name.text,
                               std::span(values).first(static_cast<std::size_t>(parameter.count)));
        }
}

void recordBoundTexture(StateRecorder& recorder, const std::string& owner, const Target& target)
{
    const auto get = [&](GLenum name, GLfloat* values) {
        glGetTexParameterfv(target.name.value, name, values);
    };
    if (target.hasSamplerParameters)
        recordParameters(recorder, owner, samplerParameters, get);
    if (target.name.value != GL_TEXTURE_BUFFER)
        recordParameters(recorder, owner, textureParameters, get);
    const GLenum image =
        target.name.value == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target.name.value;
    for (const Enum& name : levelParameters) {
        GLint value = 0;
        glGetTexLevelParameteriv(image, 0, name.value, &value);
        recorder.addSymbol(owner + name.text, value);
    }
}

void recordUnit(StateRecorder& recorder, int unit, std::span<const Target> present)
{
    glActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(unit));
    for (const Target& target : present) {
        const int texture = limit(target.binding);
        std::string name = indexed(target.name.text, unit);
        if (texture != 0 && unit < unitsWithParameters)
            recordBoundTexture(recorder, name + " ", target);
        recorder.addSymbol(std::move(name), texture);
    }
    const int sampler = limit(GL_SAMPLER_BINDING);
    if (sampler != 0 && unit < unitsWithParameters)
        recordParameters(recorder, indexed("GL_SAMPLER_BINDING", unit) + " ", samplerParameters,
                         [&](GLenum name, GLfloat* values) {
                             glGetSamplerParameterfv(static_cast<GLuint>(sampler), name, values);
                         });
    recorder.addSymbol(indexed("GL_SAMPLER_BINDING", unit), sampler);
}

} // namespace

void recordTextureUnits(StateRecorder& recorder)
{
    std::vector<Target> present;
    for (const Target& target : targets)
        if (has(target.gate))
            present.push_back(target);
    const int activeUnit = limit(GL_ACTIVE_TEXTURE);
    const int count = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    for (int unit = 0; unit < count; ++unit)
        recordUnit(recorder, unit, present);
    glActiveTexture(static_cast<GLenum>(activeUnit));
}

} // namespace tests
