// One view at a time.
uniform mat4 mirrorballCapture_probeFromWorld;
uniform int mirrorballCapture_view;
out vec3 mirrorballCapture_position; // in the probe's frame, world units
#if MIRRORBALL_CUTS
out float gl_ClipDistance[3];
#endif

void mirrorballCapture_place(vec3 positionInWorld)
{
    vec3 position = (mirrorballCapture_probeFromWorld * vec4(positionInWorld, 1.0)).xyz;
    mirrorballCapture_position = position;
    gl_Position = mirrorballCapture_project(mirrorballCapture_view, position);
#if MIRRORBALL_CUTS
    vec3 inside = mirrorballCapture_inside(mirrorballCapture_view, position);
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
    gl_ClipDistance[2] = inside.z;
#endif
}
