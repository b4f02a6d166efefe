// The reflected ray is marched against the captured distances (Szirmay-Kalos, Aszodi, Lazanyi, Premecz, "Approximate
// ray-tracing on the GPU with distance impostors", 2005), but in a projective parameter: with p = unit(position) and
// d = unit(direction), v(s) = (1 - s) p + s d runs from the start of the ray at s = 0 to its end at infinity at s = 1,
// and the point of the ray in direction v lies at 1 / radius = (1 - s) / (|position| |v|). A plane's 1 / radius times
// |v| is linear in v. So regula falsi finds a plane in one step, however far it is, and nothing beyond the march's
// end is left out.
#if MIRRORBALL_LAYERED
const int mirrorball_steps = 24; // of the march; what is thinner than one may be missed
#else
const int mirrorball_steps = 8;
#endif
const int mirrorball_refinements = 4;  // of one crossing
const int mirrorball_hiddenSteps = 16; // of the march behind an edge
const int mirrorball_halvings = 6;     // of a crossing there
// A ray that is found this much of the distance behind a surface has not met it but slipped behind its edge.
const float mirrorball_slip = 0.05;
// In place of how far the ray is behind a second surface that was not captured: behind it as well.
const float mirrorball_unknown = 1e30;

// |v| / distance of what is seen in direction v; 0 where that is nothing.
float mirrorball_nearness(sampler2DArray distances, vec3 coordinate, float size)
{
    float radius = textureLod(distances, coordinate, 0.0).r;
    return radius > 0.0 ? size / radius : 0.0;
}

// How far the ray is behind the first and the second surface in the same direction: below 0 while in front.
float mirrorball_behindFirst(vec3 v, float inverse)
{
    vec3 coordinate = mirrorball_regular_coordinateFromDirection(v);
    return mirrorball_nearness(mirrorball_distanceMap, coordinate, length(v)) - inverse;
}

vec2 mirrorball_behind(vec3 v, float inverse)
{
    vec3 coordinate = mirrorball_regular_coordinateFromDirection(v);
    float size = length(v);
#if MIRRORBALL_LAYERED
    float nearness = mirrorball_nearness(mirrorball_hiddenDistanceMap, coordinate, size);
    float second = nearness > 0.0 ? nearness - inverse : mirrorball_unknown;
#else
    float second = mirrorball_unknown;
#endif
    return vec2(mirrorball_nearness(mirrorball_distanceMap, coordinate, size) - inverse, second);
}

// Goes on from `high`, just behind an edge, where both surfaces may be ahead or behind: w is the layer of depth. Where
// nothing is found it stays at `low`, just before the edge.
vec4 mirrorball_behindEdge(vec3 start, vec3 towards, float inverse, float low, float high)
{
    float from = high;
    vec2 before = mirrorball_behind(mix(start, towards, from), (1.0 - from) * inverse);
    float previous = from;
    for (int step = 1; step <= mirrorball_hiddenSteps; ++step) {
        float next = mix(from, 1.0, float(step) / float(mirrorball_hiddenSteps));
        vec2 after = mirrorball_behind(mix(start, towards, next), (1.0 - next) * inverse);
        bool front = before.x < 0.0;
        if (before.y < 0.0 && after.y >= 0.0 || front && after.x >= 0.0) {
            float near = previous;
            float far = next;
            vec2 here = after;
            for (int count = 0; count < mirrorball_halvings; ++count) {
                float middle = 0.5 * (near + far);
                vec2 between = mirrorball_behind(mix(start, towards, middle), (1.0 - middle) * inverse);
                if (between.x < 0.0 || !front && between.y < 0.0) {
                    near = middle;
                } else {
                    far = middle;
                    here = between;
                }
            }
            float tolerance = mirrorball_slip * (1.0 - far) * inverse;
            if (here.x <= tolerance)
                return vec4(mix(start, towards, far), 0.0);
            if (here.y >= 0.0 && here.y <= tolerance)
                return vec4(mix(start, towards, far), 1.0);
        }
        before = after;
        previous = next;
    }
    return vec4(mix(start, towards, low), 0.0);
}

vec4 mirrorball_shown(vec3 positionInWorld, vec3 directionInWorld)
{
    vec3 start = mirrorball_mapFromWorld * (positionInWorld - mirrorball_centreInWorld);
    vec3 towards = normalize(mirrorball_mapFromWorld * directionInWorld);
    float inverse = 1.0 / max(length(start), 1e-30);
    start *= inverse;

    float low = 0.0;
    float high = 0.0;
    float before = -1.0;
    float after = mirrorball_behindFirst(start, inverse);
    for (int step = 1; step <= mirrorball_steps; ++step) {
        low = high;
        before = after;
        high = float(step) / float(mirrorball_steps);
        after = mirrorball_behindFirst(mix(start, towards, high), (1.0 - high) * inverse);
        if (before < 0.0 && after >= 0.0)
            break;
    }
    if (!(before < 0.0))
        return vec4(towards, 0.0);
    float s = high;
    float here = after;
    for (int count = 0; count < mirrorball_refinements; ++count) {
        s = low + (high - low) * before / (before - after);
        here = mirrorball_behindFirst(mix(start, towards, s), (1.0 - s) * inverse);
        if (here < 0.0) {
            low = s;
            before = here;
        } else {
            high = s;
            after = here;
        }
    }
    // A loop of one turn, since software rasterisers skip loops that nobody enters and walk through both sides of an if.
    vec4 shown = vec4(mix(start, towards, s), 0.0);
    for (int turns = here > mirrorball_slip * (1.0 - s) * inverse ? 1 : 0; turns > 0; --turns)
        shown = mirrorball_behindEdge(start, towards, inverse, low, high);
    return shown;
}

