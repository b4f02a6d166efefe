// As if everything were infinitely far: the position does not count.
vec3 mirrorball_shownDirection(vec3 positionInWorld, vec3 directionInWorld)
{
    return mirrorball_mapFromWorld * directionInWorld;
}

