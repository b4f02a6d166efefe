// What the rows say: whether the rivals are well built, which aims are reached, where we win and lose.
#pragma once

#include "run.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tests::benchmark {

// Six culled passes over six plain ones, against a ratio measured with other code.
struct RivalCheck
{
    std::string scene;
    Vertices vertices;
    double measured, expected;
    double nanosecondsAnUnseenTriangle; // that plain passes take longer, a triangle that only they send

    double deviation() const { return measured / expected - 1.0; }
    bool isKept() const { return deviation() > -0.15 && deviation() < 0.15; }
};
std::vector<RivalCheck> rivalChecksOf(const std::vector<Row>& rows);

// An aim of the project.
struct AimInfo
{
    const char* what;
    double limit;
    bool atLeast; // or else at most

    bool isReached(double measured) const { return atLeast ? measured >= limit : measured <= limit; }
};
inline constexpr std::size_t aimCount = 7;
std::span<const AimInfo, aimCount> aimInfos();

// What a scene has of them, at n = 256 or the smallest size that was run; empty where it was not measured. Scenes with
// none are left out.
struct Aims
{
    std::string scene;
    std::array<std::optional<double>, aimCount> measured; // in the order of aimInfos()
};
std::vector<Aims> aimsOf(const std::vector<Row>& rows);

// From the best cube by hand to the library's tennis-ball map step by step, where `automatic` misses its aims on cost.
struct ProfileLine
{
    std::string what;
    const Row* row;
};
struct Profile
{
    std::string scene;
    std::vector<ProfileLine> lines;
};
std::vector<Profile> profilesOf(const std::vector<Row>& rows);

// A map is right where no more texels than this are wrong.
inline constexpr double rightPercent = 0.01;

// In one group: the library's cheapest right map with no texel wider than the cube's.
struct Finding
{
    const Row* best;

    // Quartiles of a shared machine lie some 5 % apart.
    std::string verdict() const
    {
        return best->costRatioToBest < 0.95 ? "won" : best->costRatioToBest > 1.05 ? "**lost**" : "even";
    }
};
std::vector<Finding> findingsOf(const std::vector<Row>& rows);

} // namespace tests::benchmark
