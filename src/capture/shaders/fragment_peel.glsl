// For the second layer: whether a surface lies behind the first one, farther by the separation asked for.
#if MIRRORBALL_PEELS
uniform sampler2DArray mirrorballCapture_firstAround; // the nearest distance of the first layer that a texel covers
uniform float mirrorballCapture_texelsPerSample;      // each way
uniform int mirrorballCapture_layer;
uniform float mirrorballCapture_separation; // relative to that distance

bool mirrorballCapture_isHidden(float radius)
{
    ivec3 texel = ivec3(gl_FragCoord.xy * mirrorballCapture_texelsPerSample, mirrorballCapture_layer);
    return radius > (1.0 + mirrorballCapture_separation) * texelFetch(mirrorballCapture_firstAround, texel, 0).r;
}
#else
bool mirrorballCapture_isHidden(float radius)
{
    return true;
}
#endif
