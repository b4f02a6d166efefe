// The reference tracer against slower ways to the same answer: every triangle tried in double, and values
// worked out by hand.
#include "reference.h"

#include "support/check.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using examples::Hit;
using examples::Image;
using examples::Material;
using examples::Mesh;
using examples::ReferenceTracer;
using examples::Reflector;
using examples::Scene;
using examples::Seen;
using examples::SeenKind;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const float halfRoot = std::sqrt(0.5f);

Mesh triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& normal,
              int material = 0)
{
    Mesh mesh;
    mesh.positions = {a, b, c};
    mesh.normals.assign(3, normal);
    mesh.textureCoordinates = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.material = material;
    return mesh;
}

Scene sceneOf(std::vector<Mesh> meshes)
{
    Scene scene;
    scene.meshes = std::move(meshes);
    scene.materials.resize(1);
    scene.background = {0.1f, 0.2f, 0.3f};
    return scene;
}

// A large square z = height, facing +z, in two triangles.
Mesh wall(float height, int material = 0)
{
    Mesh mesh = triangle({-100, -100, height}, {100, -100, height}, {100, 100, height}, {0, 0, 1}, material);
    mesh.positions.push_back({-100, 100, height});
    mesh.normals.push_back({0, 0, 1});
    mesh.textureCoordinates.push_back({0, 0});
    mesh.triangles.push_back({0, 2, 3});
    return mesh;
}

bool isNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance)
{
    return glm::distance(a, b) <= tolerance;
}

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

// ---- Images and alpha ------------------------------------------------------------------------------

// 2 × 2: black, white (row v = 0), red, green with alpha 0.
Image fourTexels()
{
    return {2, 2, {0, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 255, 0, 255, 0, 0}};
}

