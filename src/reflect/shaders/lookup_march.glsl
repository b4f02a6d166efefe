// The reflected ray is marched against the captured distances (Szirmay-Kalos, Aszodi, Lazanyi, Premecz, "Approximate
// ray-tracing on the GPU with distance impostors", 2005), but in a projective parameter: with p = unit(position) and
// d = unit(direction), v(s) = (1 - s) p + s d runs from the start of the ray at s = 0 to its end at infinity at s = 1,
// and the point of the ray in direction v lies at 1 / radius = (1 - s) / (|position| |v|). A plane's 1 / radius times
// |v| is linear in v. So regula falsi finds a plane in one step, however far it is, and nothing beyond the march's
// end is left out.
const int mirrorball_steps = 12;       // of the march
const int mirrorball_refinements = 4;  // at most, of one crossing
const float mirrorball_slip = 0.1;

// |v| / distance of what is seen in direction v; 0 where that is nothing.
float mirrorball_nearness(vec3 v)
{
    float radius = textureLod(mirrorball_distanceMap, mirrorball_regular_coordinateFromDirection(v), 0.0).r;
    return radius > 0.0 ? length(v) / radius : 0.0;
}

vec3 mirrorball_shownDirection(vec3 positionInWorld, vec3 directionInWorld)
{
    vec3 start = mirrorball_mapFromWorld * (positionInWorld - mirrorball_centreInWorld);
    vec3 towards = normalize(mirrorball_mapFromWorld * directionInWorld);
    float inverse = 1.0 / max(length(start), 1e-30);
    start *= inverse;

    // How far the ray is behind what is seen in the same direction: below 0 while it is in front.
    float before = mirrorball_nearness(start) - inverse;
    for (int step = 1; step <= mirrorball_steps; ++step) {
        float high = float(step) / float(mirrorball_steps);
        float after = mirrorball_nearness(mix(start, towards, high)) - (1.0 - high) * inverse;
        float next = after;
        if (before < 0.0 && after >= 0.0) {
            float low = float(step - 1) / float(mirrorball_steps);
            float s = high;
            float here = after;
            for (int count = 0; count < mirrorball_refinements; ++count) {
                s = low + (high - low) * before / (before - after);
                here = mirrorball_nearness(mix(start, towards, s)) - (1.0 - s) * inverse;
                if (here < 0.0) {
                    low = s;
                    before = here;
                } else {
                    high = s;
                    after = here;
                }
            }
            vec3 shown = mix(start, towards, s);
            // Far behind: the ray has slipped behind the edge of something nearer.
            if (here <= mirrorball_slip * (1.0 - s) * inverse)
                return shown;
        }
        before = next;
    }
    return towards;
}

