// Leaves out pieces of triangles that lie behind what is drawn already, by the farthest distances of blocks of texels.
uniform sampler2DArray mirrorballCapture_farthest; // level 0: of 8 x 8 texels; each level twice as wide

// From the centre to the nearest point of a straight edge.
float mirrorballCapture_edgeDistance(vec3 a, vec3 b)
{
    vec3 ab = b - a;
    return length(a - clamp(dot(a, ab) / max(dot(ab, ab), 1e-37), -1.0, 0.0) * ab);
}

// From the centre to the nearest point of a triangle.
float mirrorballCapture_triangleDistance(vec3 vertex[3], vec3 inward[3], vec4 plane)
{
    float edges = min(min(mirrorballCapture_edgeDistance(vertex[0], vertex[1]),
                          mirrorballCapture_edgeDistance(vertex[1], vertex[2])),
                      mirrorballCapture_edgeDistance(vertex[2], vertex[0]));
    vec3 foot = plane.w < 0.0 ? -plane.xyz : plane.xyz;
    vec3 inside = vec3(dot(inward[0], foot), dot(inward[1], foot), dot(inward[2], foot));
    return all(greaterThanEqual(inside, vec3(0.0))) ? abs(plane.w) / max(length(plane.xyz), 1e-37) : edges;
}

// Whether a triangle, no nearer than `nearest`, lies behind everything that is drawn between two corners of a layer.
bool mirrorballCapture_isBehind(int layer, vec2 low, vec2 high, float nearest, vec4 plane)
{
    low = clamp(low, vec2(0.0), mirrorballCapture_size - 0.5);
    high = clamp(high, low, mirrorballCapture_size - 0.5);
    // The plane's distance in a direction is w / (normal . direction), which changes by less than the normal's length
    // times the angle.
    vec3 middle = mirrorballCapture_directionFromSquare(layer, 0.5 * (low + high) / mirrorballCapture_size);
    float sway = 0.5 * length(high - low) * MIRRORBALL_SPREAD * length(plane.xyz);
    nearest = max(nearest, abs(plane.w) / (abs(dot(plane.xyz, middle)) + sway));
    ivec2 first = ivec2(low) / 8;
    ivec2 last = ivec2(high) / 8;
    int across = max(last.x - first.x, last.y - first.y);
    int level = across > 1 ? int(ceil(log2(float(across)) + 1e-3)) : 0; // where there are two blocks or fewer each way
    first >>= level;
    last >>= level;
    vec4 blocks = vec4(texelFetch(mirrorballCapture_farthest, ivec3(first, layer), level).r,
                       texelFetch(mirrorballCapture_farthest, ivec3(last.x, first.y, layer), level).r,
                       texelFetch(mirrorballCapture_farthest, ivec3(first.x, last.y, layer), level).r,
                       texelFetch(mirrorballCapture_farthest, ivec3(last, layer), level).r);
    // A ten thousandth for the rounding of all.
    return nearest > 1.0001 * max(max(blocks.x, blocks.y), max(blocks.z, blocks.w));
}
