#include "builtin.h"
#include "shapes.h"

#include <glm/geometric.hpp>

namespace examples {
namespace {

struct Card
{
    const char* name;
    glm::vec3 colour;
    std::array<glm::vec3, 3> corners;
};

// The roof and the screen each fill nearly half of all directions, the two floors a quarter.
constexpr Card cards[] = {
    // The floor: two triangles, 1000 × 1000.
    {"floor left", {0.55f, 0.50f, 0.40f}, {{{-500, -3, -500}, {-500, -3, 500}, {500, -3, 500}}}},
    {"floor right", {0.40f, 0.45f, 0.55f}, {{{-500, -3, -500}, {500, -3, 500}, {500, -3, -500}}}},
    // A roof that leans over half of the sky and comes down through the floor.
    {"roof", {0.70f, 0.25f, 0.15f}, {{{-300, 6, 200}, {-40, 90, -300}, {300, -30, 200}}}},
    // Almost the whole half space towards −z; the roof and the floor cut it.
    {"screen", {0.15f, 0.35f, 0.65f}, {{{-300, -200, -12}, {300, -200, -14}, {0, 400, -11}}}},
    // A ribbon that passes at 2.5 and runs far out to both sides: nearly half a turn wide, and narrow.
    {"ribbon", {0.85f, 0.75f, 0.10f}, {{{-200, 2.0f, 2.4f}, {200, 2.2f, 2.9f}, {200, 6.2f, 2.6f}}}},
    // Two pairs that cross each other.
    {"sail red", {0.80f, 0.10f, 0.20f}, {{{5, -2, -6}, {6, 4, 0}, {5, -2, 6}}}},
    {"sail white", {0.85f, 0.85f, 0.80f}, {{{3.5f, -1, -4}, {9, 1, 1}, {3.0f, 3, 3}}}},
    {"fin green", {0.15f, 0.60f, 0.20f}, {{{-4, -2.5f, -5}, {-4.5f, 4, 1}, {-7, -1, 8}}}},
    {"fin purple", {0.50f, 0.15f, 0.60f}, {{{-9, 0.5f, -3}, {-2.6f, 1.5f, -2}, {-3.5f, 0.0f, 6}}}},
    // Far away and steep: a spire through the horizon behind.
    {"spire", {0.30f, 0.65f, 0.65f}, {{{-20, -10, 90}, {25, -10, 80}, {4, 70, 60}}}},
    // One small card near by and turned, so that sizes of all orders are there.
    {"leaf", {0.90f, 0.45f, 0.10f}, {{{-0.6f, -2.2f, 1.5f}, {0.8f, -2.4f, 1.2f}, {0.2f, -1.9f, 2.3f}}}},
};

} // namespace

Scene cardsScene()
{
    Scene scene;
    scene.name = "builtin:cards";
    scene.background = {0.50f, 0.62f, 0.80f};
    scene.light = {4.0f, 12.0f, 8.0f};
    for (const Card& card : cards) {
        Mesh mesh = meshOf(card.name, addMaterial(scene, card.name, card.colour));
        const auto& [a, b, c] = card.corners;
        mesh.positions = {a, b, c};
        mesh.normals.assign(3, glm::normalize(glm::cross(b - a, c - a)));
        mesh.textureCoordinates = {{0, 0}, {1, 0}, {0, 1}};
        mesh.triangles = {{0, 1, 2}};
        scene.meshes.push_back(mesh);
    }
    return scene;
}

} // namespace examples
