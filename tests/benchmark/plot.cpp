#include "plot.h"

#include "pareto_plot.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <functional>

namespace tests::benchmark {

namespace {

// What is on the y axis.
template <class RowType>
struct Measure
{
    const char* name; // in file names
    const char* axis;
    bool isLogarithmic;
    std::function<double(const RowType&)> of;
};

constexpr double mostWrongPercent = 0.1; // of the maps whose texels' angles are compared

const Measure<Row> captureMeasures[] = {
    {"wrong_texels", "wrong texels, %", true, [](const Row& row) { return row.errors->wrongPercent; }},
    {"worst_texel", "widest texel, degrees", false,
     [](const Row& row) { return glm::degrees(row.measures.worstDiagonal); }},
};

const Measure<LookUpRow> lookUpMeasures[] = {
    {"mean_angle", "mean angle from the right surface, degrees", true,
     [](const LookUpRow& row) { return row.errors.mean; }},
    {"wrong_surfaces", "wrong surfaces, % of pixels", true,
     [](const LookUpRow& row) { return row.errors.wrongPercent; }},
    {"flip", "FLIP of the reflector's pixels", true, [](const LookUpRow& row) { return row.errors.flip; }},
};

// `first` is the first of the scene's.
bool isPlotted(const Measure<Row>& measure, const Row& row, const Row& first)
{
    return row.group.cubeN == first.group.cubeN && !row.group.cullBackFaces && row.errors &&
           (measure.isLogarithmic || row.errors->wrongPercent <= mostWrongPercent);
}

bool isPlotted(const Measure<LookUpRow>&, const LookUpRow&, const LookUpRow&)
{
    return true;
}

template <class RowType, std::size_t count>
std::vector<std::string> namesOf(std::span<const RowType> scene, const Measure<RowType> (&measures)[count])
{
    std::vector<std::string> names;
    for (const Measure<RowType>& measure : measures)
        if (std::ranges::any_of(scene,
                                [&](const RowType& row) { return isPlotted(measure, row, scene.front()); }))
            names.push_back(std::string(sceneOf(scene.front())) + "_" + measure.name);
    return names;
}

} // namespace

void writePlots(const std::filesystem::path& folder, std::span<const Row> scene)
{
    const Row& first = scene.front();
    for (const Measure<Row>& measure : captureMeasures) {
        std::vector<PlotPoint> points;
        for (const Row& row : scene)
            if (isPlotted(measure, row, first))
                points.push_back({row.costRatio(), measure.of(row), row.entry.methodName(),
                                  row.entry.rival ? std::nullopt : std::optional(row.entry.map),
                                  row.entry.sizing == Sizing::equalTexels});
        if (points.empty())
            continue;
        writeParetoPlot(folder / (std::string(sceneOf(first)) + "_" + measure.name),
                        {std::string(sceneOf(first)) + ", " + std::to_string(first.sceneTriangles) +
                             " triangles, cube n = " + std::to_string(first.group.cubeN) +
                             (measure.isLogarithmic ? "" : ", maps with at most 0.1 % wrong"),
                         std::string(costName()) + " time of pass 1, six-pass culled cube = 1", measure.axis,
                         measure.isLogarithmic, "method", "as many texels as the cube",
                         "no texel wider than the cube's"},
                        points);
    }
}

void writePlots(const std::filesystem::path& folder, std::span<const LookUpRow> scene)
{
    const LookUpRow& first = scene.front();
    const std::string name(sceneOf(first)), n = std::to_string(first.cubeN);
    for (const Measure<LookUpRow>& measure : lookUpMeasures) {
        std::vector<PlotPoint> points;
        for (const LookUpRow& row : scene)
            points.push_back({row.ratio, measure.of(row), std::string(nameOf(row.entry.lookup)),
                              row.entry.isByHand ? std::nullopt : std::optional(row.entry.map),
                              row.cubeN == first.cubeN});
        writeParetoPlot(folder / (name + "_" + measure.name),
                        {name + " in a ball, 1280 x 720",
                         std::string(costName()) +
                             " time of pass 1 and the ball's pixels, cube by hand, infinite, n = 256: 1",
                         measure.axis, measure.isLogarithmic, "look-up", "as a cube of n = " + n,
                         "of other n"},
                        points);
    }
}

std::vector<std::string> plotNames(std::span<const Row> scene)
{
    return namesOf(scene, captureMeasures);
}

std::vector<std::string> plotNames(std::span<const LookUpRow> scene)
{
    return namesOf(scene, lookUpMeasures);
}

} // namespace tests::benchmark
