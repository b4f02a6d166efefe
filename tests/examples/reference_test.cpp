// Which triangle the reference tracer's rays meet, and where: against every triangle tried in double, and
// values worked out by hand.
#include "reference.h"
#include "small_scenes.h"

#include "support/check.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using examples::Hit;
using examples::Mesh;
using examples::ReferenceTracer;
using examples::Scene;
using tests::isNear;
using tests::sceneOf;
using tests::triangle;
using tests::wall;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- Against every triangle in double --------------------------------------------------------------

struct Brute
{
    double distance = infinity;
    std::uint32_t triangle = 0;
    double second = infinity; // the next one behind
};

Brute bruteForce(const Scene& scene, const glm::dvec3& start, const glm::dvec3& direction)
{
    Brute best;
    std::uint32_t number = 0;
    for (const Mesh& mesh : scene.meshes) {
        for (const auto& t : mesh.triangles) {
            const auto corner = [&](std::size_t k) {
                return glm::dvec3(mesh.positions[t[k]]) + (scene.offset - start);
            };
            const glm::dvec3 a = corner(0);
            const glm::dvec3 b = corner(1);
            const glm::dvec3 c = corner(2);
            const double u = glm::dot(direction, glm::cross(b, c));
            const double v = glm::dot(direction, glm::cross(c, a));
            const double w = glm::dot(direction, glm::cross(a, b));
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const double distance = glm::dot(a, normal) / glm::dot(direction, normal);
            const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
            if (inside && distance > 0.0) {
                if (distance < best.distance) {
                    best = {distance, number, best.distance};
                } else {
                    best.second = std::min(best.second, distance);
                }
            }
            ++number;
        }
    }
    return best;
}

Scene randomScene(const glm::dvec3& offset)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(-10.0f, 10.0f);
    const auto point = [&] {
        const float x = place(random);
        const float y = place(random);
        return glm::vec3(x, y, place(random));
    };
    std::vector<Mesh> meshes;
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 at = point();
        Mesh mesh = triangle(at, at + 0.3f * point(), at + 0.3f * point(), {0, 0, 1});
        mesh.positions.push_back(at + 0.2f * point());
        mesh.normals.push_back({0, 1, 0});
        mesh.textureCoordinates.push_back({1, 1});
        mesh.triangles.push_back({1, 3, 2});
        meshes.push_back(mesh);
    }
    Scene scene = sceneOf(std::move(meshes));
    scene.offset = offset;
    return scene;
}

void testBruteForce(const glm::dvec3& offset)
{
    const Scene scene = randomScene(offset);
    const ReferenceTracer tracer(scene, offset);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    int hits = 0;
    int compared = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double x = normal(random);
        const double y = normal(random);
        const glm::dvec3 direction = glm::normalize(glm::dvec3(x, y, normal(random)));
        const Brute expected = bruteForce(scene, offset, direction);
        const Hit hit = tracer.trace(offset, direction, 0.0, infinity);
        // Embree works in float, relative to the origin: beside an edge, and where two surfaces lie closer
        // together than that, it may take the other one. 1e-5 is some fifty roundings of the coordinates, at
        // most 13, in triangles seen not too steeply.
        if (hit.found && hit.edgeAngle < 1e-5) {
            continue;
        }
        if (expected.second - expected.distance < 1e-4) {
            continue;
        }
        ++compared;
        CHECK(hit.found == (expected.distance < infinity));
        if (hit.found) {
            ++hits;
            CHECK(hit.triangle == expected.triangle);
            CHECK_NEAR(hit.distance, expected.distance,
                       1e-9); // both double; steep triangles lose some digits
            CHECK(isNear(hit.position, offset + hit.distance * direction, 1e-9));
        }
    }
    CHECK(compared > 19'000 && hits > 5'000);
}

// Vertices keep their place far from the origin: this triangle's edge is 1/16 from the ray at 1e7.
void testFarAway()
{
    Scene scene = sceneOf({triangle({0.0625f, -1, -1}, {1, 0, -1}, {0.0625f, 1, -1}, {0, 0, 1})});
    scene.offset = {1e7, -2e7, 3e7 + 0.125};
    const ReferenceTracer tracer(scene, scene.offset);
    const Hit hit = tracer.trace(scene.offset, {0.0626, 0, -1}, 0.0, infinity);
    CHECK(hit.found);
    CHECK_NEAR(hit.distance, std::sqrt(1.0 + 0.0626 * 0.0626), 1e-8); // a rounding of 3e7 is 4e-9
    CHECK(!tracer.trace(scene.offset, {0.0624, 0, -1}, 0.0, infinity).found);
}

