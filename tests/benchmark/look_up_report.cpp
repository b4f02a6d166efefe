#include "look_up_report.h"

#include "number_text.h"

#include <algorithm>
#include <limits>
#include <ostream>

namespace tests::benchmark {

namespace {

using SceneRows = std::span<const LookUpRow>;

std::string_view byWhom(const LookUpRow& row)
{
    return row.entry.isByHand ? "by hand" : "mirrorball";
}

std::string errorCells(const ParallaxErrors& errors)
{
    return format("%.3f", errors.mean) + " | " + format("%.2f", errors.p95) + " | " +
           format("%.2f", errors.wrongPercent) + " | " + format("%.1f", errors.psnr) + " | " +
           format("%.4f", errors.flip) + " |\n";
}

void writeFront(std::ostream& out, SceneRows scene)
{
    for (const LookUpRow* row : paretoFront(scene))
        out << "| " << row->scene->name << " | " << byWhom(*row) << " | "
            << mirrorball::mapInfo(row->entry.map).name << " | " << nameOf(row->entry.lookup) << " | "
            << row->entry.n << " | " << format("%.2f", row->ratio) << " | " << errorCells(row->errors);
}

void writeTable(std::ostream& out, SceneRows scene)
{
    out << "\n### A ball in " << sceneOf(scene.front()) << "\n\n| | map | look-up | n | pass 1, "
        << costName() << " ms | ball, " << costName()
        << " ms | both (quartiles) | ratio | frames a "
           "second | mean angle ° | p95 ° | wrong % | PSNR dB | FLIP |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const LookUpRow& row : scene)
        out << "| " << byWhom(row) << " | " << mirrorball::mapInfo(row.entry.map).name << " | "
            << nameOf(row.entry.lookup) << " | " << row.entry.n << " | " << milliseconds(row.capture.median)
            << " | " << milliseconds(row.mirror.median) << " | " << timesOf(row.both) << " | **"
            << format("%.2f", row.ratio) << "** | " << format("%.1f", row.framesPerSecond()) << " | "
            << errorCells(row.errors);
}

} // namespace

std::vector<const LookUpRow*> paretoFront(std::span<const LookUpRow> scene)
{
    std::vector<const LookUpRow*> sorted;
    for (const LookUpRow& row : scene)
        sorted.push_back(&row);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const LookUpRow* a, const LookUpRow* b) { return a->ratio < b->ratio; });
    std::vector<const LookUpRow*> front;
    double least = std::numeric_limits<double>::infinity();
    for (const LookUpRow* row : sorted)
        if (row->errors.mean < least) {
            least = row->errors.mean;
            front.push_back(row);
        }
    return front;
}

void writeLookUps(std::ostream& out, const std::vector<LookUpRow>& rows)
{
    const std::vector<SceneRows> scenes = byScene(rows);
    out << "## Look-ups: both passes against the picture\n\nA ball of radius 0.5 at 1280 × 720. Costs are "
        << costName()
        << " times of pass 1 and of the ball's pixels together, ratios to the culled six-pass cube by hand "
           "with n = "
           "256, "
           "looked up as infinitely far; the whole frame, with the scene around the ball, is in the column "
           "of "
           "frames a second. Errors are those of docs/reflection.md, against the traced picture.\n\n"
           "### The Pareto front\n\nNothing that was measured is both cheaper and nearer to the right "
           "surface.\n\n"
           "| scene | | map | look-up | n | "
        << costName()
        << " time | mean angle ° | p95 ° | wrong % | PSNR dB | FLIP |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const SceneRows scene : scenes)
        writeFront(out, scene);
    for (const SceneRows scene : scenes)
        writeTable(out, scene);
    out << '\n';
}

} // namespace tests::benchmark
