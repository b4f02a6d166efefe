// What docs/scenes.md promises of the built-in scenes.
#include "reference.h"
#include "scene.h"

#include <mirrorball/error.h>

#include "support/check.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using examples::Hit;
using examples::loadScene;
using examples::Mesh;
using examples::ReferenceTracer;
using examples::Scene;
using mirrorball::ErrorKind;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Distance of a segment and of a triangle from the origin.
double distanceOf(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 edge = b - a;
    return glm::length(a + glm::clamp(-glm::dot(a, edge) / glm::dot(edge, edge), 0.0, 1.0) * edge);
}

double distanceOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const glm::dvec3 foot = glm::dot(a, normal) * normal;
    const auto isInside = [&](const glm::dvec3& p, const glm::dvec3& q) {
        return glm::dot(glm::cross(q - p, foot - p), normal) >= 0.0;
    };
    if (isInside(a, b) && isInside(b, c) && isInside(c, a)) {
        return glm::length(foot);
    }
    return std::min({distanceOf(a, b), distanceOf(b, c), distanceOf(c, a)});
}

double distanceOf(const Mesh& mesh)
{
    double nearest = infinity;
    for (const auto& t : mesh.triangles) {
        nearest =
            std::min(nearest, distanceOf(glm::dvec3(mesh.positions[t[0]]), glm::dvec3(mesh.positions[t[1]]),
                                         glm::dvec3(mesh.positions[t[2]])));
    }
    return nearest;
}

double distanceOf(const Scene& scene)
{
    double nearest = infinity;
    for (const Mesh& mesh : scene.meshes) {
        nearest = std::min(nearest, distanceOf(mesh));
    }
    return nearest;
}

// Indices in range, unit normals on the side from which the triangle turns counter-clockwise, no triangle
// without area.
void checkMesh(const Mesh& mesh)
{
    CHECK(mesh.normals.size() == mesh.positions.size());
    CHECK(mesh.textureCoordinates.size() == mesh.positions.size());
    for (const glm::vec3& normal : mesh.normals) {
        CHECK_NEAR(glm::length(normal), 1.0, 4e-7); // three roundings of float around 1
    }
    for (const auto& t : mesh.triangles) {
        CHECK(*std::max_element(t.begin(), t.end()) < mesh.positions.size());
        const glm::dvec3 a(mesh.positions[t[0]]);
        const glm::dvec3 face =
            glm::cross(glm::dvec3(mesh.positions[t[1]]) - a, glm::dvec3(mesh.positions[t[2]]) - a);
        CHECK(glm::length(face) > 0.0);
        for (const std::uint32_t corner : t) {
            CHECK(glm::dot(face, glm::dvec3(mesh.normals[corner])) > 0.0);
        }
    }
}

Scene checkedScene(const std::string& name)
{
    const Scene scene = loadScene(name);
    const Scene again = loadScene(name);
    CHECK(scene.name == name);
    CHECK(scene.offset == glm::dvec3(0.0));
    CHECK(scene.meshes.size() == again.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        checkMesh(mesh);
        CHECK(mesh.positions == again.meshes[i].positions && mesh.triangles == again.meshes[i].triangles);
        CHECK(mesh.material >= 0 && mesh.material < static_cast<int>(scene.materials.size()));
    }
    for (const examples::Image& image : scene.images) {
        CHECK(image.rgba.size() == static_cast<std::size_t>(4 * image.width * image.height));
    }
    return scene;
}

std::vector<glm::dvec3> randomDirections(int count)
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double x = normal(random);
        const double y = normal(random);
        directions.push_back(glm::normalize(glm::dvec3(x, y, normal(random))));
    }
    return directions;
}

// No ray from the middle leaves the room.
void checkClosed(const Scene& scene, double farthest)
{
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    for (const glm::dvec3& direction : randomDirections(200'000)) {
        const Hit hit = tracer.trace(glm::dvec3(0.0), direction, 0.0, infinity);
        CHECK(hit.found && hit.distance <= farthest);
    }
}

void testRoom()
{
    const Scene room = checkedScene("builtin:room");
    CHECK(distanceOf(room) >= 2.0);
    checkClosed(room, 12.0 + 1e-12); // √(8² + 4² + 8²), and rounding

    // The first six meshes are the walls, two triangles each, seen from inside, each of its own colour.
    glm::vec3 low(1e9f);
    glm::vec3 high(-1e9f);
    for (std::size_t i = 0; i < 6; ++i) {
        const Mesh& wall = room.meshes[i];
        CHECK(wall.triangles.size() == 2);
        for (std::size_t k = 0; k < wall.positions.size(); ++k) {
            CHECK(glm::dot(wall.normals[k], wall.positions[k]) < 0.0f);
            low = glm::min(low, wall.positions[k]);
            high = glm::max(high, wall.positions[k]);
        }
        for (std::size_t j = 0; j < i; ++j) {
            const auto colour = [&](std::size_t k) {
                return glm::vec3(room.materials[static_cast<std::size_t>(room.meshes[k].material)].diffuse);
            };
            CHECK(glm::distance(colour(i), colour(j)) > 0.3f);
        }
    }
    CHECK(low == glm::vec3(-8, -4, -8) && high == glm::vec3(8, 4, 8));
    for (const Mesh& mesh : room.meshes) {
        for (const glm::vec3& position : mesh.positions) {
            CHECK(glm::abs(position) == glm::min(glm::abs(position), glm::vec3(8, 4, 8)));
        }
    }

    // Which wall is where, by name.
    struct Side
    {
        std::string wall;
        glm::dvec3 direction;
    };
    const Side sides[] = {{"wall +x", {8, 0.5, 1}},    {"wall -x", {-8, 0.5, 1}}, {"ceiling +y", {1, 4, 1}},
                          {"floor -y", {-4.5, -4, 1}}, {"wall +z", {1, 0.5, 8}},  {"wall -z", {1, 0.5, -8}}};
    const ReferenceTracer tracer(room, glm::dvec3(0.0));
    for (std::size_t i = 0; i < 6; ++i) {
        const Hit hit = tracer.trace(glm::dvec3(0.0), sides[i].direction, 0.0, infinity);
        CHECK(hit.found && hit.triangle / 2 == i);
        CHECK(room.meshes[i].name.starts_with(sides[i].wall));
    }
}

void testGarden()
{
    const Scene garden = checkedScene("builtin:garden");
    CHECK(distanceOf(garden) >= 2.0);
    bool hasHoles = false;
    for (const examples::Image& image : garden.images) {
        bool clear = false;
        bool solid = false;
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
            clear = clear || image.rgba[i] == 0;
            solid = solid || image.rgba[i] == 255;
        }
        CHECK(solid);
        hasHoles = hasHoles || clear;
    }
    CHECK(hasHoles);
    const ReferenceTracer tracer(garden, glm::dvec3(0.0));
    CHECK(!tracer.trace(glm::dvec3(0.0), {0.0, 1.0, 0.0}, 0.0, infinity).found);
    CHECK(tracer.trace(glm::dvec3(0.0), {0.0, -1.0, 0.0}, 0.0, infinity).found);
}

