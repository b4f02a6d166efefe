#include <mirrorball/maps/measures.h>

#include <mirrorball/maps/visit.h>
#include <mirrorball/math/dual.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <numbers>

namespace mirrorball {
namespace {

// Accurate for small angles, where the arc cosine is not.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The measures of a map, texel by texel.
class Sums
{
public:
    Sums(MapKind map, int n) : map_(map)
    {
        measures_.width = n * mapInfo(map).widthInN;
        measures_.height = n * mapInfo(map).heightInN;
        measures_.texels =
            static_cast<long long>(mapInfo(map).components) * measures_.width * measures_.height;
        measures_.smallestSolidAngle = std::numeric_limits<double>::infinity();
        idealSolidAngle_ = 4 * std::numbers::pi / static_cast<double>(measures_.texels);
    }

    void add(int component, int column, int row)
    {
        const glm::dvec2 centre((column + 0.5) / measures_.width, (row + 0.5) / measures_.height);
        const Jacobian j = jacobian(map_, component, centre);
        if (!isUsed(component, centre, j.direction))
            return;
        ++measures_.used;
        const double texelArea = 1.0 / measures_.width / measures_.height;
        const double solidAngle = solidAngleDensity(j) * texelArea / idealSolidAngle_;
        measures_.largestSolidAngle = std::max(measures_.largestSolidAngle, solidAngle);
        measures_.smallestSolidAngle = std::min(measures_.smallestSolidAngle, solidAngle);
        solidAngles_ += solidAngle;

        const double diagonal =
            texelDiagonal(map_, component, column, row, measures_.width, measures_.height);
        measures_.worstDiagonal = std::max(measures_.worstDiagonal, diagonal);
        diagonals_ += diagonal * solidAngle;

        const Stretch stretch = texelStretch(j, measures_.width, measures_.height);
        const double ratio = stretch.longest / stretch.shortest;
        measures_.worstStretch = std::max(measures_.worstStretch, ratio);
        stretches_ += ratio * solidAngle;
    }

    MapMeasures result() const
    {
        MapMeasures result = measures_;
        result.meanDiagonal = diagonals_ / solidAngles_;
        result.meanStretch = stretches_ / solidAngles_;
        return result;
    }

private:
    // The direction at the texel's centre belongs there, and not to another component or texel.
    bool isUsed(int component, const glm::dvec2& centre, const glm::dvec3& direction) const
    {
        const MapCoordinate<double> owner = coordinateFromDirection(map_, direction);
        const glm::dvec2 offset = glm::abs(owner.uv - centre);
        return owner.component == component && offset.x * measures_.width < 0.5 &&
               offset.y * measures_.height < 0.5;
    }

    MapKind map_;
    MapMeasures measures_;
    double idealSolidAngle_;
    double diagonals_ = 0;
    double solidAngles_ = 0;
    double stretches_ = 0;
};

} // namespace

Jacobian jacobian(MapKind map, int component, const glm::dvec2& uv)
{
    assert(component >= 0 && component < mapInfo(map).components);
    const Vec2<Dual> variables{Dual(uv.x, 1, 0), Dual(uv.y, 0, 1)};
    return visitMap(map, [&](auto formula) {
        const Vec3<Dual> d = formula.directionFromSquare(component, regularSquare(variables));
        return Jacobian{{d.x.value, d.y.value, d.z.value},
                        {d.x.alongU, d.y.alongU, d.z.alongU},
                        {d.x.alongV, d.y.alongV, d.z.alongV}};
    });
}

glm::dvec2 squareDerivative(MapKind map, int component, const glm::dvec3& direction, const glm::dvec3& change)
{
    assert(component >= 0 && component < mapInfo(map).components);
    const auto variable = [&](int axis) { return Dual(direction[axis], change[axis], 0.0); };
    return visitMap(map, [&](auto formula) {
        const Vec2<Dual> uv =
            formula.squareFromDirection(component, Vec3<Dual>{variable(0), variable(1), variable(2)});
        return glm::dvec2(uv.x.alongU, uv.y.alongU);
    });
}

double solidAngleDensity(const Jacobian& jacobian)
{
    return glm::length(glm::cross(jacobian.alongU, jacobian.alongV));
}

Stretch texelStretch(const Jacobian& jacobian, int width, int height)
{
    // The singular values of the matrix with columns a and b: their squares have the sum |a|² + |b|², and
    // their product is |a x b|.
    const glm::dvec3 a = jacobian.alongU / static_cast<double>(width);
    const glm::dvec3 b = jacobian.alongV / static_cast<double>(height);
    const double sum = glm::dot(a, a) + glm::dot(b, b);
    const double product = glm::length(glm::cross(a, b));
    const double longest =
        std::sqrt(0.5 * (sum + std::sqrt(std::max(sum * sum - 4 * product * product, 0.0))));
    return {longest, longest > 0 ? product / longest : 0};
}

double texelDiagonal(MapKind map, int component, int column, int row, int width, int height)
{
    const auto corner = [&](int right, int down) {
        const glm::dvec2 uv(static_cast<double>(column + right) / width,
                            static_cast<double>(row + down) / height);
        return directionFromSquare(map, component, uv);
    };
    return std::max(angleBetween(corner(0, 0), corner(1, 1)), angleBetween(corner(1, 0), corner(0, 1)));
}

MapMeasures mapMeasures(MapKind map, int n)
{
    assert(n >= 1);
    Sums sums(map, n);
    const MapInfo& info = mapInfo(map);
    for (int component = 0; component < info.components; ++component)
        for (int row = 0; row < n * info.heightInN; ++row)
            for (int column = 0; column < n * info.widthInN; ++column)
                sums.add(component, column, row);
    return sums.result();
}

int shortSideFromTexels(MapKind map, double texels)
{
    const MapInfo& info = mapInfo(map);
    const double side = std::sqrt(texels / (info.components * info.widthInN * info.heightInN));
    return static_cast<int>(std::clamp(std::round(side), 1.0, 46340.0));
}

} // namespace mirrorball
