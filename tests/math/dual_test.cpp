// The rules of differentiation, word by word, against derivatives worked out by hand.
#include "support/check.h"

#include <mirrorball/math/dual.h>

namespace {

using mirrorball::Dual;

// f(u, v) = value, with its two derivatives; doubles that differ in rounding only.
void checkDual(const Dual& actual, double value, double alongU, double alongV)
{
    CHECK_NEAR(actual.value, value, 1e-15);
    CHECK_NEAR(actual.alongU, alongU, 4e-15);
    CHECK_NEAR(actual.alongV, alongV, 4e-15);
}

} // namespace

int main()
{
    using std::numbers::pi;
    const double x = 0.3, y = -0.8;
    const Dual u(x, 1, 0);
    const Dual v(y, 0, 1);

    checkDual(Dual(2), 2, 0, 0);
    checkDual(u + v, x + y, 1, 1);
    checkDual(u - v, x - y, 1, -1);
    checkDual(-u, -x, -1, 0);
    checkDual(u * v, x * y, y, x);
    checkDual(u / v, x / y, 1 / y, -x / (y * y));
    checkDual(abs(v), 0.8, 0, -1);
    checkDual(min(u, v), y, 0, 1);
    checkDual(max(u, v), x, 1, 0);
    checkDual(sqrt(u), std::sqrt(x), 0.5 / std::sqrt(x), 0);
    checkDual(sqrt(Dual(0, 1, 0)), 0, 0, 0);
    checkDual(mirrorball::signNotZero(v), -1, 0, 0);
    checkDual(select(u < v, u, v), y, 0, 1);
    checkDual(select(u >= v, u, v), x, 1, 0);
    checkDual(atanPi(u), std::atan(x) / pi, 1 / (pi * (1 + x * x)), 0);
    checkDual(sinPiAcute(u), std::sin(pi * x), pi * std::cos(pi * x), 0);

    // atan2(v, u) / pi in the fourth quadrant, in its steep octant: (-v, u) / (u² + v²) / pi.
    const double square = pi * (x * x + y * y);
    checkDual(mirrorball::atan2Pi(v, u), std::atan2(y, x) / pi, -y / square, x / square);
    checkDual(mirrorball::sinPi(v), std::sin(pi * y), 0, pi * std::cos(pi * y));
    checkDual(mirrorball::cosPi(u), std::cos(pi * x), -pi * std::sin(pi * x), 0);
}
