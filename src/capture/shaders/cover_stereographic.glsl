// The dual paraboloid is the stereographic projection: great circles become circles. With the map's axis as z and
// (a, b) in [-1, 1], the plane of normal m becomes the circle around (m.x, m.y) / m.z of radius |m| / |m.z| >= 1; its
// inside is where m . direction >= 0 for m.z > 0.

vec3 mirrorballCapture_local(int view, vec3 v)
{
    return vec3(v.xy, view == 0 ? -v.z : v.z);
}

void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent)
{
    vec3 m = mirrorballCapture_local(view, edge);
    float size = length(m);
    float b = 2.0 * at - 1.0;
    vec2 range = 2.0 * extent - 1.0;
    if (abs(m.z) < 0.01 * size) {
        // Nearly the straight line m.x a + m.y b = 0; the circle departs from it by less than (1 + 1) * 0.01 / 2 here.
        float bound = -(m.y * b + 0.02 * size) / (abs(m.x) > 1e-30 ? m.x : 1e-30);
        range = m.x >= 0.0 ? vec2(max(range.x, bound), range.y) : vec2(range.x, min(range.y, bound));
    } else {
        vec2 centre = m.xy / m.z;
        float squared = size * size / (m.z * m.z);
        float reach = squared - (b - centre.y) * (b - centre.y);
        if (m.z > 0.0) {
            float chord = sqrt(max(reach + 1e-4 * squared, 0.0));
            range = reach < -1e-4 * squared ? vec2(40.0, -40.0)
                                            : vec2(max(range.x, centre.x - chord), min(range.y, centre.x + chord));
        } else {
            // Outside the circle: what its chord takes away at either end.
            float chord = sqrt(max(reach - 1e-4 * squared, 0.0));
            vec2 ends = centre.x + vec2(-chord, chord);
            range.x = range.x > ends.x ? max(range.x, ends.y) : range.x;
            range.y = range.y < ends.y ? min(range.y, ends.x) : range.y;
        }
    }
    extent = 0.5 * range + 0.5;
}

// Either half of a circle bends one way.
float mirrorballCapture_inflection(int view, vec3 edge, float at)
{
    return -9.0;
}

#if MIRRORBALL_CURVED
void mirrorballCapture_coverCurved(int view, vec3 vertex[3], vec3 edge[3], vec2 p[3],
                                   inout mirrorballCapture_Cover cover)
{
    // Vertices, and where an edge's circle is widest or ends.
    float events[12];
    for (int k = 0; k < 3; ++k) {
        vec3 m = mirrorballCapture_local(view, edge[k]);
        float z = abs(m.z) > 1e-12 ? m.z : 1e-12;
        events[k] = 0.5 * p[k].y + 0.5;
        events[3 + 3 * k] = 0.5 * m.y / z + 0.5;
        events[4 + 3 * k] = events[3 + 3 * k] + 0.5 * length(m) / z;
        events[5 + 3 * k] = events[3 + 3 * k] - 0.5 * length(m) / z;
    }
    vec3 planes[4];
    mirrorballCapture_boundingPlanes(vertex, edge, planes);
    // The strips begin and end with the triangle: at a vertex, or where an edge's circle is widest, if that place is
    // the triangle's. Around the point behind the map's plane, which lies at infinity, there is no end.
    vec3 edgeZ, edgeLength;
    for (int k = 0; k < 3; ++k) {
        edgeZ[k] = mirrorballCapture_local(view, edge[k]).z;
        edgeLength[k] = length(edge[k]);
    }
    bool endless = all(lessThanEqual(edgeZ, 1e-4 * edgeLength));
    float first = endless ? 0.0 : 1.0;
    float last = 1.0 - first;
    for (int index = 0; index < 12; ++index) {
        ivec2 binding;
        float event = clamp(events[index], 0.0, 1.0);
        vec2 extent = mirrorballCapture_extentAt(view, planes, event, binding);
        if (index < 3 || extent.x <= extent.y) {
            first = min(first, event);
            last = max(last, event);
        }
    }
    mirrorballCapture_coverStrips(view, planes, events, first, last, cover);
}
#endif

// bend: the inverse radius of the edge's circle, in (a, b). An arc of a circle of radius r >= 1 over a chord of at most
// 1/2 rises by less than 0.1271 chord^2 / r over it; of a longer one nothing is said.
float mirrorballCapture_arcSag(float bend, float chord, vec2 step)
{
    float unit = 0.5 * mirrorballCapture_size.x;
    float squared = dot(step, step) / (unit * unit);
    return squared < 0.25 ? 0.1271 * bend * squared * unit : 1e9;
}

void mirrorballCapture_coverIn(int view, vec3 vertex[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    vec2 p[3];
    float lowest = 1.0;
    float highest = -1.0;
    for (int k = 0; k < 3; ++k) {
        vec3 unit = normalize(mirrorballCapture_local(view, vertex[k]));
        lowest = min(lowest, unit.z);
        highest = max(highest, unit.z);
        p[k] = unit.xy / max(1.0 + unit.z, 1e-6);
    }
    vec3 chord = vec3(distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1]));
    vec3 inverseRadius;
    for (int k = 0; k < 3; ++k)
        inverseRadius[k] = abs(edge[k].z) * inversesqrt(max(dot(edge[k], edge[k]), 1e-37));
    bool straight = lowest > -0.6 && max(max(chord.x, chord.y), chord.z) < 0.5;
    vec2 middle = 0.5 * mirrorballCapture_size;
    vec2 texel[3];
    for (int k = 0; k < 3; ++k)
        texel[k] = (p[k] + 1.0) * middle;
    float loose;
    vec3 sag = mirrorballCapture_sagsOf(texel, inverseRadius, chord, loose);
    mirrorballCapture_coverTriangle(texel, sag, cover);
    // The layer's corners lie at z = -1/3, and the cap beyond is convex.
    bool beyond = highest < -0.334;
    if (beyond)
        cover.count = 0;
#if MIRRORBALL_CURVED
    // Loops of one turn: software rasterisers leave loops that nobody enters, and the loops within, after one turn.
    bool covered = straight;
#if MIRRORBALL_STRIPS > 1
    float widest = straight ? 0.25 * (max(max(sag.x, sag.y), sag.z) + mirrorballCapture_guard) : 3.0;
    bool isLoose = straight ? cover.count > 0 && loose > 8.0 : lowest > -0.6;
    for (int turns = isLoose && !beyond ? 1 : 0; turns > 0; --turns)
        covered = mirrorballCapture_coverBand(view, vertex, edge, texel, MIRRORBALL_STRETCH, widest, inverseRadius,
                                              cover) ||
                  straight;
#endif
    for (int turns = covered || beyond ? 0 : 1; turns > 0; --turns)
        mirrorballCapture_coverCurved(view, vertex, edge, p, cover);
#else
    if (!straight && !beyond)
        mirrorballCapture_coverLayer(cover);
#endif
}
