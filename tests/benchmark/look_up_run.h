// Both passes and the picture: what each look-up costs and how right it is.
#pragma once

#include "look_up_plan.h"
#include "progress.h"
#include "timing.h"

#include <functional>
#include <vector>

namespace tests::benchmark {

struct LookUpRow
{
    const MirrorScene* scene;
    int cubeN;
    MirrorEntry entry;
    // Milliseconds a frame. Costs (costName()) of the map, of the reflector's pixels alone, of both; wall time of the
    // whole frame, which is the map, the scene and the reflector.
    Quartiles capture, mirror, both, frameWall;
    std::size_t frames = 0; // measured
    double ratio = 0;       // both, over that of the group's first
    ParallaxErrors errors{};
    std::string costsOf = {}; // costName() where it was measured
    std::string run = {};     // as a Row's

    double framesPerSecond() const { return 1e3 / frameWall.median; }
};

// `name` is what the rows call the run. `afterGroup` is called with all rows so far.
std::vector<LookUpRow> runLookUps(const std::vector<LookUpGroup>& plan, int frames, const std::string& name,
                                  Progress& progress,
                                  const std::function<void(const std::vector<LookUpRow>&)>& afterGroup);

// The steps that runLookUps() will report for a plan.
double stepsOf(const std::vector<LookUpGroup>& plan, int frames);

} // namespace tests::benchmark
