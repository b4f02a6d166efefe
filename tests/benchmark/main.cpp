// benchmark: run time against error of every map and method, beside hand-written cube maps.
#include "command_line.h"
#include "environment.h"
#include "findings.h"
#include "freed_memory.h"
#include "look_up_run.h"
#include "merge.h"
#include "mirror_contender.h"
#include "output.h"
#include "plan.h"
#include "run.h"

#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>
#include <string_view>

namespace {

using namespace tests::benchmark;

constexpr int fullFrames = 30;
constexpr int quickFrames = 8;
// All contenders of a scene are in memory at once: at this size some 10 GB.
constexpr int largestN = 2048;

void requireAllowed(const Options& options)
{
    for (const int size : options.sizes)
        if (size < 1 || size > largestN)
            throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--size " + std::to_string(size),
                                    "the benchmark draws cubes of 1 to " + std::to_string(largestN) +
                                        " texels across",
                                    "ask for a size in that range");
    if (options.frames < 1)
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--frames", "it is less than 1",
                                "give 1 or more");
    if ((options.part == Part::errors || options.part == Part::nothing) && options.from.empty())
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--part",
                                "there are no rows without a report that brings them", "name it with --from");
    const bool isChosen = options.quick || !options.scenes.empty() || !options.maps.empty() ||
                          !options.methods.empty() || !options.sizes.empty();
    if (options.part == Part::nothing && isChosen)
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--part nothing",
                                "it joins whole reports",
                                "leave out what chooses scenes, maps, methods or sizes");
}

void printChecks(const std::vector<Row>& rows)
{
    for (const RivalCheck& check : rivalChecksOf(rows))
        std::cout << "rival check, " << check.scene
                  << (check.vertices == Vertices::own ? ", own vertices" : "") << ": culled / plain "
                  << check.measured << ", expected " << check.expected
                  << (check.isKept() ? ": kept\n" : ": NOT KEPT\n");
}

// Their ratios are to cubes that were drawn by a renderer of the same kind.
void requireSameKind(const Results& earlier)
{
    const auto isOther = [](const std::string& costsOf) { return costsOf != costName(); };
    const auto costsOf = [](const Row& row) { return std::string(row.timing.gpu ? "GPU" : "CPU"); };
    if (std::ranges::any_of(earlier.captures, isOther, costsOf) ||
        std::ranges::any_of(earlier.lookUps, isOther, &LookUpRow::costsOf))
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--from",
                                std::string("it has other times than the ") + costName() +
                                    "'s, by which this renderer's costs are told",
                                "join reports of one renderer");
}

bool isMeasured(Part part, const Options& options)
{
    return options.part == Part::both || options.part == part;
}

using WriteReport = std::function<void(const Results& now, std::string_view changedScene)>;

Results measured(const Options& options, Circumstances& circumstances, const WriteReport& write)
{
    std::vector<Group> plan;
    std::vector<LookUpGroup> lookUpPlan;
    if (isMeasured(Part::captures, options))
        plan = makePlan(options, circumstances.missingScenes);
    if (isMeasured(Part::lookUps, options))
        lookUpPlan = makeLookUpPlan(options, circumstances.missingScenes);
    if (plan.empty() && lookUpPlan.empty() && circumstances.missingScenes.empty())
        throw mirrorball::Error(
            mirrorball::ErrorKind::badArgument, "--scene", "none that was asked for is one of this --part's",
            "look-ups are in room, garden, house and bathroom, captures in all but bathroom");
    if (plan.empty() && lookUpPlan.empty())
        throw mirrorball::Error(mirrorball::ErrorKind::notFound, "the scenes of a benchmark",
                                "none of their files is there", "install assimp-testmodels and glmark2-data");
    Results now;
    Progress progress(stepsOf(plan, options.frames) + stepsOf(lookUpPlan, options.frames));
    now.captures = run(plan, options.frames, circumstances.run, progress, [&](const std::vector<Row>& rows) {
        write({rows, {}}, sceneOf(rows.back()));
    });
    now.lookUps = runLookUps(lookUpPlan, options.frames, circumstances.run, progress,
                             [&](const std::vector<LookUpRow>& rows) {
                                 write({now.captures, rows}, sceneOf(rows.back()));
                             });
    return now;
}

