// The dual paraboloid is the stereographic projection: great circles become circles. With the map's axis as z and
// (a, b) in [-1, 1], the plane of normal m becomes the circle around (m.x, m.y) / m.z of radius |m| / |m.z| >= 1.

vec3 mirrorballCapture_local(int view, vec3 v)
{
    return vec3(v.xy, view == 0 ? -v.z : v.z);
}

// Widens the box by the circle's extreme points, where they lie between two directions.
void mirrorballCapture_addArc(vec3 from, vec3 to, vec3 m, inout vec2 low, inout vec2 high)
{
    float size = length(m);
    // Nearly a straight line through the centre: its ends are its extremes, but for what lies beyond the layer.
    if (abs(m.z) < 1e-3 * size)
        return;
    vec2 centre = m.xy / m.z;
    float radius = size / abs(m.z);
    // m is parallel or antiparallel to from x to.
    vec3 turn = dot(cross(from, to), m) < 0.0 ? -m : m;
    vec3 inwardFrom = cross(turn, from);
    vec3 inwardTo = cross(to, turn);
    for (int index = 0; index < 4; ++index) {
        vec2 extreme = centre + radius * vec2(index == 0 ? 1.0 : index == 1 ? -1.0 : 0.0,
                                              index == 2 ? 1.0 : index == 3 ? -1.0 : 0.0);
        vec3 direction = vec3(2.0 * extreme, 1.0 - dot(extreme, extreme));
        float slack = -1e-4 * size * length(direction);
        if (dot(inwardFrom, direction) >= slack * length(from) && dot(inwardTo, direction) >= slack * length(to)) {
            low = min(low, extreme);
            high = max(high, extreme);
        }
    }
}

bool mirrorballCapture_cover(int view, vec3 vertex[3], vec3 edge[3], float side, out vec2 corner[4])
{
    vec3 unit[3];
    vec2 p[3];
    float lowest = 1.0;
    for (int k = 0; k < 3; ++k) {
        unit[k] = normalize(mirrorballCapture_local(view, vertex[k]));
        lowest = min(lowest, unit[k].z);
        p[k] = unit[k].xy / max(1.0 + unit[k].z, 1e-6);
    }
    vec2 middle = 0.5 * mirrorballCapture_size;
    vec3 chord = vec3(distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1]));
    // An arc of a circle of radius >= 1 over a chord of at most 1/2 rises by less than 0.1252 chord^2 over it.
    if (lowest > -0.6 && max(max(chord.x, chord.y), chord.z) < 0.5) {
        for (int k = 0; k < 3; ++k)
            p[k] = (p[k] + 1.0) * middle;
        return mirrorballCapture_coverTriangle(p, 0.127 * chord * chord * middle.x, corner);
    }
    vec3 m[3];
    vec3 edgeZ, edgeLength;
    for (int k = 0; k < 3; ++k) {
        m[k] = mirrorballCapture_local(view, edge[k]) * (side < 0.0 ? -1.0 : 1.0);
        edgeZ[k] = m[k].z;
        edgeLength[k] = length(m[k]);
    }
    vec2 low = min(min(p[0], p[1]), p[2]);
    vec2 high = max(max(p[0], p[1]), p[2]);
    // The point at infinity is the axis backwards: in the triangle, or near an edge of it, the box is everything.
    // An edge comes near it when its plane nearly holds the axis and an end looks backwards.
    bool holdsBack = all(lessThanEqual(edgeZ, 1e-3 * edgeLength));
    bool nearBack = lowest < -0.3 && any(lessThan(abs(edgeZ), 2e-3 * edgeLength));
    if (holdsBack || nearBack || lowest < -0.999) {
        low = vec2(-1.0);
        high = vec2(1.0);
    } else {
        for (int k = 0; k < 3; ++k)
            mirrorballCapture_addArc(unit[(k + 1) % 3], unit[(k + 2) % 3], m[k], low, high);
    }
    return mirrorballCapture_coverBox((low + 1.0) * middle - 0.01, (high + 1.0) * middle + 0.01, corner);
}
