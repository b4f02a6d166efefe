#version 330 core

// Map dual-paraboloid, printed from its C++ formula.
const int mirrorball_components = 2;

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
                none ? -1.0 : mirrorball_flushed(z * scale / divisor));
}

vec2 mirrorball_regularSquare(vec2 uv)
{
    return vec2(mirrorball_isNan(uv.x) ? 0.5 : min(max(uv.x, -0.25), 1.25),
                mirrorball_isNan(uv.y) ? 0.5 : min(max(uv.y, -0.25), 1.25));
}

int mirrorball_componentOf(vec3 direction)
{
    vec3 d = mirrorball_regularDirection(direction);
    return d.z < 0.0 ? 0 : 1;
}

vec2 mirrorball_squareFromDirection(int component, vec3 direction)
{
    vec3 d = mirrorball_regularDirection(direction);
    float radius = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    float divisor = max(radius + (component == 0 ? -d.z : d.z), 0.0009765625 * radius);
    return vec2(0.5 * (d.x / divisor) + 0.5, 0.5 * (d.y / divisor) + 0.5);
}

vec3 mirrorball_directionFromSquare(int component, vec2 uv)
{
    vec2 p = mirrorball_regularSquare(uv);
    float a = 2.0 * p.x - 1.0;
    float b = 2.0 * p.y - 1.0;
    float rr = a * a + b * b;
    float divisor = 1.0 + rr;
    float ahead = (1.0 - rr) / divisor;
    return vec3(2.0 * a / divisor, 2.0 * b / divisor, component == 0 ? -ahead : ahead);
}

vec3 mirrorball_coordinateFromDirection(vec3 direction)
{
    int component = mirrorball_componentOf(direction);
    vec2 uv = mirrorball_squareFromDirection(component, direction);
    return vec3(clamp(uv, 0.0, 1.0), float(component));
}

vec4 mirrorball_squareDerivatives(int component, vec3 direction, vec3 alongU, vec3 alongV)
{
    float t = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    float radius = sqrt(t);
    bool t2 = component == 0;
    float t3 = radius + (t2 ? -direction.z : direction.z);
    float t4 = 0.0009765625 * radius;
    bool t5 = t3 < t4;
    float divisor = t5 ? t4 : t3;
    float t6 = direction.x / divisor;
    float t7 = sqrt(t);
    bool t8 = t7 > 0.0;
    float t9 = t8 ? 0.5 / (t8 ? t7 : 1.0) : 0.0;
    float radiusU = t9 * (alongU.x * direction.x + direction.x * alongU.x + (alongU.y * direction.y + direction.y * alongU.y) + (alongU.z * direction.z + direction.z * alongU.z));
    float divisorU = t5 ? 0.0009765625 * radiusU : radiusU + (t2 ? -alongU.z : alongU.z);
    float t10 = direction.y / divisor;
    float radiusV = t9 * (alongV.x * direction.x + direction.x * alongV.x + (alongV.y * direction.y + direction.y * alongV.y) + (alongV.z * direction.z + direction.z * alongV.z));
    float divisorV = t5 ? 0.0009765625 * radiusV : radiusV + (t2 ? -alongV.z : alongV.z);
    return vec4(0.5 * ((alongU.x - t6 * divisorU) / divisor),
                0.5 * ((alongU.y - t10 * divisorU) / divisor),
                0.5 * ((alongV.x - t6 * divisorV) / divisor),
                0.5 * ((alongV.y - t10 * divisorV) / divisor));
}

vec3 mirrorball_rayOfTexel(int component, vec2 place, vec2 size)
{
    float reach = 0.5 * size.x;
    vec2 p = place - reach;
    float twice = 2.0 * reach;
    float ahead = reach * reach - (p.x * p.x + p.y * p.y);
    return vec3(twice * p.x, twice * p.y, component == 0 ? -ahead : ahead);
}

float mirrorball_rayLength(vec3 ray)
{
    return length(ray);
}