void judgeAgain(std::vector<Row>& rows, const Options& options, Circumstances& circumstances,
                const WriteReport& write)
{
    for (const SceneChoice& scene : sceneChoices())
        if (!isThere(scene))
            circumstances.missingScenes.push_back(std::string(scene.name));
    const double steps = judgeSteps(rows, options);
    if (!(steps > 0.0))
        throw mirrorball::Error(mirrorball::ErrorKind::notFound, "--part errors",
                                "no row of the reports is one that was asked for and can be drawn here",
                                "ask for scenes, maps, methods and sizes that they have");
    Progress progress(steps);
    judge(rows, options, circumstances.run, progress, [&](std::string_view scene) { write({}, scene); });
}

void report(const Options& options, Circumstances circumstances)
{
    Results earlier = readReports(options.from);
    requireSameKind(earlier);
    const auto write = [&](const Results& now, std::string_view changedScene) {
        writeFiles(options.folder, merged(earlier, now), circumstances, changedScene);
    };
    Results now;
    if (options.part == Part::errors)
        judgeAgain(earlier.captures, options, circumstances, write);
    else if (options.part != Part::nothing)
        now = measured(options, circumstances, write);
    circumstances.isComplete = true;
    write(now, {});
    printChecks(now.captures);
}

void runAll(const Options& options, const std::string& command)
{
    requireAllowed(options);
    makeFolder(options.folder);
    keepFreedMemory();
    const mirrorball::headless::Context context;
    report(options, {context.description(), command, options.frames, {}, false, runName()});
    std::cout << options.folder << "/README.md\n";
}

// As it was called, without the folders' names.
std::string commandOf(int argc, char** argv)
{
    std::string command = "benchmark", from;
    for (int index = 1; index < argc; ++index) {
        const std::string word = argv[index];
        if (word.starts_with("-o") || word.starts_with("--output")) {
            index += word == "-o" || word == "--output" ? 1 : 0;
        } else if (word.starts_with("--from")) {
            index += word == "--from" ? 1 : 0;
            from = " --from DIR…";
        } else {
            command += " " + word;
        }
    }
    return command + from;
}

void addOptions(CLI::App& app, Options& options, std::optional<int>& frames)
{
    std::vector<std::pair<std::string, std::string>> scenes, methods;
    for (const SceneChoice& scene : sceneChoices())
        scenes.emplace_back(scene.name, scene.name);
    for (const MirrorScene& scene : mirrorScenes())
        if (std::ranges::none_of(scenes, [&](const auto& each) { return each.first == scene.name; }))
            scenes.emplace_back(scene.name, scene.name);
    for (const LibraryMethod& method : libraryMethods())
        methods.emplace_back(method.name, method.name);
    std::vector<std::pair<std::string, mirrorball::MapKind>> maps;
    for (const mirrorball::MapInfo& info : mirrorball::maps())
        maps.emplace_back(info.name, info.kind);
    const std::vector<std::pair<std::string, Part>> parts = {{"both", Part::both},
                                                             {"captures", Part::captures},
                                                             {"look-ups", Part::lookUps},
                                                             {"errors", Part::errors},
                                                             {"nothing", Part::nothing}};

    using namespace examples;
    addFlag(app, "--quick", options.quick, "fewer scenes, maps and frames: within two minutes");
    addChoice(app, "--part", options.part, parts,
              "what is measured: errors judges the rows of --from again, nothing only joins them");
    addChoices(app, "--scene", options.scenes, scenes, "a scene");
    addChoices(app, "--map", options.maps, maps, "a map");
    addChoices(app, "--method", options.methods, methods, "a method");
    addIntegers(app, "--size", options.sizes, "n of the cube map", "256, 64, 128, 512, 1024");
    addOptionalInteger(app, "--frames", frames, "measured frames of each contender", "30, 8 where quick");
    addTexts(app, "--from", options.from, "DIR",
             "an earlier report whose rows this one takes over, but for what it measures itself");
    addRequiredText(app, "-o,--output", options.folder, "DIR",
                    "writes README.md, a page a scene, benchmark.csv, look_ups.csv and plots into it");
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    std::optional<int> frames;
    return examples::runProgram(
        "benchmark",
        "Measures what a map of the surroundings costs and how right it is: every map and method of the "
        "library, beside cube maps written by hand.",
        argc, argv, [&](CLI::App& app) { addOptions(app, options, frames); },
        [&] {
            options.frames = frames.value_or(options.quick ? quickFrames : fullFrames);
            runAll(options, commandOf(argc, argv));
        });
}
