// A map's own texels in the middle of level 0.
uniform int guard; // texels before the first
uniform int layer;

void main()
{
    colour = fetched(ivec3(ivec2(gl_FragCoord.xy) - guard, layer));
}
