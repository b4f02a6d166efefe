// The triangle goes to the second layer.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

void main()
{
    for (int corner = 0; corner < 3; ++corner) {
        gl_Layer = 1;
        gl_Position = gl_in[corner].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
