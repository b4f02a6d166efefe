#include "builtin.h"
#include "shapes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace examples {
namespace {

// The path's top touches the ball of radius 2 around the origin that every scene leaves free; the lawn lies
// lower.
constexpr float pathTop = -2.0f;
constexpr float ground = pathTop - 0.02f;

// A small integer hash (the finaliser of MurmurHash3), mapped to [0, 1): the same noise on every machine.
float noise(std::uint32_t seed)
{
    seed ^= seed >> 16;
    seed *= 0x85ebca6bu;
    seed ^= seed >> 13;
    seed *= 0xc2b2ae35u;
    seed ^= seed >> 16;
    return static_cast<float>(seed >> 8) * 0x1p-24f;
}

std::uint8_t byteFrom(float value)
{
    return static_cast<std::uint8_t>(std::lround(255.0f * std::fmin(std::fmax(value, 0.0f), 1.0f)));
}

int addImage(Scene& scene, int size, const auto& colourAt)
{
    Image image{size, size, {}};
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::vec4 colour = colourAt(x, y);
            for (int channel = 0; channel < 4; ++channel) {
                image.rgba.push_back(byteFrom(colour[channel]));
            }
        }
    }
    scene.images.push_back(std::move(image));
    return static_cast<int>(scene.images.size() - 1);
}

int addGrassImage(Scene& scene)
{
    return addImage(scene, 32, [](int x, int y) {
        const float shade = 0.75f + 0.25f * noise(static_cast<std::uint32_t>(32 * y + x));
        return glm::vec4(0.48f * shade, 0.68f * shade, 0.30f * shade, 1.0f);
    });
}

int addCheckerImage(Scene& scene)
{
    return addImage(scene, 16, [](int x, int y) {
        const bool light = (x < 8) == (y < 8);
        const float shade = 0.94f + 0.06f * noise(static_cast<std::uint32_t>(7000 + 16 * y + x));
        return glm::vec4((light ? glm::vec3(0.93f, 0.90f, 0.82f) : glm::vec3(0.62f, 0.42f, 0.36f)) * shade,
                         1.0f);
    });
}

// Leaves: discs strewn over the image; what no disc covers is transparent. The colour runs on under the
// transparent texels, so that no dark rim appears where the image is filtered.
int addLeafImage(Scene& scene)
{
    constexpr int size = 64;
    constexpr std::uint32_t leaves = 46;
    return addImage(scene, size, [](int x, int y) {
        glm::vec4 colour(0.30f, 0.52f, 0.18f, 0.0f);
        for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
            const glm::vec2 centre = glm::vec2(noise(3 * leaf + 100), noise(3 * leaf + 101)) * 54.0f + 5.0f;
            const glm::vec2 distance = glm::vec2(x, y) - centre;
            const float radius = 3.5f + 2.0f * noise(3 * leaf + 102);
            // Only within a round crown: the corners of a card stay empty.
            const bool inCrown = glm::length(centre - 31.5f) < 27.0f;
            if (inCrown && glm::length(distance) < radius) {
                const float shade = 0.75f + 0.35f * noise(leaf + 900);
                colour = glm::vec4(0.32f * shade, 0.60f * shade, 0.20f * shade, 1.0f);
            }
        }
        return colour;
    });
}

void addGround(Scene& scene)
{
    const int grass = addMaterial(scene, "grass", glm::vec3(1.0f), 0.0f, 32.0f, addGrassImage(scene));
    Mesh lawn = meshOf("lawn", grass);
    appendQuad(lawn, {-60.0f, ground, 60.0f}, {120.0f, 0, 0}, {0, 0, -120.0f}, {40.0f, 40.0f});
    scene.meshes.push_back(lawn);

    // Two paths that cross under the origin; one is cut where the other lies.
    const int tiles = addMaterial(scene, "tiles", glm::vec3(1.0f), 0.1f, 20.0f, addCheckerImage(scene));
    Mesh path = meshOf("path", tiles);
    appendQuad(path, {-2.0f, pathTop, 40.0f}, {4.0f, 0, 0}, {0, 0, -80.0f}, {2.0f, 40.0f});
    appendQuad(path, {-40.0f, pathTop, 2.0f}, {38.0f, 0, 0}, {0, 0, -4.0f}, {19.0f, 2.0f});
    appendQuad(path, {2.0f, pathTop, 2.0f}, {38.0f, 0, 0}, {0, 0, -4.0f}, {19.0f, 2.0f});
    scene.meshes.push_back(path);
}

