uniform sampler2DArray colours; // the map itself
uniform float largest;          // number that the texture's format holds
out vec4 colour;

float finite(float x)
{
    return map_isNan(x) ? 0.0 : clamp(x, -largest, largest);
}

vec4 fetched(ivec3 texel)
{
    vec4 found = texelFetch(colours, texel, 0);
    return vec4(finite(found.r), finite(found.g), finite(found.b), finite(found.a));
}

vec4 fetchedNearest(vec3 coordinate)
{
    ivec2 size = textureSize(colours, 0).xy;
    return fetched(ivec3(clamp(ivec2(coordinate.xy * vec2(size)), ivec2(0), size - 1), int(coordinate.z)));
}

