// Views in which great circles are straight lines: cube faces, octants of the octahedral map. On the equi-angular cube each
// axis is then bent by one monotone function.
uniform mat3 mirrorballCapture_clipFromDirection[MIRRORBALL_VIEWS];
uniform mat3 mirrorballCapture_lineFromDirection[MIRRORBALL_VIEWS];

// From [-1, 1] on the straight view to texels.
vec2 mirrorballCapture_texelFromStraight(vec2 p)
{
#if MIRRORBALL_EQUI_ANGULAR_CUBE
    vec2 square = vec2(mirrorballCapture_squareFromDirection(4, vec3(p.x, 0.0, 1.0)).x,
                       mirrorballCapture_squareFromDirection(4, vec3(p.y, 0.0, 1.0)).x);
#else
    vec2 square = 0.5 * p + 0.5;
#endif
    return square * mirrorballCapture_size;
}

// Cuts a convex polygon by line . (x, y, 1) >= -slack.
void mirrorballCapture_cut(vec3 line, inout vec2 polygon[7], inout int count)
{
    vec2 kept[7];
    int keptCount = 0;
    float slack = 1e-5 * length(line);
    for (int index = 0; index < count; ++index) {
        vec2 here = polygon[index];
        vec2 next = polygon[index + 1 < count ? index + 1 : 0];
        float a = dot(line, vec3(here, 1.0)) + slack;
        float b = dot(line, vec3(next, 1.0)) + slack;
        if (a >= 0.0 && keptCount < 7)
            kept[keptCount++] = here;
        if ((a >= 0.0) != (b >= 0.0) && keptCount < 7)
            kept[keptCount++] = mix(here, next, a / (a - b));
    }
    polygon = kept;
    count = keptCount;
}

bool mirrorballCapture_cover(int view, vec3 vertex[3], vec3 edge[3], float side, out vec2 corner[4])
{
    vec2 p[3];
    bool inFront = true;
    for (int k = 0; k < 3; ++k) {
        vec3 local = mirrorballCapture_clipFromDirection[view] * vertex[k];
        inFront = inFront && local.z > 0.3 * length(vertex[k]);
        p[k] = local.xy / local.z;
    }
    vec3 chord = vec3(distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1]));
    if (inFront && max(max(chord.x, chord.y), chord.z) < 0.5) {
        for (int k = 0; k < 3; ++k)
            p[k] = mirrorballCapture_texelFromStraight(p[k]);
#if MIRRORBALL_EQUI_ANGULAR_CUBE
        // (4/pi) atan bends by at most 0.827 (its second derivative): sag <= 0.827 / 8 chord^2 in [-1, 1] on each axis.
        vec3 sag = 0.147 * chord * chord * 0.5 * mirrorballCapture_size.x;
#else
        vec3 sag = vec3(0.0);
#endif
        return mirrorballCapture_coverTriangle(p, sag, corner);
    }
    vec2 polygon[7];
    polygon[3] = polygon[4] = polygon[5] = polygon[6] = vec2(0.0);
#if MIRRORBALL_OCTAHEDRAL
    vec2 signs = vec2((view & 1) == 0 ? 1.0 : -1.0, (view & 2) == 0 ? 1.0 : -1.0);
    polygon[0] = (view & 4) == 0 ? vec2(0.0) : signs;
    polygon[1] = vec2(signs.x, 0.0);
    polygon[2] = vec2(0.0, signs.y);
    int count = 3;
#else
    polygon[0] = vec2(-1.0, -1.0);
    polygon[1] = vec2(1.0, -1.0);
    polygon[2] = vec2(1.0, 1.0);
    polygon[3] = vec2(-1.0, 1.0);
    int count = 4;
#endif
    for (int k = 0; k < 3; ++k) {
        vec3 line = mirrorballCapture_lineFromDirection[view] * edge[k];
        mirrorballCapture_cut(side < 0.0 ? -line : line, polygon, count);
    }
    if (count == 0)
        return false;
    vec2 low = vec2(1.0);
    vec2 high = vec2(-1.0);
    for (int index = 0; index < count; ++index) {
        low = min(low, polygon[index]);
        high = max(high, polygon[index]);
    }
    return mirrorballCapture_coverBox(mirrorballCapture_texelFromStraight(low),
                                      mirrorballCapture_texelFromStraight(high), corner);
}
