// No strips along an axis of the layer here.
void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent) {}
float mirrorballCapture_inflection(int view, vec3 edge, float at)
{
    return -9.0;
}

// What is not straight on the disc is covered in its polar coordinates: azimuth, and the radius 1/2 sin(angle / 2) of an
// angle to the axis +z, in units of n. The rim, at 1/2, is the one direction -z, which all texels beyond repeat.

vec2 mirrorballCapture_azimuthDirection(float azimuth)
{
    return normalize(vec2(cos(azimuth), sin(azimuth))); // to which drivers may be off
}

// The radii between which a triangle lies where the azimuth does between two, less than half a turn apart; empty where the
// first is greater. A plane's inside is where (m.x cos + m.y sin) sine + m.z cosine >= 0, with sine and cosine of the angle
// to the axis, which asks least where the first factor is greatest. The slack is for rounding, and for what the rasteriser
// may move sideways: no more than 4 radians over n.
vec2 mirrorballCapture_radiiBetween(vec3 planes[4], float from, float to)
{
    vec2 first = mirrorballCapture_azimuthDirection(from);
    vec2 last = mirrorballCapture_azimuthDirection(to);
    vec2 radii = vec2(0.0, 0.5);
    for (int k = 0; k < 4; ++k) {
        // At a size whose squares are floats. None, of two vertices in one direction, sets no bound.
        vec3 sizes = abs(planes[k]);
        vec3 m = planes[k] / max(max(max(sizes.x, sizes.y), sizes.z), 1e-37);
        bool between = first.x * m.y - first.y * m.x >= 0.0 && m.x * last.y - m.y * last.x >= 0.0;
        float greatest = between ? length(m.xy) : max(dot(m.xy, first), dot(m.xy, last));
        float slack = (1e-5 + 4.0 * mirrorballCapture_guard / mirrorballCapture_size.x) * length(m);
        // Cosine and sine of the farthest angle, from the end of the axis that is inside.
        float size = max(length(vec2(greatest, m.z)), 1e-18);
        float c = -min(slack / size, 1.0);
        float s = sqrt(1.0 - c * c);
        vec2 farthest = vec2(abs(m.z) * c - greatest * s, greatest * c + abs(m.z) * s) / size;
        float cosine = m.z < 0.0 ? -farthest.x : farthest.x;
        float share = cosine > 0.0 ? farthest.y * farthest.y / (1.0 + cosine) : 1.0 - cosine;
        float bound = 0.5 * sqrt(0.5 * share);
        // A plane that nearly holds the axis sets no bound.
        if (abs(m.z) > slack && farthest.y > 0.0)
            radii = m.z < 0.0 ? vec2(max(radii.x, bound), radii.y) : vec2(radii.x, min(radii.y, bound));
    }
    return radii;
}

// Where a triangle lies on the disc.
struct mirrorballCapture_Sector
{
    float first, middle, last; // azimuths of the vertices, in order
    bool around;               // all azimuths: it holds an end of the axis, or may, within rounding
    bool rim;                  // and that is -z, be it on an edge: the rim and all beyond are its
};

mirrorballCapture_Sector mirrorballCapture_sectorOf(vec3 unit[3], vec3 edge[3])
{
    vec3 azimuth;
    for (int k = 0; k < 3; ++k) {
        azimuth[k] = atan(unit[k].y, unit[k].x);
        azimuth[k] -= 6.2831853 * floor((azimuth[k] - azimuth[0]) / 6.2831853 + 0.5);
    }
    vec3 edgeZ = vec3(edge[0].z, edge[1].z, edge[2].z);
    vec3 slack = 1e-5 * vec3(length(edge[0]), length(edge[1]), length(edge[2]));
    float toAxis = min(min(length(unit[0].xy), length(unit[1].xy)), length(unit[2].xy));
    mirrorballCapture_Sector sector;
    // atan may be off by some 1e-3.
    sector.first = min(min(azimuth.x, azimuth.y), azimuth.z) - 4e-3;
    sector.last = max(max(azimuth.x, azimuth.y), azimuth.z) + 4e-3;
    sector.middle = max(min(max(azimuth.x, azimuth.y), azimuth.z), min(azimuth.x, azimuth.y));
    // Without an end of the axis a triangle spans half a turn at most, and nearly that where an edge passes one.
    sector.rim = all(lessThanEqual(edgeZ, slack));
    sector.around = sector.rim || all(greaterThanEqual(edgeZ, -slack)) || sector.last - sector.first > 2.8 || toAxis < 1e-3;
    return sector;
}

