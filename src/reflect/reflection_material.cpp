#include <mirrorball/reflect/reflection_material.h>

#include "reflect_shaders.h"

#include <array>
#include <utility>

namespace mirrorball {

namespace {

constexpr std::array<std::pair<std::string_view, Lookup>, 4> lookups = {{{"infinite", Lookup::infinite},
                                                                         {"sphere", Lookup::sphere},
                                                                         {"box", Lookup::box},
                                                                         {"distance", Lookup::distance}}};

std::string replaced(std::string_view given, std::string_view from, std::string_view to)
{
    std::string text(given);
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// mirrorball_shownDirection, and what it needs.
std::string shownDirectionGlsl(const ReflectionMaterial& material)
{
    switch (material.lookup) {
    case Lookup::infinite:
        break;
    case Lookup::sphere:
        return replaced(reflect::shaders::lookupProxy, "MIRRORBALL_BOX", "0");
    case Lookup::box:
        return replaced(reflect::shaders::lookupProxy, "MIRRORBALL_BOX", "1");
    case Lookup::distance:
        return std::string(reflect::shaders::lookupMarch);
    }
    return std::string(reflect::shaders::lookupInfinite);
}

// A march looks many directions up; none of them needs the answers for those that are not regular.
std::string marchMapGlsl(const ReflectionMaterial& material)
{
    if (material.lookup != Lookup::distance)
        return {};
    return mapGlsl(material.map, material.version, material.prefix + "regular_", GlslInputs::regular);
}

} // namespace

std::optional<Lookup> lookupFromName(std::string_view name)
{
    for (const auto& [known, lookup] : lookups)
        if (known == name)
            return lookup;
    return std::nullopt;
}

std::string reflectionGlsl(const ReflectionMaterial& material)
{
    const std::string text = std::string(reflect::shaders::uniforms) + shownDirectionGlsl(material) +
                             std::string(reflect::shaders::material);
    return mapGlsl(material.map, material.version, material.prefix) + marchMapGlsl(material) +
           replaced(text, "mirrorball_", material.prefix);
}

} // namespace mirrorball
