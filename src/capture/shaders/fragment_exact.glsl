// Exact capture, the fragment stage: the texel's own ray against the triangle's edges. All arithmetic of a texel
// depends on nothing but the texel and the triangle, so neighbouring triangles neither crack nor overlap.
uniform vec2 mirrorballCapture_range; // near, far
uniform vec2 mirrorballCapture_size;
uniform vec2 mirrorballCapture_depth; // depth = x + y / distance
flat in vec3 mirrorballCapture_edge0;
flat in vec3 mirrorballCapture_edge1;
flat in vec3 mirrorballCapture_edge2;
flat in vec4 mirrorballCapture_trianglePlane;
flat in ivec2 mirrorballCapture_numbers; // of the primitive and the layer
out float mirrorballCapture_distance;

vec3 mirrorballCapture_weight;
float mirrorballCapture_radius;
bool mirrorballCapture_hit;

void mirrorballCapture_begin()
{
    vec3 ray = mirrorballCapture_rayOfTexel(mirrorballCapture_numbers.y, gl_FragCoord.xy, mirrorballCapture_size);
    vec3 inside = vec3(dot(ray, mirrorballCapture_edge0), dot(ray, mirrorballCapture_edge1),
                       dot(ray, mirrorballCapture_edge2));
    // Positions hit in proportion to these weights: perspective-correct without a projection.
    mirrorballCapture_weight = inside / (inside.x + inside.y + inside.z);
    float radius = mirrorballCapture_trianglePlane.w / dot(mirrorballCapture_trianglePlane.xyz, ray) *
                   mirrorballCapture_rayLength(ray);
    mirrorballCapture_hit = (all(greaterThanEqual(inside, vec3(0.0))) || all(lessThanEqual(inside, vec3(0.0)))) &&
                            radius >= mirrorballCapture_range.x && radius <= mirrorballCapture_range.y;
    mirrorballCapture_radius = radius;
#if MIRRORBALL_READS_FRONT_FACING
    mirrorballCapture_hostFrontFacing = mirrorballCapture_trianglePlane.w < 0.0;
#endif
#if MIRRORBALL_READS_PRIMITIVE_ID
    mirrorballCapture_hostPrimitiveID = mirrorballCapture_numbers.x;
#endif
}

void mirrorballCapture_end()
{
    // After the host's main, so that its texture look-ups have derivatives everywhere.
    if (!mirrorballCapture_hit || !mirrorballCapture_isHidden(mirrorballCapture_radius))
        discard;
    gl_FragDepth = mirrorballCapture_depth.x + mirrorballCapture_depth.y / mirrorballCapture_radius;
    mirrorballCapture_distance = mirrorballCapture_radius;
}
