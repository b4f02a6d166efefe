// The summary in Markdown: what is won and lost, and every table behind it.
#pragma once

#include "results.h"

#include <iosfwd>

namespace tests::benchmark {

void writeReport(std::ostream& out, const Results& results, const Circumstances& circumstances);

} // namespace tests::benchmark
