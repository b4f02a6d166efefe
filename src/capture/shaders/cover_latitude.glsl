// Maps whose coordinates are functions of latitude and longitude. MIRRORBALL_LONGITUDE is the axis (x or y) of the
// square that longitude runs along, MIRRORBALL_LATITUDE the other, MIRRORBALL_PERIOD 360 degrees in units of the square.

vec3 mirrorballCapture_local(int view, vec3 v)
{
    return view == 0 ? v : vec3(v.y, v.x, -v.z);
}

// A pole in the triangle, or so near that rounding could tell it wrong; side is +1 or -1.
bool mirrorballCapture_holdsPole(vec3 edgeY, vec3 edgeLength, float side)
{
    return all(greaterThanEqual(side * edgeY, -1e-5 * edgeLength));
}

// Widens the range of sin(latitude) by the highest and lowest point of the arc between two unit directions.
void mirrorballCapture_addArc(vec3 from, vec3 to, float edgeY, float edgeLength, inout vec2 range)
{
    float cosine = dot(from, to);
    vec2 climb = vec2(to.y - cosine * from.y, from.y - cosine * to.y); // at both ends, towards the middle
    float steepest = edgeY / max(edgeLength, 1e-37);
    float apex = sqrt(max(1.0 - steepest * steepest, 0.0));
    range.y = min(climb.x, climb.y) > -1e-6 ? max(range.y, apex) : range.y;
    range.x = max(climb.x, climb.y) < 1e-6 ? min(range.x, -apex) : range.x;
}

bool mirrorballCapture_cover(int view, vec3 vertex[3], vec3 edge[3], float side, out vec2 corner[4])
{
    vec3 unit[3];
    vec2 square[3];
    for (int k = 0; k < 3; ++k) {
        unit[k] = normalize(mirrorballCapture_local(view, vertex[k]));
        square[k] = mirrorballCapture_squareFromDirection(view, vertex[k]);
        if (k > 0) {
            float turns = (square[k].MIRRORBALL_LONGITUDE - square[0].MIRRORBALL_LONGITUDE) / MIRRORBALL_PERIOD;
            square[k].MIRRORBALL_LONGITUDE -= MIRRORBALL_PERIOD * floor(turns + 0.5);
        }
    }
    vec3 longitudes = vec3(square[0].MIRRORBALL_LONGITUDE, square[1].MIRRORBALL_LONGITUDE, square[2].MIRRORBALL_LONGITUDE);
    float first = min(min(longitudes.x, longitudes.y), longitudes.z);
    float last = max(max(longitudes.x, longitudes.y), longitudes.z);
    // Beyond this the triangle comes back into the layer at the other end.
    bool wraps = first < 1.0 - MIRRORBALL_PERIOD || last > MIRRORBALL_PERIOD;
    vec3 chord = vec3(distance(unit[1], unit[2]), distance(unit[2], unit[0]), distance(unit[0], unit[1]));
    float steepest = max(max(abs(unit[0].y), abs(unit[1].y)), abs(unit[2].y));
    // Within 60 degrees of the equator and with edges below half a radian: nearly straight on the map.
    if (!wraps && steepest < 0.866 && max(max(chord.x, chord.y), chord.z) < 0.5) {
        vec2 p[3];
        for (int k = 0; k < 3; ++k)
            p[k] = square[k] * mirrorballCapture_size;
        return mirrorballCapture_coverTriangle(p, chord * chord * MIRRORBALL_SAG, corner);
    }

    vec3 edgeY, edgeLength;
    for (int k = 0; k < 3; ++k) {
        edgeY[k] = mirrorballCapture_local(view, edge[k]).y * (side < 0.0 ? -1.0 : 1.0);
        edgeLength[k] = length(edge[k]);
    }
    bool north = mirrorballCapture_holdsPole(edgeY, edgeLength, 1.0);
    bool south = mirrorballCapture_holdsPole(edgeY, edgeLength, -1.0);
    // Steps from vertex to vertex, not to the first: an edge that passes near a pole has no safe direction.
    vec2 steps = abs(vec2(longitudes.y - longitudes.x, longitudes.z - longitudes.x));
    float between = abs(longitudes.z - longitudes.y);
    bool nearPole = max(max(steps.x, steps.y), between) > 0.48 * MIRRORBALL_PERIOD;
    if (north || south || nearPole || wraps) {
        first = 0.0;
        last = 1.0;
    }
    vec2 range = vec2(min(min(unit[0].y, unit[1].y), unit[2].y), max(max(unit[0].y, unit[1].y), unit[2].y));
    for (int k = 0; k < 3; ++k)
        mirrorballCapture_addArc(unit[(k + 1) % 3], unit[(k + 2) % 3], edgeY[k], edgeLength[k], range);
    range = vec2(south ? -1.0 : range.x - 1e-6, north ? 1.0 : range.y + 1e-6);
    range = clamp(range, -1.0, 1.0);
    vec2 cosine = sqrt(max(1.0 - range * range, vec2(0.0)));
    vec2 ends = vec2(mirrorballCapture_squareFromDirection(0, vec3(0.0, range.x, cosine.x)).MIRRORBALL_LATITUDE,
                     mirrorballCapture_squareFromDirection(0, vec3(0.0, range.y, cosine.y)).MIRRORBALL_LATITUDE);
    vec2 low, high;
    low.MIRRORBALL_LATITUDE = min(ends.x, ends.y);
    high.MIRRORBALL_LATITUDE = max(ends.x, ends.y);
    low.MIRRORBALL_LONGITUDE = first;
    high.MIRRORBALL_LONGITUDE = last;
    return mirrorballCapture_coverBox(low * mirrorballCapture_size, high * mirrorballCapture_size, corner);
}
