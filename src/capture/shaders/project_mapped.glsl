// Vertices mapped, edges straight on the map. The textbook way has w = 1, so that nothing is interpolated in
// perspective; with w = distance, varyings and the distance itself are.
uniform vec2 mirrorballCapture_depth; // depth = x + y / distance

vec4 mirrorballCapture_project(int view, vec3 position)
{
    vec2 square = mirrorballCapture_squareFromDirection(view, position) * 2.0 - 1.0;
    float radius = length(position);
#if MIRRORBALL_TEXTBOOK_TENNIS_BALL
    float z = radius / 100.0 + square.y * square.y - 0.75;
#elif MIRRORBALL_TEXTBOOK_DUAL_PARABOLOID
    float z = (view == 0 ? -position.z : position.z) / 100.0 - 0.9;
#else
    float z = mirrorballCapture_depth.x + mirrorballCapture_depth.y / max(radius, 1e-30);
#endif
#if MIRRORBALL_PERSPECTIVE
    return vec4(square * radius, mirrorballCapture_depth.x * radius + mirrorballCapture_depth.y, radius);
#else
    return vec4(square, z, 1.0);
#endif
}

// Cuts off what lies well outside a component, where the chart would smear it.
vec3 mirrorballCapture_inside(int view, vec3 position)
{
    float radius = length(position);
#if MIRRORBALL_TENNIS_BALL
    vec3 local = view == 0 ? position : vec3(position.y, position.x, -position.z);
    // 0.9 = -cos(154 degrees); the component itself ends at 135 degrees.
    return vec3(local.z + 0.9 * length(local.xz), 0.0, 0.0);
#elif MIRRORBALL_DUAL_PARABOLOID
    // 0.5 = sin(30 degrees) beyond the hemisphere.
    return vec3((view == 0 ? -position.z : position.z) + 0.5 * radius, 0.0, 0.0);
#elif MIRRORBALL_EQUI_ANGULAR_CUBE
    float major = view < 2 ? position.x : view < 4 ? position.y : position.z;
    // 0.2 = cos(78 degrees); a face's corner is at 54.7 degrees.
    return vec3(((view & 1) == 0 ? major : -major) - 0.2 * radius, 0.0, 0.0);
#else
    return vec3(0.0);
#endif
}
