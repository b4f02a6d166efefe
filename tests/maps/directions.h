// Directions that are hard on a map: from everywhere, on axes, poles and seams and a few ulp beside them,
// tiny and huge. The same for float and double, from fixed seeds.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace tests {

template <class Number>
using Direction = glm::vec<3, Number, glm::defaultp>;

// x, moved by so many representable numbers.
template <class Number>
Number movedByUlp(Number x, int steps)
{
    const Number target =
        steps < 0 ? -std::numeric_limits<Number>::infinity() : std::numeric_limits<Number>::infinity();
    for (int i = std::abs(steps); i > 0; --i)
        x = std::nextafter(x, target);
    return x;
}

// A direction on a seam or an axis of some map, of about unit size: two coordinates equal, one zero, one at
// sqrt(1/2) of the length, or one that the others dwarf.
template <class Number>
Direction<Number> directionOnSeam(std::mt19937& random)
{
    std::uniform_real_distribution<Number> between(-1, 1);
    const auto sign = [&] { return Number(random() % 2 == 0 ? 1 : -1); };
    std::array<Number, 3> d{between(random), between(random), between(random)};
    const std::size_t i = random() % 3;
    const std::size_t j = (i + 1 + random() % 2) % 3;
    const std::size_t k = 3 - i - j;
    switch (random() % 5) {
    case 0:
        d[i] = sign() * std::abs(d[j]);
        break;
    case 1:
        d[i] = 0;
        break;
    case 2:
        d[i] = sign() * std::sqrt(d[j] * d[j] + d[k] * d[k]);
        break;
    case 3:
        d[i] = sign();
        d[j] = std::ldexp(d[j], -static_cast<int>(random() % 40));
        d[k] = std::ldexp(d[k], -static_cast<int>(random() % 40));
        break;
    default:
        d[i] = sign();
        d[j] = d[k] = 0;
    }
    return {d[0], d[1], d[2]};
}

// Each coordinate up to four ulp beside where it was.
template <class Number>
Direction<Number> nudged(Direction<Number> d, std::mt19937& random)
{
    for (int i = 0; i < 3; ++i)
        d[i] = movedByUlp(d[i], static_cast<int>(random() % 9) - 4);
    return d;
}

// 10^exponent times d, each coordinate by itself where `apart`, sizes from 1e-37 to 1e38.
template <class Number>
Direction<Number> scaled(const Direction<Number>& d, bool apart, std::mt19937& random)
{
    std::uniform_real_distribution<Number> exponent(-37, 38);
    const Number common = std::pow(Number(10), exponent(random));
    Direction<Number> result;
    for (int i = 0; i < 3; ++i)
        result[i] = d[i] * (apart ? std::pow(Number(10), exponent(random)) : common);
    return result;
}

template <class Number>
std::vector<Direction<Number>> hardDirections(int count)
{
    std::mt19937 random(20240607);
    std::normal_distribution<Number> normal;
    std::vector<Direction<Number>> result;
    // All sign patterns: axes, edges and corners of the cube, with both zeros.
    for (int pattern = 0; pattern < 64; ++pattern) {
        constexpr std::array<Number, 4> values{Number(0), Number(-0.0), Number(1), Number(-1)};
        const auto value = [&](int digit) {
            return values[static_cast<std::size_t>(pattern >> 2 * digit) % 4];
        };
        if (value(0) != 0 || value(1) != 0 || value(2) != 0)
            result.emplace_back(value(0), value(1), value(2));
    }
    while (result.size() < static_cast<std::size_t>(count)) {
        const Direction<Number> anywhere(normal(random), normal(random), normal(random));
        const Direction<Number> seam = directionOnSeam<Number>(random);
        result.push_back(anywhere);
        result.push_back(seam);
        result.push_back(nudged(seam, random));
        result.push_back(scaled(anywhere, false, random));
        result.push_back(scaled(anywhere, true, random));
        result.push_back(scaled(nudged(seam, random), false, random));
    }
    return result;
}

} // namespace tests
