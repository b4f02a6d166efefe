#include "csv.h"

#include <glm/trigonometric.hpp>

#include <functional>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

namespace tests::benchmark {

namespace {

template <class RowType>
struct Column
{
    const char* name;
    std::function<std::string(const RowType&)> text;
};

std::string number(double value)
{
    std::ostringstream out;
    out << std::setprecision(6) << value;
    return out.str();
}

std::string inQuotes(std::string_view text)
{
    return "\"" + std::string(text) + "\"";
}

template <class Value>
std::string optional(const std::optional<Value>& value)
{
    return value ? number(static_cast<double>(*value)) : "";
}

Column<Row> error(const char* name, double Errors::*member)
{
    return {name, [=](const Row& row) { return row.errors ? number((*row.errors).*member) : ""; }};
}

Column<Row> error(const char* name, Spread Errors::*spread, double Spread::*member)
{
    return {name, [=](const Row& row) { return row.errors ? number((*row.errors).*spread.*member) : ""; }};
}

Column<Row> time(const char* name, Quartiles Timing::*quartiles, double Quartiles::*member)
{
    return {name, [=](const Row& row) { return number(row.timing.*quartiles.*member); }};
}

std::vector<Column<Row>> captureColumns()
{
    return {
        {"scene", [](const Row& row) { return inQuotes(row.group.scene->name); }},
        {"scene_triangles", [](const Row& row) { return std::to_string(row.sceneTriangles); }},
        {"scene_vertices", [](const Row& row) { return std::to_string(row.sceneVertices); }},
        {"by", [](const Row& row) { return std::string(row.entry.rival ? "hand" : "mirrorball"); }},
        {"map", [](const Row& row) { return std::string(mirrorball::mapInfo(row.entry.map).name); }},
        {"method", [](const Row& row) { return inQuotes(row.entry.methodName()); }},
        {"sizing", [](const Row& row) { return std::string(nameOf(row.entry.sizing)); }},
        {"cube_n", [](const Row& row) { return std::to_string(row.group.cubeN); }},
        {"n", [](const Row& row) { return std::to_string(row.entry.n); }},
        {"back_faces_culled",
         [](const Row& row) { return std::string(row.group.cullBackFaces ? "1" : "0"); }},
        {"texels", [](const Row& row) { return std::to_string(row.measures.texels); }},
        {"worst_texel_degrees",
         [](const Row& row) { return number(glm::degrees(row.measures.worstDiagonal)); }},
        {"frames", [](const Row& row) { return std::to_string(row.timing.frames); }},
        time("cpu_ms", &Timing::cpu, &Quartiles::median),
        time("cpu_ms_lower_quartile", &Timing::cpu, &Quartiles::lower),
        time("cpu_ms_upper_quartile", &Timing::cpu, &Quartiles::upper),
        {"cost_ms_before_rasteriser", [](const Row& row) { return number(row.costBeforeRasteriser.median); }},
        time("wall_ms", &Timing::wall, &Quartiles::median),
        time("wall_ms_lower_quartile", &Timing::wall, &Quartiles::lower),
        time("wall_ms_upper_quartile", &Timing::wall, &Quartiles::upper),
        {"gpu_ms", [](const Row& row) { return row.timing.gpu ? number(row.timing.gpu->median) : ""; }},
        {"cpu_ratio", [](const Row& row) { return number(row.cpuRatio); }},
        {"wall_ratio", [](const Row& row) { return number(row.wallRatio); }},
        {"gpu_ratio", [](const Row& row) { return optional(row.gpuRatio); }},
        {"cost_ratio_to_best_cube", [](const Row& row) { return number(row.costRatioToBest); }},
        {"draws", [](const Row& row) { return std::to_string(row.work.sent.draws); }},
        {"triangles_sent", [](const Row& row) { return std::to_string(row.work.sent.triangles); }},
        {"vertex_shader_runs", [](const Row& row) { return optional(row.work.vertexShaderRuns); }},
        {"primitives_clipped", [](const Row& row) { return optional(row.work.primitivesClipped); }},
        {"fragment_shader_runs", [](const Row& row) { return optional(row.work.fragmentShaderRuns); }},
        {"texels_judged",
         [](const Row& row) { return row.errors ? std::to_string(row.errors->texels) : ""; }},
        error("wrong_texels_percent", &Errors::wrongPercent),
        error("wrong_texels_off_edges_percent", &Errors::wrongOffEdgePercent),
        error("holes_percent", &Errors::holePercent),
        error("relative_distance_error_mean", &Errors::relativeDistance, &Spread::mean),
        error("relative_distance_error_p95", &Errors::relativeDistance, &Spread::p95),
        error("relative_distance_error_max", &Errors::relativeDistance, &Spread::largest),
        error("relative_distance_error_max_off_edges", &Errors::largestRelativeDistanceOffEdges),
        error("direction_error_degrees_mean", &Errors::directionDegrees, &Spread::mean),
        error("direction_error_degrees_p95", &Errors::directionDegrees, &Spread::p95),
        error("direction_error_degrees_max", &Errors::directionDegrees, &Spread::largest),
        error("direction_error_degrees_mean_where_wrong", &Errors::directionDegreesWhereWrong),
    };
}

Column<LookUpRow> milliseconds(const char* name, Quartiles LookUpRow::*quartiles, double Quartiles::*member)
{
    return {name, [=](const LookUpRow& row) { return number(row.*quartiles.*member); }};
}

Column<LookUpRow> pictureError(const char* name, double ParallaxErrors::*member)
{
    return {name, [=](const LookUpRow& row) { return number(row.errors.*member); }};
}

std::vector<Column<LookUpRow>> lookUpColumns()
{
    return {
        {"scene", [](const LookUpRow& row) { return inQuotes(row.scene->name); }},
        {"by", [](const LookUpRow& row) { return std::string(row.entry.isByHand ? "hand" : "mirrorball"); }},
        {"map", [](const LookUpRow& row) { return std::string(mirrorball::mapInfo(row.entry.map).name); }},
        {"look_up", [](const LookUpRow& row) { return std::string(nameOf(row.entry.lookup)); }},
        {"cube_n", [](const LookUpRow& row) { return std::to_string(row.cubeN); }},
        {"n", [](const LookUpRow& row) { return std::to_string(row.entry.n); }},
        {"frames", [](const LookUpRow& row) { return std::to_string(row.frames); }},
        milliseconds("pass_1_ms", &LookUpRow::capture, &Quartiles::median),
        milliseconds("reflector_ms", &LookUpRow::mirror, &Quartiles::median),
        milliseconds("both_ms", &LookUpRow::both, &Quartiles::median),
        milliseconds("both_ms_lower_quartile", &LookUpRow::both, &Quartiles::lower),
        milliseconds("both_ms_upper_quartile", &LookUpRow::both, &Quartiles::upper),
        {"ratio", [](const LookUpRow& row) { return number(row.ratio); }},
        milliseconds("frame_wall_ms", &LookUpRow::frameWall, &Quartiles::median),
        {"frames_per_second", [](const LookUpRow& row) { return number(row.framesPerSecond()); }},
        {"pixels_judged", [](const LookUpRow& row) { return std::to_string(row.errors.pixels); }},
        pictureError("angle_degrees_mean", &ParallaxErrors::mean),
        pictureError("angle_degrees_p95", &ParallaxErrors::p95),
        pictureError("angle_degrees_max", &ParallaxErrors::max),
        pictureError("wrong_surface_percent", &ParallaxErrors::wrongPercent),
        pictureError("wrong_surface_percent_grazing", &ParallaxErrors::grazingWrongPercent),
        pictureError("psnr_db", &ParallaxErrors::psnr),
        pictureError("flip", &ParallaxErrors::flip),
    };
}

template <class RowType>
void write(std::ostream& out, const std::vector<Column<RowType>>& columns, const std::vector<RowType>& rows)
{
    for (std::size_t index = 0; index < columns.size(); ++index)
        out << (index > 0 ? "," : "") << columns[index].name;
    out << '\n';
    for (const RowType& row : rows) {
        for (std::size_t index = 0; index < columns.size(); ++index)
            out << (index > 0 ? "," : "") << columns[index].text(row);
        out << '\n';
    }
}

} // namespace

void writeCsv(std::ostream& out, const std::vector<Row>& rows)
{
    write(out, captureColumns(), rows);
}

void writeCsv(std::ostream& out, const std::vector<LookUpRow>& rows)
{
    write(out, lookUpColumns(), rows);
}

} // namespace tests::benchmark
