// A side of a cube that the host has drawn.
#if MIRRORBALL_RECTANGLE
uniform sampler2DRect side;
#define MIRRORBALL_FETCH(texel) texelFetch(side, texel)
#else
uniform sampler2D side;
#define MIRRORBALL_FETCH(texel) texelFetch(side, texel, 0)
#endif
layout(location = 0) out vec4 colour;
layout(location = 1) out float distanceOfTexel;

void main()
{
    colour = MIRRORBALL_FETCH(ivec2(gl_FragCoord.xy));
    distanceOfTexel = uintBitsToFloat(0x7f800000u); // infinite: not known
}
