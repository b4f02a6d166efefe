// The Pareto plots of the report.
#pragma once

#include "results.h"

#include <filesystem>
#include <vector>

namespace tests::benchmark {

// Of each scene, <scene>_<what>.svg and .png: at the cube's n of its first group and with back faces drawn, cost of
// pass 1 against wrong texels, and against the worst texel's angle.
void writePlots(const std::filesystem::path& folder, const std::vector<Row>& rows);

// Of each scene with a mirror: cost of both passes against the errors of the picture.
void writePlots(const std::filesystem::path& folder, const std::vector<LookUpRow>& rows);

// The names, without ending, of a scene's plots that have a mark.
std::vector<std::string> plotNames(std::span<const Row> scene);
std::vector<std::string> plotNames(std::span<const LookUpRow> scene);

} // namespace tests::benchmark
