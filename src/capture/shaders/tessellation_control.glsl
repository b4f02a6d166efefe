// Tessellated capture, control stage: cuts each edge into pieces that span at most 1 / steps radian as seen from the
// probe. An edge's level depends on its two ends alone and not on their order, so neighbours fit.
layout(vertices = 3) out;
in vec3 mirrorballCapture_vertex[];
out vec3 mirrorballCapture_corner[];
uniform float mirrorballCapture_steps; // a radian

float mirrorballCapture_level(vec3 a, vec3 b)
{
    float nearest = min(min(length(a), length(b)), 0.5 * length(a + b));
    return clamp(ceil(mirrorballCapture_steps * length(a - b) / max(nearest, 1e-30)), 1.0, 64.0);
}

void mirrorballCapture_copyVaryings();

void main()
{
    mirrorballCapture_corner[gl_InvocationID] = mirrorballCapture_vertex[gl_InvocationID];
    mirrorballCapture_copyVaryings();
    vec3 levels = vec3(mirrorballCapture_level(mirrorballCapture_vertex[1], mirrorballCapture_vertex[2]),
                       mirrorballCapture_level(mirrorballCapture_vertex[2], mirrorballCapture_vertex[0]),
                       mirrorballCapture_level(mirrorballCapture_vertex[0], mirrorballCapture_vertex[1]));
    gl_TessLevelOuter[0] = levels.x;
    gl_TessLevelOuter[1] = levels.y;
    gl_TessLevelOuter[2] = levels.z;
    gl_TessLevelInner[0] = max(max(levels.x, levels.y), levels.z);
}
