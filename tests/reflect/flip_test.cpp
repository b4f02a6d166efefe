// FLIP against the authors' own program (github.com/NVlabs/flip, version 1.6), compiled with double for float and run
// on the same pictures.
#include "support/check.h"
#include "support/flip.h"

#include <algorithm>
#include <functional>

namespace {

using Colours = std::vector<glm::dvec3>;

constexpr glm::ivec2 size(96, 64);

Colours picture(const std::function<glm::dvec3(int, int)>& colour)
{
    Colours colours;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            colours.push_back(colour(x, y));
    return colours;
}

Colours flat(const glm::dvec3& colour)
{
    return picture([&](int, int) { return colour; });
}

Colours edgeAt(int place)
{
    return picture([=](int x, int) { return x < place ? glm::dvec3(0.1) : glm::dvec3(0.8, 0.6, 0.2); });
}

Colours pointOf(double brightness)
{
    return picture([=](int x, int y) {
        return x == 48 && y == 32 ? glm::dvec3(brightness) : glm::dvec3(0.2, 0.3, 0.4);
    });
}

Colours pattern(int shift)
{
    return picture(
        [=](int x, int y) { return glm::dvec3((x + shift) % 16 / 15.0, y % 8 / 7.0, x * y % 5 / 4.0); });
}

// The mean, and three single pixels.
struct Expected
{
    double mean, middle, beside, corner;
};

void checkValues(const Colours& reference, const Colours& test, const Expected& expected)
{
    constexpr double tolerance = 5e-7; // it has some of the constants to nine digits
    const std::vector<double> errors = tests::flip(size, reference, test);
    double mean = 0.0;
    for (const double error : errors)
        mean += error / static_cast<double>(errors.size());
    const auto at = [&](int x, int y) { return errors[static_cast<std::size_t>(y * size.x + x)]; };
    CHECK_NEAR(mean, expected.mean, tolerance);
    CHECK_NEAR(at(48, 32), expected.middle, tolerance);
    CHECK_NEAR(at(47, 31), expected.beside, tolerance);
    CHECK_NEAR(at(5, 60), expected.corner, tolerance);
}

void checkUniform(const glm::dvec3& reference, const glm::dvec3& test, double expected)
{
    checkValues(flat(reference), flat(test), {expected, expected, expected, expected});
}

void testAgainstTheAuthors()
{
    checkUniform(glm::dvec3(0.0), glm::dvec3(1.0), 0.9673798);
    checkUniform({0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, 1.0);
    checkUniform(glm::dvec3(0.2), glm::dvec3(0.25), 0.1833974);
    checkUniform({0.5, 0.1, 0.1}, {0.1, 0.5, 0.5}, 0.9535580);
    checkValues(edgeAt(48), edgeAt(49), {0.0381087, 0.4094353, 0.5166265, 0.0});
    checkValues(edgeAt(48), edgeAt(51), {0.0802398, 0.8794308, 0.8069519, 0.0});
    checkValues(pointOf(0.3), pointOf(1.0), {0.0005988, 0.3316707, 0.1920567, 0.0});
    checkValues(pattern(0), pattern(2), {0.3452216, 0.4250277, 0.6874510, 0.2717008});
}

void testLaws()
{
    const Colours a = pattern(0), b = pattern(3);
    for (const double error : tests::flip(size, a, a))
        CHECK(error == 0.0);
    const std::vector<double> errors = tests::flip(size, a, b);
    CHECK(errors == tests::flip(size, b, a));
    CHECK(*std::min_element(errors.begin(), errors.end()) >= 0.0);
    CHECK(*std::max_element(errors.begin(), errors.end()) <= 1.0);
    // What no screen shows makes no difference.
    CHECK(tests::flip(size, flat(glm::dvec3(1.0)), flat(glm::dvec3(7.0)))[0] == 0.0);
}

} // namespace

int main()
{
    testAgainstTheAuthors();
    testLaws();
}
