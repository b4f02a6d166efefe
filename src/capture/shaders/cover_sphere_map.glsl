// No strips along an axis of the layer here.
void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent) {}
float mirrorballCapture_inflection(int view, vec3 edge, float at)
{
    return -9.0;
}

// What is not straight on the disc is covered in its polar coordinates: azimuth, and the radius 1/2 sin(angle / 2) of
// an angle to the axis +z, in units of n. The rim, at 1/2, is the one direction -z, which all texels beyond repeat.

vec2 mirrorballCapture_azimuthDirection(float azimuth)
{
    return normalize(vec2(cos(azimuth), sin(azimuth))); // to which drivers may be off
}

// The radius at which an angle to the axis lies, of its cosine and sine.
float mirrorballCapture_discRadius(float cosine, float sine)
{
    return 0.5 * sqrt(0.5 * (cosine > 0.0 ? sine * sine / (1.0 + cosine) : 1.0 - cosine));
}

// Where a triangle lies on the disc.
struct mirrorballCapture_Sector
{
    float first, middle, last; // azimuths of the vertices, in order
    vec2 radii;                // the nearest and the farthest
    bool around;               // all azimuths: it holds an end of the axis, or may, within rounding
    bool rim;                  // and that is -z, be it on an edge: the rim and all beyond are its
};

// The radii of a triangle's outline: those of its vertices, and of where an edge comes nearest to an end of the axis.
// An angle moves a radius by a quarter of itself at most.
vec2 mirrorballCapture_outlineRadii(vec3 unit[3], vec3 edge[3])
{
    vec2 radii = vec2(0.5, 0.0);
    float reach = 0.0;
    float off = 0.0; // how far rounded edges pass their vertices, in radians
    for (int k = 0; k < 3; ++k) {
        vec3 a = unit[(k + 1) % 3];
        vec3 b = unit[(k + 2) % 3];
        float radius = mirrorballCapture_discRadius(a.z, length(a.xy));
        radii = vec2(min(radii.x, radius), max(radii.y, radius));
        float chord = distance(a, b);
        // At which rates the edge rises from a towards b, and from b towards a: it turns where the signs are the same.
        float bend = 0.5 * chord * chord;
        vec2 rises = vec2(b.z - a.z + bend * a.z, a.z - b.z + bend * b.z);
        vec3 normal = cross(a - b, a + b);
        float size = max(length(normal), 1e-18);
        float nearest = mirrorballCapture_discRadius(length(normal.xy) / size, normal.z / size);
        float farthest = mirrorballCapture_discRadius(-length(normal.xy) / size, normal.z / size);
        // A short edge's normal is rough, but it goes no farther than half its length; and so is that of half a turn.
        if (chord < 0.02)
            reach = max(reach, 0.13 * chord);
        else if (chord > 1.999)
            radii = vec2(0.0, 0.5);
        else
            radii = vec2(min(rises.x, rises.y) > 0.0 ? min(radii.x, nearest) : radii.x,
                         max(rises.x, rises.y) < 0.0 ? max(radii.y, farthest) : radii.y);
        off = max(off, max(abs(dot(edge[k], a)), abs(dot(edge[k], b))) / max(length(edge[k]), 1e-37));
    }
    reach += 0.25 * (1e-3 + 2.0 * off);
    return vec2(max(radii.x - reach, 0.0), min(radii.y + reach, 0.5));
}

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
    sector.radii = mirrorballCapture_outlineRadii(unit, edge);
    // An end of the axis lies inside, or nearly on an edge, if the outline comes as near to it as that.
    bool centre = all(greaterThan(edgeZ, slack)) || (all(greaterThanEqual(edgeZ, -slack)) && sector.radii.x == 0.0);
    sector.rim = all(lessThan(edgeZ, -slack)) || (all(lessThanEqual(edgeZ, slack)) && sector.radii.y == 0.5);
    sector.radii = vec2(centre ? 0.0 : sector.radii.x, sector.rim ? 0.5 : sector.radii.y);
    // Without one a triangle spans half a turn at most, and nearly that where an edge passes one.
    sector.around = centre || sector.rim || sector.last - sector.first > 2.8 || toAxis < 1e-3;
    return sector;
}

// The radii between which a triangle lies where the azimuth does between two, less than half a turn apart; empty where
// the first is greater. A plane's inside is where (m.x cos + m.y sin) sine + m.z cosine >= 0, with sine and cosine of
// the angle to the axis, which asks least where the first factor is greatest. The slack is for rounding, and for what
// the rasteriser may move sideways: no more than 4 radians over n.
vec2 mirrorballCapture_radiiBetween(vec3 planes[4], mirrorballCapture_Sector sector, float from, float to)
{
    vec2 first = mirrorballCapture_azimuthDirection(from);
    vec2 last = mirrorballCapture_azimuthDirection(to);
    vec2 radii = sector.radii;
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
        float bound = mirrorballCapture_discRadius(cosine, farthest.y);
        // A plane that nearly holds the axis sets no bound.
        if (abs(m.z) > slack && farthest.y > 0.0)
            radii = m.z < 0.0 ? vec2(max(radii.x, bound), radii.y) : vec2(radii.x, min(radii.y, bound));
    }
    return radii;
}

