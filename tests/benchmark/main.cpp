// benchmark: run time against error of every map and method, beside hand-written cube maps, in one run.
#include "command_line.h"
#include "environment.h"
#include "findings.h"
#include "freed_memory.h"
#include "look_up_run.h"
#include "mirror_contender.h"
#include "output.h"
#include "plan.h"
#include "run.h"

#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <algorithm>
#include <iostream>

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
}

void printChecks(const std::vector<Row>& rows)
{
    for (const RivalCheck& check : rivalChecksOf(rows))
        std::cout << "rival check, " << check.scene
                  << (check.vertices == Vertices::own ? ", own vertices" : "") << ": culled / plain "
                  << check.measured << ", expected " << check.expected
                  << (check.isKept() ? ": kept\n" : ": NOT KEPT\n");
}

void measureAll(const Options& options, Circumstances circumstances)
{
    circumstances.revision = revision();
    std::vector<Group> plan;
    std::vector<LookUpGroup> lookUpPlan;
    if (options.part != Part::lookUps)
        plan = makePlan(options, circumstances.missingScenes);
    if (options.part != Part::captures)
        lookUpPlan = makeLookUpPlan(options, circumstances.missingScenes);
    if (plan.empty() && lookUpPlan.empty())
        throw mirrorball::Error(mirrorball::ErrorKind::notFound, "the scenes of a benchmark",
                                "none of their files is there", "install assimp-testmodels and glmark2-data");
    Results results;
    Progress progress(stepsOf(plan, options.frames) + stepsOf(lookUpPlan, options.frames));
    results.captures = run(plan, options.frames, progress, [&](const std::vector<Row>& rows) {
        writeFiles(options.folder, {rows, {}}, circumstances);
    });
    results.lookUps =
        runLookUps(lookUpPlan, options.frames, progress, [&](const std::vector<LookUpRow>& rows) {
            writeFiles(options.folder, {results.captures, rows}, circumstances);
        });
    circumstances.isComplete = true;
    writeFiles(options.folder, results, circumstances);
    printChecks(results.captures);
}

void runAll(const Options& options, const std::string& command)
{
    requireAllowed(options);
    makeFolder(options.folder);
    keepFreedMemory();
    const mirrorball::headless::Context context;
    measureAll(options, {context.description(), command, options.frames, {}});
    std::cout << options.folder << "/README.md\n";
}

// As it was called, without the folder.
std::string commandOf(int argc, char** argv)
{
    std::string command = "benchmark";
    for (int index = 1; index < argc; ++index) {
        const std::string word = argv[index];
        const bool isFolder = word.starts_with("-o") || word.starts_with("--output");
        index += word == "-o" || word == "--output" ? 1 : 0;
        command += isFolder ? "" : " " + word;
    }
    return command;
}

// An option that may be given several times, each time one of the names.
template <class Value>
void addList(CLI::App& app, const std::string& name, std::vector<Value>& values,
             const std::vector<std::pair<std::string, Value>>& known, const std::string& description)
{
    std::vector<std::string> names;
    for (const auto& [word, meaning] : known)
        names.push_back(word);
    const std::string list = examples::joined(names);
    app.add_option_function<std::vector<std::string>>(
           name,
           [&values, known, name, list](const std::vector<std::string>& words) {
               for (const std::string& word : words) {
                   const auto found = std::find_if(known.begin(), known.end(),
                                                   [&](const auto& each) { return each.first == word; });
                   if (found == known.end())
                       throw CLI::ConversionError(name + ": '" + word + "' is unknown; it is one of " + list);
                   values.push_back(found->second);
               }
           },
           description + ", once for each: " + list)
        ->default_str("all")
        ->allow_extra_args(false);
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app{"Measures what a map of the surroundings costs and how right it is: every map and method of "
                 "the library, beside cube maps written by hand."};
    app.name("benchmark");
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
    app.add_flag("--quick", options.quick, "fewer scenes, maps and frames: within two minutes");
    const std::vector<std::pair<std::string, Part>> parts = {
        {"both", Part::both}, {"captures", Part::captures}, {"look-ups", Part::lookUps}};
    examples::addChoice(app, "--part", options.part, parts, "what is measured");
    addList(app, "--scene", options.scenes, scenes, "a scene");
    addList(app, "--map", options.maps, maps, "a map");
    addList(app, "--method", options.methods, methods, "a method");
    app.add_option("--size", options.sizes,
                   "n of the cube map, once for each (default: 256, 64, 128, 512, 1024)")
        ->allow_extra_args(false);
    CLI::Option* const frames =
        examples::addInteger(app, "--frames", options.frames, "measured frames of each contender");
    frames->default_str("30, 8 where quick");
    app.add_option("-o,--output", options.folder, "writes README.md, benchmark.csv and plots into it")
        ->required()
        ->type_name("DIR");
    return examples::runProgram(app, argc, argv, [&] {
        if (frames->count() == 0)
            options.frames = options.quick ? quickFrames : fullFrames;
        runAll(options, commandOf(argc, argv));
    });
}
