// A map as GLSL, printed from the same formula that C++ runs.
#pragma once

#include <mirrorball/export.h>
#include <mirrorball/maps/maps.h>

#include <string>

namespace mirrorball {

// What the printed functions may be called with.
enum class GlslInputs {
    any,    // every direction and every (u, v), with the answers that maps/direction.h defines
    regular // finite (u, v), and directions of length 1e-15 to 1e15 only: spares the regularisation
};

enum class GlslVersion { glsl330, glsl400, glsl450, es300 };

// "#version 330 core" and so on, with precision statements for es300, ending in a newline.
MIRRORBALL_EXPORT std::string glslVersionLine(GlslVersion version);

// Functions of one map, without a #version line. Every name begins with `prefix`, so that two maps fit into
// one shader; tests/golden/ has them all as printed.
//     const int <prefix>components;
//     int  <prefix>componentOf(vec3 direction)
//     vec2 <prefix>squareFromDirection(int component, vec3 direction)      not clamped
//     vec3 <prefix>directionFromSquare(int component, vec2 uv)             unit length
//     vec3 <prefix>coordinateFromDirection(vec3 direction)                 (u, v, component), clamped
// Throws Error, badArgument, for a prefix that GLSL allows no name to begin with.
MIRRORBALL_EXPORT std::string mapGlsl(MapKind map, GlslVersion version,
                                      const std::string& prefix = "mirrorball_",
                                      GlslInputs inputs = GlslInputs::any);

// For exact rasterisation: a direction of any length at a place in a layer of so many texels. On cube, octahedral and
// dual-paraboloid maps its coordinates are whole numbers and halves at a texel's centre (on the sphere map its x and y
// are), without rounding; other maps' rays have unit length.
//     vec3  <prefix>rayOfTexel(int component, vec2 place, vec2 size)       place within the layer
//     float <prefix>rayLength(vec3 ray)
// They call functions of mapGlsl with the same prefix.
MIRRORBALL_EXPORT std::string mapRaysGlsl(MapKind map, GlslVersion version,
                                          const std::string& prefix = "mirrorball_");

// How (u, v) changes with a regular direction, along two changes of it: the derivatives of the same formula.
//     vec4 <prefix>squareDerivatives(int component, vec3 direction, vec3 alongU, vec3 alongV)
//                                           xy: those of (u, v) along the first change, zw: along the second
MIRRORBALL_EXPORT std::string mapDerivativesGlsl(MapKind map, GlslVersion version,
                                                 const std::string& prefix = "mirrorball_");

} // namespace mirrorball
