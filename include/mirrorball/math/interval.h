// A closed interval that contains the exact result and that of every float evaluation: proved rounding
// bounds.
//
// Rounding model: IEEE 754 binary32, round to nearest, a * b + c contracted or not, numbers below 2^-126
// flushed to zero or not. Each operation widens its result by half a float ulp, at most 2^-24 of its size,
// and by the flushed 2^-126; the double arithmetic of the endpoints errs by 2^-29 of that, which the last
// factor covers. Inputs are finite. An undecided condition makes select the hull of both its values.
#pragma once

#include <mirrorball/math/elementary.h>

#include <bitset>
#include <limits>
#include <utility>

namespace mirrorball {

struct Interval
{
    double lower;
    double upper;

    // A number in a formula: the double and the float nearest to it.
    explicit constexpr Interval(double number)
        : Interval(number, static_cast<double>(static_cast<float>(number)))
    {
        if (lower > upper)
            std::swap(lower, upper);
    }
    constexpr Interval(double from, double to) : lower(from), upper(to) {}

    bool contains(double x) const { return lower <= x && x <= upper; }
};

// A condition on intervals: true for some of their numbers, false for some, or both.
struct Verdict
{
    bool canBeTrue;
    bool canBeFalse;
};

// The components that an undecided componentOf may mean. At most 6 in any map.
struct IndexSet
{
    std::bitset<8> members;

    IndexSet(int index) { members.set(static_cast<std::size_t>(index)); }
};

template <>
struct ScalarTraits<Interval> : ScalarTraits<float>
{
    using Index = IndexSet;
};

// [lower, upper] with the rounding error of one operation.
inline Interval rounded(double lower, double upper)
{
    constexpr double relative = 0x1p-24 * (1 + 0x1p-20);
    constexpr double flushed = 0x1p-126;
    return {lower - std::abs(lower) * relative - flushed, upper + std::abs(upper) * relative + flushed};
}

inline Interval hull(const Interval& a, const Interval& b)
{
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

inline Interval operator-(const Interval& a)
{
    return {-a.upper, -a.lower};
}
inline Interval operator+(const Interval& a, const Interval& b)
{
    return rounded(a.lower + b.lower, a.upper + b.upper);
}
inline Interval operator-(const Interval& a, const Interval& b)
{
    return a + -b;
}
inline Interval operator*(const Interval& a, const Interval& b)
{
    // An endpoint 0 stands for the number 0, also beside an unbounded one: 0 * infinity is 0 here.
    const auto product = [](double x, double y) { return x == 0 || y == 0 ? 0.0 : x * y; };
    const auto [lower, upper] = std::minmax({product(a.lower, b.lower), product(a.lower, b.upper),
                                             product(a.upper, b.lower), product(a.upper, b.upper)});
    return rounded(lower, upper);
}
inline Interval operator/(const Interval& a, const Interval& b)
{
    if (b.contains(0))
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const auto [lower, upper] =
        std::minmax({a.lower / b.lower, a.lower / b.upper, a.upper / b.lower, a.upper / b.upper});
    return rounded(lower, upper);
}

inline Verdict operator<(const Interval& a, const Interval& b)
{
    return {a.lower < b.upper, a.upper >= b.lower};
}
inline Verdict operator<=(const Interval& a, const Interval& b)
{
    return {a.lower <= b.upper, a.upper > b.lower};
}
inline Verdict operator>(const Interval& a, const Interval& b)
{
    return b < a;
}
inline Verdict operator>=(const Interval& a, const Interval& b)
{
    return b <= a;
}
inline Verdict both(Verdict a, Verdict b)
{
    return {a.canBeTrue && b.canBeTrue, a.canBeFalse || b.canBeFalse};
}
inline Verdict either(Verdict a, Verdict b)
{
    return {a.canBeTrue || b.canBeTrue, a.canBeFalse && b.canBeFalse};
}
inline Verdict isNan(const Interval&)
{
    return {false, true};
}
inline Verdict isInfinite(const Interval&)
{
    return {false, true};
}

inline Interval select(Verdict condition, const Interval& yes, const Interval& no)
{
    return !condition.canBeFalse ? yes : !condition.canBeTrue ? no : hull(yes, no);
}
inline IndexSet select(Verdict condition, IndexSet yes, const IndexSet& no)
{
    if (condition.canBeTrue && condition.canBeFalse)
        yes.members |= no.members;
    return condition.canBeTrue ? yes : no;
}
inline Verdict operator==(const IndexSet& set, int k)
{
    const bool contained = set.members.test(static_cast<std::size_t>(k));
    return {contained, !contained || set.members.count() > 1};
}
inline Verdict operator<(const IndexSet& set, int k)
{
    const std::bitset<8> below((1u << k) - 1);
    return {(set.members & below).any(), (set.members & ~below).any()};
}

inline Interval abs(const Interval& x)
{
    const double smallest = x.contains(0) ? 0 : std::min(std::abs(x.lower), std::abs(x.upper));
    return {smallest, std::max(std::abs(x.lower), std::abs(x.upper))};
}
inline Interval min(const Interval& a, const Interval& b)
{
    return {std::min(a.lower, b.lower), std::min(a.upper, b.upper)};
}
inline Interval max(const Interval& a, const Interval& b)
{
    return {std::max(a.lower, b.lower), std::max(a.upper, b.upper)};
}
inline Interval signNotZero(const Interval& x)
{
    return {signNotZero(x.lower), signNotZero(x.upper)};
}
// The part below zero that rounding bounds may add is no number's root: it counts as 0.
inline Interval sqrt(const Interval& x)
{
    return rounded(std::sqrt(std::max(x.lower, 0.0)), std::sqrt(std::max(x.upper, 0.0)));
}

// Both kernels grow with their argument; outside their domain, where only bounds can lie, the nearest value
// in it.
inline Interval atanPi(const Interval& t)
{
    return {atanPi(std::clamp(t.lower, 0.0, 1.0)) - atanPiError,
            atanPi(std::clamp(t.upper, 0.0, 1.0)) + atanPiError};
}
inline Interval sinPiAcute(const Interval& x)
{
    return {sinPiAcute(std::clamp(x.lower, -0.5, 0.5)) - sinPiError,
            sinPiAcute(std::clamp(x.upper, -0.5, 0.5)) + sinPiError};
}

} // namespace mirrorball
