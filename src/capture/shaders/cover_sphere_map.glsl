// The sphere map has no bound of a large triangle but the whole layer.
void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent)
{
}

float mirrorballCapture_departure(int view, vec3 edge, float width)
{
    return 9.0;
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
    // A loop of one turn, since software rasterisers skip loops that nobody enters.
    for (int turns = straight ? 0 : 1; turns > 0; --turns)
        mirrorballCapture_coverStrips(view, vec3[4](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)), float[1](0.0), 0.0, 1.0, cover);
}
