// Polygons on the map, in texels, that are certain to cover a curved triangle.
uniform vec2 mirrorballCapture_size; // of a layer, in texels

// Rounding of positions (the rasteriser snaps to 1/16 texel at the coarsest) and of the chart.
const float mirrorballCapture_guard = 0.07;

// A box from low to high, cut to the layer. False if nothing of it lies there.
bool mirrorballCapture_coverBox(vec2 low, vec2 high, out vec2 corner[4])
{
    low = max(low - mirrorballCapture_guard, vec2(0.0));
    high = min(high + mirrorballCapture_guard, mirrorballCapture_size);
    corner[0] = low;
    corner[1] = vec2(high.x, low.y);
    corner[2] = vec2(low.x, high.y);
    corner[3] = high;
    return all(lessThan(low, high));
}

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
bool mirrorballCapture_coverTriangle(vec2 p[3], vec3 sag, out vec2 corner[4])
{
    sag += mirrorballCapture_guard;
    float most = max(max(sag.x, sag.y), sag.z);
    vec2 low = min(min(p[0], p[1]), p[2]) - most;
    vec2 high = max(max(p[0], p[1]), p[2]) + most;
    if (any(greaterThan(low, mirrorballCapture_size)) || any(lessThan(high, vec2(0.0))))
        return false;
    vec2 ab = p[1] - p[0];
    vec2 ac = p[2] - p[0];
    float turn = ab.x * ac.y - ab.y * ac.x < 0.0 ? -1.0 : 1.0;
    float stretch = 0.0;
    corner[0] = mirrorballCapture_pushedCorner(p[2], p[0], p[1], sag.yz, turn, stretch);
    corner[1] = mirrorballCapture_pushedCorner(p[0], p[1], p[2], sag.zx, turn, stretch);
    corner[2] = mirrorballCapture_pushedCorner(p[1], p[2], p[0], sag.xy, turn, stretch);
    corner[3] = corner[2];
    // NaN, from two corners in one place, takes the box as well.
    if (stretch < 4.0)
        return true;
    vec2 bc = p[2] - p[1];
    vec2 along = dot(ab, ab) >= dot(ac, ac) && dot(ab, ab) >= dot(bc, bc) ? ab : dot(ac, ac) >= dot(bc, bc) ? ac : bc;
    float size = length(along);
    along = size > 0.0 ? along / size : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    vec3 s = vec3(dot(p[0], along), dot(p[1], along), dot(p[2], along));
    vec3 t = vec3(dot(p[0], across), dot(p[1], across), dot(p[2], across));
    vec2 first = vec2(min(min(s.x, s.y), s.z), min(min(t.x, t.y), t.z)) - most;
    vec2 last = vec2(max(max(s.x, s.y), s.z), max(max(t.x, t.y), t.z)) + most;
    corner[0] = first.x * along + first.y * across;
    corner[1] = last.x * along + first.y * across;
    corner[2] = first.x * along + last.y * across;
    corner[3] = last.x * along + last.y * across;
    return true;
}
