// No strips here: what is neither straight nor in a sector takes the whole layer.
void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent) {}
float mirrorballCapture_inflection(int view, vec3 edge, float at)
{
    return -9.0;
}

// A triangle behind the map's plane, where the layer is an annulus of radius 1/2 sin(angle / 2): a box around the sector
// that holds its vertices. False where it holds the axis or goes round it.
bool mirrorballCapture_coverSector(vec3 unit[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    // The cap behind a plane z < 0 is convex: with its vertices in it, so is the triangle.
    float nearest = max(max(unit[0].z, unit[1].z), unit[2].z);
    vec3 edgeZ = vec3(edge[0].z, edge[1].z, edge[2].z);
    vec3 slack = 1e-3 * vec3(length(edge[0]), length(edge[1]), length(edge[2]));
    bool axis = all(greaterThanEqual(edgeZ, -slack)) || all(lessThanEqual(edgeZ, slack));
    vec3 azimuth;
    for (int k = 0; k < 3; ++k) {
        azimuth[k] = atan(unit[k].y, unit[k].x);
        azimuth[k] -= 6.2831853 * floor((azimuth[k] - azimuth[0]) / 6.2831853 + 0.5);
    }
    // atan may be off by some 1e-3.
    float first = min(min(azimuth.x, azimuth.y), azimuth.z) - 4e-3;
    float last = max(max(azimuth.x, azimuth.y), azimuth.z) + 4e-3;
    if (nearest > -0.1 || axis || last - first > 2.8)
        return false;
    float inner = 0.5 * sqrt(0.5 * (1.0 - nearest));
    vec2 low = vec2(1.0);
    vec2 high = vec2(-1.0);
    for (int quarter = -6; quarter <= 6; ++quarter) {
        float angle = clamp(float(quarter) * 1.5707963, first, last);
        vec2 direction = vec2(cos(angle), sin(angle));
        low = min(low, min(inner * direction, 0.5 * direction));
        high = max(high, max(inner * direction, 0.5 * direction));
    }
    low = (low + 0.5 - 2e-3) * mirrorballCapture_size - mirrorballCapture_guard;
    high = (high + 0.5 + 2e-3) * mirrorballCapture_size + mirrorballCapture_guard;
    cover.corner[0] = low;
    cover.corner[1] = vec2(high.x, low.y);
    cover.corner[2] = vec2(low.x, high.y);
    cover.corner[3] = high;
    cover.count = 4;
    return true;
}

void mirrorballCapture_coverIn(int view, vec3 vertex[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    vec3 unit[3];
    float lowest = 1.0;
    for (int k = 0; k < 3; ++k) {
        unit[k] = normalize(vertex[k]);
        lowest = min(lowest, unit[k].z);
    }
    vec3 chord = vec3(distance(unit[1], unit[2]), distance(unit[2], unit[0]), distance(unit[0], unit[1]));
    // Within 120 degrees of the centre, edges below a fifth of a radian: nearly straight on the map.
    bool straight = lowest > -0.5 && max(max(chord.x, chord.y), chord.z) < 0.2;
    vec2 p[3];
    for (int k = 0; k < 3; ++k)
        p[k] = mirrorballCapture_squareFromDirection(view, vertex[k]) * mirrorballCapture_size;
    mirrorballCapture_coverTriangle(p, chord * chord * MIRRORBALL_SAG, cover);
    bool covered = straight;
    for (int turns = straight ? 0 : 1; turns > 0; --turns)
        covered = mirrorballCapture_coverSector(unit, edge, cover);
    // A loop of one turn, since software rasterisers skip loops that nobody enters.
    for (int turns = covered ? 0 : 1; turns > 0; --turns)
        mirrorballCapture_coverLayer(cover);
}
