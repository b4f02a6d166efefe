// The host's fragment shader runs on interpolated varyings; the distance is that of the interpolated position.
#if MIRRORBALL_DROPS_SMEAR
uniform vec2 mirrorballCapture_size;
#endif
uniform vec2 mirrorballCapture_range; // near, far
uniform vec3 mirrorballCapture_centre; // of the probe, where the host's positions are
in vec3 mirrorballCapture_position;    // in the probe's frame
out float mirrorballCapture_distance;

// From the library's own varying or, with one less, from the host's. Its text comes last, behind the host's names.
vec3 mirrorballCapture_fromCentre();

void mirrorballCapture_begin() {}

void mirrorballCapture_end()
{
    float radius = length(mirrorballCapture_fromCentre());
#if MIRRORBALL_CLIPS_RANGE
    if (radius < mirrorballCapture_range.x || radius > mirrorballCapture_range.y)
        discard;
#endif
#if MIRRORBALL_DROPS_SMEAR
    // A triangle across the map's cut is drawn the long way round: where the interpolated direction belongs more
    // than a sixteenth of the map away, that is a smear and not the triangle.
    vec2 square = mirrorballCapture_squareFromDirection(0, mirrorballCapture_position);
    vec2 here = gl_FragCoord.xy / mirrorballCapture_size;
    if (any(greaterThan(abs(square - here), vec2(0.0625))))
        discard;
#endif
    if (!mirrorballCapture_isHidden(radius))
        discard;
    mirrorballCapture_distance = radius;
}
