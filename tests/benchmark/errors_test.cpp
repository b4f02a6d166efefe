// The judge of maps judged: contenders with errors that are known.
#include "errors.h"

#include "support/check.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <functional>
#include <limits>

namespace {

using namespace tests::benchmark;
using mirrorball::MapKind;

constexpr int n = 16;
constexpr std::size_t texels = 6 * n * n;
// What a 32-bit float may be off by, twice over: distance and position are stored as floats.
constexpr double rounding = 0x1p-23;

// Shows what it is told: a distance and a triangle for each texel that is judged.
struct Shown
{
    double distance;
    std::uint32_t triangle;
    glm::dvec3 direction; // of the point that is shown
};
using Painter = std::function<Shown(const TrueTexel&)>;

class Painted : public Contender
{
public:
    Painted(const std::vector<TrueTexel>& truth, const Painter& painter, examples::View view)
    {
        images_.rgba.assign(4 * texels, 0.0f);
        images_.distance.assign(texels, std::numeric_limits<float>::infinity());
        for (const TrueTexel& texel : truth) {
            const Shown shown = painter(texel);
            float* const rgba = &images_.rgba[4 * texel.index];
            for (int axis = 0; axis < 3; ++axis)
                rgba[axis] = static_cast<float>(shown.distance * shown.direction[axis]);
            if (view == examples::View::triangle)
                rgba[0] = static_cast<float>(shown.triangle);
            images_.distance[texel.index] = static_cast<float>(shown.distance);
        }
    }

    Work draw() override { return {}; }
    MapImages read() const override { return images_; }

private:
    MapImages images_;
};

Shown truthful(const TrueTexel& texel)
{
    return {texel.distance, texel.triangle, texel.unitDirection};
}

// One wall of two triangles, which fills a part of the view towards +x; the rest is sky.
examples::Scene wall()
{
    examples::Scene scene;
    scene.materials.emplace_back();
    examples::Mesh mesh;
    mesh.positions = {{2, -2, -2}, {2, 2, -2}, {2, 2, 2}, {2, -2, 2}};
    mesh.normals.assign(4, {-1, 0, 0});
    mesh.textureCoordinates.assign(4, {0, 0});
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.meshes.push_back(mesh);
    return scene;
}

constexpr SceneChoice choice = {"wall", "", glm::dvec3(0.0), 0.1f, 100.0f, false, false, false, 1.0, {}};

struct Judge
{
    examples::Scene scene = wall();
    std::vector<TrueTexel> truth =
        traceMap(examples::ReferenceTracer(scene, choice.at), choice, MapKind::cube, n);

