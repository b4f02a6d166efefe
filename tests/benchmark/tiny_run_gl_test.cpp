// A run of the benchmark in small: its files appear, its counts are exact, its ratios are numbers.
#include "look_up_report.h"
#include "look_up_run.h"
#include "merge.h"
#include "output.h"
#include "plan.h"
#include "run.h"

#include "support/check.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/io/image.h>
#include <mirrorball/maps/measures.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <thread>

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

Options tinyLookUps()
{
    Options options;
    options.scenes = {"room"};
    options.maps = {MapKind::cube};
    options.sizes = {256};
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
        for (const double ratio : {row.cpuRatio, row.wallRatio, row.costRatioToBest})
            CHECK(std::isfinite(ratio) && ratio > 0.0);
    for (const Row& row : rows)
        CHECK(row.costBeforeRasteriser.median > 0.0);
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

std::size_t linesOf(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::size_t lines = 0;
    for (std::string line; std::getline(file, line);)
        ++lines;
    return lines;
}

bool says(const std::filesystem::path& path, std::string_view words)
{
    std::ifstream file(path);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    return text.find(words) != std::string::npos;
}

// A report has no table of what none of its rows can tell: of vertices mapped alone, wrong as they are, who wins.
void emptyTablesAreLeftOut(const std::filesystem::path& folder, const Results& results,
                           const Circumstances& circumstances)
{
    constexpr std::string_view who = "Where we win";
    CHECK(says(folder / "README.md", who) && says(folder / "cards.md", "cards_worst_texel.png"));
    Results few;
    for (const Row& row : results.captures)
        if (row.entry.rival || row.entry.methodName() == "perVertex")
            few.captures.push_back(row);
    writeFiles(folder, few, circumstances);
    CHECK(!says(folder / "README.md", who));
    CHECK(says(folder / "cards.md", "perVertex"));

    // Nor a link to the plot of the maps that are right.
    std::erase_if(few.captures, [](const Row& row) { return row.errors && row.errors->wrongPercent < 10.0; });
    CHECK(!few.captures.empty());
    writeFiles(folder, few, circumstances);
    CHECK(says(folder / "cards.md", "cards_wrong_texels.png"));
    CHECK(!says(folder / "cards.md", "cards_worst_texel.png"));
}

void filesAppear(const std::filesystem::path& folder, const Results& results)
{
    CHECK(linesOf(folder / "benchmark.csv") == results.captures.size() + 1);
    CHECK(linesOf(folder / "look_ups.csv") == results.lookUps.size() + 1);
    CHECK(std::filesystem::file_size(folder / "README.md") > 1000);
    CHECK(says(folder / "README.md", "(cards.md)") && says(folder / "cards.md", "(README.md)"));
    for (const std::string name : {"cards_wrong_texels", "cards_worst_texel", "room_mean_angle", "room_flip"})
    {
        CHECK(std::filesystem::file_size(folder / (name + ".svg")) > 1000);
        const mirrorball::io::Image image = mirrorball::io::readImage(folder / (name + ".png"));
        CHECK(image.width == 960 && image.height == 600);
        CHECK(*std::min_element(image.pixels.begin(), image.pixels.end()) < 0.1f);
    }
}

// A report has rows in the order of its plan, also where nothing is joined.
void joiningKeepsAPlansOrder(const Results& results)
{
    const Results same = merged({}, results);
    CHECK(same.captures.size() == results.captures.size() && same.lookUps.size() == results.lookUps.size());
    for (std::size_t index = 0; index < results.captures.size(); ++index) {
        const Row &row = same.captures[index], &planned = results.captures[index];
        CHECK(isSameGroup(row.group, planned.group) && row.entry.methodName() == planned.entry.methodName());
        CHECK(row.entry.map == planned.entry.map && row.entry.sizing == planned.entry.sizing);
    }
    for (std::size_t index = 0; index < results.lookUps.size(); ++index)
        CHECK(same.lookUps[index].ratio == results.lookUps[index].ratio);
}

// Where a row is of another run, the report says which rows are of which.
void runsAreTold(const std::filesystem::path& folder, Results results, const Circumstances& circumstances)
{
    CHECK(!says(folder / "README.md", "## Runs") && says(folder / "README.md", "medians of 2 frames"));
    results.captures.back().run = "yesterday";
    results.lookUps.back().run = "long ago";
    writeFiles(folder, results, circumstances);
    CHECK(says(folder / "README.md", "## Runs"));
    CHECK(says(folder / "README.md", "| yesterday | 1 | 0 | 0 |\n"));
    CHECK(says(folder / "README.md", "| long ago | 0 | 0 | 1 |\n"));
    CHECK(says(folder / "README.md", "| tiny | " + std::to_string(results.captures.size() - 1) + " | " +
                                         std::to_string(results.captures.size()) + " | " +
                                         std::to_string(results.lookUps.size() - 1) + " |\n"));
}

// Errors are the same whenever they are told; of rows that are not asked for they stay, and so do all times.
void errorsAreToldAnew(const std::vector<Row>& rows)
{
    std::vector<Row> again = rows;
    for (Row& row : again)
        row.errors->wrongPercent = -1.0;
    Options options;
    options.methods = {"exact"};
    Progress progress(judgeSteps(again, options));
    std::vector<std::string_view> changed;
    judge(again, options, "later", progress, [&](std::string_view scene) { changed.push_back(scene); });
    CHECK(changed == std::vector<std::string_view>{"cards"});
    std::size_t judged = 0;
    for (std::size_t index = 0; index < rows.size(); ++index) {
        const bool isAskedFor = rows[index].entry.methodName() == "exact";
        judged += isAskedFor ? 1 : 0;
        CHECK(again[index].errors->wrongPercent == (isAskedFor ? rows[index].errors->wrongPercent : -1.0));
        CHECK(again[index].errorsRun == (isAskedFor ? "later" : "tiny"));
        CHECK(again[index].run == "tiny" && again[index].cpuRatio == rows[index].cpuRatio);
    }
    CHECK(judged == 3); // the cube, the tennis-ball map in both sizes
}

// The order of the look-ups is known: nothing done, a box where the scene is a box with things in it, the march.
// The library's cube and the one by hand show the same.
void lookUpsAreJudged(const std::vector<LookUpRow>& rows)
{
    const auto find = [&](bool isByHand, mirrorball::Lookup lookup) -> const tests::ParallaxErrors& {
        const auto found = std::find_if(rows.begin(), rows.end(), [&](const LookUpRow& row) {
            return row.entry.isByHand == isByHand && row.entry.lookup == lookup;
        });
        CHECK(found != rows.end());
        return found->errors;
    };
    using mirrorball::Lookup;
    CHECK(rows.front().ratio == 1.0);
    CHECK(find(true, Lookup::box).mean < 0.2 * find(true, Lookup::infinite).mean);
    CHECK(find(false, Lookup::distance).mean < find(true, Lookup::box).mean);
    // Both look up the same place, and a texel spans 0.35 degrees.
    for (const Lookup lookup : {Lookup::infinite, Lookup::box})
        CHECK_NEAR(find(false, lookup).mean, find(true, lookup).mean, 0.01);
    for (const LookUpRow& row : rows)
        CHECK(row.capture.median > 0.0 && row.mirror.median > 0.0 && row.framesPerSecond() > 0.0);
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

class SlowContender : public Contender
{
public:
    explicit SlowContender(int& draws) : draws_(draws) {}

    Work draw() override
    {
        ++draws_;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return {};
    }
    MapImages read() const override { return {}; }

private:
    int& draws_;
};

// What takes too long is drawn less often, whether it is warmed up once or more.
void slowContendersAreDrawnLess()
{
    for (const int warmUp : {1, 4}) {
        int draws = 0;
        std::vector<std::unique_ptr<Contender>> contenders;
        contenders.push_back(std::make_unique<SlowContender>(draws));
        const std::vector<Timing> timings = measure(
            contenders, warmUp, 30, [] {}, 10.0);
        CHECK(timings.front().frames == 2);
        CHECK(draws == std::min(warmUp, 2) + 2);
        CHECK(timings.front().wall.median >= 20.0);
    }
    int draws = 0;
    std::vector<std::unique_ptr<Contender>> contenders;
    contenders.push_back(std::make_unique<SlowContender>(draws));
    CHECK(measure(contenders, 1, 3, [] {}).front().frames == 3 && draws == 4);
}

} // namespace

int main()
{
    const mirrorball::headless::Context context;
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("mirrorball_tiny_run_" + std::to_string(getpid()));
    makeFolder(folder);
    Circumstances circumstances{context.description(), "benchmark", 2, {}, true, "tiny"};
    Results results;

    const std::vector<Group> plan = makePlan(tinyOptions(), circumstances.missingScenes);
    Progress progress(stepsOf(plan, 2));
    results.captures = run(plan, 2, "tiny", progress, [&](const std::vector<Row>& rows) {
        writeFiles(folder, {rows, {}}, circumstances);
        CHECK(linesOf(folder / "benchmark.csv") == rows.size() + 1); // cut off here, it is all there
    });
    countsAreExact(results.captures);
    ratiosAreNumbers(results.captures);
    errorsAreTold(results.captures);
    errorsAreToldAnew(results.captures);

    const std::vector<LookUpGroup> lookUpPlan = makeLookUpPlan(tinyLookUps(), circumstances.missingScenes);
    CHECK(circumstances.missingScenes.empty());
    results.lookUps = runLookUps(lookUpPlan, 2, "tiny", progress, [](const std::vector<LookUpRow>&) {});
    lookUpsAreJudged(results.lookUps);

    writeFiles(folder, results, circumstances);
    filesAppear(folder, results);
    joiningKeepsAPlansOrder(results);
    runsAreTold(folder, results, circumstances);
    emptyTablesAreLeftOut(folder, results, circumstances);
    std::filesystem::remove_all(folder);

    equalAngleIsTheSmallest();
    quartilesAreThoseOfTheRanks();
    slowContendersAreDrawnLess();
}
