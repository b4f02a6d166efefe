// The Pareto plots of the report.
#pragma once

#include "look_up_run.h"
#include "run.h"

#include <filesystem>
#include <vector>

namespace tests::benchmark {

// The plots of the last scene in the rows, <scene>_<what>.svg and .png: at the cube's n of its first group and with
// back faces drawn, cost of pass 1 against wrong texels, and against the worst texel's angle.
void writePlots(const std::filesystem::path& folder, const std::vector<Row>& rows);

// Of the last scene with a mirror: cost of both passes against the errors of the picture.
void writePlots(const std::filesystem::path& folder, const std::vector<LookUpRow>& rows);

// The names, without ending, of all scenes' plots.
std::vector<std::string> plotNames(const std::vector<Row>& rows);
std::vector<std::string> plotNames(const std::vector<LookUpRow>& rows);

} // namespace tests::benchmark
