// A closed interval that contains the exact result and that of every float evaluation: proved rounding
// bounds.
//
// Rounding model: IEEE 754 binary32, round to nearest, a * b + c contracted or not, numbers below 2^-126
// flushed to zero or not. Each operation widens its result by half a float ulp, at most 2^-24 of its size,
// and by the flushed 2^-126; the double arithmetic of the endpoints errs by 2^-29 of that, which `relative`
// covers. Inputs are finite. An undecided condition makes select the hull of both its values.
#pragma once

#include <mirrorball/math/elementary.h>

#include <bitset>
#include <limits>
#include <utility>

namespace mirrorball {

// A condition on intervals: true for some of their numbers, false for some, or both.
struct Verdict
{
    bool canBeTrue;
    bool canBeFalse;

    friend Verdict both(Verdict a, Verdict b)
    {
        return {a.canBeTrue && b.canBeTrue, a.canBeFalse || b.canBeFalse};
    }
    friend Verdict either(Verdict a, Verdict b)
    {
        return {a.canBeTrue || b.canBeTrue, a.canBeFalse && b.canBeFalse};
    }
};

// The components that an undecided componentOf may mean. No map has more than six.
struct IndexSet
{
    std::bitset<8> members;

    explicit IndexSet(int index) { members.set(static_cast<std::size_t>(index)); }

    bool contains(int index) const { return members.test(static_cast<std::size_t>(index)); }

    friend Verdict operator==(const IndexSet& set, int k)
    {
        return {set.contains(k), !set.contains(k) || set.members.count() > 1};
    }
    friend IndexSet select(Verdict condition, IndexSet yes, const IndexSet& no)
    {
        if (condition.canBeFalse)
            yes.members |= no.members;
        return condition.canBeTrue ? yes : no;
    }
};

struct Interval
{
    double lower;
    double upper;

    constexpr Interval(double from, double to) : lower(from), upper(to) {}

    // A number in a formula: the double and the float nearest to it.
    explicit constexpr Interval(double number)
        : Interval(number, static_cast<double>(static_cast<float>(number)))
    {
        if (lower > upper)
            std::swap(lower, upper);
    }

    bool contains(double x) const { return lower <= x && x <= upper; }

    static Interval hull(const Interval& a, const Interval& b)
    {
        return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
    }

    // [from, to] with the rounding error of one operation.
    static Interval rounded(double from, double to)
    {
        constexpr double relative = 0x1p-24 * (1 + 0x1p-20);
        constexpr double flushed = 0x1p-126;
        return {from - std::abs(from) * relative - flushed, to + std::abs(to) * relative + flushed};
    }
    static Interval rounded(const std::pair<double, double>& ends)
    {
        return rounded(ends.first, ends.second);
    }

    // Of endpoints. 0 times an unbounded end is 0, because 0 stands for a number; an unbounded end divided by
    // one is 0 too, because the ends that it is paired with besides give the rest.
    static double product(double x, double y) { return x == 0 || y == 0 ? 0 : x * y; }
    static double quotient(double x, double y) { return std::isinf(y) ? 0 : x / y; }

    friend Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }
    friend Interval operator+(const Interval& a, const Interval& b)
    {
        return rounded(a.lower + b.lower, a.upper + b.upper);
    }
    friend Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
    friend Interval operator*(const Interval& a, const Interval& b)
    {
        return rounded(std::minmax({product(a.lower, b.lower), product(a.lower, b.upper),
                                    product(a.upper, b.lower), product(a.upper, b.upper)}));
    }
    // Everything where b contains 0.
    friend Interval operator/(const Interval& a, const Interval& b)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (b.contains(0))
            return {-infinity, infinity};
        return rounded(std::minmax({quotient(a.lower, b.lower), quotient(a.lower, b.upper),
                                    quotient(a.upper, b.lower), quotient(a.upper, b.upper)}));
    }

    friend Verdict operator<(const Interval& a, const Interval& b)
    {
        return {a.lower < b.upper, a.upper >= b.lower};
    }
    friend Verdict operator<=(const Interval& a, const Interval& b)
    {
        return {a.lower <= b.upper, a.upper > b.lower};
    }
    friend Verdict operator>(const Interval& a, const Interval& b) { return b < a; }
    friend Verdict operator>=(const Interval& a, const Interval& b) { return b <= a; }
    friend Verdict isNan(const Interval&) { return {false, true}; }
    friend Verdict isInfinite(const Interval&) { return {false, true}; }
    friend Interval select(Verdict condition, const Interval& yes, const Interval& no)
    {
        return !condition.canBeFalse ? yes : !condition.canBeTrue ? no : hull(yes, no);
    }

    friend Interval abs(const Interval& x)
    {
        const auto [smaller, larger] = std::minmax({std::abs(x.lower), std::abs(x.upper)});
        return {x.contains(0) ? 0 : smaller, larger};
    }
    friend Interval min(const Interval& a, const Interval& b)
    {
        return {std::min(a.lower, b.lower), std::min(a.upper, b.upper)};
    }
    friend Interval max(const Interval& a, const Interval& b)
    {
        return {std::max(a.lower, b.lower), std::max(a.upper, b.upper)};
    }
    // What lies below zero is there by widening only: it counts as 0.
    friend Interval sqrt(const Interval& x)
    {
        return rounded(std::sqrt(std::max(x.lower, 0.0)), std::sqrt(std::max(x.upper, 0.0)));
    }

    // The kernels grow with their argument. Outside their domain, where only widening leads, they stay as at
    // its end.
    friend Interval atanPi(const Interval& t)
    {
        return {mirrorball::atanPi(std::clamp(t.lower, 0.0, 1.0)) - atanPiError,
                mirrorball::atanPi(std::clamp(t.upper, 0.0, 1.0)) + atanPiError};
    }
    friend Interval sinPiAcute(const Interval& x)
    {
        return {mirrorball::sinPiAcute(std::clamp(x.lower, -0.5, 0.5)) - sinPiError,
                mirrorball::sinPiAcute(std::clamp(x.upper, -0.5, 0.5)) + sinPiError};
    }
};

template <>
struct ScalarTraits<Interval> : ScalarTraits<float>
{
    using Index = IndexSet;
};

} // namespace mirrorball
