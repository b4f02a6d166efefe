// Rows of several runs in one report. Their ratios stay those to the rivals of their own runs.
#pragma once

#include "results.h"

#include <string>
#include <vector>

namespace tests::benchmark {

// The rows of both by scene, size and contender; where both have a row of the same contender, the later one.
Results merged(Results earlier, const Results& later);

// Those of earlier reports, merged in this order. Throws mirrorball::Error, notFound or badFile.
Results readReports(const std::vector<std::string>& folders);

} // namespace tests::benchmark
