uniform sampler2DArray mirrorball_colourMap;
uniform sampler2DArray mirrorball_distanceMap; // radial, world units
#if MIRRORBALL_LAYERED
uniform sampler2DArray mirrorball_hiddenColourMap; // what the first surface hides
uniform sampler2DArray mirrorball_hiddenDistanceMap;
#endif
uniform mat3 mirrorball_mapFromWorld;
uniform vec3 mirrorball_centreInWorld;
uniform mat4 mirrorball_worldFromView;
uniform bool mirrorball_reflective;
uniform vec3 mirrorball_tint;
uniform float mirrorball_blend;

// The mirrored direction to the eye; a zero or NaN input gives a zero or NaN output, which the map answers.
vec3 mirrorball_reflected(vec3 normal, vec3 toEye)
{
    vec3 n = normalize(normal);
    return 2.0 * dot(n, toEye) * n - toEye;
}

