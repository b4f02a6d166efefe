// As if everything were infinitely far: the position does not count.
vec4 mirrorball_shown(vec3 positionInWorld, vec3 directionInWorld)
{
    return vec4(mirrorball_mapFromWorld * directionInWorld, 0.0);
}

vec2 mirrorball_withinSurface(vec3 coordinate)
{
    return coordinate.xy;
}
