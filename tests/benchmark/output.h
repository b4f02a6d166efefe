// The files of a run: benchmark.csv, README.md and the plots.
#pragma once

#include "report.h"

#include <filesystem>

namespace tests::benchmark {

// Throws mirrorball::Error, unwritable.
void makeFolder(const std::filesystem::path& folder);
void writeFiles(const std::filesystem::path& folder, const std::vector<Row>& rows,
                const Circumstances& circumstances);

} // namespace tests::benchmark
