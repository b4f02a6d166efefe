// Rows of a report that are read again, and reports that are joined.
#include "csv.h"
#include "findings.h"
#include "merge.h"

#include "support/check.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace {

using namespace tests::benchmark;
using mirrorball::MapKind;

const SceneChoice& sceneNamed(std::string_view name)
{
    return *std::ranges::find(sceneChoices(), name, &SceneChoice::name);
}

const LibraryMethod& methodNamed(std::string_view name)
{
    return *std::ranges::find(libraryMethods(), name, &LibraryMethod::name);
}

// `cost` is that of the contender, the best cube's being 1.
Row rowOf(std::string_view scene, int cubeN, Entry entry, double cost, const std::string& run)
{
    Row row;
    row.group = {&sceneNamed(scene), cubeN, false, false, Vertices::shared, {}};
    row.entry = entry;
    row.sceneTriangles = 12345678;
    row.sceneVertices = 3456;
    row.measures = measuresOf(entry.map, entry.n);
    row.timing.cpu = {0.5 * cost, cost, 2.0 * cost};
    row.timing.wall = {0.25 * cost, 0.5 * cost, cost};
    row.timing.frames = 30;
    row.costBeforeRasteriser.median = 0.125;
    row.work = {{17, 7654321}, 9876543, {}, 0};
    row.errors = Errors{};
    row.errors->texels = 524288;
    row.errors->wrongPercent = 0.25;
    row.errors->relativeDistance = {1e-7, 2e-7, 3e-5};
    row.errors->largestRelativeDistanceOffEdges = 1e-6;
    row.cpuRatio = row.wallRatio = row.costRatioToBest = cost;
    row.run = run;
    row.errorsRun = "judged, later";
    return row;
}

Entry byHand(Rival rival, int n)
{
    return {rival, nullptr, MapKind::cube, Sizing::equalTexels, n, RivalFormats::asTheLibrary};
}

Entry byLibrary(std::string_view method, MapKind map, int n)
{
    return {std::nullopt, &methodNamed(method), map, Sizing::equalTexels, n, RivalFormats::asTheLibrary};
}

Row rivalCheckRow(Vertices vertices)
{
    Entry entry = byHand(Rival::culled, 8);
    entry.formats = RivalFormats::eightBit;
    Row row = rowOf("crowd-12k", 8, entry, 1.0, "first");
    row.group.isRivalCheck = true;
    row.group.vertices = vertices;
    if (vertices == Vertices::own)
        row.sceneVertices = 3 * row.sceneTriangles;
    row.errors.reset();
    return row;
}

template <class RowType>
std::string textOf(const std::vector<RowType>& rows)
{
    std::ostringstream out;
    writeCsv(out, rows);
    return out.str();
}

void whatIsReadIsWhatWasWritten()
{
    std::vector<Row> rows = {rowOf("cards", 8, byHand(Rival::culled, 8), 1.0, "first"),
                             rowOf("cards", 8, byLibrary("exact", MapKind::tennisBall, 8), 1.5, "first"),
                             rivalCheckRow(Vertices::shared), rivalCheckRow(Vertices::own)};
    rows[1].timing.gpu = {0.1, 0.2, 0.3};
    rows[1].gpuRatio = 2.5;
    std::istringstream in(textOf(rows));
    const std::vector<Row> again = readCaptures(in, "benchmark.csv");
    CHECK(textOf(again) == textOf(rows));
    CHECK(again.size() == rows.size());
    for (std::size_t index = 0; index < rows.size(); ++index) {
        CHECK(isSameGroup(again[index].group, rows[index].group));
        CHECK(again[index].entry.methodName() == rows[index].entry.methodName());
        CHECK(again[index].measures.worstDiagonal == rows[index].measures.worstDiagonal);
        CHECK(again[index].errors.has_value() == rows[index].errors.has_value());
    }
    CHECK(again[1].timing.gpu->upper == 0.3 && !again[0].timing.gpu && !again[0].gpuRatio);
    CHECK(*again[0].work.vertexShaderRuns == 9876543 && !again[0].work.primitivesClipped);
    CHECK(again[1].errorsRun == "judged, later");
}

