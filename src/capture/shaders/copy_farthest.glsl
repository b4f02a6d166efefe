// The farthest distance of every block of WIDTH x WIDTH texels; beyond the last texel it counts again.
uniform sampler2DArray distances; // its base level is read
uniform ivec2 last;               // texel of that
uniform int layer;
out float farthest;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * WIDTH;
    farthest = 0.0;
    for (int y = 0; y < WIDTH; ++y)
        for (int x = 0; x < WIDTH; ++x)
            farthest = max(farthest, texelFetch(distances, ivec3(min(first + ivec2(x, y), last), layer), 0).r);
}
