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

// The line's side as a bound of x in the strip between two values of y, all straight.
void mirrorballCapture_narrowByLine(vec3 line, vec2 y, inout vec2 extent)
{
    float largest = max(line.y * y.x, line.y * y.y) + line.z + 1e-5 * length(line);
    float bound = clamp(-largest / (abs(line.x) > 1e-30 ? line.x : 1e-30), -2.0, 2.0);
    bound = mirrorballCapture_texelFromStraight(vec2(bound, 0.0)).x / mirrorballCapture_size.x;
    extent = line.x >= 0.0 ? vec2(max(extent.x, bound), extent.y) : vec2(extent.x, min(extent.y, bound));
}

vec2 mirrorballCapture_straightFromSquare(vec2 square)
{
#if MIRRORBALL_EQUI_ANGULAR_CUBE
    // tan may be off by some 2^-10: a strip reaches that much over its borders.
    return tan((square - 0.5) * 1.5707963) + vec2(-2e-3, 2e-3);
#else
    return 2.0 * square - 1.0;
#endif
}

void mirrorballCapture_narrow(int view, vec3 edge, float from, float to, inout vec2 extent)
{
    mirrorballCapture_narrowByLine(mirrorballCapture_lineFromDirection[view] * edge,
                                   mirrorballCapture_straightFromSquare(vec2(from, to)), extent);
}

void mirrorballCapture_narrowToView(int view, float from, float to, inout vec2 extent)
{
#if MIRRORBALL_OCTAHEDRAL
    vec3 signs = vec3((view & 1) == 0 ? 1.0 : -1.0, (view & 2) == 0 ? 1.0 : -1.0, (view & 4) == 0 ? 1.0 : -1.0);
    mirrorballCapture_narrow(view, vec3(signs.x, 0.0, 0.0), from, to, extent);
    mirrorballCapture_narrow(view, vec3(0.0, signs.y, 0.0), from, to, extent);
    mirrorballCapture_narrow(view, vec3(0.0, 0.0, signs.z), from, to, extent);
#endif
}

void mirrorballCapture_coverIn(int view, vec3 vertex[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    vec2 p[3];
    bool inFront = true;
    for (int k = 0; k < 3; ++k) {
        vec3 local = mirrorballCapture_clipFromDirection[view] * vertex[k];
        inFront = inFront && local.z > 0.3 * length(vertex[k]);
        p[k] = local.xy / local.z;
    }
    float first = 0.0;
    float last = 1.0;
    if (inFront) {
        vec3 chord = vec3(distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1]));
        for (int k = 0; k < 3; ++k)
            p[k] = mirrorballCapture_texelFromStraight(p[k]);
        if (max(max(chord.x, chord.y), chord.z) < 0.5) {
#if MIRRORBALL_EQUI_ANGULAR_CUBE
            // (4/pi) atan bends by at most 0.827 (its second derivative): sag <= 0.827 / 8 chord^2 in [-1, 1] on each
            // axis.
            vec3 sag = 0.147 * chord * chord * 0.5 * mirrorballCapture_size.x;
#else
            vec3 sag = vec3(0.0);
#endif
            mirrorballCapture_coverTriangle(p, sag, cover);
            return;
        }
        first = clamp(min(min(p[0].y, p[1].y), p[2].y) / mirrorballCapture_size.y, 0.0, 1.0);
        last = clamp(max(max(p[0].y, p[1].y), p[2].y) / mirrorballCapture_size.y, 0.0, 1.0);
    }
    mirrorballCapture_coverStrips(view, edge, first, last, cover);
}
