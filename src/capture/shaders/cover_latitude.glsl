// Maps whose coordinates are functions of latitude and longitude. Longitude runs along the strips; MIRRORBALL_PERIOD is
// 360 degrees in units of the square.

// Latitude is the angle to the plane y = 0, longitude 0 is at +z.
vec3 mirrorballCapture_local(int view, vec3 v)
{
#if MIRRORBALL_EQUIRECTANGULAR
    return vec3(v.xy, -v.z);
#else
    return view == 0 ? v : vec3(v.y, v.x, -v.z);
#endif
}

// The map's coordinate of a latitude, given its tangent.
float mirrorballCapture_acrossOfTangent(float tangent)
{
    vec3 direction = vec3(0.0, clamp(tangent, -1e4, 1e4), 1.0);
    return mirrorballCapture_squareFromDirection(0, direction).MIRRORBALL_ACROSS;
}

// Half turns of longitude at a place along, 0 at +z.
float mirrorballCapture_halfTurns(float along)
{
    return (along - 0.5) * (2.0 / MIRRORBALL_PERIOD);
}

// The side of an edge's plane as a bound of latitude: tan(latitude) >= -(m.x sin + m.z cos) / m.y for m.y > 0, <= for
// m.y < 0, with sine and cosine of the longitude.
void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent)
{
    vec3 m = mirrorballCapture_local(view, edge);
    float halfTurns = mirrorballCapture_halfTurns(at);
    float rise = m.x * mirrorballCapture_sinPi(halfTurns) + m.z * mirrorballCapture_cosPi(halfTurns);
    rise += 1e-5 * length(m);
    float bound = mirrorballCapture_acrossOfTangent(-rise / (abs(m.y) > 1e-30 ? m.y : 1e-30));
#if MIRRORBALL_EQUIRECTANGULAR
    bool isLow = m.y < 0.0; // north comes first
#else
    bool isLow = m.y >= 0.0;
#endif
    extent = isLow ? vec2(max(extent.x, bound), extent.y) : vec2(extent.x, min(extent.y, bound));
}

// Latitude over longitude is atan(T sin l), with T the tangent of the circle's inclination: it bends one way between
// two crossings of the equator, which are half a turn apart.
float mirrorballCapture_inflection(int view, vec3 edge, float at)
{
    vec3 m = mirrorballCapture_local(view, edge);
    const float apart = 0.5 * MIRRORBALL_PERIOD;
    float crossing = mirrorballCapture_atan2Pi(m.x, m.z) * apart + 0.5 + 0.5 * apart;
    return crossing + apart * floor((at - crossing) / apart + 0.5);
}

// A pole in the triangle, or so near that rounding could tell it wrong; side is +1 or -1.
bool mirrorballCapture_holdsPole(vec3 edgeY, vec3 edgeLength, float side)
{
    return all(greaterThanEqual(side * edgeY, -1e-5 * edgeLength));
}

#if MIRRORBALL_CURVED
// A triangle that is large on the map, or near a pole or the cut.
void mirrorballCapture_coverCurved(int view, vec3 vertex[3], vec3 edge[3], vec3 along, float first, float last,
                                   bool wraps, inout mirrorballCapture_Cover cover)
{
    vec3 edgeY, edgeLength;
    for (int k = 0; k < 3; ++k) {
        edgeY[k] = mirrorballCapture_local(view, edge[k]).y;
        edgeLength[k] = length(edge[k]);
    }
    bool pole = mirrorballCapture_holdsPole(edgeY, edgeLength, 1.0) ||
                mirrorballCapture_holdsPole(edgeY, edgeLength, -1.0);
    // An edge that passes near a pole has no safe direction to go round it.
    vec3 steps = abs(along - along.yzx);
    if (pole || wraps || max(max(steps.x, steps.y), steps.z) > 0.48 * MIRRORBALL_PERIOD) {
        first = 0.0;
        last = 1.0;
    }
    // Vertices, and the two places where an edge's circle is highest and lowest.
    float events[9];
    for (int k = 0; k < 3; ++k) {
        vec3 m = mirrorballCapture_local(view, edge[k]);
        float peak = mirrorballCapture_atan2Pi(m.x, m.z) * 0.5 * MIRRORBALL_PERIOD + 0.5;
        events[k] = along[k] - MIRRORBALL_PERIOD * floor((along[k] - 0.5) / MIRRORBALL_PERIOD + 0.5);
        events[3 + 2 * k] = peak;
        events[4 + 2 * k] = peak + (peak > 0.5 ? -0.5 : 0.5) * MIRRORBALL_PERIOD;
    }
    vec3 planes[4];
    mirrorballCapture_boundingPlanes(vertex, edge, planes);
    mirrorballCapture_coverStrips(view, planes, events, max(first, 0.0), min(last, 1.0), cover);
}
#endif