void testSampling()
{
    const Image image = fourTexels();
    CHECK(examples::sampleImage(image, {0.25, 0.25}) == glm::dvec4(0, 0, 0, 1));
    CHECK(examples::sampleImage(image, {0.75, 0.25}) == glm::dvec4(1, 1, 1, 1));
    CHECK(examples::sampleImage(image, {0.25, 0.75}) == glm::dvec4(1, 0, 0, 1));
    CHECK(examples::sampleImage(image, {-1.25, 7.75}) == glm::dvec4(0, 1, 0, 0)); // repeats
    CHECK(examples::sampleImage(image, {0.5, 0.25}) == glm::dvec4(0.5, 0.5, 0.5, 1));
    CHECK(examples::sampleImage(image, {0.0, 0.25}) == glm::dvec4(0.5, 0.5, 0.5, 1)); // with its repetition
    CHECK(examples::sampleImage(image, {0.5, 0.5}) == glm::dvec4(0.5, 0.5, 0.25, 0.75));
    // sRGB byte 188 is linear 0.5029; filtering comes after decoding.
    const Image grey{1, 1, {188, 188, 188, 255}};
    CHECK_NEAR(examples::sampleImage(grey, {0.3, 0.9}).x, 0.50289, 1e-5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(examples::sampleImage(image, {nan, 0.0}) == glm::dvec4(0, 0, 0, 1));
}

void testAlpha()
{
    Mesh front =
        triangle({-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {0, 0, 1}, 1); // texture (0, 0) … (1, 1) over 4 × 4
    Scene scene =
        sceneOf({front, wall(-2), triangle({-9, -9, -1.5f}, {9, -9, -1.5f}, {0, 9, -1.5f}, {0, 0, 1}, 2)});
    scene.images = {fourTexels()};
    scene.materials.resize(3);
    scene.materials[1].diffuse = {0.5f, 1.0f, 1.0f, 1.0f};
    scene.materials[1].image = 0;
    scene.materials[2].diffuse.a = 0.49f; // not there at all
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    const auto look = [&](double u, double v) {
        return tracer.trace({4.0 * u - 1.0, 4.0 * v - 1.0, 0.0}, {0, 0, -1}, 0.0, infinity);
    };
    const Hit red = look(0.25, 0.7499);
    CHECK(red.found && red.triangle == 0 && red.material == 1);
    CHECK(isNear(glm::dvec3(red.colour), {0.5, 0, 0}, 1e-3)); // 0.0001 beside the texel's middle
    // Moved so that the clear texel's middle, (0.75, 0.75), lies at (0.25, 0.5): on the way there from (0.25,
    // 0) alpha is 1 − 2 v, and the hole begins at v = 1/4.
    scene.meshes[0].textureCoordinates = {{0.5, 0.25}, {1.5, 0.25}, {0.5, 1.25}};
    CHECK(look(0.25, 0.01).distance == 1.0);
    CHECK(look(0.25, 0.249).distance == 1.0);
    CHECK(look(0.25, 0.251).distance == 2.0); // through to the wall
    CHECK(look(0.25, 0.5).distance == 2.0);
}

// ---- Light -----------------------------------------------------------------------------------------

void testShade()
{
    Scene scene = sceneOf({wall(0)});
    scene.materials[0].diffuse = {0.5f, 0.25f, 1.0f, 1.0f};
    scene.materials[0].specular = {0.8f, 0.4f, 0.0f};
    scene.materials[0].shininess = 2.0f;
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    const glm::dvec3 eye(0, 0, 2);
    const Hit hit = tracer.trace(eye, {0, 0, -1}, 0.0, infinity);
    const glm::dvec3 d(0.5, 0.25, 1.0);
    const glm::dvec3 s(0.8f, 0.4f, 0.0f);
    constexpr double a = static_cast<double>(examples::ambient);
    const double r = std::sqrt(0.5);
    // Light at 45°: N·L = √½, R·E = √½, to the power 2: ½.
    CHECK(isNear(tracer.shade(hit, eye, {0, 3, 3}), a * d + r * d + 0.5 * s, 1e-6));
    // Light straight above: N·L = R·E = 1.
    CHECK(isNear(tracer.shade(hit, eye, {0, 0, 9}), a * d + d + s, 1e-6));
    // Eye at 45°, light at 45° on the same side: R·E = 0, no highlight.
    CHECK(isNear(tracer.shade(hit, {0, 5, 5}, {0, 3, 3}), a * d + r * d, 1e-6));
    // Light behind the surface: ambient alone.
    CHECK(isNear(tracer.shade(hit, eye, {0, 0, -1}), a * d, 1e-6));
    // Seen and lit from behind, the normal is turned.
    CHECK(isNear(tracer.shade(hit, {0, 0, -2}, {0, 0, -9}), a * d + d + s, 1e-6));
    CHECK(tracer.shade(Hit{}, eye, {0, 0, 9}) == scene.background);
}

// ---- Mirrors ---------------------------------------------------------------------------------------

Reflector ball(const glm::dvec3& at, double radius)
{
    Reflector reflector;
    reflector.at = at;
    reflector.radius = radius;
    reflector.material.diffuse = {0.9f, 0.8f, 0.7f, 1.0f};
    return reflector;
}

void testSphere()
{
    const Scene scene = sceneOf({wall(-4), wall(6)});
    ReferenceTracer tracer(scene, glm::dvec3(0.0));
    tracer.add(ball({0, 0, 0}, 1.0));
    // Head on: back to where it came from, and on to the wall behind the eye.
    const Seen head = tracer.look({0, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(head.kind == SeenKind::reflector && head.hit.reflector == 0);
    CHECK_NEAR(head.hit.distance, 4.0, 1e-15);
    CHECK(isNear(head.hit.normal, {0, 0, 1}, 1e-15) && isNear(head.mirrorDirection, {0, 0, 1}, 1e-15));
    CHECK(head.mirrored.found && head.mirrored.triangle >= 2);
    CHECK_NEAR(head.mirrored.distance, 5.0, 1e-12);
    // Where the normal stands at 45°, straight down becomes sideways: past both walls.
    const double r = std::sqrt(0.5);
    const Seen side = tracer.look({r, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(isNear(side.hit.position, {r, 0, r}, 1e-14) && isNear(side.mirrorDirection, {1, 0, 0}, 1e-14));
    CHECK(!side.mirrored.found);
    CHECK(tracer.shade(side.mirrored, side.hit.position, {0, 0, 9}) == scene.background);
    // Beside it, and in front of it.
    CHECK(tracer.look({1.001, 0, 5}, {0, 0, -1}, 0.1, 100.0).kind == SeenKind::scene);
    CHECK(tracer.look({1.001, 0, 5}, {1, 0, 0}, 0.1, 100.0).kind == SeenKind::background);
    CHECK(tracer.look({0, 0, 5}, {0, 0, -1}, 0.1, 3.9).kind == SeenKind::background);
    const Seen inside =
        tracer.look({0, 0, 5}, {0, 0, -1}, 4.5, 100.0); // past the front: the back from within
    CHECK(inside.kind == SeenKind::reflector && std::abs(inside.hit.distance - 6.0) < 1e-15);
    // The outline of a unit ball from 5 away lies asin(1/5) from its middle.
    CHECK_NEAR(head.hit.edgeAngle, std::asin(0.2), 1e-15);
}

// A square at 45° sends a ray along −z to +x; with scale and place as given.
void testMirrorMesh()
{
    Scene scene = sceneOf({wall(-4)});
    Mesh right = triangle({9, -50, -50}, {9, 50, -50}, {9, 0, 50}, {-1, 0, 0});
    scene.meshes.push_back(right);
    Reflector mirror;
    mirror.at = {2, 0, 0};
    mirror.scale = 0.5;
    mirror.mesh = triangle({-2, -4, 2}, {2, -4, -2}, {0, 4, 0}, {halfRoot, 0, halfRoot});
    ReferenceTracer tracer(scene, glm::dvec3(0.0));
    tracer.add(mirror);
    const Seen seen = tracer.look({2, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(seen.kind == SeenKind::reflector);
    CHECK(isNear(seen.hit.position, {2, 0, 0}, 1e-12));
    CHECK(isNear(seen.mirrorDirection, {1, 0, 0}, 1e-7)); // the normal is a float
    CHECK(seen.mirrored.found && seen.mirrored.triangle == 2 && seen.mirrored.reflector == -1);
    CHECK_NEAR(seen.mirrored.distance, 7.0, 1e-6);
    // At y = 0 the triangle is 2 wide, scaled 1: from x = 1.5 to 2.5.
    CHECK(tracer.look({2.45, 0, 5}, {0, 0, -1}, 0.1, 100.0).kind == SeenKind::reflector);
    CHECK(tracer.look({2.55, 0, 5}, {0, 0, -1}, 0.1, 100.0).kind == SeenKind::scene);
}

// Two balls: each shows the other as a plain object, and itself not at all.
void testTwoReflectors()
{
    const Scene scene = sceneOf({wall(-4)});
    ReferenceTracer tracer(scene, glm::dvec3(0.0));
    tracer.add(ball({0, 0, 0}, 1.0));
    tracer.add(ball({0, 0, 10}, 2.0));
    const Seen seen = tracer.look({0, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(seen.hit.reflector == 0 && seen.mirrored.reflector == 1);
    CHECK_NEAR(seen.mirrored.distance, 7.0, 1e-12);
    // Its plain colour, lit head on: (ambient + 1) of the diffuse colour.
    const glm::vec3 colour = tracer.shade(seen.mirrored, {0, 0, 1}, {0, 0, 1});
    CHECK(isNear(glm::dvec3(colour), 1.3 * glm::dvec3(0.9, 0.8, 0.7), 1e-6));
    const Seen other = tracer.look({0, 0, 5}, {0, 0, 1}, 0.1, 100.0);
    CHECK(other.hit.reflector == 1 && other.mirrored.reflector == 0);
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
    testSampling();
    testAlpha();
    testShade();
    testSphere();
    testMirrorMesh();
    testTwoReflectors();
    testRows();
}
