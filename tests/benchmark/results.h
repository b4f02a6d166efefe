// All that a run has measured so far.
#pragma once

#include "look_up_run.h"
#include "run.h"

#include <string>
#include <vector>

namespace tests::benchmark {

struct Results
{
    std::vector<Row> captures;      // pass 1
    std::vector<LookUpRow> lookUps; // both passes
};

struct Circumstances
{
    std::string driver;
    std::string command; // what was asked for
    int frames;
    std::vector<std::string> missingScenes;
    bool isComplete = false;   // all that was asked for is measured
    std::string revision = {}; // when it began: a run of hours may see commits
};

} // namespace tests::benchmark
