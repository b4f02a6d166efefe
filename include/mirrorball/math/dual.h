// A number with its derivatives along u and v: run through a map it gives the exact Jacobian.
// Derivatives at a kink (abs, min, max, select) are those of the branch taken; sqrt's at 0 counts as 0.
#pragma once

#include <mirrorball/math/elementary.h>

namespace mirrorball {

struct Dual
{
    double value;
    double alongU;
    double alongV;

    explicit constexpr Dual(double number) : value(number), alongU(0), alongV(0) {}
    constexpr Dual(double number, double derivativeU, double derivativeV)
        : value(number), alongU(derivativeU), alongV(derivativeV)
    {
    }

    // f(x) from its value and f'(x).
    static Dual chain(const Dual& x, double value, double slope)
    {
        return {value, slope * x.alongU, slope * x.alongV};
    }

    friend Dual operator-(const Dual& a) { return chain(a, -a.value, -1); }
    friend Dual operator+(const Dual& a, const Dual& b)
    {
        return {a.value + b.value, a.alongU + b.alongU, a.alongV + b.alongV};
    }
    friend Dual operator-(const Dual& a, const Dual& b) { return a + -b; }
    friend Dual operator*(const Dual& a, const Dual& b)
    {
        return {a.value * b.value, a.alongU * b.value + a.value * b.alongU,
                a.alongV * b.value + a.value * b.alongV};
    }
    friend Dual operator/(const Dual& a, const Dual& b)
    {
        const double quotient = a.value / b.value;
        return {quotient, (a.alongU - quotient * b.alongU) / b.value,
                (a.alongV - quotient * b.alongV) / b.value};
    }

    friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
    friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
    friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
    friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
    friend bool isNan(const Dual& x) { return mirrorball::isNan(x.value); }
    friend bool isInfinite(const Dual& x) { return mirrorball::isInfinite(x.value); }
    friend Dual select(bool condition, const Dual& yes, const Dual& no) { return condition ? yes : no; }

    friend Dual abs(const Dual& x) { return x.value < 0 ? -x : x; }
    friend Dual min(const Dual& a, const Dual& b) { return b < a ? b : a; }
    friend Dual max(const Dual& a, const Dual& b) { return a < b ? b : a; }
    friend Dual sqrt(const Dual& x)
    {
        const double root = std::sqrt(x.value);
        return chain(x, root, root > 0 ? 0.5 / root : 0);
    }
    friend Dual atanPi(const Dual& t)
    {
        return chain(t, mirrorball::atanPi(t.value), std::numbers::inv_pi / (1 + t.value * t.value));
    }
    friend Dual sinPiAcute(const Dual& x)
    {
        const double slope = std::numbers::pi * std::cos(std::numbers::pi * x.value);
        return chain(x, mirrorball::sinPiAcute(x.value), slope);
    }
};

template <>
struct ScalarTraits<Dual> : ScalarTraits<double>
{
};

} // namespace mirrorball