// ---- What is hit, and what is not ------------------------------------------------------------------

void testBothSidesAndRange()
{
    const Scene scene = sceneOf({wall(-2), wall(3)});
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    const glm::dvec3 start(0.25, 0.5, 0.0);
    const Hit front = tracer.trace(start, {0, 0, -1}, 0.0, infinity);
    CHECK(front.found && front.triangle < 2 && front.distance == 2.0 && front.normal == glm::dvec3(0, 0, 1));
    const Hit back = tracer.trace(start, {0, 0, 10}, 0.0, infinity); // no unit length needed
    CHECK(back.found && back.triangle >= 2 && back.distance == 3.0);
    CHECK(back.position == glm::dvec3(0.25, 0.5, 3.0));
    CHECK(!tracer.trace(start, {0, 0, 1}, 3.1, infinity).found);
    CHECK(!tracer.trace(start, {0, 0, 1}, 0.0, 2.9).found);
    CHECK(!tracer.trace(start, {1, 0, 0}, 0.0, infinity).found);
}

// A broken vertex costs its triangles only; the numbers of the others stay.
void testBrokenVertices()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    Mesh mesh = wall(-5);
    mesh.positions.insert(mesh.positions.end(), {{nan, 0, -1}, {inf, 0, -1}});
    mesh.normals.insert(mesh.normals.end(), 2, {0, 0, 1});
    mesh.textureCoordinates.insert(mesh.textureCoordinates.end(), 2, {0, 0});
    mesh.triangles = {{0, 1, 4}, {2, 3, 5}, {0, 1, 1}, {0, 1, 2}, {0, 2, 3}};
    const Scene scene = sceneOf({mesh});
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    const Hit hit = tracer.trace(glm::dvec3(0.0), {0.1, 0.05, -1.0}, 0.0, infinity);
    CHECK(hit.found && hit.triangle == 3);
}

void testEdgeAngle()
{
    const Scene scene = sceneOf({triangle({0.1f, -50, -1}, {-50, 0, -1}, {0.1f, 50, -1}, {0, 0, 1})});
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    const Hit side = tracer.trace(glm::dvec3(0.0), {0, 0, -1}, 0.0, infinity);
    CHECK_NEAR(side.edgeAngle, std::atan(static_cast<double>(0.1f)), 1e-15);
    // Nearest a corner, not an edge's great circle beyond it: no angle is larger than to the corner.
    const Hit corner = tracer.trace(glm::dvec3(0.0), {-49.9, 0, -1}, 0.0, infinity);
    const double toCorner = std::atan(50.0) - std::atan(49.9);
    CHECK(corner.found && corner.edgeAngle > 0.0 && corner.edgeAngle <= toCorner + 1e-12);
}

// Normal and texture coordinate are linear on the triangle, not on the picture.
void testInterpolation()
{
    Mesh mesh = triangle({0, 0, -1}, {4, 0, -3}, {0, 4, -1}, {0, 0, 1});
    mesh.normals[1] = {1, 0, 0};
    const Scene scene = sceneOf({mesh});
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    // Weights 1/2, 1/4, 1/4: the point (1, 1, −1.5).
    const Hit hit = tracer.trace(glm::dvec3(0.0), {1, 1, -1.5}, 0.0, infinity);
    CHECK(hit.found && isNear(hit.position, {1, 1, -1.5}, 1e-15));
    CHECK(isNear(hit.normal, glm::normalize(glm::dvec3(0.25, 0, 0.75)), 1e-15));
}

// ---- Threads ---------------------------------------------------------------------------------------

void testRows()
{
    std::vector<std::atomic<int>> visits(1000);
    examples::forEachRow(1000, [&](int row) { ++visits[static_cast<std::size_t>(row)]; });
    for (const std::atomic<int>& visit : visits) {
        CHECK(visit == 1);
    }
    examples::forEachRow(0, [](int) { CHECK(false); });
    bool thrown = false;
    try {
        examples::forEachRow(100, [](int row) {
            if (row == 42) {
                throw std::runtime_error("row 42");
            }
        });
    } catch (const std::runtime_error& error) {
        thrown = error.what() == std::string("row 42");
    }
    CHECK(thrown);
}

} // namespace

int main()
{
    testBruteForce({0.0, 0.0, 0.0});
    testBruteForce({1e6, -2e6, 3e6});
    testFarAway();
    testBothSidesAndRange();
    testBrokenVertices();
    testEdgeAngle();
    testInterpolation();
    testRows();
}
