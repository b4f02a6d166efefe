layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
flat in int instance[];
flat out int layer;

void main()
{
    for (int corner = 0; corner < 3; ++corner) {
        layer = gl_Layer = instance[0];
        gl_Position = gl_in[corner].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
