// Polygons on the map, in texels, that are certain to cover a curved triangle.
layout(triangles) in;
uniform vec2 mirrorballCapture_size; // of a layer, in texels

// Rounding of positions, to the rasteriser's grid (each way by half a step), and of the chart, by 2^-18 of the layer.
#define mirrorballCapture_guard (MIRRORBALL_SNAP + 3.9e-6 * max(mirrorballCapture_size.x, mirrorballCapture_size.y))

// A covering polygon: the corners of a triangle strip, or of several.
struct mirrorballCapture_Cover
{
    int count;  // 0 where nothing of the triangle lies on the layer
    int breaks; // bit k: a new strip begins with corner 2 k
    vec2 corner[MIRRORBALL_CORNERS];
};

// The corner at b of a triangle whose edges ab and bc are pushed outwards by `push` (x for ab, y for bc); turn is +1
// for a counter-clockwise triangle. `stretch` tells how far the corner moved compared with the pushes.
vec2 mirrorballCapture_pushedCorner(vec2 a, vec2 b, vec2 c, vec2 push, float turn, inout float stretch)
{
    vec2 ab = normalize(b - a);
    vec2 bc = normalize(c - b);
    vec2 outAb = turn * vec2(ab.y, -ab.x);
    vec2 outBc = turn * vec2(bc.y, -bc.x);
    float sine = turn * (ab.x * bc.y - ab.y * bc.x);
    // Solves outAb . move = push.x, outBc . move = push.y.
    vec2 move = (push.y * ab - push.x * bc) / max(sine, 1e-20);
    stretch = max(stretch, 1.0 / max(sine, 1e-20));
    return b + move;
}

// A triangle with straight edges on the map, each pushed out by its sag (edge k is opposite to corner k); a needle
// gets a box along its longest edge instead, since its pushed corners would lie far out.
void mirrorballCapture_coverTriangle(vec2 p[3], vec3 sag, inout mirrorballCapture_Cover cover)
{
    sag += mirrorballCapture_guard;
    float most = max(max(sag.x, sag.y), sag.z);
    vec2 low = min(min(p[0], p[1]), p[2]) - most;
    vec2 high = max(max(p[0], p[1]), p[2]) + most;
    cover.count = 0;
    cover.breaks = 0;
    if (any(greaterThan(low, mirrorballCapture_size)) || any(lessThan(high, vec2(0.0))))
        return;
    cover.count = 3;
    vec2 ab = p[1] - p[0];
    vec2 ac = p[2] - p[0];
    float turn = ab.x * ac.y - ab.y * ac.x < 0.0 ? -1.0 : 1.0;
    float stretch = 0.0;
    cover.corner[0] = mirrorballCapture_pushedCorner(p[2], p[0], p[1], sag.yz, turn, stretch);
    cover.corner[1] = mirrorballCapture_pushedCorner(p[0], p[1], p[2], sag.zx, turn, stretch);
    cover.corner[2] = mirrorballCapture_pushedCorner(p[1], p[2], p[0], sag.xy, turn, stretch);
    // NaN, from two corners in one place, takes the box as well.
    if (stretch < 4.0)
        return;
    cover.count = 4;
#if !MIRRORBALL_CURVED
    // So small that an upright box will do.
    cover.corner[0] = low;
    cover.corner[1] = vec2(high.x, low.y);
    cover.corner[2] = vec2(low.x, high.y);
    cover.corner[3] = high;
#else
    vec2 bc = p[2] - p[1];
    vec2 along = dot(ab, ab) >= dot(ac, ac) && dot(ab, ab) >= dot(bc, bc) ? ab : dot(ac, ac) >= dot(bc, bc) ? ac : bc;
    float size = length(along);
    along = size > 0.0 ? along / size : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    vec3 s = vec3(dot(p[0], along), dot(p[1], along), dot(p[2], along));
    vec3 t = vec3(dot(p[0], across), dot(p[1], across), dot(p[2], across));
    vec2 first = vec2(min(min(s.x, s.y), s.z), min(min(t.x, t.y), t.z)) - most;
    vec2 last = vec2(max(max(s.x, s.y), s.z), max(max(t.x, t.y), t.z)) + most;
    cover.corner[0] = first.x * along + first.y * across;
    cover.corner[1] = last.x * along + first.y * across;
    cover.corner[2] = first.x * along + last.y * across;
    cover.corner[3] = last.x * along + last.y * across;
#endif
}

