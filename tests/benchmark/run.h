// Runs a plan: every number of the report comes from here.
#pragma once

#include "errors.h"
#include "plan.h"
#include "progress.h"
#include "timing.h"

#include <mirrorball/maps/measures.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tests::benchmark {

struct Row
{
    Group group; // without its entries
    Entry entry;
    std::size_t sceneTriangles = 0, sceneVertices = 0;
    mirrorball::MapMeasures measures; // of the map at the entry's n
    Timing timing;
    Quartiles costBeforeRasteriser; // of frames whose draws end before it
    WorkCounts work;
    std::optional<Errors> errors; // not of the 8-bit rivals
    // Medians over those of the culled six-pass cube in the same group; the cost also over that of the cheapest
    // hand-written cube there.
    double cpuRatio = 0, wallRatio = 0, costRatioToBest = 0;
    std::optional<double> gpuRatio;
    // When and at which revision the run began that drew it, and the one that told its errors.
    std::string run = {}, errorsRun = {};

    double cost() const { return timing.cost().median; }
    double costRatio() const { return gpuRatio.value_or(cpuRatio); }
};

// `name` is what the rows call the run. `afterGroup` is called with all rows so far.
std::vector<Row> run(const std::vector<Group>& plan, int frames, const std::string& name, Progress& progress,
                     const std::function<void(const std::vector<Row>&)>& afterGroup);

// The steps that run() will report for a plan.
double stepsOf(const std::vector<Group>& plan, int frames);

// Tells the errors of rows anew, whose times stay: of those that have errors, and that the options ask for by scene,
// map, method and size. Rows of scenes whose file is not there stay as they are. `afterGroup` is called with a scene's
// name after each of its sizes.
void judge(std::vector<Row>& rows, const Options& options, const std::string& name, Progress& progress,
           const std::function<void(std::string_view)>& afterGroup);

// The steps that judge() will report.
double judgeSteps(const std::vector<Row>& rows, const Options& options);

} // namespace tests::benchmark
