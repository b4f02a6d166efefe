// Tessellated capture, evaluation stage: each new vertex is mapped.
layout(triangles, equal_spacing, ccw) in;
in vec3 mirrorballCapture_corner[];
out vec3 mirrorballCapture_position;
out float gl_ClipDistance[3];
uniform int mirrorballCapture_view;

void mirrorballCapture_mixVaryings(vec3 weight);

void main()
{
    vec3 position = gl_TessCoord.x * mirrorballCapture_corner[0] + gl_TessCoord.y * mirrorballCapture_corner[1] +
                    gl_TessCoord.z * mirrorballCapture_corner[2];
    mirrorballCapture_position = position;
    mirrorballCapture_mixVaryings(gl_TessCoord);
    gl_Position = mirrorballCapture_project(mirrorballCapture_view, position);
    vec3 inside = mirrorballCapture_inside(mirrorballCapture_view, position);
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
    gl_ClipDistance[2] = inside.z;
}
