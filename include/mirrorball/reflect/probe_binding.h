// Sets a map's textures and a material's uniforms on the host's program for the draws of one reflective
// object.
//
//     ProbeBinding binding(program);                    // once, after linking
//     {
//         auto bound = binding.bind(probe.map());
//         drawTeapot();
//     }                                                 // textures and samplers of the units are as before
#pragma once

#include <mirrorball/export.h>
#include <mirrorball/gl/objects.h>
#include <mirrorball/reflect/reflection_map.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <string>

namespace mirrorball {

enum class Filtering {
    linear, // within and between mip levels, across borders: where the map is filtered
    nearest // the texels of the map itself
};

struct MaterialSettings
{
    // For shaders that call mirrorball_material(own, reflection); mirrorball_reflection alone knows none of these.
    bool reflective = true; // false: the object's own colour
    glm::vec3 tint{1.0f};   // multiplied onto the reflection
    float blend = 1.0f;     // 0: own colour only, 1: reflection only

    glm::mat3 probeFromWorld{1.0f}; // turns the map further for this object, before the probe's own pose
    glm::mat4 worldFromView{1.0f};  // for inputs in view space: the inverse of the view matrix
    glm::dvec3 origin{0.0};         // world positions given to the shader are relative to this point
    Filtering filtering = Filtering::linear;
    // The longest pixels that LevelOfDetail::anisotropic follows, length to width. Below 1 is 1; above the driver's
    // limit, or NaN, is that limit.
    float anisotropy = 8.0f;
    // For Lookup::sphere and Lookup::box: an affine transformation of the unit sphere, or of the cube
    // [-1, 1]³, onto what stands for the surroundings. Without an inverse, or not finite, everything is infinitely far.
    glm::dmat4 worldFromProxy{0.0};
};

class MIRRORBALL_EXPORT ProbeBinding
{
public:
    // A linked program with reflectionGlsl in it (borrowed, to live as long). Uses the texture units firstUnit and
    // firstUnit + 1, for Lookup::layered two more, which the program's own samplers must leave free. Throws Error
    // badArgument for a program that is not linked, or that uses no look-up with this prefix (compilers drop what no
    // output depends on), and for units beyond the driver's limit; noContext, unsupported and hostBusy as a probe does,
    // and so does bind.
    explicit ProbeBinding(unsigned int program, int firstUnit = 0, std::string prefix = "mirrorball_");
    ~ProbeBinding();
    ProbeBinding(ProbeBinding&&) noexcept;
    ProbeBinding& operator=(ProbeBinding&&) noexcept;

    // Keeps the textures bound while it lives, then puts back what the units held. Of two that share units the later
    // one dies first.
    class MIRRORBALL_EXPORT Bound
    {
    public:
        ~Bound();
        Bound(Bound&&) noexcept;
        Bound& operator=(Bound&&) = delete; // it would put the units back while the new textures are wanted

    private:
        friend class ProbeBinding;
        struct Saved;
        explicit Bound(std::unique_ptr<Saved> saved);
        std::unique_ptr<Saved> saved_;
    };

    // Sets the uniforms (the current program stays current) and binds the textures. Throws Error badArgument for a map
    // without colours, or of another kind than the program looks up, and for a tint, blend, turn, view or origin that
    // is not finite.
    [[nodiscard]] Bound bind(const ReflectionMap& map, const MaterialSettings& settings = {}) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace mirrorball
