#include <mirrorball/reflect/reflection_material.h>

#include "reflect_shaders.h"

namespace mirrorball {

std::optional<Lookup> lookupFromName(std::string_view name)
{
    if (name == "infinite")
        return Lookup::infinite;
    return std::nullopt;
}

std::string reflectionGlsl(const ReflectionMaterial& material)
{
    constexpr std::string_view written = "mirrorball_";
    std::string text(reflect::shaders::reflection);
    for (std::size_t at = text.find(written); at != std::string::npos;
         at = text.find(written, at + material.prefix.size()))
        text.replace(at, written.size(), material.prefix);
    return mapGlsl(material.map, material.version, material.prefix) + text;
}

} // namespace mirrorball