// For what nothing closer is known of.
void mirrorballCapture_coverLayer(inout mirrorballCapture_Cover cover)
{
    cover.corner[0] = vec2(0.0);
    cover.corner[1] = vec2(mirrorballCapture_size.x, 0.0);
    cover.corner[2] = vec2(0.0, mirrorballCapture_size.y);
    cover.corner[3] = mirrorballCapture_size;
    cover.count = 4;
    cover.breaks = 0;
}

// How far an arc's image departs from its chord at most, in texels; each family of maps writes it. `bend` is the
// family's own measure of an edge, chord that between its ends' unit directions, step that between their places, in
// texels.
float mirrorballCapture_arcSag(float bend, float chord, vec2 step);

#if MIRRORBALL_BANDS
// The sags of a triangle's edges, and how many texels straight edges pushed out by them waste along one, at most.
vec3 mirrorballCapture_sagsOf(vec2 p[3], vec3 bend, vec3 chord, out float loose)
{
    vec3 sag;
    loose = 0.0;
    for (int k = 0; k < 3; ++k) {
        vec2 step = abs(p[(k + 1) % 3] - p[(k + 2) % 3]);
        sag[k] = mirrorballCapture_arcSag(bend[k], chord[k], step);
        loose = max(loose, sag[k] * length(step));
    }
    return sag;
}
#endif

#if MIRRORBALL_BANDS && MIRRORBALL_CURVED && MIRRORBALL_STRIPS > 1
// A thin triangle: a band of MIRRORBALL_STRIPS straight pieces along the arc of its longest edge (k, opposite to corner
// k). Every direction of it is as near to that arc as its third corner is, so that the band is as wide as the map
// stretches that, and as a piece's sag. False where it would be wider, to either side, than so many texels.
bool mirrorballCapture_coverBand(int view, vec3 vertex[3], vec3 edge[3], vec2 p[3], float stretch,
                                 float widest, vec3 bend, inout mirrorballCapture_Cover cover)
{
    vec3 unit[3];
    for (int corner = 0; corner < 3; ++corner)
        unit[corner] = normalize(vertex[corner]);
    vec3 chord = vec3(distance(unit[1], unit[2]), distance(unit[2], unit[0]), distance(unit[0], unit[1]));
    int k = chord.x >= max(chord.y, chord.z) ? 0 : chord.y >= chord.z ? 1 : 2;
    vec3 a = unit[(k + 1) % 3];
    vec3 b = unit[(k + 2) % 3];
    float sine = abs(dot(edge[k], vertex[k])) / max(length(edge[k]) * length(vertex[k]), 1e-37);
    // Angles below a radian: at most 1.19 times their sine.
    float width = 1.19 * sine * stretch;
    // Pieces even on the chord are uneven on the arc: the middle ones are longest.
    float part = 1.01 * chord[k] * inversesqrt(1.0 - 0.25 * chord[k] * chord[k]) / float(MIRRORBALL_STRIPS);
    vec2 place[MIRRORBALL_STRIPS + 1];
    float piece = 0.0;
    for (int index = 0; index <= MIRRORBALL_STRIPS; ++index) {
        vec2 square = mirrorballCapture_squareFromDirection(view, mix(a, b, float(index) / float(MIRRORBALL_STRIPS)));
        if (MIRRORBALL_WRAPS) {
            float near = index == 0 ? p[(k + 1) % 3].MIRRORBALL_ALONG : place[max(index - 1, 0)].MIRRORBALL_ALONG;
            float turns = square.MIRRORBALL_ALONG - near / mirrorballCapture_size.MIRRORBALL_ALONG;
            square.MIRRORBALL_ALONG -= MIRRORBALL_PERIOD * floor(turns / MIRRORBALL_PERIOD + 0.5);
        }
        place[index] = square * mirrorballCapture_size;
        if (index > 0)
            piece = max(piece, mirrorballCapture_arcSag(bend[k], part, abs(place[index] - place[max(index - 1, 0)])));
    }
    width += piece + mirrorballCapture_guard;
    // A quarter turn at most: the third corner of a longer edge may lie near its circle, but on the far side.
    if (!(width < widest && chord[k] < 1.4))
        return false;
    cover.count = 2 * MIRRORBALL_STRIPS + 2;
    cover.breaks = 0;
    vec2 before = normalize(place[1] - place[0]);
    for (int index = 0; index <= MIRRORBALL_STRIPS; ++index) {
        int last = MIRRORBALL_STRIPS;
        vec2 after = index < last ? normalize(place[min(index + 1, last)] - place[index]) : before;
        vec2 middle = normalize(before + after);
        vec2 across = width / max(dot(middle, before), 0.5) * vec2(-middle.y, middle.x);
        vec2 at = place[index] + (index == 0 ? -width : index == last ? width : 0.0) * middle;
        cover.corner[2 * index] = at - across;
        cover.corner[2 * index + 1] = at + across;
        before = after;
    }
    return true;
}
#endif

