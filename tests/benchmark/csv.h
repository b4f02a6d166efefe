// All rows as comma-separated values, one line each, units in the column names; and back.
#pragma once

#include "look_up_run.h"
#include "run.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace tests::benchmark {

void writeCsv(std::ostream& out, const std::vector<Row>& rows);
void writeCsv(std::ostream& out, const std::vector<LookUpRow>& rows);

// What writeCsv wrote, with the six digits that it gives. `name` is the file's, for the message of mirrorball::Error,
// badFile: a column is not there, a row names no known scene, map or method, or has something else than numbers. Columns
// of other names are passed over.
std::vector<Row> readCaptures(std::istream& in, const std::string& name);
std::vector<LookUpRow> readLookUps(std::istream& in, const std::string& name);

} // namespace tests::benchmark
