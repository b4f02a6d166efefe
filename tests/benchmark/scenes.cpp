#include "scenes.h"

#include <filesystem>

namespace tests::benchmark {

namespace {

// Debian's glmark2-data and assimp-testmodels.
#define MODELS "/usr/share/assimp/models/"

constexpr std::string_view house = MODELS "IFC/AC14-FZK-Haus.ifc";
constexpr std::string_view bunny = "/usr/share/glmark2/models/bunny.obj";
constexpr std::string_view engine = MODELS "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";

constexpr glm::dvec3 origin(0.0);

constexpr SceneChoice choices[] = {
    {"cards", "builtin:cards", origin, 0.1f, 3000.0f, false, true, true, 1.0, {}},
    {"room", "builtin:room", origin, 0.1f, 100.0f, true, false, false, 1.5, {}},
    // Leaves are cut out of their triangles, which are seen from both sides.
    {"garden", "builtin:garden", origin, 0.1f, 10000.0f, false, false, false, 2.0, {}},
    // 128 objects on a shell of radius 4 to 13 in a room.
    {"crowd-12k", "builtin:crowd:12000", origin, 0.1f, 100.0f, true, true, false, 1.2, 0.86},
    {"crowd-100k", "builtin:crowd:100000", origin, 0.1f, 100.0f, true, true, true, 2.5, 0.65},
    {"crowd-200k", "builtin:crowd:200000", origin, 0.1f, 100.0f, true, false, false, 4.0, {}},
    {"crowd-503k", "builtin:crowd:503000", origin, 0.1f, 100.0f, true, false, false, 9.0, 0.56},
    // In a room of the ground floor, which is y from 0 to 2.5.
    {"house", house, {4.0, 1.5, -3.0}, 0.1f, 100.0f, false, false, false, 12.0, {}},
    // From inside the bunny: its back faces are all that is seen.
    {"bunny", bunny, origin, 0.01f, 10.0f, false, false, false, 3.0, {}},
    // In millimetres, between the cylinders; the nearest surface is 8 away.
    {"engine", engine, origin, 1.0f, 2000.0f, false, false, false, 4.0, {}},
};

} // namespace

std::span<const SceneChoice> sceneChoices()
{
    return choices;
}

bool isModel(const SceneChoice& scene)
{
    return !scene.source.starts_with("builtin:");
}

bool isThere(const SceneChoice& scene)
{
    return !isModel(scene) || std::filesystem::exists(scene.source);
}

examples::Scene withOwnVertices(const examples::Scene& scene)
{
    examples::Scene result = scene;
    for (std::size_t index = 0; index < scene.meshes.size(); ++index) {
        const examples::Mesh& from = scene.meshes[index];
        examples::Mesh& to = result.meshes[index];
        to.positions.clear();
        to.normals.clear();
        to.textureCoordinates.clear();
        for (auto& triangle : to.triangles)
            for (std::uint32_t& corner : triangle) {
                to.positions.push_back(from.positions[corner]);
                to.normals.push_back(from.normals[corner]);
                to.textureCoordinates.push_back(from.textureCoordinates[corner]);
                corner = static_cast<std::uint32_t>(to.positions.size() - 1);
            }
    }
    return result;
}

} // namespace tests::benchmark
