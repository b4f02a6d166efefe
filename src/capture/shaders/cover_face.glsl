// The equi-angular cube: straight lines on the gnomonic face, each axis then bent by one monotone function.
uniform mat3 mirrorballCapture_faceFromDirection[6]; // rows s, t and the major axis

float mirrorballCapture_bent(float x)
{
    return mirrorballCapture_squareFromDirection(4, vec3(x, 0.0, 1.0)).x;
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
    mat3 face = mirrorballCapture_faceFromDirection[view];
    vec3 local[3];
    bool inFront = true;
    for (int k = 0; k < 3; ++k) {
        local[k] = face * vertex[k];
        inFront = inFront && local[k].z > 0.3 * length(local[k]);
    }
    if (inFront) {
        vec2 x[3];
        vec2 p[3];
        for (int k = 0; k < 3; ++k) {
            x[k] = local[k].xy / local[k].z;
            p[k] = mirrorballCapture_squareFromDirection(view, vertex[k]) * mirrorballCapture_size;
        }
        vec3 chord = vec3(distance(x[1], x[2]), distance(x[2], x[0]), distance(x[0], x[1]));
        // (4/pi) atan bends by at most 0.827 (its second derivative): sag <= 0.827 / 8 chord^2 in [-1, 1] on each axis.
        if (max(max(chord.x, chord.y), chord.z) < 0.5)
            return mirrorballCapture_coverTriangle(p, 0.147 * chord * chord * 0.5 * mirrorballCapture_size.x, corner);
    }
    vec2 polygon[7];
    polygon[0] = vec2(-1.0, -1.0);
    polygon[1] = vec2(1.0, -1.0);
    polygon[2] = vec2(1.0, 1.0);
    polygon[3] = vec2(-1.0, 1.0);
    polygon[4] = polygon[5] = polygon[6] = vec2(0.0);
    int count = 4;
    for (int k = 0; k < 3; ++k)
        mirrorballCapture_cut((side < 0.0 ? -1.0 : 1.0) * (face * edge[k]), polygon, count);
    if (count == 0)
        return false;
    vec2 low = vec2(1.0);
    vec2 high = vec2(-1.0);
    for (int index = 0; index < count; ++index) {
        low = min(low, polygon[index]);
        high = max(high, polygon[index]);
    }
    low = vec2(mirrorballCapture_bent(low.x), mirrorballCapture_bent(low.y));
    high = vec2(mirrorballCapture_bent(high.x), mirrorballCapture_bent(high.y));
    return mirrorballCapture_coverBox(low * mirrorballCapture_size, high * mirrorballCapture_size, corner);
}
