// The Pareto plots of the report.
#pragma once

#include "results.h"

#include <filesystem>
#include <vector>

namespace tests::benchmark {

// Of a scene's rows, <scene>_<what>.svg and .png: at the cube's n of the first group and with back faces drawn, cost of
// pass 1 against wrong texels, and against the worst texel's angle.
void writePlots(const std::filesystem::path& folder, std::span<const Row> scene);

// Cost of both passes against the errors of the picture.
void writePlots(const std::filesystem::path& folder, std::span<const LookUpRow> scene);

// The names, without ending, of a scene's plots that have a mark.
std::vector<std::string> plotNames(std::span<const Row> scene);
std::vector<std::string> plotNames(std::span<const LookUpRow> scene);

} // namespace tests::benchmark
