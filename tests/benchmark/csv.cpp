#include "csv.h"

#include "csv_table.h"

#include <glm/trigonometric.hpp>

#include <string_view>

namespace tests::benchmark {

namespace {

constexpr std::string_view eightBit = ", 8-bit formats";

mirrorball::MapKind mapNamed(const std::string& text)
{
    return named(mirrorball::maps(), text, "map", [](const mirrorball::MapInfo& map) { return map.name; })
        .kind;
}

Sizing sizingNamed(const std::string& text)
{
    constexpr Sizing sizings[] = {Sizing::equalTexels, Sizing::equalAngle};
    return named(sizings, text, "sizing", [](Sizing sizing) { return nameOf(sizing); });
}

void setMethod(Row& row, const std::string& text)
{
    row.group.isRivalCheck = text.ends_with(eightBit);
    row.entry.formats = row.group.isRivalCheck ? RivalFormats::eightBit : RivalFormats::asTheLibrary;
    const std::string name =
        text.substr(0, text.size() - (row.group.isRivalCheck ? eightBit.size() : std::size_t(0)));
    if (row.entry.rival)
        row.entry.rival =
            named(rivals(), name, "rival", [](const RivalInfo& rival) { return rival.name; }).rival;
    else
        row.entry.method =
            &named(libraryMethods(), name, "method", [](const LibraryMethod& method) { return method.name; });
}

// One of a part that a row need not have; `part`, given a row, is it.
template <class Part, class Reach>
Column<Row> partCell(const char* name, Part part, Reach reach)
{
    return {name, [=](const Row& row) { return part(row) ? spelled(reach(*part(row))) : ""; },
            [=](Row& row, const std::string& text) {
                if (!text.empty())
                    parse(text, reach(part(row) ? *part(row) : part(row).emplace()));
            }};
}

template <class Reach>
Column<Row> error(const char* name, Reach reach)
{
    return partCell(
        name, [](auto& row) -> auto& { return row.errors; }, reach);
}

Column<Row> error(const char* name, Spread Errors::*spread, double Spread::*member)
{
    return error(
        name, [=](auto& errors) -> auto& { return errors.*spread.*member; });
}

Column<Row> time(const char* name, Quartiles Timing::*quartiles, double Quartiles::*member)
{
    return cell<Row>(
        name, [=](auto& row) -> auto& { return row.timing.*quartiles.*member; });
}

Column<Row> gpuTime(const char* name, double Quartiles::*member)
{
    return partCell(
        name, [](auto& row) -> auto& { return row.timing.gpu; },
        [=](auto& quartiles) -> auto& { return quartiles.*member; });
}

std::vector<Column<Row>> captureColumns()
{
    return {
        {"scene", [](const Row& row) { return inQuotes(row.group.scene->name); },
         [](Row& row, const std::string& text) {
             row.group.scene =
                 &named(sceneChoices(), text, "scene", [](const SceneChoice& scene) { return scene.name; });
         }},
        cell<Row>(
            "scene_triangles", [](auto& row) -> auto& { return row.sceneTriangles; }),
        cell<Row>(
            "scene_vertices", [](auto& row) -> auto& { return row.sceneVertices; }),
        {"by", [](const Row& row) { return std::string(row.entry.rival ? "hand" : "mirrorball"); },
         [](Row& row, const std::string& text) {
             if (isFirst(text, "hand", "mirrorball"))
                 row.entry.rival.emplace(); // which, the method tells
         }},
        {"map", [](const Row& row) { return std::string(mirrorball::mapInfo(row.entry.map).name); },
         [](Row& row, const std::string& text) { row.entry.map = mapNamed(text); }},
        {"method", [](const Row& row) { return inQuotes(row.entry.methodName()); }, setMethod},
        {"sizing", [](const Row& row) { return std::string(nameOf(row.entry.sizing)); },
         [](Row& row, const std::string& text) { row.entry.sizing = sizingNamed(text); }},
        cell<Row>(
            "cube_n", [](auto& row) -> auto& { return row.group.cubeN; }),
        cell<Row>(
            "n", [](auto& row) -> auto& { return row.entry.n; }),
        cell<Row>(
            "back_faces_culled", [](auto& row) -> auto& { return row.group.cullBackFaces; }),
        derived<Row>("texels", [](const Row& row) { return std::to_string(row.measures.texels); }),
        derived<Row>("worst_texel_degrees",
                     [](const Row& row) { return spelled(glm::degrees(row.measures.worstDiagonal)); }),
        cell<Row>(
            "frames", [](auto& row) -> auto& { return row.timing.frames; }),
        time("cpu_ms", &Timing::cpu, &Quartiles::median),
        time("cpu_ms_lower_quartile", &Timing::cpu, &Quartiles::lower),
        time("cpu_ms_upper_quartile", &Timing::cpu, &Quartiles::upper),
        cell<Row>(
            "cost_ms_before_rasteriser", [](auto& row) -> auto& { return row.costBeforeRasteriser.median; }),
        time("wall_ms", &Timing::wall, &Quartiles::median),
        time("wall_ms_lower_quartile", &Timing::wall, &Quartiles::lower),
        time("wall_ms_upper_quartile", &Timing::wall, &Quartiles::upper),
        gpuTime("gpu_ms", &Quartiles::median),
        gpuTime("gpu_ms_lower_quartile", &Quartiles::lower),
        gpuTime("gpu_ms_upper_quartile", &Quartiles::upper),
        cell<Row>(
            "cpu_ratio", [](auto& row) -> auto& { return row.cpuRatio; }),
        cell<Row>(
            "wall_ratio", [](auto& row) -> auto& { return row.wallRatio; }),
        cell<Row>(
            "gpu_ratio", [](auto& row) -> auto& { return row.gpuRatio; }),
        cell<Row>(
            "cost_ratio_to_best_cube", [](auto& row) -> auto& { return row.costRatioToBest; }),
        cell<Row>(
            "draws", [](auto& row) -> auto& { return row.work.sent.draws; }),
        cell<Row>(
            "triangles_sent", [](auto& row) -> auto& { return row.work.sent.triangles; }),
        cell<Row>(
            "vertex_shader_runs", [](auto& row) -> auto& { return row.work.vertexShaderRuns; }),
        cell<Row>(
            "primitives_clipped", [](auto& row) -> auto& { return row.work.primitivesClipped; }),
        cell<Row>(
            "fragment_shader_runs", [](auto& row) -> auto& { return row.work.fragmentShaderRuns; }),
        error(
            "texels_judged", [](auto& errors) -> auto& { return errors.texels; }),
        error(
            "wrong_texels_percent", [](auto& errors) -> auto& { return errors.wrongPercent; }),
        error(
            "wrong_texels_off_edges_percent",
            [](auto& errors) -> auto& { return errors.wrongOffEdgePercent; }),
        error(
            "holes_percent", [](auto& errors) -> auto& { return errors.holePercent; }),
        error("relative_distance_error_mean", &Errors::relativeDistance, &Spread::mean),
        error("relative_distance_error_p95", &Errors::relativeDistance, &Spread::p95),
        error("relative_distance_error_max", &Errors::relativeDistance, &Spread::largest),
        error(
            "relative_distance_error_max_off_edges",
            [](auto& errors) -> auto& { return errors.largestRelativeDistanceOffEdges; }),
        error("direction_error_degrees_mean", &Errors::directionDegrees, &Spread::mean),
        error("direction_error_degrees_p95", &Errors::directionDegrees, &Spread::p95),
        error("direction_error_degrees_max", &Errors::directionDegrees, &Spread::largest),
        error(
            "direction_error_degrees_mean_where_wrong",
            [](auto& errors) -> auto& { return errors.directionDegreesWhereWrong; }),
        cell<Row>(
            "run", [](auto& row) -> auto& { return row.run; }),
        cell<Row>(
            "errors_run", [](auto& row) -> auto& { return row.errorsRun; }),
    };
}

Column<LookUpRow> milliseconds(const char* name, Quartiles LookUpRow::*quartiles, double Quartiles::*member)
{
    return cell<LookUpRow>(
        name, [=](auto& row) -> auto& { return row.*quartiles.*member; });
}

Column<LookUpRow> pictureError(const char* name, double ParallaxErrors::*member)
{
    return cell<LookUpRow>(
        name, [=](auto& row) -> auto& { return row.errors.*member; });
}

std::vector<Column<LookUpRow>> lookUpColumns()
{
    return {
        {"scene", [](const LookUpRow& row) { return inQuotes(row.scene->name); },
         [](LookUpRow& row, const std::string& text) {
             row.scene = &named(mirrorScenes(), text, "scene with a mirror",
                                [](const MirrorScene& scene) { return scene.name; });
         }},
        {"by", [](const LookUpRow& row) { return std::string(row.entry.isByHand ? "hand" : "mirrorball"); },
         [](LookUpRow& row, const std::string& text) {
             row.entry.isByHand = isFirst(text, "hand", "mirrorball");
         }},
        {"map", [](const LookUpRow& row) { return std::string(mirrorball::mapInfo(row.entry.map).name); },
         [](LookUpRow& row, const std::string& text) { row.entry.map = mapNamed(text); }},
        {"look_up", [](const LookUpRow& row) { return std::string(nameOf(row.entry.lookup)); },
         [](LookUpRow& row, const std::string& text) {
             row.entry.lookup =
                 named(lookups, text, "look-up", [](const NamedLookup& each) { return each.name; }).lookup;
         }},
        cell<LookUpRow>(
            "cube_n", [](auto& row) -> auto& { return row.cubeN; }),
        cell<LookUpRow>(
            "n", [](auto& row) -> auto& { return row.entry.n; }),
        cell<LookUpRow>(
            "frames", [](auto& row) -> auto& { return row.frames; }),
        milliseconds("pass_1_ms", &LookUpRow::capture, &Quartiles::median),
        milliseconds("reflector_ms", &LookUpRow::mirror, &Quartiles::median),
        milliseconds("both_ms", &LookUpRow::both, &Quartiles::median),
        milliseconds("both_ms_lower_quartile", &LookUpRow::both, &Quartiles::lower),
        milliseconds("both_ms_upper_quartile", &LookUpRow::both, &Quartiles::upper),
        cell<LookUpRow>(
            "ratio", [](auto& row) -> auto& { return row.ratio; }),
        milliseconds("frame_wall_ms", &LookUpRow::frameWall, &Quartiles::median),
        derived<LookUpRow>("frames_per_second",
                           [](const LookUpRow& row) { return spelled(row.framesPerSecond()); }),
        cell<LookUpRow>(
            "pixels_judged", [](auto& row) -> auto& { return row.errors.pixels; }),
        pictureError("angle_degrees_mean", &ParallaxErrors::mean),
        pictureError("angle_degrees_p95", &ParallaxErrors::p95),
        pictureError("angle_degrees_max", &ParallaxErrors::max),
        pictureError("wrong_surface_percent", &ParallaxErrors::wrongPercent),
        pictureError("wrong_surface_percent_grazing", &ParallaxErrors::grazingWrongPercent),
        pictureError("psnr_db", &ParallaxErrors::psnr),
        pictureError("flip", &ParallaxErrors::flip),
        cell<LookUpRow>(
            "costs_of", [](auto& row) -> auto& { return row.costsOf; }),
        cell<LookUpRow>(
            "run", [](auto& row) -> auto& { return row.run; }),
    };
}

// What numbers must be for a report to be made of them.
void requireUsable(const Row& row)
{
    if (row.entry.n < 1 || row.group.cubeN < 1 || row.sceneTriangles < 1 || row.sceneVertices < 1)
        throw BadCell{"a size or count is less than 1"};
    if (!(row.cpuRatio > 0.0 && row.wallRatio > 0.0 && row.costRatioToBest > 0.0 &&
          row.gpuRatio.value_or(1.0) > 0.0))
        throw BadCell{"a ratio is not positive"};
}

void requireUsable(const LookUpRow& row)
{
    if (row.entry.n < 1 || row.cubeN < 1)
        throw BadCell{"a size is less than 1"};
    if (!(row.ratio > 0.0 && row.frameWall.median > 0.0))
        throw BadCell{"a ratio or time is not positive"};
}

} // namespace

void writeCsv(std::ostream& out, const std::vector<Row>& rows)
{
    writeTable(out, captureColumns(), rows);
}

void writeCsv(std::ostream& out, const std::vector<LookUpRow>& rows)
{
    writeTable(out, lookUpColumns(), rows);
}

std::vector<Row> readCaptures(std::istream& in, const std::string& name)
{
    std::vector<Row> rows = readTable(in, name, captureColumns(), requireUsable);
    for (Row& row : rows) {
        row.measures = measuresOf(row.entry.map, row.entry.n);
        const bool isOwn = row.group.isRivalCheck && row.sceneVertices == 3 * row.sceneTriangles;
        row.group.vertices = isOwn ? Vertices::own : Vertices::shared;
    }
    return rows;
}

std::vector<LookUpRow> readLookUps(std::istream& in, const std::string& name)
{
    return readTable(in, name, lookUpColumns(), requireUsable);
}

} // namespace tests::benchmark
