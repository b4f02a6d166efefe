// The polynomials against the standard library in double, whose own error of 1e-16 does not count here.
#include "support/check.h"

#include <mirrorball/math/elementary.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>

namespace {

using std::numbers::pi;

// The largest error of `approximation` over the floats of [first, last]: each `stride`-th of them.
template <class Approximation, class Exact>
double largestError(float first, float last, std::uint32_t stride, Approximation approximation, Exact exact)
{
    double worst = 0;
    const auto lastBits = std::bit_cast<std::uint32_t>(last);
    for (auto bits = std::bit_cast<std::uint32_t>(first); bits <= lastBits; bits += stride) {
        const float x = std::bit_cast<float>(bits);
        worst = std::max(worst, std::abs(double(approximation(x)) - exact(double(x))));
    }
    return worst;
}

// Every float down to 1/8 of the end of the domain, where errors are largest; every 1009th below. Odd
// symmetry gives the rest. The errors are also not much smaller than claimed: a bound that is far too wide
// would hide a bad coefficient.
void checkKernels()
{
    const auto atanFloat = [](float t) { return mirrorball::atanPi(t); };
    const auto atanExact = [](double t) { return std::atan(t) / pi; };
    const auto sinFloat = [](float x) { return mirrorball::sinPiAcute(x); };
    const auto sinExact = [](double x) { return std::sin(pi * x); };
    const double atanError = std::max(largestError(0.125f, 1, 1, atanFloat, atanExact),
                                      largestError(0, 0.125f, 1009, atanFloat, atanExact));
    const double sinError = std::max(largestError(0.0625f, 0.5f, 1, sinFloat, sinExact),
                                     largestError(0, 0.0625f, 1009, sinFloat, sinExact));
    CHECK(atanError <= mirrorball::atanPiError && atanError > mirrorball::atanPiError / 4);
    CHECK(sinError <= mirrorball::sinPiError && sinError > mirrorball::sinPiError / 4);
}

// The polynomials alone, without float rounding.
void checkApproximation()
{
    double atanError = 0;
    double sinError = 0;
    for (int i = 0; i <= 1000000; ++i) {
        const double t = i * 1e-6;
        atanError = std::max(atanError, std::abs(mirrorball::atanPiPolynomial(t) - std::atan(t) / pi));
        sinError = std::max(sinError, std::abs(mirrorball::sinPiPolynomial(t / 2) - std::sin(pi * t / 2)));
    }
    CHECK(atanError < 1.31e-8);
    CHECK(sinError < 9.3e-9);
}

// A division and a reflection at 1/2 and at 1 are added to the kernel's error: of a result up to 1, each at
// most half an ulp, and the division's error of the ratio counts by the slope 1 / pi.
template <class Number>
void checkAtan2(double bound)
{
    std::mt19937 random(3);
    std::normal_distribution<Number> normal;
    for (int i = 0; i < 1000000; ++i) {
        const Number y = std::ldexp(normal(random), -(i % 30));
        const Number x = std::ldexp(normal(random), -(i / 30 % 30));
        CHECK_NEAR(mirrorball::atan2Pi(y, x), std::atan2(double(y), double(x)) / pi, bound);
    }
    for (const Number zero : {Number(0), Number(-0.0)}) {
        CHECK(mirrorball::atan2Pi(zero, zero) == 0);
        CHECK(mirrorball::atan2Pi(zero, Number(2)) == 0);
        CHECK(mirrorball::atan2Pi(zero, Number(-2)) == 1);
        CHECK(mirrorball::atan2Pi(Number(2), zero) == Number(0.5));
        CHECK(mirrorball::atan2Pi(Number(-2), zero) == Number(-0.5));
    }
}

template <class Number>
void checkSinAndCos(double bound)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<Number> angle(Number(-1.5), Number(1.5));
    for (int i = 0; i < 1000000; ++i) {
        const Number x = angle(random);
        CHECK_NEAR(mirrorball::sinPi(x), std::sin(pi * double(x)), bound);
        CHECK_NEAR(mirrorball::cosPi(x), std::cos(pi * double(x)), bound);
    }
    for (const int turn : {-1, 0, 1})
        CHECK(mirrorball::sinPi(Number(turn)) == 0);
    for (const double quarter : {-1.5, -0.5, 0.5, 1.5})
        CHECK(mirrorball::cosPi(Number(quarter)) == 0);
}

} // namespace

int main()
{
    checkKernels();
    checkApproximation();
    checkAtan2<float>(mirrorball::atanPiError + 1.5 * 0x1p-24);
    checkAtan2<double>(4 * 0x1p-53);
    // 1/2 - |x| rounds by up to 2^-25 below 1/4, where the slope of the sine counts pi / sqrt(2) at most,
    // times that.
    checkSinAndCos<float>(mirrorball::sinPiError + 2.3 * 0x1p-25);
    checkSinAndCos<double>(8 * 0x1p-53);
}
