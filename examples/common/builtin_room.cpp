#include "builtin.h"
#include "shapes.h"

namespace examples {
namespace {

// Half of 16 × 8 × 16.
constexpr glm::vec3 half(8.0f, 4.0f, 8.0f);

// Six walls of six colours, facing inward: which way is which can be read from any picture.
void addWalls(Scene& scene)
{
    struct Wall
    {
        const char* name;
        glm::vec3 colour, corner, u, v;
    };
    const glm::vec3 x(2.0f * half.x, 0, 0);
    const glm::vec3 y(0, 2.0f * half.y, 0);
    const glm::vec3 z(0, 0, 2.0f * half.z);
    const Wall walls[] = {
        {"wall +x, red", {0.80f, 0.10f, 0.08f}, {half.x, -half.y, -half.z}, z, y},
        {"wall -x, green", {0.10f, 0.55f, 0.12f}, {-half.x, -half.y, half.z}, -z, y},
        {"ceiling +y, white", {0.85f, 0.85f, 0.82f}, {-half.x, half.y, -half.z}, x, z},
        {"floor -y, brown", {0.35f, 0.20f, 0.10f}, {-half.x, -half.y, half.z}, x, -z},
        {"wall +z, yellow", {0.85f, 0.70f, 0.10f}, {half.x, -half.y, half.z}, -x, y},
        {"wall -z, blue", {0.10f, 0.20f, 0.75f}, {-half.x, -half.y, -half.z}, x, y},
    };
    for (const Wall& wall : walls) {
        Mesh mesh = meshOf(wall.name, addMaterial(scene, wall.name, wall.colour));
        appendQuad(mesh, wall.corner, wall.u, wall.v);
        scene.meshes.push_back(mesh);
    }
}

void addTable(Scene& scene, int wood)
{
    Mesh table = meshOf("table", wood);
    appendBox(table, {3.0f, -2.2f, -5.0f}, {6.5f, -2.0f, -2.5f});
    for (const float x : {3.1f, 6.2f}) {
        for (const float z : {-4.9f, -2.8f}) {
            appendBox(table, {x, -half.y, z}, {x + 0.2f, -2.2f, z + 0.2f});
        }
    }
    scene.meshes.push_back(table);
}

void addShelf(Scene& scene, int wood, int paint)
{
    Mesh shelf = meshOf("shelf", wood);
    for (const float y : {-4.0f, -2.6f, -1.2f, 0.2f, 1.6f}) {
        appendBox(shelf, {-7.0f, y, -7.8f}, {-2.0f, y + 0.15f, -6.6f});
    }
    appendBox(shelf, {-7.15f, -half.y, -7.8f}, {-7.0f, 1.75f, -6.6f});
    appendBox(shelf, {-2.0f, -half.y, -7.8f}, {-1.85f, 1.75f, -6.6f});
    scene.meshes.push_back(shelf);

    // Books: heights from a fixed short cycle, so that the row looks uneven.
    Mesh books = meshOf("books", paint);
    for (int i = 0; i < 14; ++i) {
        const float x = -6.8f + 0.33f * static_cast<float>(i);
        const float height = 0.7f + 0.1f * static_cast<float>(i * 5 % 4);
        appendBox(books, {x, -1.05f, -7.6f}, {x + 0.25f, -1.05f + height, -6.9f});
    }
    scene.meshes.push_back(books);
}

void addBalls(Scene& scene)
{
    struct Ball
    {
        const char* name;
        glm::vec3 colour, centre;
        float radius;
    };
    const Ball balls[] = {
        {"orange ball", {0.90f, 0.35f, 0.05f}, {4.8f, -1.3f, -3.8f}, 0.7f},
        {"purple ball", {0.45f, 0.10f, 0.60f}, {-5.0f, -3.0f, 3.5f}, 1.0f},
        {"turquoise ball", {0.05f, 0.60f, 0.60f}, {2.0f, 3.2f, 4.5f}, 0.8f},
        {"white ball", {0.80f, 0.80f, 0.80f}, {-6.2f, 2.4f, -1.5f}, 0.6f},
    };
    for (const Ball& ball : balls) {
        Mesh mesh = meshOf(ball.name, addMaterial(scene, ball.name, ball.colour, 0.4f, 40.0f));
        appendSphere(mesh, ball.centre, ball.radius, 24, 48);
        scene.meshes.push_back(mesh);
    }
}

} // namespace

Scene roomScene()
{
    Scene scene;
    scene.name = "builtin:room";
    scene.light = {2.5f, 3.5f, 1.5f};
    addWalls(scene);
    const int wood = addMaterial(scene, "wood", {0.45f, 0.25f, 0.12f}, 0.1f, 16.0f);
    const int paint = addMaterial(scene, "paint", {0.20f, 0.45f, 0.55f}, 0.1f, 16.0f);
    addTable(scene, wood);
    addShelf(scene, wood, paint);
    addBalls(scene);
    Mesh chest = meshOf("chest", paint);
    appendBox(chest, {3.5f, -half.y, 4.5f}, {6.5f, -2.3f, 6.5f});
    scene.meshes.push_back(chest);
    Mesh carpet = meshOf("carpet", addMaterial(scene, "carpet", {0.55f, 0.12f, 0.25f}));
    appendBox(carpet, {-3.0f, -half.y, -2.0f}, {3.0f, -3.95f, 2.0f});
    scene.meshes.push_back(carpet);
    return scene;
}

} // namespace examples
