// All rows as comma-separated values, one line each, units in the column names.
#pragma once

#include "look_up_run.h"
#include "run.h"

#include <iosfwd>

namespace tests::benchmark {

void writeCsv(std::ostream& out, const std::vector<Row>& rows);
void writeCsv(std::ostream& out, const std::vector<LookUpRow>& rows);

} // namespace tests::benchmark
