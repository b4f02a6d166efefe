// All rows as comma-separated values, one line each, units in the column names.
#pragma once

#include "run.h"

#include <iosfwd>

namespace tests::benchmark {

void writeCsv(std::ostream& out, const std::vector<Row>& rows);

} // namespace tests::benchmark
