// The reflected ray is marched against the captured distances (Szirmay-Kalos, Aszodi, Lazanyi, Premecz, "Approximate
// ray-tracing on the GPU with distance impostors", 2005), but in a projective parameter: with p = unit(position) and
// d = unit(direction), v(s) = (1 - s) p + s d runs from the start of the ray at s = 0 to its end at infinity at s = 1,
// and the point of the ray in direction v lies at 1 / radius = (1 - s) / (|position| |v|). A plane's 1 / radius times
// |v| is linear in v. So regula falsi finds a plane in one step, however far it is, and nothing beyond the march's
// end is left out.
uniform int mirrorball_nearestLevel; // of the distances: there a texel holds the nearest of a block; 0 for none
// Of the march; what is thinner than one may be missed. Steps are denser towards the end, by the more the smaller
// mirrorball_even.
#if MIRRORBALL_LAYERED
const int mirrorball_steps = 28;
const float mirrorball_even = 0.3;
#else
const int mirrorball_steps = 18;
const float mirrorball_even = 0.0;
#endif
const int mirrorball_refinements = 6; // of one crossing: three of them halve the interval
// Parts of the distance. So close to a surface a point lies on it; what is found farther behind it has not met it but
// slipped behind its edge.
const float mirrorball_close = 0.005;
const float mirrorball_slip = 0.03;
// Neighbouring texels whose distances have no larger ratio are filtered together.
const float mirrorball_alike = 1.3;

struct mirrorball_Ray
{
    vec3 start, towards; // p and d
    float inverse;       // 1 / |position|
};

vec3 mirrorball_at(mirrorball_Ray ray, float s)
{
    return mix(ray.start, ray.towards, s);
}

// How far the ray is behind a surface in the same direction, as a difference of |v| / distance: below 0 while in front.
// What nothing was captured of is infinitely far.
float mirrorball_behind(sampler2DArray distances, mirrorball_Ray ray, float s)
{
    vec3 v = mirrorball_at(ray, s);
    float radius = textureLod(distances, mirrorball_regular_coordinateFromDirection(v), 0.0).r;
    return (radius > 0.0 ? length(v) / radius : 0.0) - (1.0 - s) * ray.inverse;
}

// The nearest distance around the direction at one place.
float mirrorball_nearestAround(mirrorball_Ray ray, float s)
{
    vec3 coordinate = mirrorball_regular_coordinateFromDirection(mirrorball_at(ray, s));
    ivec2 size = textureSize(mirrorball_distanceMap, mirrorball_nearestLevel).xy;
    ivec3 texel = ivec3(clamp(ivec2(coordinate.xy * vec2(size)), ivec2(0), size - 1), int(coordinate.z));
    return texelFetch(mirrorball_distanceMap, texel, mirrorball_nearestLevel).r;
}

// Where the march begins: by the blocks in four directions of the sweep nothing is nearer than the ray has come there.
// Of a sweep of 90 degrees they are 30 apart, and something narrow between two blocks may be passed by. A ray that
// comes nearer to the centre first (a mirror that is long or hollow has those) begins at the mirror.
float mirrorball_firstPlace(mirrorball_Ray ray)
{
    float place = 0.0;
    float cosine = dot(ray.start, ray.towards);
    for (int turns = mirrorball_nearestLevel > 0 && cosine >= 0.0 ? 1 : 0; turns > 0; --turns) {
        float nearest = min(min(mirrorball_nearestAround(ray, 0.0), mirrorball_nearestAround(ray, 0.366)),
                            min(mirrorball_nearestAround(ray, 0.634), mirrorball_nearestAround(ray, 1.0)));
        nearest = min(nearest, 1e6 / ray.inverse);
        // |p + x d| = nearest / |position| at x = s / (1 - s), and a little before, to be in front of it.
        float size = max((1.0 - 2.0 * mirrorball_close) * nearest * ray.inverse, 1.0);
        float x = max(sqrt(cosine * cosine + size * size - 1.0) - cosine, 0.0);
        place = x / (1.0 + x);
    }
    return place;
}

// Narrows an interval from in front of a surface to behind it, as `front` and `back` tell; whether the ray meets the
// surface there, at y.
bool mirrorball_meets(sampler2DArray distances, mirrorball_Ray ray, float front, float back, inout vec2 interval)
{
    bool crosses = front < 0.0 && back >= 0.0;
    for (int count = crosses ? mirrorball_refinements : 0; count > 0; --count) {
        // Regula falsi, for planes, and halving, for edges, in turn.
        float part = (count & 1) == 0 ? front / (front - back) : 0.5;
        float s = mix(interval.x, interval.y, part);
        float here = mirrorball_behind(distances, ray, s);
        bool isClose = abs(here) <= mirrorball_close * (1.0 - s) * ray.inverse;
        if (here < 0.0 && !isClose) {
            interval.x = s;
            front = here;
        } else {
            interval.y = s;
            back = here;
        }
        if (isClose)
            break;
    }
    return crosses && back <= mirrorball_slip * (1.0 - interval.y) * ray.inverse;
}

#if MIRRORBALL_LAYERED
// A surface goes on where its 1 / distance, linear for a plane, bends by no more than this part of what it changes by.
const float mirrorball_bend = 0.3;

float mirrorball_inverseDistance(ivec2 texel, int layer)
{
    texel = clamp(texel, ivec2(0), textureSize(mirrorball_distanceMap, 0).xy - 1);
    return 1.0 / texelFetch(mirrorball_distanceMap, ivec3(texel, layer), 0).r;
}

