#version 330 core

// Map sphere-map, printed from its C++ formula.
const int mirrorball_components = 1;

bool mirrorball_isNan(float x)
{
    return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u;
}

bool mirrorball_isInfinite(float x)
{
    return (floatBitsToUint(x) & 0x7fffffffu) == 0x7f800000u;
}

float mirrorball_signNotZero(float x)
{
    return x < 0.0 ? -1.0 : 1.0;
}

float mirrorball_flushed(float x)
{
    return abs(x) < 1.1754944e-38 ? 0.0 : x;
}

float mirrorball_infinitySign(float x)
{
    return mirrorball_isInfinite(x) ? mirrorball_signNotZero(x) : 0.0;
}

vec3 mirrorball_regularDirection(vec3 direction)
{
    bool nan = mirrorball_isNan(direction.x) || mirrorball_isNan(direction.y) || mirrorball_isNan(direction.z);
    bool infinite = mirrorball_isInfinite(direction.x) || mirrorball_isInfinite(direction.y) || mirrorball_isInfinite(direction.z);
    float x = infinite ? mirrorball_infinitySign(direction.x) : mirrorball_flushed(direction.x);
    float y = infinite ? mirrorball_infinitySign(direction.y) : mirrorball_flushed(direction.y);
    float z = infinite ? mirrorball_infinitySign(direction.z) : mirrorball_flushed(direction.z);
    float size = max(max(abs(x), abs(y)), abs(z));
    bool none = nan || size <= 0.0;
    float scale = size > 1.8446744e+19 ? 2.3283064e-10 : 1.0;
    float divisor = none ? 1.0 : size * scale;
    return vec3(none ? 0.0 : mirrorball_flushed(x * scale / divisor),
                none ? 0.0 : mirrorball_flushed(y * scale / divisor),
                none ? 1.0 : mirrorball_flushed(z * scale / divisor));
}

vec2 mirrorball_regularSquare(vec2 uv)
{
    return vec2(mirrorball_isNan(uv.x) ? 0.5 : min(max(uv.x, -0.25), 1.25),
                mirrorball_isNan(uv.y) ? 0.5 : min(max(uv.y, -0.25), 1.25));
}

int mirrorball_componentOf(vec3 direction)
{
    return 0;
}

vec2 mirrorball_squareFromDirection(int component, vec3 direction)
{
    vec3 d = mirrorball_regularDirection(direction);
    bool behind = d.z < 0.0;
    float radius = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    float ahead = max(d.z, 0.0);
    float factor = behind ? sqrt((radius - d.z) / (2.0 * radius)) : 1.0 / sqrt(2.0 * radius * (radius + ahead));
    float size = max(abs(d.x), abs(d.y));
    bool none = size <= 0.0;
    float safeSize = none ? 1.0 : size;
    float across = none ? 1.0 : d.x / safeSize;
    float up = d.y / safeSize;
    float range = sqrt(across * across + up * up);
    return vec2(0.5 * (factor * (behind ? across / range : d.x)) + 0.5,
                0.5 * (factor * (behind ? up / range : d.y)) + 0.5);
}

vec3 mirrorball_directionFromSquare(int component, vec2 uv)
{
    vec2 p = mirrorball_regularSquare(uv);
    float a = 2.0 * p.x - 1.0;
    float b = 2.0 * p.y - 1.0;
    float rr = min(a * a + b * b, 1.0);
    float scale = 2.0 * sqrt(1.0 - rr);
    return vec3(a * scale, b * scale, 1.0 - 2.0 * rr);
}

vec3 mirrorball_coordinateFromDirection(vec3 direction)
{
    int component = mirrorball_componentOf(direction);
    vec2 uv = mirrorball_squareFromDirection(component, direction);
    return vec3(clamp(uv, 0.0, 1.0), float(component));
}

