// What a report says about the machine and the code it was made with.
#pragma once

#include <string>

namespace tests::benchmark {

std::string processor(); // "2 x AMD EPYC": the cores that the program may use, and their model

// What a run that begins now is called: "2024-05-31 09:45:10, revision 5eb984c", in UTC; the source tree's by git, or
// "unknown".
std::string runName();

} // namespace tests::benchmark
