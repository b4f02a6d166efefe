// benchmark: run time against error of every map and method, beside hand-written cube maps, in one run.
#include "command_line.h"
#include "csv.h"
#include "plan.h"
#include "run.h"

#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using namespace tests::benchmark;

void runAll(const Options& options)
{
    const mirrorball::headless::Context context;
    std::vector<std::string> missing;
    const std::vector<Group> plan = makePlan(options, missing);
    const int frames = options.frames > 0 ? options.frames : options.quick ? 8 : 30;
    Progress progress(stepsOf(plan, frames));
    const std::vector<Row> rows = run(plan, frames, progress);
    std::filesystem::create_directories(options.folder);
    std::ofstream file(std::filesystem::path(options.folder) / "benchmark.csv");
    writeCsv(file, rows);
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app{"Measures what a map costs and how right it is."};
    app.name("benchmark");
    app.add_flag("--quick", options.quick, "fewer scenes, maps and frames: two minutes");
    app.add_option("--scene", options.scenes, "scene");
    app.add_option("--method", options.methods, "method");
    app.add_option("--size", options.sizes, "the cube map's n");
    app.add_option("--frames", options.frames, "frames");
    app.add_option("-o,--output", options.folder, "folder")->required()->type_name("DIR");
    return examples::runProgram(app, argc, argv, [&] { runAll(options); });
}