template <class RowType>
std::string problemOf(const std::string& csv,
                      std::vector<RowType> (*readRows)(std::istream&, const std::string&))
{
    std::istringstream in(csv);
    try {
        readRows(in, "report.csv");
    } catch (const mirrorball::Error& error) {
        CHECK(error.kind() == mirrorball::ErrorKind::badFile);
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, std::string_view what, std::string_view by)
{
    const std::size_t at = text.find(what);
    CHECK(at != std::string::npos);
    return text.replace(at, what.size(), by);
}

bool has(const std::string& text, std::string_view part)
{
    return text.find(part) != std::string::npos;
}

void brokenReportsAreNamed()
{
    const std::string good =
        textOf(std::vector<Row>{rowOf("cards", 8, byHand(Rival::culled, 8), 1.25, "first"),
                                rowOf("cards", 8, byLibrary("exact", MapKind::tennisBall, 8), 1.5, "first")});
    const auto problem = [&](std::string_view what, std::string_view by) {
        return problemOf(replaced(good, what, by), readCaptures);
    };
    CHECK(problem("cards", "cards").empty());
    CHECK(has(problem("\"cards\"", "\"nowhere\""), "report.csv, line 2: scene: 'nowhere' is no scene"));
    CHECK(has(problem("tennis-ball", "globe"), "line 3: map: 'globe' is no map"));
    CHECK(has(problem("six passes, culled", "exact"), "method: 'exact' is no rival"));
    CHECK(has(problem("hand", "mirrorball"), "method: 'six passes, culled' is no method"));
    CHECK(has(problem("hand", "me"), "by: 'me' is neither 'hand' nor 'mirrorball'"));
    CHECK(has(problem("equal texels", "any"), "sizing: 'any' is no sizing"));
    CHECK(has(problem("12345678", "12345678.5"), "scene_triangles: '12345678.5' is not a number"));
    CHECK(has(problem("12345678", "-1"), "scene_triangles: '-1' is not a number"));
    CHECK(has(problem("12345678", "0"), "less than 1"));
    CHECK(has(problem("1.25", "nan"), "'nan' is not finite"));
    CHECK(has(problem("1.25,1.25,", "1.25,0,"), "a ratio is not positive"));
    CHECK(has(problem("\"first\",", ""), "line 2: it has"));
    CHECK(has(problem("\"first\"", "\"first"), "line 2: a quotation mark is not closed"));
    CHECK(has(problem("wall_ratio", "wall"), "line 1: 'wall_ratio' does not name one column"));
    CHECK(has(problemOf("", readCaptures), "line 1"));
}

LookUpRow lookUpRow(int cubeN, bool isByHand, double ratio, const std::string& run)
{
    LookUpRow row{.scene = &mirrorScenes().front(),
                  .cubeN = cubeN,
                  .entry = {isByHand, MapKind::cube, mirrorball::Lookup::infinite, cubeN},
                  .capture = {1, 2, 3},
                  .mirror = {1, 2, 3},
                  .both = {2, 4, 6},
                  .frameWall = {4, 5, 6},
                  .frames = 30};
    row.ratio = ratio;
    row.errors.pixels = 4321;
    row.errors.psnr = 33.25;
    row.costsOf = "CPU";
    row.run = run;
    return row;
}

void brokenLookUpsAreNamed()
{
    const std::string good = textOf(std::vector<LookUpRow>{lookUpRow(mainN, true, 1.0, "first")});
    const auto problem = [&](std::string_view what, std::string_view by) {
        return problemOf(replaced(good, what, by), readLookUps);
    };
    CHECK(problem("hand", "hand").empty());
    CHECK(has(problem("infinite", "far"), "line 2: look_up: 'far' is no look-up"));
    CHECK(has(problem("hand", "me"), "by: 'me'"));
    CHECK(has(problem("\"room\"", "\"crowd-12k\""), "is no scene with a mirror"));
    CHECK(has(problem("4321", "many"), "pixels_judged: 'many' is not a number"));
}

void laterRowsReplaceEarlierOnes()
{
    const Entry cube = byHand(Rival::culled, mainN), exact = byLibrary("exact", MapKind::tennisBall, 256),
                tessellated = byLibrary("tessellated", MapKind::tennisBall, 256);
    Results first, second;
    first.captures = {rowOf("room", mainN, cube, 1.0, "first"), rowOf("room", mainN, exact, 1.5, "first"),
                      rowOf("room", mainN, tessellated, 3.0, "first"), rowOf("room", 64, cube, 1.0, "first")};
    second.captures = {rowOf("cards", mainN, cube, 1.0, "second"), rowOf("room", mainN, cube, 1.0, "second"),
                       rowOf("room", mainN, exact, 1.25, "second")};
    first.lookUps = {lookUpRow(mainN, true, 1.0, "first"), lookUpRow(mainN, false, 1.5, "first"),
                     lookUpRow(64, true, 0.5, "first")};
    second.lookUps = {lookUpRow(mainN, false, 1.25, "second")};

    const Results both = merged(first, second);
    CHECK(both.captures.size() == 5);
    // Scenes, then sizes, the main one first; in a group what is by hand first.
    CHECK(both.captures[0].group.scene->name == "cards");
    CHECK(both.captures[1].entry.rival && both.captures[1].run == "second");
    CHECK(both.captures[2].entry.methodName() == "exact" && both.captures[2].cpuRatio == 1.25);
    CHECK(both.captures[3].entry.methodName() == "tessellated" && both.captures[3].run == "first");
    CHECK(both.captures[4].group.cubeN == 64);
    CHECK(both.lookUps.size() == 3 && both.lookUps[1].ratio == 1.25 && both.lookUps[2].cubeN == 64);

    // Each scene's aims are those of its own first size.
    Results sizes;
    sizes.captures = {rowOf("cards", 64, cube, 1.0, "first"), rowOf("room", mainN, cube, 1.0, "first"),
                      rowOf("room", mainN, exact, 1.5, "first"),
                      rowOf("room", mainN, tessellated, 3.0, "first")};
    CHECK(aimsOf(sizes.captures).size() == 1);

    // Times of two runs are not divided by each other.
    constexpr std::size_t exactToTessellated = 2;
    CHECK(aimsOf(first.captures).front().measured[exactToTessellated] == 0.5);
    CHECK(std::ranges::none_of(aimsOf(both.captures), [](const Aims& aims) {
        return aims.measured[exactToTessellated].has_value();
    }));
}

void foldersAreRead()
{
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("mirrorball_merge_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "a");
    std::filesystem::create_directories(folder / "b");
    const std::vector<Row> captures = {rowOf("cards", 8, byHand(Rival::culled, 8), 1.0, "first")};
    const std::vector<LookUpRow> lookUps = {lookUpRow(mainN, true, 1.0, "second")};
    std::ofstream(folder / "a" / "benchmark.csv") << textOf(captures);
    std::ofstream(folder / "b" / "look_ups.csv") << textOf(lookUps);
    const Results results = readReports({(folder / "a").string(), (folder / "b").string()});
    CHECK(textOf(results.captures) == textOf(captures) && textOf(results.lookUps) == textOf(lookUps));
    CHECK(results.lookUps.front().costsOf == "CPU" && results.lookUps.front().run == "second");
    CHECK_THROWS(readReports({folder.string()}), mirrorball::ErrorKind::notFound);
    std::filesystem::remove_all(folder);
}

} // namespace

int main()
{
    whatIsReadIsWhatWasWritten();
    brokenReportsAreNamed();
    brokenLookUpsAreNamed();
    laterRowsReplaceEarlierOnes();
    foldersAreRead();
}
