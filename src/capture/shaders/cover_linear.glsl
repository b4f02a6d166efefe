// Views in which great circles are straight lines: cube faces, octants of the octahedral map. On the equi-angular cube
// each axis is then bent by one monotone function.
uniform mat3 mirrorballCapture_clipFromDirection[MIRRORBALL_SLOTS];
uniform mat3 mirrorballCapture_lineFromDirection[MIRRORBALL_SLOTS];

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

float mirrorballCapture_straightFromSquare(float square)
{
#if MIRRORBALL_EQUI_ANGULAR_CUBE
    float halfTurns = 0.5 * square - 0.25;
    return mirrorballCapture_sinPi(halfTurns) / mirrorballCapture_cosPi(halfTurns);
#else
    return 2.0 * square - 1.0;
#endif
}

void mirrorballCapture_narrowByLine(vec3 line, float y, inout vec2 extent)
{
    float rise = line.y * y + line.z + 1e-5 * length(line);
    float bound = clamp(-rise / (abs(line.x) > 1e-30 ? line.x : 1e-30), -40.0, 40.0);
    bound = mirrorballCapture_texelFromStraight(vec2(bound, 0.0)).x / mirrorballCapture_size.x;
    extent = line.x >= 0.0 ? vec2(max(extent.x, bound), extent.y) : vec2(extent.x, min(extent.y, bound));
}

void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent)
{
    mirrorballCapture_narrowByLine(mirrorballCapture_lineFromDirection[MIRRORBALL_SLOT(view)] * edge,
                                   mirrorballCapture_straightFromSquare(at), extent);
}

#if MIRRORBALL_OCTAHEDRAL
// An octant is a triangle of the layer: |x| + |y| <= 1 with the octant's signs in the upper half, >= 1 in the lower.
void mirrorballCapture_narrowToView(int view, float from, float to, inout vec2 extent)
{
    vec2 signs = vec2((view & 1) == 0 ? 1.0 : -1.0, (view & 2) == 0 ? 1.0 : -1.0);
    vec2 y = signs.y * (2.0 * vec2(from, to) - 1.0);
    float nearest = min(y.x, y.y);
    float farthest = max(y.x, y.y);
    vec2 x = (view & 4) == 0 ? vec2(0.0, 1.0 - max(nearest, 0.0)) : vec2(1.0 - min(farthest, 1.0), 1.0);
    x = 0.5 * signs.x * x + 0.5;
    extent = vec2(max(extent.x, min(x.x, x.y)), min(extent.y, max(x.x, x.y)));
    if (farthest < 0.0)
        extent = vec2(20.0, -20.0);
}
#endif

// Lines are straight on a cube face and in an octant. On the equi-angular cube they are x = atan(a tan y + b), whose
// derivative is a / (cos^2 y + (a sin y + b cos y)^2): its extremes are a quarter turn apart.
float mirrorballCapture_inflection(int view, vec3 edge, float at)
{
#if MIRRORBALL_EQUI_ANGULAR_CUBE
    vec3 line = mirrorballCapture_lineFromDirection[MIRRORBALL_SLOT(view)] * edge;
    float halfTurns = 0.5 * mirrorballCapture_atan2Pi(2.0 * line.y * line.z, dot(line.xz, line.xz) - line.y * line.y);
    float place = 2.0 * halfTurns + 0.5;
    return place + floor(at - place + 0.5);
#else
    return -9.0;
#endif
}

#if MIRRORBALL_CURVED
void mirrorballCapture_coverLarge(int view, vec3 vertex[3], vec3 edge[3], float first, float last,
                                  inout mirrorballCapture_Cover cover)
{
    // Vertices, as far as they lie in front, and where an edge's line crosses the layer's sides: what lies between these,
    // along a line that is level or nearly so, may begin and end at vertices far out.
    float events[9];
    for (int k = 0; k < 3; ++k) {
        vec3 local = mirrorballCapture_clipFromDirection[MIRRORBALL_SLOT(view)] * vertex[k];
        vec3 line = mirrorballCapture_lineFromDirection[MIRRORBALL_SLOT(view)] * edge[k];
        float across = abs(line.y) > 1e-30 ? line.y : 1e-30;
        bool inFront = local.z > 1e-4 * length(vertex[k]);
        vec3 place = vec3(inFront ? local.y / local.z : 0.0, (line.x - line.z) / across, (-line.x - line.z) / across);
        for (int which = 0; which < 3; ++which)
            events[k + 3 * which] = mirrorballCapture_texelFromStraight(vec2(clamp(place[which], -2.0, 2.0))).y /
                                    mirrorballCapture_size.y;
    }
    vec3 planes[4];
    mirrorballCapture_boundingPlanes(vertex, edge, planes);
    mirrorballCapture_coverStrips(view, planes, events, first, last, cover);
}
#endif

void mirrorballCapture_coverIn(int view, vec3 vertex[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    vec2 p[3];
    bool inFront = true;
    bvec4 beyond = bvec4(true); // a side of the view, with all vertices
    for (int k = 0; k < 3; ++k) {
        vec3 local = mirrorballCapture_clipFromDirection[MIRRORBALL_SLOT(view)] * vertex[k];
        inFront = inFront && local.z > 0.3 * length(vertex[k]);
        beyond = bvec4(ivec4(beyond) * ivec4(greaterThan(vec4(local.xy, -local.xy), vec4(local.z * 1.0001))));
        p[k] = local.xy / local.z;
    }
    vec3 chord = vec3(distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1]));
    for (int k = 0; k < 3; ++k)
        p[k] = mirrorballCapture_texelFromStraight(p[k]);
#if MIRRORBALL_EQUI_ANGULAR_CUBE
    // (4/pi) atan bends by at most 0.827 (its second derivative) on each axis. Sideways that tells most on a diagonal,
    // where either axis has half of chord^2: sag <= sqrt(2) * 0.827 / 8 * chord^2 / 2, rounded up by a tenth.
    vec3 sag = 0.08 * chord * chord * 0.5 * mirrorballCapture_size.x;
#else
    vec3 sag = vec3(0.0);
#endif
    mirrorballCapture_coverTriangle(p, sag, cover);
    if (any(beyond))
        cover.count = 0;
#if MIRRORBALL_CURVED
    bool small = inFront && max(max(chord.x, chord.y), chord.z) < 0.5;
    vec3 y = vec3(p[0].y, p[1].y, p[2].y) / mirrorballCapture_size.y;
    float first = inFront ? clamp(min(min(y.x, y.y), y.z), 0.0, 1.0) : 0.0;
    float last = inFront ? clamp(max(max(y.x, y.y), y.z), 0.0, 1.0) : 1.0;
    // A loop of one turn: software rasterisers leave loops that nobody enters, and the loops within, after one turn.
    for (int turns = small || any(beyond) ? 0 : 1; turns > 0; --turns)
        mirrorballCapture_coverLarge(view, vertex, edge, first, last, cover);
#else
    if (!inFront && !any(beyond))
        mirrorballCapture_coverLayer(cover);
#endif
}
