#version 330 core

// Map tennis-ball, printed from its C++ formula.
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
                none ? 1.0 : mirrorball_flushed(z * scale / divisor));
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
    float yy = d.y * d.y;
    float xx = d.x * d.x;
    float zz = d.z * d.z;
    return (d.z >= 0.0 && yy <= xx + zz) || (d.z <= 0.0 && xx >= yy + zz) ? 0 : 1;
}

vec2 mirrorball_squareFromDirection(int component, vec3 direction)
{
    vec3 d = mirrorball_regularDirection(direction);
    bool first = component == 0;
    float y = first ? d.y : d.x;
    float x = first ? d.x : d.y;
    float z = first ? d.z : -d.z;
    float latitude = mirrorball_atan2Pi(y, sqrt(x * x + z * z));
    float longitude = mirrorball_atan2Pi(x, z);
    return vec2(2.0 * latitude + 0.5, 0.6666667 * longitude + 0.5);
}

vec3 mirrorball_directionFromSquare(int component, vec2 uv)
{
    vec2 p = mirrorball_regularSquare(uv);
    bool first = component == 0;
    float latitude = 0.5 * (p.x - 0.5);
    float radius = mirrorball_cosPi(latitude);
    float longitude = 1.5 * (p.y - 0.5);
    float right = radius * mirrorball_sinPi(longitude);
    float up = mirrorball_sinPi(latitude);
    float x = first ? right : up;
    float y = first ? up : right;
    float ahead = radius * mirrorball_cosPi(longitude);
    float z = first ? ahead : -ahead;
    return vec3(x, y, z);
}

vec3 mirrorball_coordinateFromDirection(vec3 direction)
{
    int component = mirrorball_componentOf(direction);
    vec2 uv = mirrorball_squareFromDirection(component, direction);
    return vec3(clamp(uv, 0.0, 1.0), float(component));
}

vec4 mirrorball_squareDerivatives(int component, vec3 direction, vec3 alongU, vec3 alongV)
{
    bool first = component == 0;
    float x = first ? direction.x : direction.y;
    float z = first ? direction.z : -direction.z;
    float t = sqrt(x * x + z * z);
    float yU = first ? alongU.y : alongU.x;
    float y = first ? direction.y : direction.x;
    bool t2 = t > 0.0;
    float t3 = t2 ? 0.5 / (t2 ? t : 1.0) : 0.0;
    float xU = first ? alongU.x : alongU.y;
    float zU = first ? alongU.z : -alongU.z;
    float t4 = t * t + y * y;
    float t5 = 0.31830987 / (t4 > 0.0 ? t4 : 1.0);
    float latitudeU = (t * yU - y * (t3 * (xU * x + x * xU + (zU * z + z * zU)))) * t5;
    float t6 = z * z + x * x;
    float t7 = 0.31830987 / (t6 > 0.0 ? t6 : 1.0);
    float longitudeU = (z * xU - x * zU) * t7;
    float yV = first ? alongV.y : alongV.x;
    float xV = first ? alongV.x : alongV.y;
    float zV = first ? alongV.z : -alongV.z;
    float latitudeV = (t * yV - y * (t3 * (xV * x + x * xV + (zV * z + z * zV)))) * t5;
    float longitudeV = (z * xV - x * zV) * t7;
    return vec4(2.0 * latitudeU, 0.6666667 * longitudeU, 2.0 * latitudeV, 0.6666667 * longitudeV);
}

vec3 mirrorball_rayOfTexel(int component, vec2 place, vec2 size)
{
    return mirrorball_directionFromSquare(component, place / size);
}

float mirrorball_rayLength(vec3 ray)
{
    return 1.0;
}
