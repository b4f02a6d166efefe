#include "report.h"

#include "environment.h"
#include "findings.h"
#include "look_up_report.h"
#include "number_text.h"
#include "plot.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <map>
#include <ostream>

namespace tests::benchmark {

namespace {

bool isJoined(const Results& results, const Circumstances& circumstances)
{
    const auto isEarlier = [&](const auto& row) { return row.run != circumstances.run; };
    return std::ranges::any_of(results.captures, isEarlier) ||
           std::ranges::any_of(results.lookUps, isEarlier);
}

void writeCircumstances(std::ostream& out, const Results& results, const Circumstances& circumstances)
{
    const bool joined = isJoined(results, circumstances);
    out << "# Run time against error\n\n"
        << "Written by `" << circumstances.command
        << "`. docs/benchmark.md says how to read and repeat it.\n\n"
        << "- " << circumstances.driver << "\n- " << processor() << "\n- " << circumstances.run;
    if (joined)
        out << ", joined with rows of [earlier runs](#runs)";
    out << "\n- medians of "
        << (joined ? "a contender's frames (column `frames` of the CSV files)"
                   : std::to_string(circumstances.frames) + " frames a contender")
        << ", drawn in turn; the ratios are to the culled six-pass cube of the same scene, size "
           "and "
           "back-face culling, and mean more than the times\n";
    if (!circumstances.isComplete)
        out << "- **cut off**: what follows is all that had been measured\n";
    for (const std::string& scene : circumstances.missingScenes)
        out << "- scene `" << scene << "` left out of this run: its file is not there\n";
    out << '\n';
}

// How many rows each run gave.
void writeRuns(std::ostream& out, const Results& results)
{
    struct Counts
    {
        std::size_t times = 0, errors = 0, lookUps = 0;
    };
    std::map<std::string, Counts> runs;
    for (const Row& row : results.captures) {
        ++runs[row.run].times;
        if (row.errors)
            ++runs[row.errorsRun].errors;
    }
    for (const LookUpRow& row : results.lookUps)
        ++runs[row.run].lookUps;
    out << "## Runs\n\nOf each contender stands the row of the report that was read last. Each row names its "
           "run in "
           "the CSV files, and of pass 1 the run that told its errors, which may be a later one: the "
           "machine's load "
           "does not change them.\n\n"
           "| run | rows with times of pass 1 | with errors of pass 1 | of look-ups |\n|---|---|---|---|\n";
    for (const auto& [name, counts] : runs)
        out << "| " << name << " | " << counts.times << " | " << counts.errors << " | " << counts.lookUps
            << " |\n";
    out << '\n';
}

void writeRivalCheck(std::ostream& out, const std::vector<RivalCheck>& checks)
{
    if (checks.empty())
        return;
    out << "## Whether the hand-written cube is well built\n\n"
        << costName()
        << " time of six culled passes over six plain "
           "ones, n = 256, "
           "8-bit formats, back faces culled, beside the ratio that an independent implementation had on a "
           "scene of "
           "the same kind. It must lie within 15 %, and depends on what a triangle costs that no face shows: "
           "there 25 to "
           "29 ns. Where no vertex is shared between triangles it is more than in the scene itself, and "
           "culling gains more.\n\n| scene | vertices | an unseen triangle, ns | "
           "culled / plain | "
           "independent | off by | |\n|---|---|---|---|---|---|---|\n";
    for (const RivalCheck& check : checks)
        out << "| " << check.scene << " | "
            << (check.vertices == Vertices::own ? "three a triangle" : "shared") << " | "
            << format("%.1f", check.nanosecondsAnUnseenTriangle) << " | " << format("%.2f", check.measured)
            << " | " << format("%.2f", check.expected) << " | "
            << format("%+.0f %%", 100.0 * check.deviation()) << " | "
            << (check.isKept() ? "kept" : "**not kept**") << " |\n";
    out << '\n';
}

// A row for each scene, a column for each aim.
void writeAims(std::ostream& out, const std::vector<Aims>& scenes)
{
    if (scenes.empty())
        return;
    out << "## Aims\n\nBest cube: the fastest by hand, with the same back faces culled; beside it the "
           "cheaper of both "
           "tennis-ball maps. Tessellated: at its "
           "coarsest "
           "setting, half a texel; where `exact` has no wrong texel, half a one counts. `exact` / "
           "`perVertex` is an aim "
           "of `crowd-200k` only. Missed aims are bold; – is what was not measured, or not in one run.\n\n| "
           "scene |";
    for (const AimInfo& info : aimInfos())
        out << ' ' << info.what << " |";
    out << "\n|---|";
    for (std::size_t column = 0; column < aimInfos().size(); ++column)
        out << "---|";
    out << "\n| aim |";
    for (const AimInfo& info : aimInfos())
        out << (info.atLeast ? " ≥ " : " ≤ ") << format("%.4g", info.limit) << " |";
    out << '\n';
    for (const Aims& aims : scenes) {
        out << "| " << aims.scene << " |";
        for (std::size_t column = 0; column < aimInfos().size(); ++column) {
            const std::optional<double>& measured = aims.measured[column];
            const std::string mark = measured && !aimInfos()[column].isReached(*measured) ? "**" : "";
            out << ' ' << (measured ? mark + format("%.4g", *measured) + mark : "–") << " |";
        }
        out << '\n';
    }
    out << '\n';
}

std::string nanosecondsAFragment(const Row& row)
{
    if (!row.work.fragmentShaderRuns || *row.work.fragmentShaderRuns == 0)
        return "";
    const double rest = row.cost() - row.costBeforeRasteriser.median;
    return format("%.1f", 1e6 * rest / static_cast<double>(*row.work.fragmentShaderRuns));
}

void writeProfiles(std::ostream& out, const std::vector<Profile>& profiles)
{
    if (profiles.empty())
        return;
    out << "## Where the time goes\n\nThe scenes where `automatic` misses an aim on cost. The library's own "
           "cube does "
           "what the one by hand does, so that the difference is what the library adds; `perVertex` is what "
           "the map "
           "costs, `automatic` and `exact` what being right does. Vertices: the time of the same draws where "
           "the "
           "rasteriser "
           "discards all, which leaves vertex and geometry shaders; the rest, over the fragment-shader runs, "
           "holds the "
           "triangles' set-up, too. Runs and triangles are what the driver counts in one "
           "frame.\n\n| scene | | "
        << costName()
        << " ms | best cube = 1 | of them vertices, ms | the rest, ns a fragment | "
           "draws | vertex-shader runs a vertex | triangles "
           "rasterised, of "
           "the scene's | fragment-shader runs a texel |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Profile& profile : profiles)
        for (const ProfileLine& line : profile.lines) {
            const Row& row = *line.row;
            const auto share = [](const std::optional<std::size_t>& count, std::size_t of) {
                return count ? format("%.2f", static_cast<double>(*count) / static_cast<double>(of)) : "";
            };
            out << "| " << profile.scene << " | " << line.what << " | " << milliseconds(row.cost()) << " | **"
                << format("%.2f", row.costRatioToBest) << "** | "
                << milliseconds(row.costBeforeRasteriser.median) << " | " << nanosecondsAFragment(row)
                << " | " << row.work.sent.draws << " | "
                << share(row.work.vertexShaderRuns, row.sceneVertices) << " | "
                << share(row.work.primitivesClipped, row.sceneTriangles) << " | "
                << share(row.work.fragmentShaderRuns, static_cast<std::size_t>(row.measures.texels))
                << " |\n";
        }
    out << '\n';
}

void writeFindings(std::ostream& out, const std::vector<Row>& rows)
{
    const std::vector<Finding> findings = findingsOf(rows);
    if (findings.empty())
        return;
    out << "## Where we win and where we lose\n\nThe cheapest map of the library that shows at most "
        << format("%g", rightPercent)
        << " % wrong texels and no texel wider than the cube's, against the cheapest hand-written cube.\n\n"
           "| scene | cube n | back faces | map, method | n | "
        << costName()
        << " time, best cube = 1 | wrong texels | |\n"
           "|---|---|---|---|---|---|---|---|\n";
    for (const Finding& finding : findings) {
        const Row& row = *finding.best;
        out << "| " << row.group.scene->name << " | " << row.group.cubeN << " | "
            << (row.group.cullBackFaces ? "culled" : "drawn") << " | "
            << mirrorball::mapInfo(row.entry.map).name << ", " << row.entry.methodName() << " | "
            << row.entry.n << " | " << format("%.2f", row.costRatioToBest) << " | "
            << format("%.4f %%", row.errors->wrongPercent) << " | " << finding.verdict() << " |\n";
    }
    out << '\n';
}

std::string cells(const Row& row)
{
    std::string text = "| " + std::string(row.entry.rival ? "by hand" : "mirrorball") + " | " +
                       std::string(mirrorball::mapInfo(row.entry.map).name) + " | " + row.entry.methodName() +
                       " | " + std::string(nameOf(row.entry.sizing)) + " | " + std::to_string(row.entry.n) +
                       " | " + format("%.4f", glm::degrees(row.measures.worstDiagonal)) + " | " +
                       timesOf(row.timing.cpu) + " | **" + format("%.2f", row.cpuRatio) + "** | " +
                       timesOf(row.timing.wall) + " | " + format("%.2f", row.wallRatio) + " | ";
    if (row.timing.gpu)
        text += timesOf(*row.timing.gpu) + " | " + format("%.2f", row.gpuRatio.value_or(0.0)) + " | ";
    text += std::to_string(row.work.sent.draws) + " | ";
    if (row.work.vertexShaderRuns)
        text += format("%.2f", static_cast<double>(*row.work.vertexShaderRuns) /
                                   static_cast<double>(row.sceneVertices));
    text += " | ";
    if (!row.errors)
        return text + "| | | | |";
    const Errors& errors = *row.errors;
    return text + format("%.4f", errors.wrongPercent) + " | " + format("%.4f", errors.wrongOffEdgePercent) +
           " | " + format("%.4f", errors.holePercent) + " | " + format("%.1e", errors.relativeDistance.p95) +
           " | " + format("%.1e", errors.directionDegrees.p95) + " |";
}

void writeTables(std::ostream& out, std::span<const Row> rows)
{
    for (std::size_t index = 0; index < rows.size(); ++index) {
        const Row& row = rows[index];
        const bool isFirst = index == 0 || !isSameGroup(rows[index - 1].group, row.group);
        if (isFirst) {
            const std::string gpu = row.timing.gpu ? "GPU ms | GPU ratio | " : "";
            out << (index > 0 ? "\n" : "") << "## Cube n = " << row.group.cubeN << ", back faces "
                << (row.group.cullBackFaces ? "culled" : "drawn")
                << (row.group.isRivalCheck ? ", 8-bit formats" : "")
                << (row.group.vertices == Vertices::own ? ", every triangle with its own vertices" : "")
                << "\n\n"
                << "| | map | method | sizing | n | widest texel ° | CPU ms (quartiles) | ratio | wall ms "
                   "(quartiles) | ratio | "
                << gpu
                << "draws | vertex-shader runs a vertex | wrong % | off edges % | holes % | distance p95 | "
                   "direction p95 ° |\n|";
            for (int column = 0; column < (row.timing.gpu ? 19 : 17); ++column)
                out << "---|";
            out << '\n';
        }
        out << cells(row) << '\n';
    }
}

void writePlotLinks(std::ostream& out, const std::vector<std::string>& plots)
{
    for (const std::string& plot : plots)
        out << "![" << plot << "](" << plot << ".png)\n";
    out << '\n';
}

void writeCaptures(std::ostream& out, const std::vector<Row>& rows)
{
    writeRivalCheck(out, rivalChecksOf(rows));
    writeAims(out, aimsOf(rows));
    writeProfiles(out, profilesOf(rows));
    writeFindings(out, rows);
    out << "## Every number of pass 1\n\n";
    for (const std::span<const Row> scene : byScene(rows))
        out << "- [" << sceneOf(scene.front()) << "](" << pageOf(scene) << "), "
            << scene.front().sceneTriangles << " triangles: plots and tables\n";
    out << "- [benchmark.csv](benchmark.csv): the same and more, one line a contender\n\n";
}

} // namespace

void writeReport(std::ostream& out, const Results& results, const Circumstances& circumstances)
{
    writeCircumstances(out, results, circumstances);
    if (!results.captures.empty())
        writeCaptures(out, results.captures);
    if (!results.lookUps.empty()) {
        writeLookUps(out, results.lookUps);
        for (const std::span<const LookUpRow> scene : byScene(results.lookUps))
            writePlotLinks(out, plotNames(scene));
    }
    if (isJoined(results, circumstances))
        writeRuns(out, results);
}

void writeScene(std::ostream& out, std::span<const Row> scene)
{
    out << "# Pass 1 in " << sceneOf(scene.front()) << "\n\n"
        << scene.front().sceneTriangles
        << " triangles. The [report](README.md) sums up; docs/benchmark.md says what the columns mean.\n\n";
    if (std::ranges::any_of(scene, [&](const Row& row) { return row.run != scene.front().run; }))
        out << "Rows are of several runs (column `run` of benchmark.csv). Ratios are those to the cubes of "
               "each "
               "row's own run; here stand the cubes of one.\n\n";
    writePlotLinks(out, plotNames(scene));
    writeTables(out, scene);
}

std::string pageOf(std::span<const Row> scene)
{
    return std::string(sceneOf(scene.front())) + ".md";
}

} // namespace tests::benchmark
