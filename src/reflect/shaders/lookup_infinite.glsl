// As if everything were infinitely far: the position does not count.
vec4 mirrorball_shown(vec3 positionInWorld, vec3 directionInWorld)
{
    return vec4(mirrorball_mapFromWorld * directionInWorld, 0.0);
}