// Each family of maps writes these two. The first narrows the extent across, at one place along, to the side of an
// edge's plane where edge . direction >= 0 (a little more, for rounding).
void mirrorballCapture_narrow(int view, vec3 edge, float at, inout vec2 extent);
// The second: where, nearest to a place along, an edge's curve changes the sense of its bend; outside the layer if
// nowhere.
float mirrorballCapture_inflection(int view, vec3 edge, float at);

#if MIRRORBALL_OCTAHEDRAL
// The octahedral map's views share a layer: the extent is narrowed to what a view has of a strip.
void mirrorballCapture_narrowToView(int view, float from, float to, inout vec2 extent);
#endif

// A triangle's extent at one place along, which may lie beyond the layer; empty where the first is greater than the
// second. `binding` are the planes that bind it.
vec2 mirrorballCapture_extentAt(int view, vec3 edge[4], float at, out ivec2 binding)
{
    vec2 extent = vec2(-9.0, 10.0);
    binding = ivec2(-1);
    for (int turn = 0; turn < 4 * MIRRORBALL_NARROWINGS; ++turn) {
        int k = turn % 4;
        vec2 wider = extent;
        mirrorballCapture_narrow(view, edge[k], at, extent);
        // What lies farther out still tells in which direction the triangle goes on from here.
        extent = clamp(extent, -9.0, 10.0);
        binding = ivec2(extent.x > wider.x ? k : binding.x, extent.y < wider.y ? k : binding.y);
    }
    return extent;
}

// The bound that one edge sets over a strip, as a straight line on its outer side: at the strip's beginning and end.
// `side` is 0 for the lower bound, 1 for the upper. Without a bound everywhere in the strip: `wide`.
vec2 mirrorballCapture_edgeLine(int view, vec3 edge, float from, float to, float guard, int side, vec2 wide)
{
    const vec2 everything = vec2(-9.0, 10.0);
    float place[5];
    place[0] = from - guard;
    place[4] = to + guard;
    place[2] = clamp(mirrorballCapture_inflection(view, edge, 0.5 * (from + to)), place[0], place[4]);
    place[1] = 0.5 * (place[0] + place[2]);
    place[3] = 0.5 * (place[2] + place[4]);
    float outward = side == 0 ? -1.0 : 1.0;
    float value[5]; // grows outwards
    float greatest = 0.0;
    for (int k = 0; k < 5; ++k) {
        vec2 extent = everything;
        mirrorballCapture_narrow(view, edge, place[k], extent);
        value[k] = outward * extent[side];
        greatest = max(greatest, abs(value[k]));
    }
    float slope = (value[4] - value[0]) / (place[4] - place[0]);
    // On either side of the inflection the curve bends one way, and departs from a chord by at most twice what it does
    // in the chord's middle.
    float bulge = max(value[1] - 0.5 * (value[0] + value[2]), value[3] - 0.5 * (value[2] + value[4]));
    float knee = value[2] - value[0] - slope * (place[2] - place[0]);
    // The guard along moves a sloping line, too.
    float push = max(knee, 0.0) + 2.0 * max(bulge, 0.0) + guard * abs(slope);
    vec2 line = outward * (value[0] + push + slope * (vec2(from, to) - place[0]));
    return greatest < 8.0 && to - from < MIRRORBALL_LONGEST_STRIP ? line : wide;
}

