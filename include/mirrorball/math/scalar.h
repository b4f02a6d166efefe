// The closed vocabulary in which every map is written, and its words for float and double.
//
// A map's body is a template over a scalar `Real` and uses nothing but these words, so the same body runs as
// float and double (here), as a dual number (dual.h), as an interval (interval.h), and is printed as GLSL
// (glsl_scalar.h):
//     Real(0.5)                        the only way to write a number
//     a + b  a - b  a * b  a / b  -a
//     abs  min  max  sqrt              sqrt of a number >= 0
//     signNotZero                      -1 below zero, else +1: for -0 too
//     a < b  a <= b  a > b  a >= b     a condition
//     isNan  isInfinite                a condition, decided on bits: no compiler flag changes it
//     both  either                     of conditions
//     select(condition, yes, no)       both are evaluated: each must be finite. At a seam a derivative is
//                                      that of the value taken
//     component == k                   a condition on an Index<Real>
//     named(value, "latitude")         the value; a name for it in printed GLSL
//     atanPi  sinPiAcute               elementary.h; from them atan2Pi, sinPi, cosPi
//     flushed  infinitySign            below, from the other words
// A condition or an index need not be a bool or an int (an undecided one, a recorded one): `if` and `?:` do
// not compile on them, which tests/must_not_compile holds.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace mirrorball {

// What differs between kinds of scalar. The range is that of the numbers that the kind stands for: float's
// here.
template <class Real>
struct ScalarTraits
{
    using Index = int;
    // Smaller ones count as zero, as on GPUs that flush them.
    static constexpr double smallestNormal = 0x1p-126;
    // Above it, numbers are scaled down before dividing by them: a GPU may multiply by a subnormal reciprocal.
    static constexpr double large = 0x1p64;
    static constexpr double scaleOfLarge = 0x1p-32;
};

template <>
struct ScalarTraits<double>
{
    using Index = int;
    static constexpr double smallestNormal = 0x1p-1022;
    static constexpr double large = 0x1p512;
    static constexpr double scaleOfLarge = 0x1p-256;
};

// The number of a component, as componentOf gives it.
template <class Real>
using Index = typename ScalarTraits<Real>::Index;

inline bool both(bool a, bool b)
{
    return a && b;
}
inline bool either(bool a, bool b)
{
    return a || b;
}

template <std::floating_point Real>
Real abs(Real x)
{
    return std::abs(x);
}
template <std::floating_point Real>
Real min(Real a, Real b)
{
    return std::min(a, b);
}
template <std::floating_point Real>
Real max(Real a, Real b)
{
    return std::max(a, b);
}
template <std::floating_point Real>
Real sqrt(Real x)
{
    return std::sqrt(x);
}

// yes and no: two numbers or two indices.
template <class Value>
requires std::is_arithmetic_v<Value> Value select(bool condition, Value yes, Value no)
{
    return condition ? yes : no;
}

// IEEE 754: a NaN's exponent bits are all set and its fraction is not zero; an infinity's fraction is zero.
inline bool isNan(float x)
{
    return (std::bit_cast<std::uint32_t>(x) & 0x7fffffffu) > 0x7f800000u;
}
inline bool isInfinite(float x)
{
    return (std::bit_cast<std::uint32_t>(x) & 0x7fffffffu) == 0x7f800000u;
}
inline bool isNan(double x)
{
    return (std::bit_cast<std::uint64_t>(x) & 0x7fffffffffffffffu) > 0x7ff0000000000000u;
}
inline bool isInfinite(double x)
{
    return (std::bit_cast<std::uint64_t>(x) & 0x7fffffffffffffffu) == 0x7ff0000000000000u;
}

template <class Real>
Real signNotZero(const Real& x)
{
    return select(x < Real(0), Real(-1), Real(1));
}

// x, or 0 where it is subnormal.
template <class Real>
Real flushed(const Real& x)
{
    return select(abs(x) < Real(ScalarTraits<Real>::smallestNormal), Real(0), x);
}

// -1 or 1 for an infinity, 0 for a finite number.
template <class Real>
Real infinitySign(const Real& x)
{
    return select(isInfinite(x), signNotZero(x), Real(0));
}

template <class Value>
Value named(const Value& value, const char*)
{
    return value;
}

} // namespace mirrorball