vec4 mirrorball_squareDerivatives(int component, vec3 direction, vec3 alongU, vec3 alongV)
{
    bool behind = direction.z < 0.0;
    float t = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    float radius = sqrt(t);
    float t2 = 2.0 * radius;
    float t3 = (radius - direction.z) / t2;
    float t4 = sqrt(t3);
    bool t5 = t4 > 0.0;
    float t6 = t5 ? 0.5 / (t5 ? t4 : 1.0) : 0.0;
    float t7 = sqrt(t);
    bool t8 = t7 > 0.0;
    float t9 = t8 ? 0.5 / (t8 ? t7 : 1.0) : 0.0;
    float radiusU = t9 * (alongU.x * direction.x + direction.x * alongU.x + (alongU.y * direction.y + direction.y * alongU.y) + (alongU.z * direction.z + direction.z * alongU.z));
    float t10 = 2.0 * radius;
    bool t11 = direction.z < 0.0;
    float ahead = t11 ? 0.0 : direction.z;
    float t12 = radius + ahead;
    float t13 = sqrt(t10 * t12);
    float t14 = 1.0 / t13;
    bool t15 = t13 > 0.0;
    float t16 = t15 ? 0.5 / (t15 ? t13 : 1.0) : 0.0;
    float aheadU = t11 ? 0.0 : alongU.z;
    float factorU = behind ? t6 * ((radiusU - alongU.z - t3 * (2.0 * radiusU)) / t2) : -(t14 * (t16 * (2.0 * radiusU * t12 + t10 * (radiusU + aheadU)))) / t13;
    bool t17 = direction.x < 0.0;
    float t18 = t17 ? -direction.x : direction.x;
    bool t19 = direction.y < 0.0;
    float t20 = t19 ? -direction.y : direction.y;
    bool t21 = t18 < t20;
    float size = t21 ? t20 : t18;
    bool none = size <= 0.0;
    float safeSize = none ? 1.0 : size;
    float t22 = direction.x / safeSize;
    float across = none ? 1.0 : t22;
    float up = direction.y / safeSize;
    float t23 = across * across + up * up;
    float range = sqrt(t23);
    float t24 = across / range;
    float t25 = behind ? t24 : direction.x;
    float factor = behind ? t4 : t14;
    float sizeU = t21 ? (t19 ? -alongU.y : alongU.y) : t17 ? -alongU.x : alongU.x;
    float safeSizeU = none ? 0.0 : sizeU;
    float acrossU = none ? 0.0 : (alongU.x - t22 * safeSizeU) / safeSize;
    float t26 = sqrt(t23);
    bool t27 = t26 > 0.0;
    float t28 = t27 ? 0.5 / (t27 ? t26 : 1.0) : 0.0;
    float t29 = direction.y / safeSize;
    float upU = (alongU.y - t29 * safeSizeU) / safeSize;
    float rangeU = t28 * (acrossU * across + across * acrossU + (upU * up + up * upU));
    float t30 = up / range;
    float t31 = behind ? t30 : direction.y;
    float radiusV = t9 * (alongV.x * direction.x + direction.x * alongV.x + (alongV.y * direction.y + direction.y * alongV.y) + (alongV.z * direction.z + direction.z * alongV.z));
    float aheadV = t11 ? 0.0 : alongV.z;
    float factorV = behind ? t6 * ((radiusV - alongV.z - t3 * (2.0 * radiusV)) / t2) : -(t14 * (t16 * (2.0 * radiusV * t12 + t10 * (radiusV + aheadV)))) / t13;
    float sizeV = t21 ? (t19 ? -alongV.y : alongV.y) : t17 ? -alongV.x : alongV.x;
    float safeSizeV = none ? 0.0 : sizeV;
    float acrossV = none ? 0.0 : (alongV.x - t22 * safeSizeV) / safeSize;
    float upV = (alongV.y - t29 * safeSizeV) / safeSize;
    float rangeV = t28 * (acrossV * across + across * acrossV + (upV * up + up * upV));
    return vec4(0.5 * (factorU * t25 + factor * (behind ? (acrossU - t24 * rangeU) / range : alongU.x)),
                0.5 * (factorU * t31 + factor * (behind ? (upU - t30 * rangeU) / range : alongU.y)),
                0.5 * (factorV * t25 + factor * (behind ? (acrossV - t24 * rangeV) / range : alongV.x)),
                0.5 * (factorV * t31 + factor * (behind ? (upV - t30 * rangeV) / range : alongV.y)));
}

vec3 mirrorball_rayOfTexel(int component, vec2 place, vec2 size)
{
    float reach = 0.5 * size.x;
    vec2 p = place - reach;
    float pp = p.x * p.x + p.y * p.y;
    float inside = reach * reach - pp;
    bool beyond = inside <= 0.0;
    float root = sqrt(beyond ? 1.0 : inside);
    return vec3(beyond ? 0.0 : p.x,
                beyond ? 0.0 : p.y,
                beyond ? -1.0 : (inside - pp) / (2.0 * root));
}

float mirrorball_rayLength(vec3 ray)
{
    return length(ray);
}