// What a strip has of a triangle: its lower and upper outline at the strip's beginning (x, y) and end (z, w); empty
// where x > y, and `clear` if that is more than rounding: nothing needs to be drawn there. The outline is monotone
// between `events` (vertices, and where an edge turns back), so the extents there and at both ends bound it; the edges
// that bind it in the strip's middle bound it more closely.
vec4 mirrorballCapture_stripOutline(int view, vec3 edge[4], float events[MIRRORBALL_EVENTS], float from, float to,
                                    out bool clear)
{
    // The rasteriser may move the strip's ends along, too: a triangle that is thin that way changes its extent within
    // less.
    float guard = mirrorballCapture_guard / mirrorballCapture_size.MIRRORBALL_ALONG;
    vec2 extent = vec2(20.0, -20.0);
    ivec2 binding;
    bool corner = false;
    vec2 found;
    for (int index = 0; index < MIRRORBALL_EVENTS + 5; ++index) {
        float event = index < MIRRORBALL_EVENTS ? events[min(index, MIRRORBALL_EVENTS - 1)]
                      : index == MIRRORBALL_EVENTS       ? from
                      : index == MIRRORBALL_EVENTS + 1   ? to
                      : index == MIRRORBALL_EVENTS + 2   ? from - guard
                      : index == MIRRORBALL_EVENTS + 3   ? to + guard
                                                         : 0.5 * (from + to);
        found = mirrorballCapture_extentAt(view, edge, clamp(event, from - guard, to + guard), binding);
        corner = corner || (index < 3 && event > from && event < to);
        if (found.x <= found.y)
            extent = vec2(min(extent.x, found.x), max(extent.y, found.y));
    }
    vec2 low = extent.xx;
    vec2 high = extent.yy;
    // The last place was the middle; a thousandth of the layer is far beyond rounding.
    clear = MIRRORBALL_WRAPS && !corner && found.x > found.y + 1e-3;
    // Any edge bounds the triangle: which one is taken matters only for how closely.
    if (binding.x >= 0) {
        vec2 line = mirrorballCapture_edgeLine(view, edge[binding.x], from, to, guard, 0, low);
        low = line.x + line.y > low.x + low.y ? line : low;
    }
    if (binding.y >= 0) {
        vec2 line = mirrorballCapture_edgeLine(view, edge[binding.y], from, to, guard, 1, high);
        high = line.x + line.y < high.x + high.y ? line : high;
    }
    // What lies beside the layer is left out; the rest is cut off by the rasteriser.
    bool outside = extent.x > 1.0 || extent.y < 0.0 || extent.x > extent.y || clear;
#if MIRRORBALL_OCTAHEDRAL
    vec2 octant = vec2(0.0, 1.0);
    mirrorballCapture_narrowToView(view, from, to, octant);
    outside = outside || extent.x > octant.y || extent.y < octant.x;
    if (low.x == low.y)
        low = max(low, vec2(octant.x));
    if (high.x == high.y)
        high = min(high, vec2(octant.y));
#endif
    // Where the bounds cross in the strip, behind a corner of the triangle, any point between them ends it.
    vec2 middle = 0.5 * (low + high);
    low = min(low, middle);
    high = max(high, middle);
    return outside ? vec4(20.0, -20.0, 20.0, -20.0) : vec4(low.x, high.x, low.y, high.y);
}

// The borders of the strips between `first` and `last`: at the three vertices between them, so that few strips hold a
// corner, and evenly in between, there at multiples of 4 texels: a block of 4 x 4 (of 2 x 2 on GPUs) that a border
// parts is run for both sides.
void mirrorballCapture_placeStrips(vec3 vertices, float first, float last, out float border[MIRRORBALL_STRIPS + 1])
{
    // With fewer strips than four parts: evenly.
    vec3 v = MIRRORBALL_STRIPS < 4 ? vec3(first) : clamp(vertices, first, last);
    float least = min(min(v.x, v.y), v.z);
    float most = max(max(v.x, v.y), v.z);
    float middle = max(min(max(v.x, v.y), v.z), min(v.x, v.y));
    float stops[5] = float[5](first, least, middle, most, last);
    float blocks = 0.25 * mirrorballCapture_size.MIRRORBALL_ALONG;
    int done = 0;
    border[0] = first;
    for (int part = 0; part < 4; ++part) {
        float from = stops[part];
        float to = stops[part + 1];
        int later = 0; // parts that still need a strip each
        for (int next = part + 1; next < 4; ++next)
            later += stops[next + 1] > stops[next] ? 1 : 0;
        int left = MIRRORBALL_STRIPS - done;
        int share = int(floor(float(left) * (to - from) / max(last - from, 1e-30) + 0.5));
        share = later == 0 ? left : clamp(share, 1, max(left - later, 1));
        share = to > from || part == 3 ? min(share, left) : 0;
        for (int index = 1; index < share; ++index) {
            float place = mix(from, to, float(index) / float(share));
            border[done + index] = clamp(floor(place * blocks + 0.5) / blocks, from, to);
        }
        if (share > 0)
            border[done + share] = to;
        done += share;
    }
}

