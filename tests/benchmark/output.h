// The files of a run: benchmark.csv, look_ups.csv, README.md, a page of tables for each scene, and the plots.
#pragma once

#include "results.h"

#include <filesystem>
#include <string_view>

namespace tests::benchmark {

// Throws mirrorball::Error, unwritable.
void makeFolder(const std::filesystem::path& folder);

// Summary, tables and plots: called after every group, so that a run that is cut off leaves a whole report of what it
// did. Plots take a while; where a scene is named, only its are drawn.
void writeFiles(const std::filesystem::path& folder, const Results& results,
                const Circumstances& circumstances, std::string_view changedScene = {});

} // namespace tests::benchmark
