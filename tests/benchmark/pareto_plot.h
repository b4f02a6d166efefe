// A Pareto plot: what a contender costs, against how far it is off.
#pragma once

#include <mirrorball/maps/maps.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tests::benchmark {

struct PlotPoint
{
    double cost, error; // the error is 0 where there is none
    std::string method; // the mark's shape
    // Its colour; empty: by hand, black.
    std::optional<mirrorball::MapKind> map;
    bool isFilled;
};

struct PlotTexts
{
    std::string title, costAxis, errorAxis;
    bool isLogarithmic;         // the axis of errors; that of costs always is
    std::string method;         // what the shapes stand for
    std::string filled, hollow; // what filled and hollow marks stand for
};

// Writes <path>.svg and <path>.png. Precondition: there is a point. Throws mirrorball::Error, unwritable.
void writeParetoPlot(const std::filesystem::path& pathWithoutEnding, const PlotTexts& texts,
                     const std::vector<PlotPoint>& points);

} // namespace tests::benchmark
