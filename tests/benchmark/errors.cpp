#include "errors.h"

#include "reference_direction.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tests::benchmark {

namespace {

// The Embree trace is exact to float: within this of an edge either neighbour may be right.
constexpr double edgeTolerance = 1e-5; // radians
constexpr double distanceTolerance = 1e-4;
constexpr double surfaceTolerance = 1e-5; // relative: a drawn point this near to a triangle lies on it
constexpr std::size_t mostTexels = std::size_t(1) << 19;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Between a unit direction and the arc from a to b.
double angleToArc(const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b)
{
    const double atEnds = std::min(angleBetween(direction, a), angleBetween(direction, b));
    const glm::dvec3 normal = glm::cross(a, b);
    const double length = glm::length(normal);
    const bool isBeside =
        glm::dot(glm::cross(normal, a), direction) > 0.0 && glm::dot(glm::cross(b, normal), direction) > 0.0;
    if (!(length > 0.0) || !isBeside)
        return atEnds;
    return std::min(atEnds, std::abs(std::asin(std::clamp(glm::dot(direction, normal) / length, -1.0, 1.0))));
}

double distanceToSegment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double squared = glm::dot(along, along);
    const double part = squared > 0.0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + part * along);
}

double distanceToTriangle(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners)
{
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    bool isAbove = glm::length(normal) > 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3 &a = corners[corner], &b = corners[(corner + 1) % 3];
        least = std::min(least, distanceToSegment(point, a, b));
        isAbove = isAbove && glm::dot(glm::cross(b - a, point - a), normal) >= 0.0;
    }
    return isAbove ? std::abs(glm::dot(point - corners[0], normal)) / glm::length(normal) : least;
}

// Triangles by their number over all meshes of a scene, as seen from the probe.
class TriangleTable
{
public:
    TriangleTable(const examples::Scene& scene, const glm::dvec3& at)
        : scene_(scene), offset_(scene.offset - at)
    {
        for (const examples::Mesh& mesh : scene.meshes) {
            first_.push_back(count_);
            count_ += mesh.triangles.size();
        }
    }

    double edgeAngle(std::size_t triangle, const glm::dvec3& direction) const
    {
        if (triangle >= count_)
            return std::numeric_limits<double>::infinity();
        const std::array<glm::dvec3, 3> corners = cornersOf(triangle);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t corner = 0; corner < 3; ++corner)
            least = std::min(least, angleToArc(direction, corners[corner], corners[(corner + 1) % 3]));
        return least;
    }

    bool holds(std::size_t triangle, const glm::dvec3& point) const
    {
        return triangle < count_ &&
               distanceToTriangle(point, cornersOf(triangle)) <= surfaceTolerance * glm::length(point);
    }

private:
    std::array<glm::dvec3, 3> cornersOf(std::size_t triangle) const
    {
        const auto after = std::upper_bound(first_.begin(), first_.end(), triangle);
        const auto meshIndex = static_cast<std::size_t>(after - first_.begin()) - 1;
        const examples::Mesh& mesh = scene_.meshes[meshIndex];
        const auto& corners = mesh.triangles[triangle - first_[meshIndex]];
        return {position(mesh, corners[0]), position(mesh, corners[1]), position(mesh, corners[2])};
    }

    glm::dvec3 position(const examples::Mesh& mesh, std::uint32_t vertex) const
    {
        return glm::dvec3(mesh.positions[vertex]) + offset_;
    }

    const examples::Scene& scene_;
    glm::dvec3 offset_;
    std::vector<std::size_t> first_;
    std::size_t count_ = 0;
};

Spread spreadOf(std::vector<double> values)
{
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    const auto count = static_cast<double>(values.size());
    return {sum / count, values[static_cast<std::size_t>(0.95 * (count - 1.0))], values.back()};
}

// Whether the direction's own place on the map is this texel; so not in an overlap, a corner outside a disc.
bool belongs(mirrorball::MapKind map, int component, const glm::dvec2& uv, const glm::dvec3& direction,
             const glm::dvec2& texel)
{
    const auto place = mirrorball::coordinateFromDirection(map, direction);
    const glm::dvec2 off = glm::abs(place.uv - uv);
    return place.component == component && off.x < 0.5 * texel.x && off.y < 0.5 * texel.y;
}

} // namespace

