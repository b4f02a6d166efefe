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
    vec4 shown = mirrorball_shown(positionInWorld, directionInWorld);
    vec3 coordinate = mirrorball_coordinateFromDirection(shown.xyz);
    float radius = textureLod(mirrorball_distanceMap, coordinate, 0.0).r;
#if MIRRORBALL_LAYERED
    if (shown.w > 0.5)
        radius = textureLod(mirrorball_hiddenDistanceMap, coordinate, 0.0).r;
#endif
    vec3 inWorld = mirrorball_centreInWorld + radius * (normalize(shown.xyz) * mirrorball_mapFromWorld);
    return radius < 1e30 ? vec4(inWorld, 1.0) : vec4(0.0);
}
