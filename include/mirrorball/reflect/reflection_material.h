// Pass 2: the functions that a host's fragment shader calls to see the map.
//
//     std::string fragmentSource = "#version 330 core\n" + reflectionGlsl({.map = probe.map().map}) + R"(
//         in vec3 positionInWorld; in vec3 normalInWorld; uniform vec3 eyeInWorld; out vec4 colour;
//         void main() { colour = mirrorball_reflection(positionInWorld, normalInWorld, eyeInWorld); })";
//
// The host's source is never patched: it includes this text and calls it. ProbeBinding sets the uniforms.
#pragma once

#include <mirrorball/export.h>
#include <mirrorball/maps/glsl.h>
#include <mirrorball/maps/maps.h>

#include <optional>
#include <string>
#include <string_view>

namespace mirrorball {

// How the map is looked up with a reflected ray; docs/reflection.md has what each is good for, measured.
enum class Lookup {
    infinite, // as if everything were infinitely far: by the ray's direction alone
    sphere,   // the surroundings are taken for an ellipsoid, MaterialSettings::worldFromProxy
    box,      // … or for a box, which may be turned; neither need be centred on the probe
    distance, // the ray is marched against the captured distances; without any, as `infinite`
    layered,  // … of two layers of depth: the probe's Desc::layersOfDepth is 2; of one, about as `distance`
};

MIRRORBALL_EXPORT std::optional<Lookup> lookupFromName(std::string_view name);

// Whether Lookup::infinite is right to within the smallest texel of a map of size n: for a reflector of this
// radius around the probe, and everything that it mirrors at least so far from the probe. A point of its
// surface sees a place at most asin(radius / distance) away from where the probe sees it.
MIRRORBALL_EXPORT bool infiniteSuffices(MapKind map, int n, double radius, double nearestDistance);

// Which of the map's mip levels a pixel is filtered from; docs/reflection.md has what each costs. The map's
// own Jacobian tells it, so that no border, cut or pole shows.
enum class LevelOfDetail {
    first,      // the finest: no derivatives, so that it works in any shader stage; aliases where minified
    isotropic,  // as wide as the pixel's longer axis on the map
    anisotropic // along that axis as far as MaterialSettings::anisotropy allows, where the driver can
};

struct ReflectionMaterial
{
    MapKind map = MapKind::tennisBall;
    Lookup lookup = Lookup::infinite;
    GlslVersion version = GlslVersion::glsl330;
    std::string prefix = "mirrorball_"; // of every name, so that one shader can hold several maps
    LevelOfDetail detail = LevelOfDetail::isotropic;
};

// Functions and uniforms, without a #version line (<prefix> is written mirrorball_ here):
//     vec3 mirrorball_reflected(vec3 normal, vec3 toEye)            2(N·E)N - E; any lengths
//     vec4 mirrorball_lookUp(vec3 positionInWorld, vec3 directionInWorld)    the map along a ray
//     vec4 mirrorball_lookUpLevel(vec3 positionInWorld, vec3 directionInWorld, float level)    of one mip level
//     vec4 mirrorball_lookUpGradient(vec3 positionInWorld, vec3 directionInWorld,
//                                    vec3 positionAlongX, vec3 positionAlongY,       what both change by across
//                                    vec3 directionAlongX, vec3 directionAlongY)     the pixel
//     vec4 mirrorball_reflection(vec3 positionInWorld, vec3 normalInWorld, vec3 eyeInWorld)
//     vec4 mirrorball_reflectionInView(vec3 positionInView, vec3 normalInView)     eye at the origin
//     vec4 mirrorball_material(vec4 own, vec4 reflection)    tint and blend, or `own` if not reflective
//     vec4 mirrorball_shownPosition(vec3 positionInWorld, vec3 normalInWorld, vec3 eyeInWorld)
//                        xyz: the surface that the mirror shows, in world space; w: 1, or 0 if none
// With a level of detail other than `first`, functions without a level or changes use dFdx and dFdy: they are
// for fragment shaders, to be called by all pixels of an object alike. Without it there is no lookUpGradient.
// Throws Error badArgument for a prefix that GLSL allows no name to begin with, and for what its enumeration does not
// name.
MIRRORBALL_EXPORT std::string reflectionGlsl(const ReflectionMaterial& material);

} // namespace mirrorball
