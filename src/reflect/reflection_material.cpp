#include <mirrorball/reflect/reflection_material.h>

#include "enumeration.h"
#include "reflect/uniform_names.h"
#include "reflect_shaders.h"

#include <mirrorball/maps/measures.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace mirrorball {

namespace {

constexpr std::array<std::pair<std::string_view, Lookup>, 5> lookups = {{{"infinite", Lookup::infinite},
                                                                         {"sphere", Lookup::sphere},
                                                                         {"box", Lookup::box},
                                                                         {"distance", Lookup::distance},
                                                                         {"layered", Lookup::layered}}};

std::string replaced(std::string_view given, std::string_view from, std::string_view to)
{
    std::string text(given);
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// mirrorball_shown, and what it needs.
std::string_view shownGlsl(const ReflectionMaterial& material)
{
    switch (material.lookup) {
    case Lookup::infinite:
        break;
    case Lookup::sphere:
    case Lookup::box:
        return reflect::shaders::lookupProxy;
    case Lookup::distance:
    case Lookup::layered:
        return reflect::shaders::lookupMarch;
    }
    return reflect::shaders::lookupInfinite;
}

std::string mapsGlsl(const ReflectionMaterial& material)
{
    // Of the many directions that are looked up, none needs the answers for those that are not regular.
    std::string text = mapGlsl(material.map, material.version, material.prefix);
    text += mapGlsl(material.map, material.version, material.prefix + "regular_", GlslInputs::regular);
    if (material.detail != LevelOfDetail::first)
        text += mapDerivativesGlsl(material.map, material.version, material.prefix);
    return text;
}

} // namespace

std::optional<Lookup> lookupFromName(std::string_view name)
{
    for (const auto& [known, lookup] : lookups)
        if (known == name)
            return lookup;
    return std::nullopt;
}

bool infiniteSuffices(MapKind map, int n, double radius, double nearestDistance)
{
    // The side of a square as large as the smallest texel. Smallest and mean keep their ratio with n, so a
    // small map tells it; steradians are shared out evenly otherwise.
    constexpr int small = 32;
    const MapMeasures measures = mapMeasures(map, small);
    const double texels = static_cast<double>(measures.texels) * n * n / (small * small);
    const double sphere = 4.0 * std::numbers::pi;
    const double texel = std::sqrt(sphere / texels * measures.smallestSolidAngle);
    return radius < nearestDistance * std::sin(texel);
}

std::string reflectionGlsl(const ReflectionMaterial& material)
{
    requireOneOf(material.lookup, Lookup::layered, "a material's look-up", "Lookup");
    requireOneOf(material.detail, LevelOfDetail::anisotropic, "a material's level of detail",
                 "LevelOfDetail");
    std::string text(reflect::shaders::uniforms);
    text += shownGlsl(material);
    text += reflect::shaders::sampling;
    text += reflect::shaders::material;
    text = replaced(text, "MIRRORBALL_DETAIL", std::to_string(static_cast<int>(material.detail)));
    text = replaced(text, "MIRRORBALL_PARALLAX", material.lookup == Lookup::infinite ? "0" : "1");
    text = replaced(text, "MIRRORBALL_LAYERED", material.lookup == Lookup::layered ? "1" : "0");
    text = replaced(text, "MIRRORBALL_BOX", material.lookup == Lookup::box ? "1" : "0");
    text = replaced(text, "mapFromWorld", reflect::mapFromWorld(material.map));
    return mapsGlsl(material) + replaced(text, "mirrorball_", material.prefix);
}

} // namespace mirrorball