// Whether an edge of one triangle passes through the other.
bool cross(const Mesh& one, const Mesh& other)
{
    const auto& p = one.positions;
    const auto& q = other.positions;
    const auto volume = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                           const glm::dvec3& d) { return glm::dot(glm::cross(b - a, c - a), d - a); };
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 from(p[k]);
        const glm::dvec3 to(p[(k + 1) % 3]);
        const bool separated = volume(q[0], q[1], q[2], from) * volume(q[0], q[1], q[2], to) < 0.0;
        const bool a = volume(from, to, q[0], q[1]) > 0.0;
        const bool b = volume(from, to, q[1], q[2]) > 0.0;
        const bool c = volume(from, to, q[2], q[0]) > 0.0;
        if (separated && a == b && b == c) {
            return true;
        }
    }
    return false;
}

void testCards()
{
    const Scene cards = checkedScene("builtin:cards");
    CHECK(cards.triangleCount() == 11);
    CHECK(distanceOf(cards) >= 2.0);
    const auto card = [&](const std::string& name) -> const Mesh& {
        return *std::find_if(cards.meshes.begin(), cards.meshes.end(),
                             [&](const Mesh& mesh) { return mesh.name == name; });
    };
    const auto crossing = [&](const std::string& a, const std::string& b) {
        return cross(card(a), card(b)) || cross(card(b), card(a));
    };
    CHECK(crossing("sail red", "sail white"));
    CHECK(crossing("fin green", "fin purple"));
    CHECK(crossing("roof", "floor right"));
    CHECK(crossing("screen", "roof"));
    CHECK(!crossing("leaf", "spire"));
    for (const Mesh& mesh : cards.meshes) {
        CHECK(mesh.triangles.size() == 1);
    }
    CHECK(glm::distance(card("floor left").positions[0], card("floor left").positions[2]) > 1414.0f);
}

void testCrowd()
{
    // Odd ones, those around the steps of its rule, and sizes that benchmarks use.
    for (const std::size_t count :
         {1, 2, 11, 12, 13, 50, 111, 112, 113, 211, 212, 1000, 12'811, 12'812, 33'000, 205'001})
    {
        const Scene crowd = checkedScene("builtin:crowd:" + std::to_string(count));
        CHECK(crowd.triangleCount() == count);
        for (std::size_t i = 1; i < crowd.meshes.size(); ++i) {
            CHECK(distanceOf(crowd.meshes[i]) >= 4.0 - 0.02); // a sphere's facets cut 2 % of 0.6 at most
            for (const glm::vec3& position : crowd.meshes[i].positions) {
                CHECK(glm::length(position) <= 13.0f);
            }
        }
        if (count >= 12) {
            checkClosed(crowd, 14.0 * std::sqrt(3.0) + 1e-12);
        }
        // Most of a large crowd is in its objects, not in the triangles that fill up.
        const bool hasConfetti = crowd.meshes.back().name == "confetti";
        CHECK(count < 10'000 || !hasConfetti || crowd.meshes.back().triangles.size() < count / 100);
    }
    CHECK(loadScene("builtin:crowd:33000").meshes.size() >= 129);
}

void testNames()
{
    for (const char* name : {"builtin:", "builtin:garage", "builtin:rooms", "builtin:room ", "builtin:crowd",
                             "builtin:crowd:", "builtin:crowd:x", "builtin:crowd:-1", "builtin:crowd:1.5",
                             "builtin:crowd: 7", "builtin:crowd:0x10"})
    {
        CHECK_THROWS(loadScene(name), ErrorKind::unknownName);
    }
    for (const char* name :
         {"builtin:crowd:0", "builtin:crowd:20000001", "builtin:crowd:99999999999999999999999"})
    {
        CHECK_THROWS(loadScene(name), ErrorKind::badArgument);
    }
}

} // namespace

int main()
{
    testRoom();
    testGarden();
    testCards();
    testCrowd();
    testNames();
}
