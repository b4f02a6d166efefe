#include "report.h"

#include "environment.h"
#include "findings.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <ostream>

namespace tests::benchmark {

namespace {

std::string format(const char* pattern, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

void writeCircumstances(std::ostream& out, const Circumstances& circumstances)
{
    out << "# Run time against error\n\n"
        << "Written by `" << circumstances.command
        << "`. docs/benchmark.md says how to read and repeat it.\n\n"
        << "- " << circumstances.driver << "\n- " << processor() << "\n- " << today() << ", revision "
        << revision() << "\n- medians of " << circumstances.frames
        << " frames a contender, drawn in turn; the ratios are to the culled six-pass cube of the same "
           "scene, "
           "size and back-face culling, and mean more than the times\n";
    for (const std::string& scene : circumstances.missingScenes)
        out << "- scene `" << scene << "` left out: its file is not there\n";
    out << '\n';
}

void writeRivalCheck(std::ostream& out, const std::vector<RivalCheck>& checks)
{
    if (checks.empty())
        return;
    out << "## Whether the hand-written cube is well built\n\nCPU time of six culled passes over six plain "
           "ones, n = 256, 8-bit formats, back faces culled, beside the ratio that an independent "
           "implementation had on a scene of the same kind. It must lie within 15 %.\n\n"
        << "| scene | culled / plain | independent | off by | |\n|---|---|---|---|---|\n";
    for (const RivalCheck& check : checks)
        out << "| " << check.scene << " | " << format("%.2f", check.measured) << " | "
            << format("%.2f", check.expected) << " | " << format("%+.0f %%", 100.0 * check.deviation())
            << " | " << (check.isKept() ? "kept" : "**not kept**") << " |\n";
    out << '\n';
}

void writeAims(std::ostream& out, const std::vector<Aim>& aims)
{
    if (aims.empty())
        return;
    out << "## Aims\n\n| scene | what | measured | aim | |\n|---|---|---|---|---|\n";
    for (const Aim& aim : aims)
        out << "| " << aim.scene << " | " << aim.what << " | " << format("%.2f", aim.measured) << " | "
            << format("%.4g", aim.limit) << (aim.atLeast ? " or more" : " or less") << " | "
            << (aim.isReached() ? "reached" : "**missed**") << " |\n";
    out << '\n';
}

void writeFindings(std::ostream& out, const std::vector<Row>& rows)
{
    out << "## Where we win and where we lose\n\nThe cheapest map of the library that shows at most "
        << format("%g", rightPercent)
        << " % wrong texels and no texel wider than the cube's, against the cheapest hand-written cube.\n\n"
           "| scene | cube n | back faces | map, method | n | CPU time, best cube = 1 | wrong texels | |\n"
           "|---|---|---|---|---|---|---|---|\n";
    for (const Finding& finding : findingsOf(rows)) {
        const Row& row = *finding.best;
        out << "| " << row.group.scene->name << " | " << row.group.cubeN << " | "
            << (row.group.cullBackFaces ? "culled" : "drawn") << " | "
            << mirrorball::mapInfo(row.entry.map).name << ", " << row.entry.methodName() << " | "
            << row.entry.n << " | " << format("%.2f", row.cpuRatioToBest) << " | "
            << format("%.4f %%", row.errors->wrongPercent) << " | " << finding.verdict() << " |\n";
    }
    out << '\n';
}

std::string timesOf(const Quartiles& quartiles)
{
    return format("%.1f", quartiles.median) + " (" + format("%.1f", quartiles.lower) + "-" +
           format("%.1f", quartiles.upper) + ")";
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

void writeTables(std::ostream& out, const std::vector<Row>& rows)
{
    out << "## Tables\n\n";
    for (std::size_t index = 0; index < rows.size(); ++index) {
        const Row& row = rows[index];
        const bool isFirst = index == 0 || !isSameGroup(rows[index - 1].group, row.group);
        if (isFirst) {
            const std::string gpu = row.timing.gpu ? "GPU ms | GPU ratio | " : "";
            out << (index > 0 ? "\n" : "") << "### " << row.group.scene->name << ", " << row.sceneTriangles
                << " triangles, cube n = " << row.group.cubeN << ", back faces "
                << (row.group.cullBackFaces ? "culled" : "drawn")
                << (row.group.isRivalCheck ? ", 8-bit formats" : "") << "\n\n"
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
    out << "## Plots\n\n";
    for (const std::string& plot : plots)
        out << "![" << plot << "](" << plot << ".png)\n";
    out << '\n';
}

} // namespace

void writeReport(std::ostream& out, const std::vector<Row>& rows, const Circumstances& circumstances,
                 const std::vector<std::string>& plots)
{
    writeCircumstances(out, circumstances);
    writeRivalCheck(out, rivalChecksOf(rows));
    writeAims(out, aimsOf(rows));
    writeFindings(out, rows);
    writePlotLinks(out, plots);
    writeTables(out, rows);
}

} // namespace tests::benchmark
