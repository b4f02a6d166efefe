// One triangle over the whole viewport for every instance, each for a layer of its own.
flat out int layerOfInstance;

void main()
{
    layerOfInstance = gl_InstanceID;
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
