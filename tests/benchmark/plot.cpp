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

std::string_view sceneOf(const Row& row)
{
    return row.group.scene->name;
}

std::string_view sceneOf(const LookUpRow& row)
{
    return row.scene->name;
}

// Rows of a scene stand together.
template <class RowType>
std::vector<const RowType*> lastScene(const std::vector<RowType>& rows)
{
    std::vector<const RowType*> result;
    for (const RowType& row : rows)
        if (sceneOf(row) == sceneOf(rows.back()))
            result.push_back(&row);
    return result;
}

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

// Of all plots that have a mark.
template <class RowType, std::size_t count>
std::vector<std::string> namesOf(const std::vector<RowType>& rows, const Measure<RowType> (&measures)[count])
{
    std::vector<std::string> names;
    for (auto first = rows.begin(); first != rows.end();) {
        const auto isOfAnother = [&](const RowType& row) { return sceneOf(row) != sceneOf(*first); };
        const auto after = std::find_if(first, rows.end(), isOfAnother);
        for (const Measure<RowType>& measure : measures)
            if (std::any_of(first, after,
                            [&](const RowType& row) { return isPlotted(measure, row, *first); }))
                names.push_back(std::string(sceneOf(*first)) + "_" + measure.name);
        first = after;
    }
    return names;
}

} // namespace

void writePlots(const std::filesystem::path& folder, const std::vector<Row>& rows)
{
    const std::vector<const Row*> scene = lastScene(rows);
    const Row& first = *scene.front();
    for (const Measure<Row>& measure : captureMeasures) {
        std::vector<PlotPoint> points;
        for (const Row* row : scene)
            if (isPlotted(measure, *row, first))
                points.push_back({row->costRatio(), measure.of(*row), row->entry.methodName(),
                                  row->entry.rival ? std::nullopt : std::optional(row->entry.map),
                                  row->entry.sizing == Sizing::equalTexels});
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

void writePlots(const std::filesystem::path& folder, const std::vector<LookUpRow>& rows)
{
    const std::vector<const LookUpRow*> scene = lastScene(rows);
    const LookUpRow& first = *scene.front();
    const std::string name(sceneOf(first)), n = std::to_string(first.cubeN);
    for (const Measure<LookUpRow>& measure : lookUpMeasures) {
        std::vector<PlotPoint> points;
        for (const LookUpRow* row : scene)
            points.push_back({row->ratio, measure.of(*row), std::string(nameOf(row->entry.lookup)),
                              row->entry.isByHand ? std::nullopt : std::optional(row->entry.map),
                              row->cubeN == first.cubeN});
        writeParetoPlot(folder / (name + "_" + measure.name),
                        {name + " in a ball, 1280 x 720",
                         std::string(costName()) +
                             " time of pass 1 and the ball's pixels, cube by hand, infinite, n = 256: 1",
                         measure.axis, measure.isLogarithmic, "look-up", "as a cube of n = " + n,
                         "of other n"},
                        points);
    }
}

std::vector<std::string> plotNames(const std::vector<Row>& rows)
{
    return namesOf(rows, captureMeasures);
}

std::vector<std::string> plotNames(const std::vector<LookUpRow>& rows)
{
    return namesOf(rows, lookUpMeasures);
}

} // namespace tests::benchmark
