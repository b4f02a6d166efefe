// The dual paraboloid is the stereographic projection: great circles become circles. With the map's axis as z and
// (a, b) in [-1, 1], the plane of normal m becomes the circle around (m.x, m.y) / m.z of radius |m| / |m.z| >= 1; its inside
// is where m . direction >= 0 for m.z > 0.

vec3 mirrorballCapture_local(int view, vec3 v)
{
    return vec3(v.xy, view == 0 ? -v.z : v.z);
}

void mirrorballCapture_narrow(int view, vec3 edge, float from, float to, inout vec2 extent)
{
    vec3 m = mirrorballCapture_local(view, edge);
    float size = length(m);
    vec2 b = 2.0 * vec2(from, to) - 1.0;
    vec2 range = 2.0 * extent - 1.0;
    if (abs(m.z) < 0.01 * size) {
        // Nearly the straight line m.x a + m.y b = 0; the circle departs from it by less than (1 + 1) * 0.01 / 2 here.
        float largest = max(m.y * b.x, m.y * b.y) + 0.02 * size;
        float bound = -largest / (abs(m.x) > 1e-30 ? m.x : 1e-30);
        range = m.x >= 0.0 ? vec2(max(range.x, bound), range.y) : vec2(range.x, min(range.y, bound));
    } else {
        vec2 centre = m.xy / m.z;
        float radius = size / abs(m.z);
        float nearest = clamp(centre.y, b.x, b.y) - centre.y;
        float farthest = max(abs(b.x - centre.y), abs(b.y - centre.y));
        if (m.z > 0.0) {
            float reach = radius * radius * 1.0001 - nearest * nearest;
            float chord = sqrt(max(reach, 0.0));
            range = reach < 0.0 ? vec2(2.0, -2.0)
                                : vec2(max(range.x, centre.x - chord), min(range.y, centre.x + chord));
        } else {
            // Outside the circle: what its narrowest chord in the strip takes away at either end.
            float chord = sqrt(max(radius * radius * 0.9999 - farthest * farthest, 0.0));
            vec2 ends = centre.x + vec2(-chord, chord);
            range.x = range.x > ends.x ? max(range.x, ends.y) : range.x;
            range.y = range.y < ends.y ? min(range.y, ends.x) : range.y;
        }
    }
    extent = 0.5 * range + 0.5 + vec2(-1e-4, 1e-4);
}

void mirrorballCapture_narrowToView(int view, float from, float to, inout vec2 extent)
{
}

void mirrorballCapture_coverIn(int view, vec3 vertex[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    vec2 p[3];
    float lowest = 1.0;
    for (int k = 0; k < 3; ++k) {
        vec3 unit = normalize(mirrorballCapture_local(view, vertex[k]));
        lowest = min(lowest, unit.z);
        p[k] = unit.xy / max(1.0 + unit.z, 1e-6);
    }
    vec3 chord = vec3(distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1]));
    // An arc of a circle of radius >= 1 over a chord of at most 1/2 rises by less than 0.127 chord^2 over it.
    if (lowest > -0.6 && max(max(chord.x, chord.y), chord.z) < 0.5) {
        vec2 middle = 0.5 * mirrorballCapture_size;
        for (int k = 0; k < 3; ++k)
            p[k] = (p[k] + 1.0) * middle;
        mirrorballCapture_coverTriangle(p, 0.127 * chord * chord * middle.x, cover);
        return;
    }
    mirrorballCapture_coverStrips(view, edge, 0.0, 1.0, cover);
}
