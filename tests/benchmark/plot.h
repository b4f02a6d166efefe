// Pareto plots: what a contender costs, against how far it is off.
#pragma once

#include "run.h"

#include <filesystem>
#include <vector>

namespace tests::benchmark {

// For each scene, at the cube's n of its first group and with back faces drawn: CPU time against wrong
// texels, and against the worst texel's angle. Writes <scene>_<what>.svg and .png into the folder; returns
// the names without ending.
std::vector<std::string> writePlots(const std::filesystem::path& folder, const std::vector<Row>& rows);

} // namespace tests::benchmark
