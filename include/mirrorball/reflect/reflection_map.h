// What pass 2 reads: a map of the sphere in layers of a texture array, wherever it came from.
#pragma once

#include <mirrorball/maps/maps.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace mirrorball {

struct ReflectionMap
{
    MapKind map = MapKind::tennisBall;
    int n = 0;
    unsigned int colourTexture = 0; // borrowed; GL_TEXTURE_2D_ARRAY, linear RGBA
    // Borrowed; GL_TEXTURE_2D_ARRAY, radial distance in world units; 0 if unknown.
    unsigned int distanceTexture = 0;
    glm::dmat4 worldFromProbe{1.0}; // rotation and translation: where directions are measured from
    // The second layer of depth, what the first hides; 0 if there is none.
    unsigned int hiddenColourTexture = 0;
    unsigned int hiddenDistanceTexture = 0;
    // The same colours with mip levels, and round each layer guard texels, which hold what is seen in their
    // own directions: filtering crosses no border. 0 if there is none.
    unsigned int filteredColourTexture = 0;
    glm::vec4 filteredFromSquare{1.0f, 1.0f, 0.0f, 0.0f}; // its coordinates: xy times (u, v) plus zw
    // Of distanceTexture: a texel there holds about the nearest distance of a block of them, so that a march knows
    // where it may begin (docs/reflection.md); 0 if there is no such level.
    int nearestLevel = 0;
    int hiddenN = 0; // n of the second layer; 0 if there is none
};

} // namespace mirrorball