// Whether the texels at both ends of a narrow interval show one surface, which goes on beyond one of them: seen at a
// grazing angle it recedes by more than the slip from one row of texels to the next.
bool mirrorball_goesOn(mirrorball_Ray ray, vec2 interval)
{
    vec3 size = vec3(textureSize(mirrorball_distanceMap, 0).xy, 1.0);
    ivec3 a = ivec3(size * mirrorball_regular_coordinateFromDirection(mirrorball_at(ray, interval.x)));
    ivec3 b = ivec3(size * mirrorball_regular_coordinateFromDirection(mirrorball_at(ray, interval.y)));
    ivec2 onwards = b.xy - a.xy;
    float atA = mirrorball_inverseDistance(a.xy, a.z);
    float change = mirrorball_inverseDistance(b.xy, b.z) - atA;
    float beforeA = mirrorball_inverseDistance(a.xy - onwards, a.z);
    float beyondB = mirrorball_inverseDistance(b.xy + onwards, b.z);
    float bend = min(abs(atA - beforeA - change), abs(beyondB - atA - 2.0 * change));
    return a.z == b.z && bend <= mirrorball_bend * abs(change);
}
#endif

// w of the answer is the layer of depth. A ray that meets nothing shows the last direction in front of an edge.
vec4 mirrorball_shown(vec3 positionInWorld, vec3 directionInWorld)
{
    mirrorball_Ray ray;
    ray.start = mirrorball_mapFromWorld * (positionInWorld - mirrorball_centreInWorld);
    ray.towards = normalize(mirrorball_mapFromWorld * directionInWorld);
    ray.inverse = 1.0 / max(length(ray.start), 1e-30);
    ray.start *= ray.inverse;

    float first = mirrorball_firstPlace(ray);
    float before = mirrorball_behind(mirrorball_distanceMap, ray, first);
    // Behind something narrow between the places asked: from the start, taken to be in front of everything.
    bool isLate = before >= 0.0;
    first = isLate ? 0.0 : first;
    before = isLate ? -ray.inverse : before;
    float previous = first;
    vec4 shown = vec4(ray.towards, 0.0);
    bool found = false;
#if MIRRORBALL_LAYERED
    vec2 slipped = vec2(-1.0); // where the ray first came behind the first surface without meeting it
    float front = 0.0;         // how far it is behind the second surface at `previous`, if behind the first
#endif
    for (int step = 1; step <= mirrorball_steps && !found; ++step) {
        // Half as far from the end, surfaces are twice as far away.
        float remaining = 1.0 - float(step) / float(mirrorball_steps);
        float next = 1.0 - (1.0 - first) * remaining * mix(remaining, 1.0, mirrorball_even);
        float after = mirrorball_behind(mirrorball_distanceMap, ray, next);
        // Loops of one turn, since software rasterisers skip loops that nobody enters and walk through both sides of an
        // if.
        for (int turns = before < 0.0 && after >= 0.0 ? 1 : 0; turns > 0; --turns) {
            vec2 interval = vec2(previous, next);
            found = mirrorball_meets(mirrorball_distanceMap, ray, before, after, interval);
            shown = vec4(mirrorball_at(ray, found ? interval.y : interval.x), 0.0);
#if MIRRORBALL_LAYERED
            slipped = found || slipped.y > 0.0 ? slipped : interval;
            front = mirrorball_behind(mirrorball_hiddenDistanceMap, ray, previous);
#endif
        }
#if MIRRORBALL_LAYERED
        // Only what is behind the first surface can be behind the second. The last step ends at infinity, behind all:
        // there nothing is looked for.
        for (int turns = after >= 0.0 && next < 1.0 && !found ? 1 : 0; turns > 0; --turns) {
            vec2 interval = vec2(previous, next);
            float back = mirrorball_behind(mirrorball_hiddenDistanceMap, ray, next);
            found = mirrorball_meets(mirrorball_hiddenDistanceMap, ray, front, back, interval);
            shown = found ? vec4(mirrorball_at(ray, interval.y), 1.0) : shown;
            front = back;
        }
#endif
        before = after;
        previous = next;
    }
#if MIRRORBALL_LAYERED
    // What only the second layer shows may be the grazing surface that the ray has met before.
    for (int turns = slipped.y > 0.0 && shown.w > 0.5 ? 1 : 0; turns > 0; --turns)
        shown = mirrorball_goesOn(ray, slipped) ? vec4(mirrorball_at(ray, slipped.y), 0.0) : shown;
#endif
    return shown;
}

// Where the colours are to be read: as near as linear filtering mixes in nothing of another surface than the one that
// the nearest texel shows. (Corners, a quarter of what is mixed at most, are left.)
vec2 mirrorball_withinSurface(vec3 coordinate)
{
    vec2 size = max(vec2(textureSize(mirrorball_distanceMap, 0).xy), 1.0); // no texture may have no size
    vec2 place = coordinate.xy * size;
    vec2 middle = min(floor(place), size - 1.0) + 0.5;
    vec2 offset = place - middle;
    vec2 next = coordinate.xy + sign(offset) / size;
    float here = textureLod(mirrorball_distanceMap, coordinate, 0.0).r;
    vec2 beside = vec2(textureLod(mirrorball_distanceMap, vec3(next.x, coordinate.yz), 0.0).r,
                       textureLod(mirrorball_distanceMap, vec3(coordinate.x, next.y, coordinate.z), 0.0).r);
    bvec2 alike = lessThanEqual(max(beside, here), mirrorball_alike * min(beside, here));
    return (middle + offset * vec2(alike)) / size;
}
