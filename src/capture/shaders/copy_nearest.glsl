#ifdef GL_ARB_texture_gather
#extension GL_ARB_texture_gather : enable
#endif
// Distances with fewer texels from finer ones: of every block of texels the nearest.
uniform sampler2DArray distances; // its base level is read
uniform ivec2 size;               // of what is drawn into
uniform int stride;               // 2: of every second texel each way
flat in int layer;
out float nearest;

void main()
{
    ivec2 from = textureSize(distances, 0).xy;
#ifdef GL_ARB_texture_gather
    if (from == 2 * size && stride == 1) {
        vec4 four = textureGather(distances, vec3(gl_FragCoord.xy / vec2(size), float(layer))); // around their corner
        nearest = min(min(four.x, four.y), min(four.z, four.w));
        return;
    }
#endif
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 first = texel * from / size;
    ivec2 end = ((texel + 1) * from + size - 1) / size; // rounded up: blocks overlap where sizes do not divide
    nearest = uintBitsToFloat(0x7f800000u);
    for (int y = first.y; y < end.y; y += stride)
        for (int x = first.x; x < end.x; x += stride)
            nearest = min(nearest, texelFetch(distances, ivec3(x, y, layer), 0).r);
}
