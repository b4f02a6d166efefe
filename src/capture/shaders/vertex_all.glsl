// Only moves to the probe's frame; the geometry shader goes on.
uniform mat4 mirrorballCapture_probeFromWorld;
out vec3 mirrorballCapture_vertex;

void main()
{
    mirrorballCapture_hostMain();
    mirrorballCapture_vertex = (mirrorballCapture_probeFromWorld * vec4(MIRRORBALL_POSITION, 1.0)).xyz;
    gl_Position = vec4(0.0);
}