// A triangle of any size, cut into strips between `first` and `last` along MIRRORBALL_ALONG; the polygon runs through
// the wider of two neighbours' outlines. edge: those of the triangle, turned so that the inside is where they are >= 0,
// and a plane that cuts away the far side of the sphere. The first three events are the vertices.
void mirrorballCapture_coverStrips(int view, vec3 edge[4], float events[MIRRORBALL_EVENTS], float first, float last,
                                   inout mirrorballCapture_Cover cover)
{
    const vec4 nothing = vec4(20.0, -20.0, 20.0, -20.0);
    float border[MIRRORBALL_STRIPS + 1];
    mirrorballCapture_placeStrips(vec3(events[0], events[1], events[2]), first, last, border);
    vec4 before = nothing;
    bool seen = false;
    bool gap = true; // the strips between the last one seen and this one need nothing drawn
    for (int strip = 0; strip <= MIRRORBALL_STRIPS; ++strip) {
        float at = border[strip];
        vec4 here = nothing;
        bool clear = true;
        if (strip < MIRRORBALL_STRIPS)
            here = mirrorballCapture_stripOutline(view, edge, events, at, border[strip + 1], clear);
        vec2 both = vec2(min(before.z, here.x), max(before.w, here.y));
        vec2 low, high;
        low.MIRRORBALL_ALONG = high.MIRRORBALL_ALONG = at * mirrorballCapture_size.MIRRORBALL_ALONG;
        low.MIRRORBALL_ACROSS = both.x * mirrorballCapture_size.MIRRORBALL_ACROSS - mirrorballCapture_guard;
        high.MIRRORBALL_ACROSS = both.y * mirrorballCapture_size.MIRRORBALL_ACROSS + mirrorballCapture_guard;
        if (both.x > both.y && seen) { // behind the triangle: no area
            low = cover.corner[2 * strip - 2];
            high = cover.corner[2 * strip - 1];
        }
        if (both.x <= both.y && !seen) { // before it: no area either
            low.MIRRORBALL_ALONG -= mirrorballCapture_guard;
            high.MIRRORBALL_ALONG -= mirrorballCapture_guard;
            for (int index = 0; index < 2 * strip; ++index)
                cover.corner[index] = low;
            seen = true;
        } else if (here.x <= here.y && before.x > before.y && gap) { // where it comes back
            low.MIRRORBALL_ALONG -= mirrorballCapture_guard;
            high.MIRRORBALL_ALONG -= mirrorballCapture_guard;
            cover.breaks |= 1 << strip;
        } else if (here.x > here.y && before.x <= before.y) { // its end
            low.MIRRORBALL_ALONG += mirrorballCapture_guard;
            high.MIRRORBALL_ALONG += mirrorballCapture_guard;
        }
        cover.corner[2 * strip] = low;
        cover.corner[2 * strip + 1] = high;
        gap = here.x > here.y && clear && (gap || before.x <= before.y);
        before = here;
    }
    cover.count = seen ? 2 * MIRRORBALL_STRIPS + 2 : 0;
}

// The triangle's edges and, where its vertices lie within a quarter turn of their mean, the plane square to that.
void mirrorballCapture_boundingPlanes(vec3 vertex[3], vec3 edge[3], out vec3 planes[4])
{
    vec3 a = normalize(vertex[0]);
    vec3 b = normalize(vertex[1]);
    vec3 c = normalize(vertex[2]);
    vec3 mean = a + b + c;
    bool within = min(min(dot(a, mean), dot(b, mean)), dot(c, mean)) > 0.0;
    planes = vec3[4](edge[0], edge[1], edge[2], within ? mean : edge[0]);
}
