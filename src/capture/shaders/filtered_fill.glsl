// Level 0 of a map with guard texels: each texel shows what is seen in its own direction, whichever component owns
// that.
uniform int guard; // texels before the map's first
uniform int layer;

vec2 squareFromTexels(vec2 texels)
{
    return (texels + 0.5) / vec2(textureSize(colours, 0).xy);
}

vec2 texelsFromSquare(vec2 uv)
{
    return uv * vec2(textureSize(colours, 0).xy) - 0.5;
}

// Where the direction of a texel's centre lies in the component that owns it.
vec3 ownerOf(int component, ivec2 texel)
{
    return map_coordinateFromDirection(map_directionFromSquare(component, squareFromTexels(vec2(texel))));
}

// Whether the map holds the colour that is seen in the direction of a texel's centre.
bool isKnown(int component, ivec2 texel)
{
#if MIRRORBALL_WHOLE_SQUARE
    return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, textureSize(colours, 0).xy));
#else
    vec3 owner = ownerOf(component, texel);
    return int(owner.z) == component && all(lessThan(abs(texelsFromSquare(owner.xy) - vec2(texel)), vec2(0.5)));
#endif
}

// The texel, or the nearest one of the component.
vec4 fetchedAt(int component, ivec2 texel)
{
    return fetched(ivec3(clamp(texel, ivec2(0), textureSize(colours, 0).xy - 1), component));
}

// The four texels around a place, and their weights in linear interpolation.
ivec2 around(vec2 place, int k)
{
    return ivec2(floor(place)) + ivec2(k & 1, k >> 1);
}

float weightOf(vec2 place, int k)
{
    vec2 share = mix(1.0 - fract(place), fract(place), vec2(k & 1, k >> 1));
    return share.x * share.y;
}

#if MIRRORBALL_WHOLE_SQUARE
// In place of a texel that is not known: one within half a texel of it, in the component that owns it.
vec4 replacement(int component, ivec2 texel, vec3 near)
{
    return fetchedNearest(ownerOf(component, texel));
}
#else
// Linear interpolation between those of the four that are known; their weights' sum.
vec4 meanOfKnown(vec3 coordinate, out float known)
{
    int component = int(coordinate.z);
    vec2 place = texelsFromSquare(coordinate.xy);
    vec4 sum = vec4(0.0);
    known = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 texel = around(place, k);
        float weight = isKnown(component, texel) ? weightOf(place, k) : 0.0;
        sum += weight * fetchedAt(component, texel);
        known += weight;
    }
    return known > 0.0 ? sum / known : fetchedNearest(coordinate);
}

// In place of a texel that is not known, near a coordinate of the same component: from the component that owns it, and
// where little is known there too, as next to a seam through both, from both sides of the seam.
vec4 replacement(int component, ivec2 texel, vec3 near)
{
    float known, knownHere;
    vec4 there = meanOfKnown(ownerOf(component, texel), known);
    vec4 here = meanOfKnown(near, knownHere);
    return mix(0.5 * (there + here), there, known);
}
#endif

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy) - guard;
    bool known = isKnown(layer, texel);
    colour = known ? fetchedAt(layer, texel) : vec4(0.0);

    vec3 owner = ownerOf(layer, texel);
    int component = int(owner.z);
    vec2 place = texelsFromSquare(owner.xy);
    for (int k = 0; k < 4 && !known; ++k) {
        ivec2 next = around(place, k);
        vec4 value = isKnown(component, next) ? fetchedAt(component, next) : replacement(component, next, owner);
        colour += weightOf(place, k) * value;
    }
}
