// Only moves to the probe's frame; the geometry shader goes on.
uniform mat4 mirrorballCapture_probeFromWorld;
out vec3 mirrorballCapture_vertex;

void mirrorballCapture_place(vec3 positionInWorld)
{
    mirrorballCapture_vertex = (mirrorballCapture_probeFromWorld * vec4(positionInWorld, 1.0)).xyz;
    gl_Position = vec4(0.0);
}
