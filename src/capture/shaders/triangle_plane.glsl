// The plane of a triangle as seen from the probe's centre: xyz . position = w.

#ifdef GL_ARB_gpu_shader5
#define MIRRORBALL_COMPENSATED 1
// Adds a * b to an unevaluated sum of two floats, both roundings kept (Dekker, "A floating-point technique for
// extending the available precision", 1971). `precise` forbids the compiler to simplify the differences away.
void mirrorballCapture_addProduct(float a, float b, inout vec2 sum)
{
    const float splitter = 4097.0; // 2^12 + 1 halves a float's 24 bits
    precise float product = a * b;
    precise float aLarge = splitter * a;
    precise float aHigh = aLarge - (aLarge - a);
    precise float aLow = a - aHigh;
    precise float bLarge = splitter * b;
    precise float bHigh = bLarge - (bLarge - b);
    precise float bLow = b - bHigh;
    precise float productError = aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow);
    precise float total = sum.x + product;
    precise float part = total - sum.x;
    precise float sumError = (sum.x - (total - part)) + (product - part);
    precise float low = sum.y + (productError + sumError);
    sum = vec2(total, low);
}

#endif

vec4 mirrorballCapture_plane(vec3 a, vec3 b, vec3 c)
{
    vec3 ab = b - a;
    vec3 ac = c - a;
    vec3 normal = cross(ab, ac);
    // The nearest vertex loses least in the sum.
    vec3 squared = vec3(dot(a, a), dot(b, b), dot(c, c));
    vec3 nearest = squared.x <= squared.y && squared.x <= squared.z ? a : squared.y <= squared.z ? b : c;
    vec4 plane = vec4(normal, dot(normal, nearest));
#ifdef MIRRORBALL_COMPENSATED
    // Needles, and planes that nearly hold the centre, lose too many digits. A loop, and no if: software rasterisers
    // leave loops that nobody enters after one turn, and walk through both sides of an if.
    float area = dot(normal, normal);
    bool needle = area < 1e-3 * dot(ab, ab) * dot(ac, ac);
    bool edgeOn = plane.w * plane.w < 1e-3 * area * dot(nearest, nearest);
    vec2 offset = vec2(0.0);
    for (int axis = needle || edgeOn ? 0 : 3; axis < 3; ++axis) {
        int i = (axis + 1) % 3;
        int j = (axis + 2) % 3;
        vec2 sum = vec2(0.0);
        mirrorballCapture_addProduct(a[i], b[j], sum);
        mirrorballCapture_addProduct(-a[j], b[i], sum);
        mirrorballCapture_addProduct(b[i], c[j], sum);
        mirrorballCapture_addProduct(-b[j], c[i], sum);
        mirrorballCapture_addProduct(c[i], a[j], sum);
        mirrorballCapture_addProduct(-c[j], a[i], sum);
        mirrorballCapture_addProduct(sum.x, a[axis], offset);
        mirrorballCapture_addProduct(sum.y, a[axis], offset);
        plane[axis] = sum.x + sum.y;
        plane.w = offset.x + offset.y;
    }
#endif
    return plane;
}
