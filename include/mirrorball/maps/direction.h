// What every map's input goes through first, so that the maps are total and give the same answer in C++ and
// GLSL.
//
// A regular direction has its largest coordinate at ±1. It comes from any three numbers:
// - NaN in any coordinate, or nothing but zeros and subnormals: `front`, the centre of the map's component 0.
// - Infinite coordinates count as ±1 and finite ones beside them as 0.
// - Else the direction divided by its largest coordinate. Coordinates that are subnormal, before or after,
//   count as zero (float: below 2^-126, double: below 2^-1022): a GPU may flush them.
#pragma once

#include <mirrorball/math/elementary.h>
#include <mirrorball/math/vector.h>

namespace mirrorball {

template <class Real>
Vec3<Real> regularDirection(const Vec3<Real>& d, const Vec3<double>& front)
{
    const auto infinite =
        named(either(either(isInfinite(d.x), isInfinite(d.y)), isInfinite(d.z)), "infinite");
    const Real x = named(select(infinite, infinitySign(d.x), flushed(d.x)), "x");
    const Real y = named(select(infinite, infinitySign(d.y), flushed(d.y)), "y");
    const Real z = named(select(infinite, infinitySign(d.z), flushed(d.z)), "z");

    const Real size = named(max(max(abs(x), abs(y)), abs(z)), "size");
    const auto nan = named(either(either(isNan(d.x), isNan(d.y)), isNan(d.z)), "nan");
    const auto none = named(either(nan, size <= Real(0)), "none");
    const Real large = Real(ScalarTraits<Real>::large);
    const Real scale = named(select(size > large, Real(ScalarTraits<Real>::scaleOfLarge), Real(1)), "scale");
    const Real divisor = named(select(none, Real(1), size * scale), "divisor");
    return {select(none, Real(front.x), flushed(x * scale / divisor)),
            select(none, Real(front.y), flushed(y * scale / divisor)),
            select(none, Real(front.z), flushed(z * scale / divisor))};
}

// A chart continues by a quarter of the square beyond each side: enough for guard texels, and short of what
// no formula could continue. A coordinate beyond that is taken there; NaN is the middle.
template <class Real>
Real regularCoordinate(const Real& u)
{
    return select(isNan(u), Real(0.5), min(max(u, Real(-0.25)), Real(1.25)));
}

template <class Real>
Vec2<Real> regularSquare(const Vec2<Real>& uv)
{
    return {regularCoordinate(uv.x), regularCoordinate(uv.y)};
}

// [-1, 1] to [0, 1], and back.
template <class Real>
Real unitFromSigned(const Real& a)
{
    return Real(0.5) * a + Real(0.5);
}
template <class Real>
Real signedFromUnit(const Real& u)
{
    return Real(2) * u - Real(1);
}

// Lengths, of regular directions and parts of them. What underflows is below 2^-60 of a regular direction.
template <class Real>
Real length(const Real& x, const Real& y)
{
    return sqrt(x * x + y * y);
}
template <class Real>
Real length(const Vec3<Real>& d)
{
    return sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

} // namespace mirrorball
