// One triangle over the whole viewport, without attributes.
flat out int instance; // for a geometry shader that draws each into a layer of its own

void main()
{
    instance = gl_InstanceID;
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
