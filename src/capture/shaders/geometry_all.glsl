// Sends each triangle to every view that it may touch, all in one draw.
layout(triangles) in;
layout(triangle_strip, max_vertices = MIRRORBALL_VERTICES) out;
in vec3 mirrorballCapture_vertex[];
out vec3 mirrorballCapture_position;
#if MIRRORBALL_CUTS
out float gl_ClipDistance[3];
#endif
// Hands on the host's varyings of one vertex. Its text comes last, behind the host's macros and names.
void mirrorballCapture_copyVaryings(int corner);

bool mirrorballCapture_outside(vec4 a, vec4 b, vec4 c)
{
    return (a.x > a.w && b.x > b.w && c.x > c.w) || (a.x < -a.w && b.x < -b.w && c.x < -c.w) ||
           (a.y > a.w && b.y > b.w && c.y > c.w) || (a.y < -a.w && b.y < -b.w && c.y < -c.w) ||
           (a.w <= 0.0 && b.w <= 0.0 && c.w <= 0.0);
}

void main()
{
    for (int view = 0; view < MIRRORBALL_VIEWS; ++view) {
        vec4 clip[3];
        vec3 inside[3];
        for (int corner = 0; corner < 3; ++corner) {
            clip[corner] = mirrorballCapture_project(view, mirrorballCapture_vertex[corner]);
            inside[corner] = mirrorballCapture_inside(view, mirrorballCapture_vertex[corner]);
        }
        vec3 most = max(max(inside[0], inside[1]), inside[2]);
        if (mirrorballCapture_outside(clip[0], clip[1], clip[2]) || min(min(most.x, most.y), most.z) < 0.0)
            continue;
        // Where the map turns round what is seen, the first two change places: a front face is always
        // counter-clockwise on the layer, and the last vertex still provokes.
        bool turned = ((MIRRORBALL_TURNED_VIEWS >> view) & 1) != 0;
        for (int index = 0; index < 3; ++index) {
            int corner = turned && index < 2 ? 1 - index : index;
            mirrorballCapture_copyVaryings(corner);
            mirrorballCapture_position = mirrorballCapture_vertex[corner];
#if MIRRORBALL_CUTS
            gl_ClipDistance[0] = inside[corner].x;
            gl_ClipDistance[1] = inside[corner].y;
            gl_ClipDistance[2] = inside[corner].z;
#endif
            gl_Position = clip[corner];
            gl_Layer = MIRRORBALL_LAYER(view);
            gl_PrimitiveID = gl_PrimitiveIDIn;
            EmitVertex();
        }
        EndPrimitive();
    }
}