    Errors errors(const Painter& painter) const
    {
        return errorsOf([&](examples::View view) { return std::make_unique<Painted>(truth, painter, view); },
                        truth, scene, choice.at);
    }
};

const Judge& judge()
{
    static const Judge theJudge;
    return theJudge;
}

void everyTexelOfACubeIsJudged()
{
    CHECK(judge().truth.size() == texels);
    for (const TrueTexel& texel : judge().truth)
        CHECK_NEAR(glm::length(texel.unitDirection), 1.0, 1e-15);
}

void theTruthHasNoError()
{
    const Errors errors = judge().errors(truthful);
    CHECK(errors.texels == texels);
    CHECK(errors.wrongPercent == 0.0 && errors.wrongOffEdgePercent == 0.0 && errors.holePercent == 0.0);
    CHECK(errors.relativeDistance.largest <= rounding);
    CHECK(errors.directionDegrees.largest <= 60.0 * rounding); // degrees
}

void nothingDrawnIsAllHoles()
{
    std::size_t surfaces = 0;
    for (const TrueTexel& texel : judge().truth)
        surfaces += std::isfinite(texel.distance) ? 1 : 0;
    CHECK(surfaces > 0 && surfaces < texels);
    const Errors errors = judge().errors([](const TrueTexel& texel) {
        return Shown{std::numeric_limits<double>::infinity(), 0, texel.unitDirection};
    });
    const double share = 100.0 * static_cast<double>(surfaces) / static_cast<double>(texels);
    CHECK_NEAR(errors.holePercent, share, 1e-9);
    CHECK_NEAR(errors.wrongPercent, share, 1e-9);
}

// A neighbour at the same distance is the same surface; far from it, it is another one.
void anotherTriangleIsWrongWhereItLiesElsewhere()
{
    const auto shifted = [](double factor) {
        return [=](const TrueTexel& texel) {
            return Shown{factor * texel.distance, texel.triangle + 1, texel.unitDirection};
        };
    };
    CHECK(judge().errors(shifted(1.0 + 0.9e-4)).wrongPercent == 0.0);
    const Errors errors = judge().errors(shifted(1.0 + 1.1e-4));
    CHECK(errors.wrongPercent > 0.0 && errors.holePercent == 0.0);
    CHECK(errors.wrongOffEdgePercent > 0.9 * errors.wrongPercent);
}

// A point of the true triangle is of it, whatever number is drawn; beside it, or off its plane, it is not.
void aTriangleIsToldByItsPointsToo()
{
    const auto moved = [](double along, double off) {
        return [=](const TrueTexel& texel) {
            if (!std::isfinite(texel.distance))
                return truthful(texel);
            const glm::dvec3 centre =
                texel.triangle == 0 ? glm::dvec3(2, 0.5, -0.5) : glm::dvec3(2, -0.5, 0.5);
            const glm::dvec3 point =
                glm::mix(texel.distance * texel.unitDirection, centre, along) * (1.0 + off);
            return Shown{glm::length(point), 1000, glm::normalize(point)};
        };
    };
    const Errors within = judge().errors(moved(0.1, 0.0));
    CHECK(within.wrongPercent == 0.0);
    CHECK(within.relativeDistance.largest > 1e-3);
    CHECK(judge().errors(moved(0.1, 1e-4)).wrongPercent > 0.0);
    CHECK(judge().errors(moved(-0.1, 0.0)).wrongOffEdgePercent > 0.0);
}

// An edge-on triangle is narrower than float resolves: distances at its edges are judged apart.
void distancesAtEdgesAreJudgedApart()
{
    Judge parted;
    bool isAtEdge = false;
    for (TrueTexel& texel : parted.truth)
        if (std::isfinite(texel.distance))
            texel.edgeAngle = (isAtEdge = !isAtEdge) ? 0.9e-5 : 1.1e-5;
    const Errors errors = parted.errors([](const TrueTexel& texel) {
        return Shown{(texel.edgeAngle < 1e-5 ? 1.02 : 1.01) * texel.distance, texel.triangle,
                     texel.unitDirection};
    });
    CHECK_NEAR(errors.relativeDistance.largest, 0.02, 2.0 * rounding);
    CHECK_NEAR(errors.largestRelativeDistanceOffEdges, 0.01, 2.0 * rounding);
}

void distanceAndDirectionAreMeasured()
{
    const double angle = glm::radians(0.5);
    const Errors errors = judge().errors([=](const TrueTexel& texel) {
        const glm::dvec3 other =
            std::abs(texel.unitDirection.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 across = glm::normalize(glm::cross(texel.unitDirection, other));
        return Shown{1.01 * texel.distance, texel.triangle,
                     std::cos(angle) * texel.unitDirection + std::sin(angle) * across};
    });
    CHECK(errors.wrongPercent == 0.0);
    CHECK_NEAR(errors.relativeDistance.mean, 0.01, 2.0 * rounding);
    CHECK_NEAR(errors.directionDegrees.mean, 0.5, 60.0 * rounding);
    CHECK_NEAR(errors.directionDegrees.p95, 0.5, 60.0 * rounding);
}

} // namespace

int main()
{
    everyTexelOfACubeIsJudged();
    theTruthHasNoError();
    nothingDrawnIsAllHoles();
    anotherTriangleIsWrongWhereItLiesElsewhere();
    aTriangleIsToldByItsPointsToo();
    distancesAtEdgesAreJudgedApart();
    distanceAndDirectionAreMeasured();
}
