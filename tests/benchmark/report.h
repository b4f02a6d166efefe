// The summary in Markdown: what is won and lost, and every table behind it.
#pragma once

#include "run.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace tests::benchmark {

struct Circumstances
{
    std::string driver;
    std::string command; // what was asked for
    int frames;
    std::vector<std::string> missingScenes;
};

void writeReport(std::ostream& out, const std::vector<Row>& rows, const Circumstances& circumstances,
                 const std::vector<std::string>& plots);

} // namespace tests::benchmark
