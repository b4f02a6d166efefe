#version 330 core

// Map equi-angular-cube, printed from its C++ formula.
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

float mirrorball_atanPi(float t)
{
    float s = t * t;
    float p = 0.063489825 + s * (-0.044264145 + s * (0.03067373 + s * (-0.017775392 + s * (0.006945435 + s * -0.0012871294))));
    return t * (0.31830966 + s * (-0.106092 + s * p));
}

float mirrorball_atan2Pi(float y, float x)
{
    float opposite = abs(y);
    float adjacent = abs(x);
    float larger = max(adjacent, opposite);
    float octant = mirrorball_atanPi(min(adjacent, opposite) / (larger > 0.0 ? larger : 1.0));
    float quadrant = opposite > adjacent ? 0.5 - octant : octant;
    return (x < 0.0 ? 1.0 - quadrant : quadrant) * mirrorball_signNotZero(y);
}

float mirrorball_sinPiAcute(float x)
{
    float s = x * x;
    float p = 2.5499578 + s * (-0.5976252 + s * 0.07643289);
    return x * (3.1415925 + s * (-5.167702 + s * p));
}

float mirrorball_sinPi(float x)
{
    float size = abs(x);
    return mirrorball_sinPiAcute(size > 0.5 ? 1.0 - size : size) * mirrorball_signNotZero(x);
}

float mirrorball_cosPi(float x)
{
    return mirrorball_sinPi(0.5 - abs(x));
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
    return vec2(2.0 * mirrorball_atan2Pi(alongX ? -side * d.z : alongY ? d.x : side * d.x, divisor) + 0.5,
                2.0 * mirrorball_atan2Pi(alongX ? -d.y : alongY ? side * d.z : -d.y, divisor) + 0.5);
}

vec3 mirrorball_directionFromSquare(int component, vec2 uv)
{
    vec2 p = mirrorball_regularSquare(uv);
    bool alongX = component == 0 || component == 1;
    float side = component == 1 || component == 3 || component == 5 ? -1.0 : 1.0;
    float across = 0.5 * (p.x - 0.5);
    float cosAcross = mirrorball_cosPi(across);
    float down = 0.5 * (p.y - 0.5);
    float cosDown = mirrorball_cosPi(down);
    float m = cosAcross * cosDown;
    float s = mirrorball_sinPi(across) * cosDown;
    float t = mirrorball_sinPi(down) * cosAcross;
    float range = sqrt(s * s + t * t + m * m);
    float ahead = m / range;
    bool alongY = component == 2 || component == 3;
    float right = s / range;
    float below = t / range;
    return vec3(alongX ? side * ahead : alongY ? right : side * right,
                alongX ? -below : alongY ? side * ahead : -below,
                alongX ? -side * right : alongY ? side * below : side * ahead);
}

vec3 mirrorball_coordinateFromDirection(vec3 direction)
{
    int component = mirrorball_componentOf(direction);
    vec2 uv = mirrorball_squareFromDirection(component, direction);
    return vec3(clamp(uv, 0.0, 1.0), float(component));
}

vec4 mirrorball_squareDerivatives(int component, vec3 direction, vec3 alongU, vec3 alongV)
{
    float side = component == 1 || component == 3 || component == 5 ? -1.0 : 1.0;
    bool alongX = component == 0 || component == 1;
    bool alongY = component == 2 || component == 3;
    float t = side * (alongX ? direction.x : alongY ? direction.y : direction.z);
    bool t2 = t < 0.015625;
    float divisor = t2 ? 0.015625 : t;
    float t3 = -side;
    float t4 = alongX ? t3 * direction.z : alongY ? direction.x : side * direction.x;
    float divisorU = t2 ? 0.0 : side * (alongX ? alongU.x : alongY ? alongU.y : alongU.z);
    float t5 = divisor * divisor + t4 * t4;
    float t6 = 0.31830987 / (t5 > 0.0 ? t5 : 1.0);
    float t7 = alongX ? -direction.y : alongY ? side * direction.z : -direction.y;
    float t8 = divisor * divisor + t7 * t7;
    float t9 = 0.31830987 / (t8 > 0.0 ? t8 : 1.0);
    float divisorV = t2 ? 0.0 : side * (alongX ? alongV.x : alongY ? alongV.y : alongV.z);
    return vec4(2.0 * ((divisor * (alongX ? t3 * alongU.z : alongY ? alongU.x : side * alongU.x) - t4 * divisorU) * t6),
                2.0 * ((divisor * (alongX ? -alongU.y : alongY ? side * alongU.z : -alongU.y) - t7 * divisorU) * t9),
                2.0 * ((divisor * (alongX ? t3 * alongV.z : alongY ? alongV.x : side * alongV.x) - t4 * divisorV) * t6),
                2.0 * ((divisor * (alongX ? -alongV.y : alongY ? side * alongV.z : -alongV.y) - t7 * divisorV) * t9));
}

vec3 mirrorball_rayOfTexel(int component, vec2 place, vec2 size)
{
    return mirrorball_directionFromSquare(component, place / size);
}

float mirrorball_rayLength(vec3 ray)
{
    return 1.0;
}