// bend: the tangent of the greatest latitude. A meridian is straight, and so is the equator.
float mirrorballCapture_arcSag(float bend, float chord, vec2 step)
{
    float slope = MIRRORBALL_SLANTED_SAG * step.MIRRORBALL_ACROSS + MIRRORBALL_LEVEL_SAG * step.MIRRORBALL_ALONG;
    return min(chord * chord * MIRRORBALL_SAG,
               bend * step.MIRRORBALL_ALONG * slope / mirrorballCapture_size.MIRRORBALL_ACROSS);
}

void mirrorballCapture_coverIn(int view, vec3 vertex[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    vec3 unit[3];
    vec2 square[3];
    for (int k = 0; k < 3; ++k) {
        unit[k] = normalize(mirrorballCapture_local(view, vertex[k]));
        square[k] = mirrorballCapture_squareFromDirection(view, vertex[k]);
        if (k > 0) {
            float turns = (square[k].MIRRORBALL_ALONG - square[0].MIRRORBALL_ALONG) / MIRRORBALL_PERIOD;
            square[k].MIRRORBALL_ALONG -= MIRRORBALL_PERIOD * floor(turns + 0.5);
        }
    }
    vec3 along = vec3(square[0].MIRRORBALL_ALONG, square[1].MIRRORBALL_ALONG, square[2].MIRRORBALL_ALONG);
    float first = min(min(along.x, along.y), along.z);
    float last = max(max(along.x, along.y), along.z);
    // Beyond this the triangle comes back into the layer at the other end.
    bool wraps = first < 1.0 - MIRRORBALL_PERIOD || last > MIRRORBALL_PERIOD;
    vec3 chord = vec3(distance(unit[1], unit[2]), distance(unit[2], unit[0]), distance(unit[0], unit[1]));
    float steepest = max(max(abs(unit[0].y), abs(unit[1].y)), abs(unit[2].y));
    // Within 60 degrees of the equator and with edges below half a radian: nearly straight on the map.
    bool straight = !wraps && steepest < 0.866 && max(max(chord.x, chord.y), chord.z) < 0.5;
    vec2 p[3];
    for (int k = 0; k < 3; ++k)
        p[k] = square[k] * mirrorballCapture_size;
    vec3 tangent;
    for (int k = 0; k < 3; ++k) {
        // An arc rises at most to its ends' sine over the cosine of half its angle, here a quarter radian at most.
        float sine = min(1.033 * max(abs(unit[(k + 1) % 3].y), abs(unit[(k + 2) % 3].y)), 0.9);
        tangent[k] = sine * inversesqrt(1.0 - sine * sine);
    }
    float loose;
    vec3 sag = mirrorballCapture_sagsOf(p, tangent, chord, loose);
    mirrorballCapture_coverTriangle(p, sag, cover);
#if MIRRORBALL_EQUIRECTANGULAR
    bool beyond = false;
#else
    // Both caps beyond 45 degrees are convex, and so is the wedge between 135 degrees and the cut: with all vertices in
    // one of them (here 0.01 degrees further in), so is the triangle, and nothing of it lies on the layer.
    vec3 sines = vec3(unit[0].y, unit[1].y, unit[2].y);
    bool beyond = all(greaterThan(sines, vec3(0.70723))) || all(lessThan(sines, vec3(-0.70723))) ||
                  max(max(abs(unit[0].x) + unit[0].z, abs(unit[1].x) + unit[1].z), abs(unit[2].x) + unit[2].z) < -3e-4;
#endif
    cover.count = beyond ? 0 : cover.count;
#if MIRRORBALL_CURVED
    // A loop of one turn, and not an if: software rasterisers leave loops that nobody enters, and the loops within,
    // after one turn.
#if MIRRORBALL_BANDS && MIRRORBALL_STRIPS > 1
    float widest = 0.25 * (max(max(sag.x, sag.y), sag.z) + mirrorballCapture_guard);
    for (int turns = straight && cover.count > 0 && loose > 8.0 ? 1 : 0; turns > 0; --turns)
        if (mirrorballCapture_coverBand(view, vertex, edge, p, MIRRORBALL_STRETCH, widest, tangent, cover))
            loose = 0.0;
#endif
    bool close = straight && loose < 100.0; // which is what strips cost
    for (int turns = close || beyond ? 0 : 1; turns > 0; --turns)
        mirrorballCapture_coverCurved(view, vertex, edge, along, first, last, wraps, cover);
#else
    if (!straight && !beyond)
        mirrorballCapture_coverLayer(cover);
#endif
}
