// Measuring: frames of all contenders in turn, so that what else the machine does meets them alike.
#pragma once

#include "contender.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tests::benchmark {

struct Quartiles
{
    double lower = 0, median = 0, upper = 0;
};
Quartiles quartilesOf(std::vector<double> values); // at least one

struct Timing
{
    Quartiles wall, cpu;          // milliseconds a frame; CPU of all threads of the process
    std::optional<Quartiles> gpu; // GL_TIME_ELAPSED; not on software rasterisers, where it is wrong
    std::size_t frames = 0;       // measured

    // What contenders are compared by: GPU time where there is one.
    const Quartiles& cost() const { return gpu ? *gpu : cpu; }
};

// Milliseconds of one piece of work that ends with glFinish.
struct Sample
{
    double wall, cpu;
    std::optional<double> gpu;

    double cost() const { return gpu.value_or(cpu); }
};
Sample timed(const std::function<void()>& work);

// "CPU" or "GPU": whose time the current context's costs are.
const char* costName();

// `warmUp` frames that are not measured, at least one, then `frames`; of a contender of which so many would take longer
// than so many milliseconds fewer are drawn, but two. `afterEach` is called after every frame of one, drawn or not.
std::vector<Timing> measure(std::span<const std::unique_ptr<Contender>> contenders, int warmUp, int frames,
                            const std::function<void()>& afterEach, double millisecondsAContender = 6000.0);

// One frame's work as the driver counts it (pipeline statistics queries), apart from the timed frames.
struct WorkCounts
{
    Work sent;
    // Empty where the context has no such query.
    std::optional<std::size_t> vertexShaderRuns, primitivesClipped, fragmentShaderRuns;
};
WorkCounts countWork(Contender& contender);

} // namespace tests::benchmark
