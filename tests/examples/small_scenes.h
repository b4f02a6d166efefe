// Scenes of a few triangles, in which a ray's answer can be worked out by hand.
#pragma once

#include "scene.h"

#include <glm/geometric.hpp>

#include <utility>
#include <vector>

namespace tests {

inline examples::Mesh triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                               const glm::vec3& normal, int material = 0)
{
    examples::Mesh mesh;
    mesh.positions = {a, b, c};
    mesh.normals.assign(3, normal);
    mesh.textureCoordinates = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.material = material;
    return mesh;
}

inline examples::Scene sceneOf(std::vector<examples::Mesh> meshes)
{
    examples::Scene scene;
    scene.meshes = std::move(meshes);
    scene.materials.resize(1);
    scene.background = {0.1f, 0.2f, 0.3f};
    return scene;
}

// A large square z = height, facing +z, in two triangles.
inline examples::Mesh wall(float height, int material = 0)
{
    examples::Mesh mesh =
        triangle({-100, -100, height}, {100, -100, height}, {100, 100, height}, {0, 0, 1}, material);
    mesh.positions.push_back({-100, 100, height});
    mesh.normals.push_back({0, 0, 1});
    mesh.textureCoordinates.push_back({0, 0});
    mesh.triangles.push_back({0, 2, 3});
    return mesh;
}

inline bool isNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance)
{
    return glm::distance(a, b) <= tolerance;
}

} // namespace tests
