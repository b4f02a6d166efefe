// How well a map samples the sphere, from any map's exact Jacobian.
#pragma once

#include <mirrorball/export.h>
#include <mirrorball/maps/maps.h>

namespace mirrorball {

// The unit direction at (u, v), and its derivatives: radians per unit of u and of v.
struct Jacobian
{
    glm::dvec3 direction;
    glm::dvec3 alongU;
    glm::dvec3 alongV;
};
MIRRORBALL_EXPORT Jacobian jacobian(MapKind map, int component, const glm::dvec2& uv);

// How (u, v) changes with the direction: the derivative of squareFromDirection along a change of the
// direction, which need not have unit length. The other way round, and with the radial part of the change lost.
MIRRORBALL_EXPORT glm::dvec2 squareDerivative(MapKind map, int component, const glm::dvec3& direction,
                                              const glm::dvec3& change);

// Steradians per unit of area of (u, v).
MIRRORBALL_EXPORT double solidAngleDensity(const Jacobian& jacobian);

// The singular values of the Jacobian for one texel of width x height texels: its longest and shortest extent
// in radians.
struct Stretch
{
    double longest;
    double shortest;
};
MIRRORBALL_EXPORT Stretch texelStretch(const Jacobian& jacobian, int width, int height);

// The larger of the angles between opposite corners of texel (column, row), in radians.
MIRRORBALL_EXPORT double texelDiagonal(MapKind map, int component, int column, int row, int width,
                                       int height);

// A whole map of n texels across the short side, over its used texels: those whose centre's direction belongs
// there.
struct MapMeasures
{
    int width = 0; // of a component, in texels
    int height = 0;
    long long texels = 0; // of all components
    long long used = 0;
    double worstDiagonal = 0;     // radians
    double meanDiagonal = 0;      // radians; means are weighted by solid angle
    double largestSolidAngle = 0; // of a texel, in units of 4 pi / texels
    double smallestSolidAngle = 0;
    double worstStretch = 0; // longest / shortest extent of a texel
    double meanStretch = 0;
};
// n >= 1
MIRRORBALL_EXPORT MapMeasures mapMeasures(MapKind map, int n);

// The n whose map comes nearest to so many texels in all, at least 1.
MIRRORBALL_EXPORT int shortSideFromTexels(MapKind map, double texels);

} // namespace mirrorball
