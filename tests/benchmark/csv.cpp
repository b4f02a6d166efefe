#include "csv.h"

#include <glm/trigonometric.hpp>

#include <functional>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

namespace tests::benchmark {

namespace {

struct Column
{
    const char* name;
    std::function<std::string(const Row&)> text;
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

Column error(const char* name, double Errors::*member)
{
    return {name, [=](const Row& row) { return row.errors ? number((*row.errors).*member) : ""; }};
}

Column error(const char* name, Spread Errors::*spread, double Spread::*member)
{
    return {name, [=](const Row& row) { return row.errors ? number((*row.errors).*spread.*member) : ""; }};
}

Column time(const char* name, Quartiles Timing::*quartiles, double Quartiles::*member)
{
    return {name, [=](const Row& row) { return number(row.timing.*quartiles.*member); }};
}

std::vector<Column> columns()
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
        time("wall_ms", &Timing::wall, &Quartiles::median),
        time("wall_ms_lower_quartile", &Timing::wall, &Quartiles::lower),
        time("wall_ms_upper_quartile", &Timing::wall, &Quartiles::upper),
        {"gpu_ms", [](const Row& row) { return row.timing.gpu ? number(row.timing.gpu->median) : ""; }},
        {"cpu_ratio", [](const Row& row) { return number(row.cpuRatio); }},
        {"wall_ratio", [](const Row& row) { return number(row.wallRatio); }},
        {"gpu_ratio", [](const Row& row) { return optional(row.gpuRatio); }},
        {"cpu_ratio_to_best_cube", [](const Row& row) { return number(row.cpuRatioToBest); }},
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
        error("direction_error_degrees_mean", &Errors::directionDegrees, &Spread::mean),
        error("direction_error_degrees_p95", &Errors::directionDegrees, &Spread::p95),
        error("direction_error_degrees_max", &Errors::directionDegrees, &Spread::largest),
        error("direction_error_degrees_mean_where_wrong", &Errors::directionDegreesWhereWrong),
    };
}

} // namespace

void writeCsv(std::ostream& out, const std::vector<Row>& rows)
{
    const std::vector<Column> all = columns();
    for (std::size_t index = 0; index < all.size(); ++index)
        out << (index > 0 ? "," : "") << all[index].name;
    out << '\n';
    for (const Row& row : rows) {
        for (std::size_t index = 0; index < all.size(); ++index)
            out << (index > 0 ? "," : "") << all[index].text(row);
        out << '\n';
    }
}

} // namespace tests::benchmark
