// What a report says about the machine and the code it was made with.
#pragma once

#include <string>

namespace tests::benchmark {

std::string processor(); // "2 x AMD EPYC": the cores that the program may use, and their model
std::string today();     // "2024-05-31", UTC
std::string revision();  // of the source tree, by git; "unknown" without it

} // namespace tests::benchmark
