// Exact capture, the geometry stage: each triangle becomes a polygon that covers its curved outline on the map, with
// what the fragment stage needs to test and interpolate in direction space (homogeneous rasterisation: Olano and Greer,
// "Triangle scan conversion using 2D homogeneous coordinates", 1997; Gascuel et al., "Fast non-linear projections using
// graphics hardware", 2008).
layout(triangle_strip, max_vertices = MIRRORBALL_VERTICES) out;
in vec3 mirrorballCapture_vertex[];
uniform int mirrorballCapture_view;
uniform bool mirrorballCapture_cullBackFaces;
// Normals of the planes through the probe's centre and an edge; edge k is opposite to vertex k.
flat out vec3 mirrorballCapture_edge0;
flat out vec3 mirrorballCapture_edge1;
flat out vec3 mirrorballCapture_edge2;
flat out vec4 mirrorballCapture_trianglePlane; // of the triangle: xyz . position = w
flat out ivec2 mirrorballCapture_numbers; // of the primitive and the layer
// Hands on the host's varyings at the three vertices. Its text comes last, behind the host's macros and names.
void mirrorballCapture_copyVaryings();

// Twice the cross product, in Embree's form: under exchange of the ends every product and difference negates exactly.
// The ends are put in a canonical order first, so that even a compiler that contracts a * b + c into one rounding gives
// the two triangles of an edge the same normal up to its sign.
vec3 mirrorballCapture_edgeNormal(vec3 from, vec3 to)
{
    bool inOrder = from.x != to.x ? from.x < to.x : from.y != to.y ? from.y < to.y : from.z < to.z;
    vec3 first = inOrder ? from : to;
    vec3 second = inOrder ? to : from;
    vec3 normal = cross(first - second, first + second);
    return inOrder ? normal : -normal;
}

void mirrorballCapture_emit(int view, vec3 vertex[3], vec3 edge[3], vec4 plane)
{
    vec3 inward[3];
    for (int k = 0; k < 3; ++k)
        inward[k] = plane.w < 0.0 ? -edge[k] : edge[k];
    mirrorballCapture_Cover cover;
    mirrorballCapture_coverIn(view, vertex, inward, cover);
    // Bit k: the quadrilateral that begins with corner 2 k, or the only triangle, is drawn.
    int drawn = ((1 << (max(cover.count + 1, 2) / 2 - 1)) - 1) & ~(cover.breaks >> 1);
#if MIRRORBALL_HIDES
    float nearest = mirrorballCapture_triangleDistance(vertex, inward, plane);
    for (int quad = 0; 2 * quad + 2 < cover.count; ++quad) {
        vec2 a = cover.corner[2 * quad];
        vec2 b = cover.corner[2 * quad + 1];
        vec2 c = cover.corner[2 * quad + 2];
        vec2 d = cover.corner[min(2 * quad + 3, cover.count - 1)];
        vec2 low = min(min(a, b), min(c, d));
        vec2 high = max(max(a, b), max(c, d));
        bool behind = mirrorballCapture_isBehind(MIRRORBALL_LAYER(view), low, high, nearest, plane);
        drawn &= behind ? ~(1 << quad) : -1;
    }
#endif
    for (int index = 0; index < cover.count; ++index) {
        int neighbours = ((drawn << 1) >> (index / 2)) & 3; // bit 0: before these corners, bit 1: behind them
        if (neighbours == 0)
            continue;
        if ((index & 1) == 0 && (neighbours & 1) == 0)
            EndPrimitive();
        mirrorballCapture_edge0 = edge[0];
        mirrorballCapture_edge1 = edge[1];
        mirrorballCapture_edge2 = edge[2];
        mirrorballCapture_trianglePlane = plane;
        mirrorballCapture_numbers = ivec2(gl_PrimitiveIDIn, MIRRORBALL_LAYER(view));
        mirrorballCapture_copyVaryings();
        gl_Position = vec4(2.0 * cover.corner[index] / mirrorballCapture_size - 1.0, 0.0, 1.0);
#if MIRRORBALL_ALL_AT_ONCE
        gl_Layer = MIRRORBALL_LAYER(view);
#endif
        EmitVertex();
    }
    EndPrimitive();
}

void main()
{
    vec3 vertex[3];
    vec3 edge[3];
    for (int corner = 0; corner < 3; ++corner) {
        vertex[corner] = mirrorballCapture_vertex[corner];
        // NaN fails every comparison; beyond 1e12 the products of three coordinates would leave the range of floats.
        if (!all(lessThan(abs(vertex[corner]), vec3(1e12))))
            return;
    }
    vec4 plane = mirrorballCapture_plane(vertex[0], vertex[1], vertex[2]);
    // Seen edge-on, or without area: it covers no direction.
    if (plane.w == 0.0 || (mirrorballCapture_cullBackFaces && plane.w > 0.0))
        return;
    for (int corner = 0; corner < 3; ++corner)
        edge[corner] = mirrorballCapture_edgeNormal(vertex[(corner + 1) % 3], vertex[(corner + 2) % 3]);
#if MIRRORBALL_ALL_AT_ONCE
    for (int view = 0; view < MIRRORBALL_VIEWS; ++view)
        mirrorballCapture_emit(view, vertex, edge, plane);
#else
    mirrorballCapture_emit(mirrorballCapture_view, vertex, edge, plane);
#endif
}
