// Which look-ups are measured against which: groups of contenders whose frames are drawn in turn.
#pragma once

#include "mirror_contender.h"
#include "plan.h"

#include <vector>

namespace tests::benchmark {

struct LookUpGroup
{
    const MirrorScene* scene;
    int cubeN; // maps have as many texels as a cube of this size
    // The first is the cube by hand, looked up as infinitely far, at n = 256 in every group: what all costs are told
    // in.
    std::vector<MirrorEntry> entries;
};

std::string_view nameOf(mirrorball::Lookup lookup);

// Scenes whose file is not there are left out and named in `missing`.
std::vector<LookUpGroup> makeLookUpPlan(const Options& options, std::vector<std::string>& missing);

} // namespace tests::benchmark
