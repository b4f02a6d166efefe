#version 330 core

// Map octahedral, printed from its C++ formula.
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
    bool below = d.z < 0.0;
    float sum = abs(d.x) + abs(d.y) + abs(d.z);
    float b = d.y / sum;
    float a = d.x / sum;
    return vec2(0.5 * (below ? (1.0 - abs(b)) * mirrorball_signNotZero(d.x) : a) + 0.5,
                0.5 * (below ? (1.0 - abs(a)) * mirrorball_signNotZero(d.y) : b) + 0.5);
}

vec3 mirrorball_directionFromSquare(int component, vec2 uv)
{
    vec2 p = mirrorball_regularSquare(uv);
    float b0 = 2.0 * p.y - 1.0;
    bool pastB = abs(b0) > 1.0;
    float a0 = 2.0 * p.x - 1.0;
    bool pastA = abs(a0) > 1.0;
    float a1 = pastA ? 2.0 * mirrorball_signNotZero(a0) - a0 : a0;
    float a = pastB ? -a1 : a1;
    float b1 = pastB ? 2.0 * mirrorball_signNotZero(b0) - b0 : b0;
    float b = pastA ? -b1 : b1;
    float z = 1.0 - abs(a) - abs(b);
    bool below = z < 0.0;
    float x = below ? (1.0 - abs(b)) * mirrorball_signNotZero(a) : a;
    float y = below ? (1.0 - abs(a)) * mirrorball_signNotZero(b) : b;
    float size = sqrt(x * x + y * y + z * z);
    return vec3(x / size, y / size, z / size);
}

vec3 mirrorball_coordinateFromDirection(vec3 direction)
{
    int component = mirrorball_componentOf(direction);
    vec2 uv = mirrorball_squareFromDirection(component, direction);
    return vec3(clamp(uv, 0.0, 1.0), float(component));
}

vec4 mirrorball_squareDerivatives(int component, vec3 direction, vec3 alongU, vec3 alongV)
{
    bool below = direction.z < 0.0;
    bool t = direction.x < 0.0;
    bool t2 = direction.y < 0.0;
    bool t3 = direction.z < 0.0;
    float sum = (t ? -direction.x : direction.x) + (t2 ? -direction.y : direction.y) + (t3 ? -direction.z : direction.z);
    float b = direction.y / sum;
    bool t4 = b < 0.0;
    float t5 = direction.y / sum;
    float sumU = (t ? -alongU.x : alongU.x) + (t2 ? -alongU.y : alongU.y) + (t3 ? -alongU.z : alongU.z);
    float bU = (alongU.y - t5 * sumU) / sum;
    float t6 = direction.x < 0.0 ? -1.0 : 1.0;
    float t7 = direction.x / sum;
    float aU = (alongU.x - t7 * sumU) / sum;
    float a = direction.x / sum;
    bool t8 = a < 0.0;
    float t9 = direction.y < 0.0 ? -1.0 : 1.0;
    float sumV = (t ? -alongV.x : alongV.x) + (t2 ? -alongV.y : alongV.y) + (t3 ? -alongV.z : alongV.z);
    float bV = (alongV.y - t5 * sumV) / sum;
    float aV = (alongV.x - t7 * sumV) / sum;
    return vec4(0.5 * (below ? -(t4 ? -bU : bU) * t6 : aU),
                0.5 * (below ? -(t8 ? -aU : aU) * t9 : bU),
                0.5 * (below ? -(t4 ? -bV : bV) * t6 : aV),
                0.5 * (below ? -(t8 ? -aV : aV) * t9 : bV));
}

vec3 mirrorball_rayOfTexel(int component, vec2 place, vec2 size)
{
    float reach = 0.5 * size.x;
    vec2 p = place - reach;
    float z = reach - abs(p.x) - abs(p.y);
    bool below = z < 0.0;
    return vec3(below ? (reach - abs(p.y)) * mirrorball_signNotZero(p.x) : p.x,
                below ? (reach - abs(p.x)) * mirrorball_signNotZero(p.y) : p.y,
                z);
}

float mirrorball_rayLength(vec3 ray)
{
    return length(ray);
}
