#include "output.h"

#include "csv.h"
#include "plot.h"
#include "report.h"

#include <mirrorball/error.h>

#include <fstream>
#include <functional>

namespace tests::benchmark {

namespace {

void requireWritten(bool isWritten, const std::filesystem::path& path)
{
    if (!isWritten)
        throw mirrorball::Error(mirrorball::ErrorKind::unwritable, "the report in '" + path.string() + "'",
                                "it cannot be written", "name a folder that can");
}

void writeFile(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write)
{
    // Whole or not at all: it may replace the only copy of rows that it holds.
    const std::filesystem::path unfinished = path.string() + ".part";
    std::ofstream out(unfinished);
    write(out);
    requireWritten(static_cast<bool>(out.flush()), path);
    std::error_code problem;
    std::filesystem::rename(unfinished, path, problem);
    requireWritten(!problem, path);
}

} // namespace

void makeFolder(const std::filesystem::path& folder)
{
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    requireWritten(!problem && std::filesystem::is_directory(folder), folder);
}

void writeFiles(const std::filesystem::path& folder, const Results& results,
                const Circumstances& circumstances, std::string_view changedScene)
{
    if (!results.captures.empty())
        writeFile(folder / "benchmark.csv", [&](std::ostream& out) { writeCsv(out, results.captures); });
    if (!results.lookUps.empty())
        writeFile(folder / "look_ups.csv", [&](std::ostream& out) { writeCsv(out, results.lookUps); });
    const auto hasChanged = [&](const auto& scene) {
        return changedScene.empty() || changedScene == sceneOf(scene.front());
    };
    for (const std::span<const Row> scene : byScene(results.captures))
        if (hasChanged(scene)) {
            writePlots(folder, scene);
            writeFile(folder / pageOf(scene), [&](std::ostream& out) { writeScene(out, scene); });
        }
    for (const std::span<const LookUpRow> scene : byScene(results.lookUps))
        if (hasChanged(scene))
            writePlots(folder, scene);
    writeFile(folder / "README.md", [&](std::ostream& out) { writeReport(out, results, circumstances); });
}

} // namespace tests::benchmark