std::vector<TrueTexel> traceMap(const examples::ReferenceTracer& tracer, const SceneChoice& scene,
                                mirrorball::MapKind map, int n, const glm::dmat3& worldFromProbe)
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(map);
    const int width = info.widthInN * n, height = info.heightInN * n;
    const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                               static_cast<std::size_t>(info.components);
    const auto step =
        static_cast<int>(std::ceil(std::sqrt(static_cast<double>(texels) / static_cast<double>(mostTexels))));
    const glm::dvec2 texel(1.0 / width, 1.0 / height);
    const int rowsJudged = (height + step - 1) / step;
    std::vector<std::vector<TrueTexel>> rows(static_cast<std::size_t>(info.components * rowsJudged));
    examples::forEachRow(static_cast<int>(rows.size()), [&](int job) {
        const int component = job / rowsJudged, row = job % rowsJudged * step;
        for (int column = 0; column < width; column += step) {
            const glm::dvec2 uv = glm::dvec2(column + 0.5, row + 0.5) * texel;
            const glm::dvec3 inProbe =
                examples::referenceRay(info.name, component, column, row, width, height);
            if (!belongs(map, component, uv, inProbe, texel))
                continue;
            const glm::dvec3 ray = worldFromProbe * inProbe;
            const examples::Hit hit =
                tracer.trace(scene.at, ray, static_cast<double>(scene.near), static_cast<double>(scene.far));
            const auto index =
                static_cast<std::size_t>(component * height + row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column);
            rows[static_cast<std::size_t>(job)].push_back(
                {index, glm::normalize(ray), hit.distance, hit.edgeAngle, hit.triangle});
        }
    });
    std::vector<TrueTexel> result;
    for (const std::vector<TrueTexel>& row : rows)
        result.insert(result.end(), row.begin(), row.end());
    return result;
}

Errors errorsOf(const MakeContender& make, const std::vector<TrueTexel>& truth, const examples::Scene& scene,
                const glm::dvec3& at)
{
    const auto imagesOf = [&](examples::View view) {
        const std::unique_ptr<Contender> contender = make(view);
        contender->draw();
        return contender->read();
    };
    const MapImages triangles = imagesOf(examples::View::triangle);
    const MapImages positions = imagesOf(examples::View::position);
    const TriangleTable table(scene, at);

    std::size_t wrong = 0, offEdge = 0, holes = 0;
    double distanceOffEdge = 0.0;
    std::vector<double> distances, directions, directionsWhereWrong;
    for (const TrueTexel& texel : truth) {
        const auto drawn = static_cast<double>(triangles.distance[texel.index]);
        const bool isDrawn = std::isfinite(drawn), isThere = std::isfinite(texel.distance);
        const auto triangle = static_cast<std::size_t>(isDrawn ? triangles.rgba[4 * texel.index] : 0.0f);
        const double distanceError =
            isDrawn && isThere ? std::abs(drawn - texel.distance) / texel.distance : 0.0;
        const float* const rgb = &positions.rgba[4 * texel.index];
        const glm::dvec3 position(rgb[0], rgb[1], rgb[2]);
        const bool isWrong =
            isDrawn != isThere || (isThere && distanceError > distanceTolerance &&
                                   triangle != texel.triangle && !table.holds(texel.triangle, position));
        if (isDrawn) {
            const double angle = glm::degrees(angleBetween(texel.unitDirection, position));
            directions.push_back(angle);
            if (isWrong)
                directionsWhereWrong.push_back(angle);
        }
        if (isDrawn && isThere && !isWrong) {
            distances.push_back(distanceError);
            if (texel.edgeAngle > edgeTolerance)
                distanceOffEdge = std::max(distanceOffEdge, distanceError);
        }
        if (!isWrong)
            continue;
        ++wrong;
        holes += isDrawn ? 0 : 1;
        const double edgeAngle = std::min(isThere ? texel.edgeAngle : std::numeric_limits<double>::infinity(),
                                          isDrawn && table.holds(triangle, position)
                                              ? table.edgeAngle(triangle, texel.unitDirection)
                                              : std::numeric_limits<double>::infinity());
        offEdge += edgeAngle > edgeTolerance ? 1 : 0;
    }
    const auto percent = [&](std::size_t count) {
        return truth.empty() ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(truth.size());
    };
    return {truth.size(),        percent(wrong),  percent(offEdge),     percent(holes),
            spreadOf(distances), distanceOffEdge, spreadOf(directions), spreadOf(directionsWhereWrong).mean};
}

} // namespace tests::benchmark
