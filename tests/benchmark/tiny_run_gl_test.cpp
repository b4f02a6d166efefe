// A run of the benchmark in small: its files appear, its counts are exact, its ratios are numbers.
#include "output.h"
#include "plan.h"
#include "run.h"

#include "support/check.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/io/image.h>
#include <mirrorball/maps/measures.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace {

using namespace tests::benchmark;
using mirrorball::MapKind;

constexpr int n = 16;
constexpr std::size_t cards = 11; // each a mesh of one triangle and three vertices

Options tinyOptions()
{
    Options options;
    options.scenes = {"cards"};
    options.maps = {MapKind::tennisBall, MapKind::cube};
    options.methods = {"exact", "perVertex"};
    options.sizes = {n};
    options.frames = 2;
    return options;
}

const Row& find(const std::vector<Row>& rows, MapKind map, std::string_view method)
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return row.entry.map == map && row.entry.methodName() == method;
    });
    CHECK(found != rows.end());
    return *found;
}

void countsAreExact(const std::vector<Row>& rows)
{
    const Row& plain = find(rows, MapKind::cube, "six passes");
    CHECK(plain.sceneTriangles == cards && plain.sceneVertices == 3 * cards);
    CHECK(plain.measures.texels == 6 * n * n);
    CHECK(plain.work.sent.draws == 6 * static_cast<int>(cards));
    CHECK(plain.work.sent.triangles == 6 * cards);
    if (plain.work.vertexShaderRuns)
        CHECK(*plain.work.vertexShaderRuns == 6 * 3 * cards);

    // Culling drops draws, never a triangle that is seen.
    const Row& culled = find(rows, MapKind::cube, "six passes, culled");
    CHECK(culled.work.sent.draws < plain.work.sent.draws);
    CHECK(culled.errors->wrongPercent == plain.errors->wrongPercent);
    // The layered draws send to the same faces, in one draw a mesh.
    const Row& geometry = find(rows, MapKind::cube, "layered, geometry shader");
    CHECK(geometry.work.sent.draws == static_cast<int>(cards));
    if (isSupported(Rival::layeredInstanced)) {
        const Row& instanced = find(rows, MapKind::cube, "layered, instanced");
        CHECK(instanced.work.sent.draws == static_cast<int>(cards));
        CHECK(instanced.work.sent.triangles == culled.work.sent.triangles);
    }
}

void ratiosAreNumbers(const std::vector<Row>& rows)
{
    for (const Row& row : rows)
        for (const double ratio : {row.cpuRatio, row.wallRatio, row.cpuRatioToBest})
            CHECK(std::isfinite(ratio) && ratio > 0.0);
    CHECK(find(rows, MapKind::cube, "six passes, culled").cpuRatio == 1.0);
}

// The rasteriser places vertices on a grid of at most 1/16 texel (most: 1/256), so that some texels whose
// centres lie beside an edge are its neighbours'. Straight edges of large triangles on a curved map are wrong
// in most places, and exact capture is right but for rounding.
void errorsAreTold(const std::vector<Row>& rows)
{
    for (const char* const rival : {"six passes", "six passes, culled", "layered, geometry shader"})
        CHECK(find(rows, MapKind::cube, rival).errors->wrongPercent < 1.0);
    CHECK(find(rows, MapKind::tennisBall, "perVertex").errors->wrongPercent > 10.0);
    CHECK(find(rows, MapKind::tennisBall, "exact").errors->wrongPercent < 0.1);
}

void filesAppear(const std::filesystem::path& folder, const std::vector<Row>& rows)
{
    std::ifstream csv(folder / "benchmark.csv");
    std::size_t lines = 0;
    for (std::string line; std::getline(csv, line);)
        ++lines;
    CHECK(lines == rows.size() + 1);
    CHECK(std::filesystem::file_size(folder / "README.md") > 1000);
    for (const std::string name : {"cards_wrong_texels", "cards_worst_texel"}) {
        CHECK(std::filesystem::file_size(folder / (name + ".svg")) > 1000);
        const mirrorball::io::Image image = mirrorball::io::readImage(folder / (name + ".png"));
        CHECK(image.width == 960 && image.height == 600);
        CHECK(*std::min_element(image.pixels.begin(), image.pixels.end()) < 0.1f);
    }
}

void equalAngleIsTheSmallest()
{
    const double cube = mirrorball::mapMeasures(MapKind::cube, 64).worstDiagonal;
    for (const MapKind map : {MapKind::tennisBall, MapKind::tennisBallEven, MapKind::dualParaboloid}) {
        const int size = equalAngleN(map, 64).value();
        CHECK(mirrorball::mapMeasures(map, size).worstDiagonal <= cube);
        CHECK(mirrorball::mapMeasures(map, size - 1).worstDiagonal > cube);
    }
    CHECK(!equalAngleN(MapKind::sphereMap, 64));
}

void quartilesAreThoseOfTheRanks()
{
    const Quartiles quartiles = quartilesOf({5.0, 1.0, 4.0, 2.0, 3.0});
    CHECK(quartiles.lower == 2.0 && quartiles.median == 3.0 && quartiles.upper == 4.0);
    CHECK(quartilesOf({1.0, 2.0}).median == 1.5);
}

} // namespace

int main()
{
    const mirrorball::headless::Context context;
    const Options options = tinyOptions();
    std::vector<std::string> missing;
    const std::vector<Group> plan = makePlan(options, missing);
    CHECK(missing.empty());
    Progress progress(stepsOf(plan, options.frames));
    const std::vector<Row> rows = run(plan, options.frames, progress);
    countsAreExact(rows);
    ratiosAreNumbers(rows);
    errorsAreTold(rows);

    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("mirrorball_tiny_run_" + std::to_string(getpid()));
    makeFolder(folder);
    writeFiles(folder, rows, {context.description(), "benchmark", options.frames, missing});
    filesAppear(folder, rows);
    std::filesystem::remove_all(folder);

    equalAngleIsTheSmallest();
    quartilesAreThoseOfTheRanks();
}
