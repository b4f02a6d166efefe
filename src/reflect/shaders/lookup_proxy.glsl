// The surroundings are taken for the inside of a box or an ellipsoid, which is the cube [-1, 1]³ or the unit sphere of
// proxy space.
uniform mat4 mirrorball_proxyFromWorld; // affine; 0 in place of one that has no inverse

// How many directions it takes from a point to leave the proxy; not above 0 if it does not.
float mirrorball_leaves(vec3 point, vec3 direction)
{
#if MIRRORBALL_BOX
    vec3 far = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0, direction.z < 0.0 ? -1.0 : 1.0);
    // Along an axis that the direction does not follow, 1e30 stands for never.
    vec3 size = max(abs(direction), vec3(1e-30));
    vec3 leaves = (1.0 - far * point) / size;
    vec3 enters = -(1.0 + far * point) / size;
    float first = min(min(leaves.x, leaves.y), leaves.z);
    return max(max(enters.x, enters.y), enters.z) <= first ? first : 0.0;
#else
    float a = dot(direction, direction);
    float b = dot(point, direction);
    float c = dot(point, point) - 1.0;
    float discriminant = b * b - a * c;
    if (!(discriminant >= 0.0) || !(a > 0.0))
        return 0.0;
    // The larger root of a t² + 2 b t + c, by the formula in which nothing cancels.
    float root = sqrt(discriminant);
    return b <= 0.0 ? (root - b) / a : -c / (b + root);
#endif
}

// Where the ray leaves the proxy as seen from the map's centre; where it never does, as if infinitely far.
vec4 mirrorball_shown(vec3 positionInWorld, vec3 directionInWorld)
{
    vec3 point = (mirrorball_proxyFromWorld * vec4(positionInWorld, 1.0)).xyz;
    float leaves = mirrorball_leaves(point, mat3(mirrorball_proxyFromWorld) * directionInWorld);
    bool found = leaves > 0.0 && leaves < 1e30;
    vec3 shown = found ? positionInWorld - mirrorball_centreInWorld + leaves * directionInWorld : directionInWorld;
    return vec4(mirrorball_mapFromWorld * shown, 0.0);
}

vec2 mirrorball_withinSurface(vec3 coordinate)
{
    return coordinate.xy;
}
