#include "maps/reference.h"

#include <algorithm>

namespace tests {
namespace {

using mirrorball::MapKind;

struct Unit
{
    Exact x, y, z;
};

Unit normalised(const std::array<Exact, 3>& d)
{
    const Exact length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    return {d[0] / length, d[1] / length, d[2] / length};
}

std::array<Exact, 2> fromSigned(const Exact& a, const Exact& b)
{
    return {a / 2 + 0.5, b / 2 + 0.5};
}

// MPFR's atan2 knows signed zeros; the maps do not: (±0, x < 0) is +pi.
Exact angle(const Exact& y, const Exact& x)
{
    const Exact zero(0);
    return y <= zero && y >= zero ? (x < zero ? Exact::pi() : zero) : atan2(y, x);
}

std::array<Exact, 2> tennisBall(int component, const Unit& d, bool even)
{
    const Exact pi = Exact::pi();
    const Exact latitudeSine = component == 0 ? d.y : d.x;
    const Exact longitude = component == 0 ? angle(d.x, d.z) : angle(d.y, -d.z);
    const Exact t = sqrt(Exact(2)) * latitudeSine;
    // The library's q is the double nearest to 0.042.
    const Exact q = 0.042;
    const Exact a = even ? t * (Exact(1) - q + q * t * t) : asin(latitudeSine) / (pi / 4);
    return fromSigned(a, longitude / (pi * 3 / 4));
}

// The table of the OpenGL specification: sc, tc, ma.
std::array<Exact, 3> cubeFace(int component, const Unit& d)
{
    switch (component) {
    case 0:
        return {-d.z, -d.y, d.x};
    case 1:
        return {d.z, -d.y, d.x};
    case 2:
        return {d.x, d.z, d.y};
    case 3:
        return {d.x, -d.z, d.y};
    case 4:
        return {d.x, -d.y, d.z};
    default:
        return {-d.x, -d.y, d.z};
    }
}

std::array<Exact, 2> cube(int component, const Unit& d)
{
    const auto [sc, tc, ma] = cubeFace(component, d);
    return {(sc / abs(ma) + 1) / 2, (tc / abs(ma) + 1) / 2};
}

std::array<Exact, 2> equiAngularCube(int component, const Unit& d)
{
    const auto [sc, tc, ma] = cubeFace(component, d);
    const Exact scale = Exact(4) / Exact::pi();
    return fromSigned(scale * atan(sc / abs(ma)), scale * atan(tc / abs(ma)));
}

std::array<Exact, 2> octahedral(const Unit& d)
{
    const Exact sum = abs(d.x) + abs(d.y) + abs(d.z);
    const Exact a = d.x / sum;
    const Exact b = d.y / sum;
    if (d.z >= 0)
        return fromSigned(a, b);
    const Exact foldedA = Exact(1) - abs(b);
    const Exact foldedB = Exact(1) - abs(a);
    return fromSigned(d.x < 0 ? -foldedA : foldedA, d.y < 0 ? -foldedB : foldedB);
}

std::array<Exact, 2> sphereMap(const Unit& d)
{
    const Exact m = Exact(2) * sqrt(d.x * d.x + d.y * d.y + (d.z + 1) * (d.z + 1));
    if (m <= 0) // the rim, where the formula has no value
        return {1, 0.5};
    return {d.x / m + 0.5, d.y / m + 0.5};
}

int largestCoordinate(const Unit& d)
{
    if (abs(d.x) >= abs(d.y) && abs(d.x) >= abs(d.z))
        return d.x >= 0 ? 0 : 1;
    if (abs(d.y) >= abs(d.z))
        return d.y >= 0 ? 2 : 3;
    return d.z >= 0 ? 4 : 5;
}

} // namespace

int exactComponent(MapKind map, const std::array<Exact, 3>& direction)
{
    const Unit d = normalised(direction);
    const Exact half = sqrt(Exact(2)) / 2;
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
        return (d.z >= 0 && abs(d.y) <= half) || (d.z <= 0 && abs(d.x) >= half) ? 0 : 1;
    case MapKind::dualParaboloid:
        return d.z < 0 ? 0 : 1;
    case MapKind::cube:
    case MapKind::equiAngularCube:
        return largestCoordinate(d);
    default:
        return 0;
    }
}

double distanceFromBorder(MapKind map, const std::array<Exact, 3>& direction)
{
    const Unit d = normalised(direction);
    const Exact half = sqrt(Exact(2)) / 2;
    const double x = abs(d.x).rounded(), y = abs(d.y).rounded(), z = abs(d.z).rounded();
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
        return std::min({z, abs(abs(d.y) - half).rounded(), abs(abs(d.x) - half).rounded()});
    case MapKind::dualParaboloid:
        return z;
    case MapKind::cube:
    case MapKind::equiAngularCube: {
        std::array<double, 3> sizes{x, y, z};
        std::sort(sizes.begin(), sizes.end());
        return sizes[2] - sizes[1];
    }
    default:
        return 1; // one component, no border
    }
}

std::array<Exact, 2> exactSquare(MapKind map, int component, const std::array<Exact, 3>& direction)
{
    const Unit d = normalised(direction);
    const Exact pi = Exact::pi();
    switch (map) {
    case MapKind::tennisBall:
        return tennisBall(component, d, false);
    case MapKind::tennisBallEven:
        return tennisBall(component, d, true);
    case MapKind::dualParaboloid: {
        const Exact divisor = component == 0 ? Exact(1) - d.z : Exact(1) + d.z;
        return fromSigned(d.x / divisor, d.y / divisor);
    }
    case MapKind::cube:
        return cube(component, d);
    case MapKind::equiAngularCube:
        return equiAngularCube(component, d);
    case MapKind::octahedral:
        return octahedral(d);
    case MapKind::equirectangular:
        return {angle(d.x, -d.z) / (pi * 2) + 0.5, Exact(0.5) - asin(d.y) / pi};
    default:
        return sphereMap(d);
    }
}

} // namespace tests
