// Intervals: each word contains what float and double give for any numbers inside its arguments.
#include "support/check.h"

#include <mirrorball/math/interval.h>

#include <random>

namespace {

using mirrorball::Interval;
using mirrorball::Verdict;

// Random numbers of all sizes, zeros, and neighbours of both.
class Numbers
{
public:
    float next()
    {
        switch (random_() % 6) {
        case 0:
            return 0;
        case 1:
            return last_;
        case 2:
            return last_ = -last_;
        case 3:
            return last_ = std::nextafter(last_, random_() % 2 == 0 ? -2.0f : 2.0f);
        case 4:
            return last_ = std::ldexp(unit_(random_), -static_cast<int>(random_() % 20));
        default:
            return last_ = unit_(random_);
        }
    }

    // An interval that contains x: half of them x alone.
    Interval around(float x)
    {
        if (random_() % 2 == 0)
            return {double(x), double(x)};
        const double below = std::abs(double(next()));
        const double above = std::abs(double(next()));
        return {double(x) - below, double(x) + above};
    }

private:
    std::mt19937 random_{11};
    std::uniform_real_distribution<float> unit_{-1, 1};
    float last_ = 1;
};

void checkContains(const Interval& interval, float inFloat, double inDouble)
{
    if (!interval.contains(double(inFloat)) || !interval.contains(inDouble))
        std::fprintf(stderr, "[%a, %a] float %a double %a\n", interval.lower, interval.upper, double(inFloat),
                     inDouble);
    CHECK(interval.contains(double(inFloat)));
    CHECK(interval.contains(inDouble));
}

void checkVerdict(Verdict verdict, bool truth)
{
    CHECK(truth ? verdict.canBeTrue : verdict.canBeFalse);
}

void checkArithmetic(Numbers& numbers)
{
    const float a = numbers.next(), b = numbers.next();
    const double da = double(a), db = double(b);
    const Interval x = numbers.around(a), y = numbers.around(b);
    checkContains(x + y, a + b, da + db);
    checkContains(x - y, a - b, da - db);
    checkContains(x * y, a * b, da * db);
    if (b != 0)
        checkContains(x / y, a / b, da / db);
    checkContains(-x, -a, -da);
    checkContains(abs(x), std::abs(a), std::abs(da));
    checkContains(min(x, y), std::min(a, b), std::min(da, db));
    checkContains(max(x, y), std::max(a, b), std::max(da, db));
    checkContains(sqrt(abs(x)), std::sqrt(std::abs(a)), std::sqrt(std::abs(da)));
    // Contracted to one rounding: what a compiler may do to a * b + b.
    checkContains(x * y + y, std::fma(a, b, b), da * db + db);
    checkContains(select(x < y, x, y), a < b ? a : b, da < db ? da : db);
    checkContains(mirrorball::signNotZero(x), mirrorball::signNotZero(a), mirrorball::signNotZero(da));
    checkVerdict(x < y, a < b);
    checkVerdict(x <= y, a <= b);
    checkVerdict(x > y, a > b);
    checkVerdict(x >= y, a >= b);
}

void checkElementary(Numbers& numbers)
{
    const float a = numbers.next(), b = numbers.next();
    const double da = double(a), db = double(b);
    const Interval x = numbers.around(a), y = numbers.around(b);
    checkContains(mirrorball::atan2Pi(x, y), mirrorball::atan2Pi(a, b), mirrorball::atan2Pi(da, db));
    checkContains(mirrorball::sinPi(x), mirrorball::sinPi(a), mirrorball::sinPi(da));
    checkContains(mirrorball::cosPi(x), mirrorball::cosPi(a), mirrorball::cosPi(da));
}

void checkConditions()
{
    const Interval low(0, 1), high(2, 3), across(0.5, 2.5);
    CHECK((low < high).canBeTrue && !(low < high).canBeFalse);
    CHECK(!(low >= high).canBeTrue && (low >= high).canBeFalse);
    CHECK((low < across).canBeTrue && (low < across).canBeFalse);
    const Verdict never{false, true}, maybe{true, true}, always{true, false};
    CHECK(!both(maybe, never).canBeTrue && both(maybe, always).canBeTrue && both(maybe, always).canBeFalse);
    CHECK(!either(maybe, always).canBeFalse && either(maybe, never).canBeTrue &&
          either(maybe, never).canBeFalse);

    const Interval hull = select(maybe, low, high);
    CHECK(hull.lower == 0 && hull.upper == 3);
    CHECK(select(always, low, high).upper == 1 && select(never, low, high).lower == 2);

    using mirrorball::IndexSet;
    const IndexSet two = select(maybe, IndexSet(1), IndexSet(4));
    CHECK(two.contains(1) && two.contains(4) && !two.contains(0));
    CHECK((two == 1).canBeTrue && (two == 1).canBeFalse && !(two == 0).canBeTrue);
    CHECK(!(IndexSet(3) == 3).canBeFalse);
    CHECK(!select(always, IndexSet(1), IndexSet(4)).contains(4));
}

// 0.1 is not a float: a formula's number stands for both its roundings.
void checkNumbers()
{
    const Interval tenth(0.1);
    CHECK(tenth.contains(0.1) && tenth.contains(double(0.1f)));
    CHECK(Interval(0.5).lower == 0.5 && Interval(0.5).upper == 0.5);
    CHECK(!std::isfinite((Interval(0.5) / Interval(-1, 1)).upper));
    CHECK((Interval(0.0) * (Interval(0.5) / Interval(-1, 1))).upper < 1e-30);
}

} // namespace

int main()
{
    checkConditions();
    checkNumbers();
    Numbers numbers;
    for (int i = 0; i < 1000000; ++i) {
        checkArithmetic(numbers);
        checkElementary(numbers);
    }
}
