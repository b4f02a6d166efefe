// A number with its derivatives along two variables, u and v: run through a map it gives the exact Jacobian,
// in double or, on recorded scalars, as GLSL.
// Derivatives at a kink (abs, min, max, select) are those of the branch taken; those of sqrt at 0 and of
// atan2Pi at (0, 0) count as 0.
#pragma once

#include <mirrorball/math/elementary.h>

#include <numbers>
#include <string>
#include <type_traits>

namespace mirrorball {

template <class Real>
struct BasicDual
{
    Real value;
    Real alongU;
    Real alongV;

    explicit constexpr BasicDual(double number) : value(number), alongU(0.0), alongV(0.0) {}
    constexpr BasicDual(const Real& number, const Real& derivativeU, const Real& derivativeV)
        : value(number), alongU(derivativeU), alongV(derivativeV)
    {
    }

    // f(x) from its value and f'(x).
    static BasicDual chain(const BasicDual& x, const Real& value, const Real& slope)
    {
        return {value, slope * x.alongU, slope * x.alongV};
    }

    friend BasicDual operator-(const BasicDual& a) { return {-a.value, -a.alongU, -a.alongV}; }
    friend BasicDual operator+(const BasicDual& a, const BasicDual& b)
    {
        return {a.value + b.value, a.alongU + b.alongU, a.alongV + b.alongV};
    }
    friend BasicDual operator-(const BasicDual& a, const BasicDual& b)
    {
        return {a.value - b.value, a.alongU - b.alongU, a.alongV - b.alongV};
    }
    friend BasicDual operator*(const BasicDual& a, const BasicDual& b)
    {
        return {a.value * b.value, a.alongU * b.value + a.value * b.alongU,
                a.alongV * b.value + a.value * b.alongV};
    }
    friend BasicDual operator/(const BasicDual& a, const BasicDual& b)
    {
        const Real quotient = a.value / b.value;
        return {quotient, (a.alongU - quotient * b.alongU) / b.value,
                (a.alongV - quotient * b.alongV) / b.value};
    }

    friend auto operator<(const BasicDual& a, const BasicDual& b) { return a.value < b.value; }
    friend auto operator>(const BasicDual& a, const BasicDual& b) { return a.value > b.value; }
    friend auto operator<=(const BasicDual& a, const BasicDual& b) { return a.value <= b.value; }
    friend auto operator>=(const BasicDual& a, const BasicDual& b) { return a.value >= b.value; }
    friend auto isNan(const BasicDual& x) { return isNan(x.value); }
    friend auto isInfinite(const BasicDual& x) { return isInfinite(x.value); }
    template <class Condition>
    friend BasicDual select(const Condition& condition, const BasicDual& yes, const BasicDual& no)
    {
        return {select(condition, yes.value, no.value), select(condition, yes.alongU, no.alongU),
                select(condition, yes.alongV, no.alongV)};
    }
    friend BasicDual named(const BasicDual& x, const char* name)
    {
        if constexpr (std::is_floating_point_v<Real>) // which keeps no name, so that none need be made
            return x;
        else
            return {named(x.value, name), named(x.alongU, (std::string(name) + "U").c_str()),
                    named(x.alongV, (std::string(name) + "V").c_str())};
    }

    friend BasicDual abs(const BasicDual& x) { return select(x.value < Real(0), -x, x); }
    friend BasicDual min(const BasicDual& a, const BasicDual& b) { return select(b < a, b, a); }
    friend BasicDual max(const BasicDual& a, const BasicDual& b) { return select(a < b, b, a); }
    friend BasicDual sqrt(const BasicDual& x)
    {
        const Real root = sqrt(x.value);
        const auto positive = root > Real(0);
        return chain(x, root, select(positive, Real(0.5) / select(positive, root, Real(1)), Real(0)));
    }
    friend BasicDual atanPi(const BasicDual& t)
    {
        return chain(t, atanPi(t.value), Real(std::numbers::inv_pi) / (Real(1) + t.value * t.value));
    }
    friend BasicDual sinPiAcute(const BasicDual& x)
    {
        return chain(x, sinPiAcute(x.value), Real(std::numbers::pi) * cosPi(x.value));
    }
    // Not through the octants and quadrants of the value.
    friend BasicDual atan2Pi(const BasicDual& y, const BasicDual& x)
    {
        const Real square = x.value * x.value + y.value * y.value;
        const Real inverse = Real(std::numbers::inv_pi) / select(square > Real(0), square, Real(1));
        return {atan2Pi(y.value, x.value), (x.value * y.alongU - y.value * x.alongU) * inverse,
                (x.value * y.alongV - y.value * x.alongV) * inverse};
    }
};

using Dual = BasicDual<double>;

template <class Real>
struct ScalarTraits<BasicDual<Real>> : ScalarTraits<Real>
{
};

} // namespace mirrorball