#if MIRRORBALL_CURVED && MIRRORBALL_STRIPS > 1
// A piece of a ring for each part of the azimuths, between the radii that the triangle has there.
void mirrorballCapture_coverSector(vec3 planes[4], mirrorballCapture_Sector sector, inout mirrorballCapture_Cover cover)
{
    // All around, the ends overlap by what sines and cosines may be off.
    float first = sector.around ? -3.1456 : sector.first;
    float last = sector.around ? 3.1456 : sector.last;
    float middle = sector.around ? 0.0 : sector.middle;
    int before = int(float(MIRRORBALL_STRIPS) * (middle - first) / (last - first) + 0.5);
    before = clamp(before, 1, MIRRORBALL_STRIPS - 1);
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
            radii = mirrorballCapture_radiiBetween(planes, sector, border[strip],
                                                   border[min(strip + 1, MIRRORBALL_STRIPS)]);
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
    vec2 radii = mirrorballCapture_radiiBetween(planes, sector, sector.first, sector.last);
    vec2 low = vec2(1.0);
    vec2 high = vec2(-1.0);
    for (int quarter = -6; quarter <= 6; ++quarter) {
        float azimuth = clamp(float(quarter) * 1.5707963, sector.first, sector.last);
        vec2 outwards = mirrorballCapture_azimuthDirection(azimuth);
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

// bend: the sag of an arc over its chord in units of n, over chord squared, as the next function gives it.
float mirrorballCapture_arcSag(float bend, float chord, vec2 step)
{
    return bend * chord * chord * mirrorballCapture_size.x;
}

// For chords below 1/2 of the edges' great circles, in units of n; room is 1 + z, at least, along them. A circle
// through the axis, whose normal has no z, is straight.
vec3 mirrorballCapture_bendOf(vec3 unit[3], float room)
{
    vec3 bend;
    for (int k = 0; k < 3; ++k) {
        vec3 a = unit[(k + 1) % 3];
        vec3 b = unit[(k + 2) % 3];
        vec3 normal = cross(a - b, a + b);
        float lean = abs(normal.z) / max(length(normal), 1e-18) + 1e-4;
        bend[k] = min(0.05, 0.073 * lean * inversesqrt(room)) / room;
    }
    return bend;
}

void mirrorballCapture_coverIn(int view, vec3 vertex[3], vec3 edge[3], inout mirrorballCapture_Cover cover)
{
    vec3 unit[3];
    vec2 p[3];
    float lowest = 1.0;
    for (int k = 0; k < 3; ++k) {
        unit[k] = normalize(vertex[k]);
        p[k] = mirrorballCapture_squareFromDirection(view, vertex[k]) * mirrorballCapture_size;
        lowest = min(lowest, unit[k].z);
    }
    vec3 chord = vec3(distance(unit[1], unit[2]), distance(unit[2], unit[0]), distance(unit[0], unit[1]));
    float longest = max(max(chord.x, chord.y), chord.z);
    // No farther from its nearer end than half its length, an edge comes no lower than this. It is nearly straight.
    float room = 1.0 + lowest - 0.51 * longest;
    bool straight = room > 0.03 && longest < 0.5;
    vec3 bend = mirrorballCapture_bendOf(unit, max(room, 0.03));
    float loose;
    vec3 sag = mirrorballCapture_sagsOf(p, bend, chord, loose);
    mirrorballCapture_coverTriangle(p, sag, cover);
    // Loops of one turn, since software rasterisers skip loops that nobody enters.
#if MIRRORBALL_CURVED && MIRRORBALL_STRIPS > 1
    float widest = 0.25 * (max(max(sag.x, sag.y), sag.z) + mirrorballCapture_guard);
    for (int turns = straight && cover.count > 0 && loose > 8.0 ? 1 : 0; turns > 0; --turns)
        if (mirrorballCapture_coverBand(view, vertex, edge, p, MIRRORBALL_STRETCH * inversesqrt(room), widest, bend,
                                        cover))
            loose = 0.0;
#endif
    for (int turns = straight && loose < 100.0 ? 0 : 1; turns > 0; --turns) {
        vec3 planes[4];
        mirrorballCapture_boundingPlanes(vertex, edge, planes);
        mirrorballCapture_Sector sector = mirrorballCapture_sectorOf(unit, edge);
        bool covered = false;
#if MIRRORBALL_CURVED && MIRRORBALL_STRIPS > 1
        room = 2.0 - 8.0 * sector.radii.y * sector.radii.y;
        if (room > 0.03 && longest < 1.2)
            covered = mirrorballCapture_coverBand(view, vertex, edge, p, MIRRORBALL_STRETCH * inversesqrt(room), 3.0,
                                                  mirrorballCapture_bendOf(unit, room), cover);
#endif
        if (!covered)
            mirrorballCapture_coverSector(planes, sector, cover);
    }
}
