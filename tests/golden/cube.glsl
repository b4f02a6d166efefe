#version 330 core

// Map cube, printed from its C++ formula.
const int mirrorball_components = 6;

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
    return vec3(none ? 1.0 : mirrorball_flushed(x * scale / divisor),
                none ? 0.0 : mirrorball_flushed(y * scale / divisor),
                none ? 0.0 : mirrorball_flushed(z * scale / divisor));
}

vec2 mirrorball_regularSquare(vec2 uv)
{
    return vec2(mirrorball_isNan(uv.x) ? 0.5 : min(max(uv.x, -0.25), 1.25),
                mirrorball_isNan(uv.y) ? 0.5 : min(max(uv.y, -0.25), 1.25));
}

int mirrorball_componentOf(vec3 direction)
{
    vec3 d = mirrorball_regularDirection(direction);
    float xSize = abs(d.x);
    float ySize = abs(d.y);
    float zSize = abs(d.z);
    bool xLargest = xSize >= ySize && xSize >= zSize;
    return xLargest ? (d.x >= 0.0 ? 0 : 1) : ySize >= zSize ? (d.y >= 0.0 ? 2 : 3) : d.z >= 0.0 ? 4 : 5;
}

vec2 mirrorball_squareFromDirection(int component, vec3 direction)
{
    vec3 d = mirrorball_regularDirection(direction);
    bool alongX = component == 0 || component == 1;
    float side = component == 1 || component == 3 || component == 5 ? -1.0 : 1.0;
    bool alongY = component == 2 || component == 3;
    float divisor = max(side * (alongX ? d.x : alongY ? d.y : d.z), 0.015625);
    return vec2(0.5 * ((alongX ? -side * d.z : alongY ? d.x : side * d.x) / divisor) + 0.5,
                0.5 * ((alongX ? -d.y : alongY ? side * d.z : -d.y) / divisor) + 0.5);
}

vec3 mirrorball_directionFromSquare(int component, vec2 uv)
{
    vec2 p = mirrorball_regularSquare(uv);
    bool alongX = component == 0 || component == 1;
    float side = component == 1 || component == 3 || component == 5 ? -1.0 : 1.0;
    float s = 2.0 * p.x - 1.0;
    float t = 2.0 * p.y - 1.0;
    float range = sqrt(s * s + t * t + 1.0);
    float ahead = 1.0 / range;
    bool alongY = component == 2 || component == 3;
    float right = s / range;
    float down = t / range;
    return vec3(alongX ? side * ahead : alongY ? right : side * right,
                alongX ? -down : alongY ? side * ahead : -down,
                alongX ? -side * right : alongY ? side * down : side * ahead);
}

vec3 mirrorball_coordinateFromDirection(vec3 direction)
{
    int component = mirrorball_componentOf(direction);
    vec2 uv = mirrorball_squareFromDirection(component, direction);
    return vec3(clamp(uv, 0.0, 1.0), float(component));
}

vec4 mirrorball_squareDerivatives(int component, vec3 direction, vec3 alongU, vec3 alongV)
{
    bool alongX = component == 0 || component == 1;
    float side = component == 1 || component == 3 || component == 5 ? -1.0 : 1.0;
    float t = -side;
    bool alongY = component == 2 || component == 3;
    float t2 = side * (alongX ? direction.x : alongY ? direction.y : direction.z);
    bool t3 = t2 < 0.015625;
    float divisor = t3 ? 0.015625 : t2;
    float t4 = (alongX ? t * direction.z : alongY ? direction.x : side * direction.x) / divisor;
    float divisorU = t3 ? 0.0 : side * (alongX ? alongU.x : alongY ? alongU.y : alongU.z);
    float t5 = (alongX ? -direction.y : alongY ? side * direction.z : -direction.y) / divisor;
    float divisorV = t3 ? 0.0 : side * (alongX ? alongV.x : alongY ? alongV.y : alongV.z);
    return vec4(0.5 * (((alongX ? t * alongU.z : alongY ? alongU.x : side * alongU.x) - t4 * divisorU) / divisor),
                0.5 * (((alongX ? -alongU.y : alongY ? side * alongU.z : -alongU.y) - t5 * divisorU) / divisor),
                0.5 * (((alongX ? t * alongV.z : alongY ? alongV.x : side * alongV.x) - t4 * divisorV) / divisor),
                0.5 * (((alongX ? -alongV.y : alongY ? side * alongV.z : -alongV.y) - t5 * divisorV) / divisor));
}

vec3 mirrorball_rayOfTexel(int component, vec2 place, vec2 size)
{
    float reach = 0.5 * size.x;
    vec2 p = place - reach;
    bool alongX = component == 0 || component == 1;
    float side = component == 1 || component == 3 || component == 5 ? -1.0 : 1.0;
    bool alongY = component == 2 || component == 3;
    return vec3(alongX ? side * reach : alongY ? p.x : side * p.x,
                alongX ? -p.y : alongY ? side * reach : -p.y,
                alongX ? -side * p.x : alongY ? side * p.y : side * reach);
}

float mirrorball_rayLength(vec3 ray)
{
    return length(ray);
}
