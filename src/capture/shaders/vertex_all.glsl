// Only moves to the probe's frame; the geometry shader goes on.
uniform mat4 mirrorballCapture_probeFromWorld;
out vec3 mirrorballCapture_vertex;
#if MIRRORBALL_SQUARES
uniform int mirrorballCapture_view;
out vec2 mirrorballCapture_square; // where the one view has it: once a vertex, not once a corner of a triangle
#endif

void mirrorballCapture_place(vec3 positionInWorld)
{
    mirrorballCapture_vertex = (mirrorballCapture_probeFromWorld * vec4(positionInWorld, 1.0)).xyz;
#if MIRRORBALL_SQUARES
    mirrorballCapture_square = mirrorballCapture_squareFromDirection(mirrorballCapture_view, mirrorballCapture_vertex);
#endif
    gl_Position = vec4(0.0);
}
