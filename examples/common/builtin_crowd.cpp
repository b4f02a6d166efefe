#include "builtin.h"
#include "shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace examples {
namespace {

// The room is 28 wide; the objects' centres lie on the shell 4.6 … 12.4 around its middle, so that with a
// size of at most 0.6 they stay between 4 and 13.
constexpr float half = 14.0f;
constexpr float nearest = 4.6f;
constexpr float farthest = 12.4f;
constexpr float size = 0.6f;
constexpr std::size_t wallTriangles = 12;
constexpr std::size_t mostObjects = 128;
// An object of fewer would not look like a sphere or a ring.
constexpr std::size_t leastTriangles = 100;

constexpr glm::vec3 palette[] = {{0.75f, 0.12f, 0.10f}, {0.85f, 0.60f, 0.08f}, {0.10f, 0.30f, 0.65f},
                                 {0.60f, 0.15f, 0.50f}, {0.10f, 0.50f, 0.45f}, {0.85f, 0.35f, 0.10f},
                                 {0.30f, 0.50f, 0.12f}, {0.75f, 0.72f, 0.68f}};
constexpr int colours = static_cast<int>(std::size(palette));

// Evenly spread directions: heights in equal steps, each turned on by the golden angle.
glm::vec3 spread(std::size_t i, std::size_t count)
{
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double y = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double r = std::sqrt(1.0 - y * y);
    const double angle = golden * static_cast<double>(i);
    return {static_cast<float>(r * std::cos(angle)), static_cast<float>(y),
            static_cast<float>(r * std::sin(angle))};
}

void addWalls(Scene& scene, std::size_t count)
{
    // A box from outside is a room from inside: the same triangles with normals turned inward.
    Mesh walls = meshOf("walls", addMaterial(scene, "walls", {0.60f, 0.58f, 0.54f}));
    appendBox(walls, glm::vec3(-half), glm::vec3(half));
    for (glm::vec3& normal : walls.normals) {
        normal = -normal;
    }
    for (auto& triangle : walls.triangles) {
        std::swap(triangle[1], triangle[2]);
    }
    walls.triangles.resize(std::min(count, wallTriangles));
    scene.meshes.push_back(walls);
}

// A sphere, a ring or a box, as fine as `budget` triangles allow.
void appendObject(Mesh& mesh, std::size_t kind, const glm::vec3& centre, const glm::vec3& axis,
                  std::size_t budget)
{
    const auto root = [](double value) { return static_cast<int>(std::sqrt(value)); };
    const auto available = static_cast<double>(budget);
    if (kind == 0) {
        const int rings = (1 + root(1.0 + available)) / 2; // 4 · rings · (rings − 1) triangles
        appendSphere(mesh, centre, size, rings, 2 * rings);
    } else if (kind == 1) {
        const int sectors = root(available / 4.0); // 4 · sectors² triangles
        appendTorus(mesh, centre, axis, 0.7f * size, 0.3f * size, 2 * sectors, sectors);
    } else {
        // Half an edge of size / √3 keeps the corners within `size`.
        const glm::vec3 reach(size / std::numbers::sqrt3_v<float>);
        appendBox(mesh, centre - reach, centre + reach, root(available / 12.0));
    }
}

// Single small triangles make up what no object can: they lie on the shell as well.
void addConfetti(Scene& scene, std::size_t count)
{
    Mesh confetti = meshOf("confetti", 1);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 direction = spread(i, count);
        const glm::vec3 side = glm::normalize(glm::cross(direction, glm::vec3(0.36f, 0.48f, 0.80f)));
        const glm::vec3 centre = nearest * direction;
        const auto first = static_cast<std::uint32_t>(confetti.positions.size());
        confetti.positions.insert(confetti.positions.end(), {centre + 0.05f * side, centre - 0.05f * side,
                                                             centre + 0.08f * glm::cross(direction, side)});
        confetti.normals.insert(confetti.normals.end(), 3, -direction);
        confetti.textureCoordinates.insert(confetti.textureCoordinates.end(), {{0, 0}, {1, 0}, {0, 1}});
        confetti.triangles.push_back({first, first + 1, first + 2});
    }
    scene.meshes.push_back(confetti);
}

} // namespace

Scene crowdScene(std::size_t triangles)
{
    Scene scene;
    scene.name = "builtin:crowd:" + std::to_string(triangles);
    scene.light = {3.0f, 10.0f, 5.0f};
    addWalls(scene, triangles);
    for (const glm::vec3& colour : palette) {
        addMaterial(scene, "paint", colour, 0.4f, 40.0f);
    }

    std::size_t left = triangles - scene.triangleCount();
    const std::size_t objects = std::min(mostObjects, left / leastTriangles);
    for (std::size_t i = 0; i < objects; ++i) {
        // Neighbours in direction differ in distance: 5 and 7 have no common divisor with 128 or each other.
        const float depth = static_cast<float>(i * 5 % 7) / 6.0f;
        const glm::vec3 centre = (nearest + depth * (farthest - nearest)) * spread(i, objects);
        Mesh mesh = meshOf("object", 1 + static_cast<int>(i) % colours);
        appendObject(mesh, i % 3, centre, spread(i * 7 % objects, objects), left / (objects - i));
        left -= mesh.triangles.size();
        scene.meshes.push_back(std::move(mesh));
    }
    if (left > 0) {
        addConfetti(scene, left);
    }
    return scene;
}

} // namespace examples
