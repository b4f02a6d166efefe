uniform sampler2DArray mirrorball_colourMap;
uniform sampler2DArray mirrorball_distanceMap; // radial, world units
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

// As if everything were infinitely far: the position does not count.
vec3 mirrorball_coordinate(vec3 positionInWorld, vec3 directionInWorld)
{
    return mirrorball_coordinateFromDirection(mirrorball_mapFromWorld * directionInWorld);
}

vec4 mirrorball_lookUp(vec3 positionInWorld, vec3 directionInWorld)
{
    return textureLod(mirrorball_colourMap, mirrorball_coordinate(positionInWorld, directionInWorld), 0.0);
}

vec4 mirrorball_reflection(vec3 positionInWorld, vec3 normalInWorld, vec3 eyeInWorld)
{
    return mirrorball_lookUp(positionInWorld, mirrorball_reflected(normalInWorld, eyeInWorld - positionInWorld));
}

vec4 mirrorball_reflectionInView(vec3 positionInView, vec3 normalInView)
{
    vec3 directionInView = mirrorball_reflected(normalInView, -positionInView);
    return mirrorball_lookUp((mirrorball_worldFromView * vec4(positionInView, 1.0)).xyz,
                             mat3(mirrorball_worldFromView) * directionInView);
}

vec4 mirrorball_material(vec4 own, vec4 reflection)
{
    vec3 mirrored = mirrorball_tint * reflection.rgb;
    return mirrorball_reflective ? vec4(mix(own.rgb, mirrored, mirrorball_blend), own.a) : own;
}

vec4 mirrorball_shownPosition(vec3 positionInWorld, vec3 normalInWorld, vec3 eyeInWorld)
{
    vec3 directionInWorld = mirrorball_reflected(normalInWorld, eyeInWorld - positionInWorld);
    vec3 coordinate = mirrorball_coordinate(positionInWorld, directionInWorld);
    float radius = textureLod(mirrorball_distanceMap, coordinate, 0.0).r;
    vec3 inMap = mirrorball_directionFromSquare(int(coordinate.z), coordinate.xy);
    vec3 shown = mirrorball_centreInWorld + radius * (inMap * mirrorball_mapFromWorld);
    return radius < 1e30 ? vec4(shown, 1.0) : vec4(0.0);
}
