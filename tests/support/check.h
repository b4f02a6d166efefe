// Plain assertions that stay alive in Release builds. A failed check prints what failed and ends the test.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#define CHECK(condition)                                                                                     \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            std::fprintf(stderr, "%s:%d: failed: %s\n", __FILE__, __LINE__, #condition);                     \
            std::exit(1);                                                                                    \
        }                                                                                                    \
    } while (false)

// |actual - expected| <= tolerance; NaN fails. Prints the three numbers.
#define CHECK_NEAR(actual, expected, tolerance)                                                              \
    do {                                                                                                     \
        const double actualValue = static_cast<double>(actual);                                              \
        const double expectedValue = static_cast<double>(expected);                                          \
        const double toleranceValue = static_cast<double>(tolerance);                                        \
        if (!(std::abs(actualValue - expectedValue) <= toleranceValue)) {                                    \
            std::fprintf(stderr, "%s:%d: failed: %s = %.17g is not within %.3g of %.17g\n", __FILE__,        \
                         __LINE__, #actual, actualValue, toleranceValue, expectedValue);                     \
            std::exit(1);                                                                                    \
        }                                                                                                    \
    } while (false)

// The statement throws a mirrorball::Error of that kind.
#define CHECK_THROWS(statement, expectedKind)                                                                \
    do {                                                                                                     \
        bool thrown = false;                                                                                 \
        try {                                                                                                \
            statement;                                                                                       \
        } catch (const mirrorball::Error& error) {                                                           \
            thrown = true;                                                                                   \
            if (error.kind() != (expectedKind)) {                                                            \
                std::fprintf(stderr, "%s:%d: wrong kind of error: %s\n", __FILE__, __LINE__, error.what());  \
                std::exit(1);                                                                                \
            }                                                                                                \
        }                                                                                                    \
        if (!thrown) {                                                                                       \
            std::fprintf(stderr, "%s:%d: nothing thrown: %s\n", __FILE__, __LINE__, #statement);             \
            std::exit(1);                                                                                    \
        }                                                                                                    \
    } while (false)
