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
