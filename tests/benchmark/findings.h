// What the rows say: whether the rivals are well built, which aims are reached, where we win and lose.
#pragma once

#include "run.h"

#include <string>
#include <vector>

namespace tests::benchmark {

// Six culled passes over six plain ones, against a ratio measured with other code.
struct RivalCheck
{
    std::string scene;
    double measured, expected;

    double deviation() const { return measured / expected - 1.0; }
    bool isKept() const { return deviation() > -0.15 && deviation() < 0.15; }
};
std::vector<RivalCheck> rivalChecksOf(const std::vector<Row>& rows);

// An aim of the project in one scene, at n = 256 or the first size that was run.
struct Aim
{
    std::string scene, what;
    double measured, limit;
    bool atLeast = false;

    bool isReached() const { return atLeast ? measured >= limit : measured <= limit; }
};
std::vector<Aim> aimsOf(const std::vector<Row>& rows);

// A map is right where no more texels than this are wrong.
inline constexpr double rightPercent = 0.01;

// In one group: the library's cheapest right map with no texel wider than the cube's.
struct Finding
{
    const Row* best;

    // Quartiles of a shared machine lie some 5 % apart.
    std::string verdict() const
    {
        return best->cpuRatioToBest < 0.95 ? "won" : best->cpuRatioToBest > 1.05 ? "**lost**" : "even";
    }
};
std::vector<Finding> findingsOf(const std::vector<Row>& rows);

} // namespace tests::benchmark