void addHedges(Scene& scene)
{
    const int leaves = addMaterial(scene, "hedge", {0.10f, 0.24f, 0.07f}, 0.05f, 8.0f);
    for (const float sx : {-1.0f, 1.0f}) {
        for (const float sz : {-1.0f, 1.0f}) {
            Mesh hedge = meshOf("hedge", leaves);
            const glm::vec3 nearX(sx * 3.0f, ground, sz * 11.0f);
            const glm::vec3 farX(sx * 12.0f, ground + 1.6f, sz * 12.0f);
            appendBox(hedge, glm::min(nearX, farX), glm::max(nearX, farX));
            const glm::vec3 nearZ(sx * 11.0f, ground, sz * 3.0f);
            const glm::vec3 farZ(sx * 12.0f, ground + 1.6f, sz * 11.0f);
            appendBox(hedge, glm::min(nearZ, farZ), glm::max(nearZ, farZ));
            scene.meshes.push_back(hedge);
        }
    }
}

void addColumns(Scene& scene)
{
    const int stone = addMaterial(scene, "stone", {0.62f, 0.60f, 0.55f}, 0.15f, 24.0f);
    const glm::vec3 colours[] = {{0.75f, 0.12f, 0.10f}, {0.85f, 0.60f, 0.08f}, {0.10f, 0.30f, 0.65f},
                                 {0.60f, 0.15f, 0.50f}, {0.10f, 0.50f, 0.45f}, {0.85f, 0.35f, 0.10f},
                                 {0.30f, 0.50f, 0.12f}, {0.75f, 0.72f, 0.68f}};
    for (int i = 0; i < 8; ++i) {
        // Eight around the origin, none on a path.
        const double angle = std::numbers::pi / 4.0 * (i + 0.5);
        const glm::vec3 foot(7.5f * static_cast<float>(std::sin(angle)), ground,
                             7.5f * static_cast<float>(std::cos(angle)));
        Mesh column = meshOf("column", stone);
        appendBox(column, foot - glm::vec3(0.6f, 0.0f, 0.6f), foot + glm::vec3(0.6f, 0.3f, 0.6f));
        appendColumn(column, foot + glm::vec3(0, 0.3f, 0), 0.38f, 0.30f, 3.4f, 32);
        appendBox(column, foot + glm::vec3(-0.5f, 3.7f, -0.5f), foot + glm::vec3(0.5f, 3.95f, 0.5f));
        scene.meshes.push_back(column);

        Mesh ball = meshOf("ball", addMaterial(scene, "ball", colours[i], 0.5f, 50.0f));
        appendSphere(ball, foot + glm::vec3(0, 4.45f, 0), 0.5f, 20, 40);
        scene.meshes.push_back(ball);
    }
}

// A trunk and a crown of crossing cards.
void addTree(Scene& scene, const glm::vec3& foot, float size, std::uint32_t seed, int bark, int leaves)
{
    Mesh trunk = meshOf("trunk", bark);
    appendColumn(trunk, foot, 0.35f * size, 0.15f * size, 4.0f * size, 12);
    scene.meshes.push_back(trunk);

    Mesh crown = meshOf("crown", leaves);
    constexpr int cards = 9;
    for (std::uint32_t card = 0; card < cards; ++card) {
        const float angle = static_cast<float>(std::numbers::pi) *
                            (static_cast<float>(card) + noise(seed + card)) / static_cast<float>(cards);
        const float tilt = 0.5f * (noise(seed + card + 50) - 0.5f);
        const glm::vec3 across(std::cos(angle), 0.0f, std::sin(angle));
        const glm::vec3 up = glm::normalize(glm::vec3(-tilt * across.z, 1.0f, tilt * across.x));
        const float width = size * (4.0f + 1.5f * noise(seed + card + 20));
        const glm::vec3 centre = foot + glm::vec3(0.0f, size * (4.3f + 0.8f * noise(seed + card + 70)), 0.0f);
        appendQuad(crown, centre - 0.5f * width * (across + up), width * across, width * up);
    }
    scene.meshes.push_back(crown);
}

void addTrees(Scene& scene)
{
    const int bark = addMaterial(scene, "bark", {0.22f, 0.13f, 0.07f});
    const int leaves = addMaterial(scene, "leaves", glm::vec3(1.0f), 0.0f, 32.0f, addLeafImage(scene));
    for (std::uint32_t i = 0; i < 12; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.5) / 12.0;
        const float distance = 17.0f + 6.0f * noise(i + 500);
        const glm::vec3 foot(distance * static_cast<float>(std::sin(angle)), ground,
                             distance * static_cast<float>(std::cos(angle)));
        addTree(scene, foot, 1.0f + 0.5f * noise(i + 600), 1000 * i, bark, leaves);
    }
}

} // namespace

Scene gardenScene()
{
    Scene scene;
    scene.name = "builtin:garden";
    scene.background = {0.36f, 0.58f, 0.86f};
    scene.light = {25.0f, 40.0f, 20.0f};
    addGround(scene);
    addHedges(scene);
    addColumns(scene);
    addTrees(scene);
    return scene;
}

} // namespace examples
