// All that a report has.
#pragma once

#include "look_up_run.h"
#include "run.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tests::benchmark {

struct Results
{
    std::vector<Row> captures;      // pass 1
    std::vector<LookUpRow> lookUps; // both passes
};

struct Circumstances
{
    std::string driver;
    std::string command; // what was asked for
    int frames;
    std::vector<std::string> missingScenes;
    bool isComplete = false; // all that was asked for is measured
    std::string run = {};    // as its rows call it
};

inline std::string_view sceneOf(const Row& row)
{
    return row.group.scene->name;
}

inline std::string_view sceneOf(const LookUpRow& row)
{
    return row.scene->name;
}

// Rows of a scene stand together.
template <class RowType>
std::vector<std::span<const RowType>> byScene(const std::vector<RowType>& rows)
{
    std::vector<std::span<const RowType>> scenes;
    for (auto first = rows.begin(); first != rows.end();) {
        const auto after = std::find_if(first, rows.end(),
                                        [&](const RowType& row) { return sceneOf(row) != sceneOf(*first); });
        scenes.emplace_back(first, after);
        first = after;
    }
    return scenes;
}

} // namespace tests::benchmark