#if MIRRORBALL_CURVED && MIRRORBALL_STRIPS > 1
// A piece of a ring for each part of the azimuths, between the radii that the triangle has there.
void mirrorballCapture_coverSector(vec3 planes[4], mirrorballCapture_Sector sector, inout mirrorballCapture_Cover cover)
{
    // All around, the ends overlap by what sines and cosines may be off.
    float first = sector.around ? -3.1456 : sector.first;
    float last = sector.around ? 3.1456 : sector.last;
    float middle = sector.around ? 0.0 : sector.middle;
    int before = clamp(int(float(MIRRORBALL_STRIPS) * (middle - first) / (last - first) + 0.5), 1, MIRRORBALL_STRIPS - 1);
    float border[MIRRORBALL_STRIPS + 1];
    for (int index = 0; index <= MIRRORBALL_STRIPS; ++index)
        border[index] = index < before ? mix(first, middle, float(index) / float(before))
                                       : mix(middle, last, float(index - before) / float(MIRRORBALL_STRIPS - before));
    float widest = max(middle - first, 0.0) / float(before);
    widest = max(widest, (last - middle) / float(MIRRORBALL_STRIPS - before));
    if (widest > 2.0) {
        mirrorballCapture_coverLayer(cover);
        return;
    }
    // A chord at a radius passes nearer to the centre by this factor.
    float reach = mirrorballCapture_size.x / cos(0.5 * widest + 1e-3);
    bool seen = false;
    cover.breaks = 0;
    vec2 previous = vec2(1.0, 0.0);
    for (int strip = 0; strip <= MIRRORBALL_STRIPS; ++strip) {
        vec2 radii = vec2(1.0, 0.0);
        if (strip < MIRRORBALL_STRIPS)
            radii = mirrorballCapture_radiiBetween(planes, border[strip], border[min(strip + 1, MIRRORBALL_STRIPS)]);
        if (sector.rim)
            radii = vec2(min(radii.x, 0.4999), 0.7072);
        bool empty = radii.x > radii.y;
        cover.breaks |= empty ? 2 << strip : 0; // nothing is drawn from these corners on
        radii = empty ? vec2(1.0, 0.0) : radii;
        seen = seen || !empty;
        vec2 both = vec2(min(previous.x, radii.x), max(previous.y, radii.y));
        vec2 outwards = mirrorballCapture_azimuthDirection(border[strip]);
        float aside = strip == 0 ? -1.0 : strip == MIRRORBALL_STRIPS ? 1.0 : 0.0;
        vec2 at = 0.5 * mirrorballCapture_size + aside * mirrorballCapture_guard * vec2(-outwards.y, outwards.x);
        cover.corner[2 * strip] = at + max(both.x * mirrorballCapture_size.x - mirrorballCapture_guard, 0.0) * outwards;
        cover.corner[2 * strip + 1] = at + (both.y * reach + 2.0 * mirrorballCapture_guard) * outwards;
        previous = radii;
    }
    cover.breaks &= (2 << MIRRORBALL_STRIPS) - 1;
    cover.count = seen ? 2 * MIRRORBALL_STRIPS + 2 : 0;
}
#else
// A box around the piece of a ring that the triangle lies in.
void mirrorballCapture_coverSector(vec3 planes[4], mirrorballCapture_Sector sector, inout mirrorballCapture_Cover cover)
{
    vec2 radii = mirrorballCapture_radiiBetween(planes, sector.first, sector.last);
    vec2 low = vec2(1.0);
    vec2 high = vec2(-1.0);
    for (int quarter = -6; quarter <= 6; ++quarter) {
        vec2 outwards = mirrorballCapture_azimuthDirection(clamp(float(quarter) * 1.5707963, sector.first, sector.last));
        low = min(low, min(radii.x * outwards, radii.y * outwards));
        high = max(high, max(radii.x * outwards, radii.y * outwards));
    }
    low = (low + 0.5) * mirrorballCapture_size - mirrorballCapture_guard;
    high = (high + 0.5) * mirrorballCapture_size + mirrorballCapture_guard;
    cover.corner[0] = low;
    cover.corner[1] = vec2(high.x, low.y);
    cover.corner[2] = vec2(low.x, high.y);
    cover.corner[3] = high;
    cover.count = 4;
    cover.breaks = 0;
    if (sector.around)
        mirrorballCapture_coverLayer(cover);
    else if (radii.x > radii.y)
        cover.count = 0;
}
#endif

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
    for (int turns = straight ? 0 : 1; turns > 0; --turns) {
        vec3 planes[4];
        mirrorballCapture_boundingPlanes(vertex, edge, planes);
        mirrorballCapture_coverSector(planes, mirrorballCapture_sectorOf(unit, edge), cover);
    }
}
