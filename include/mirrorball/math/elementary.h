// Angles in units of pi, as IEEE 754-2019 names them: atan2Pi(y, x) = atan2(y, x) / pi, sinPi(x) = sin(pi x).
// A map needs no rounded pi, and quarter turns are exact.
//
// Two kernels are words of the vocabulary; everything else is written once on top of them. float and GLSL run
// the same polynomials, because GLSL leaves the precision of its own atan, asin, sin and cos open; double
// uses the standard library. tests/math/elementary_test.cpp holds every bound given here.
#pragma once

#include <mirrorball/math/scalar.h>

#include <numbers>

namespace mirrorball {

// atan(t) / pi for 0 <= t <= 1: odd minimax polynomial of degree 15, each coefficient rounded to float and
// the rest fitted again. Error of the polynomial 1.3e-8, evaluated in float at most atanPiError in all.
template <class Real>
Real atanPiPolynomial(const Real& t)
{
    const Real s = named(t * t, "s");
    const Real p0 = Real(0.00694543496) + s * Real(-0.00128712936);
    const Real p1 = Real(0.0306737293) + s * (Real(-0.0177753922) + s * p0);
    const Real p2 = named(Real(0.0634898245) + s * (Real(-0.0442641452) + s * p1), "p");
    return t * (Real(0.318309665) + s * (Real(-0.106091999) + s * p2));
}

// sin(pi x) for |x| <= 1/2: odd minimax polynomial of degree 9, rounded likewise. Error of the polynomial
// 9.2e-9, evaluated in float at most sinPiError in all.
template <class Real>
Real sinPiPolynomial(const Real& x)
{
    const Real s = named(x * x, "s");
    const Real p = named(Real(2.54995775) + s * (Real(-0.597625196) + s * Real(0.0764328912)), "p");
    return x * (Real(3.1415925) + s * (Real(-5.1677022) + s * p));
}

inline constexpr double atanPiError = 0x1p-24;
inline constexpr double sinPiError = 0x1p-22;

inline float atanPi(float t)
{
    return atanPiPolynomial(t);
}
inline float sinPiAcute(float x)
{
    return sinPiPolynomial(x);
}
inline double atanPi(double t)
{
    return std::atan(t) * std::numbers::inv_pi;
}
inline double sinPiAcute(double x)
{
    return std::sin(x * std::numbers::pi);
}

// atan2(y, x) / pi in [-1, 1]; 0 for (0, 0). A zero has no sign: (±0, x < 0) gives +1.
template <class Real>
Real atan2Pi(const Real& y, const Real& x)
{
    const Real adjacent = named(abs(x), "adjacent");
    const Real opposite = named(abs(y), "opposite");
    const Real larger = named(max(adjacent, opposite), "larger");
    const Real ratio = min(adjacent, opposite) / select(larger > Real(0), larger, Real(1));
    const Real octant = named(atanPi(ratio), "octant");
    const Real quadrant = named(select(opposite > adjacent, Real(0.5) - octant, octant), "quadrant");
    return select(x < Real(0), Real(1) - quadrant, quadrant) * signNotZero(y);
}

// sin(pi x) for |x| <= 3/2.
template <class Real>
Real sinPi(const Real& x)
{
    const Real size = named(abs(x), "size");
    return sinPiAcute(select(size > Real(0.5), Real(1) - size, size)) * signNotZero(x);
}

// cos(pi x) for |x| <= 2.
template <class Real>
Real cosPi(const Real& x)
{
    return sinPi(Real(0.5) - abs(x));
}

} // namespace mirrorball
