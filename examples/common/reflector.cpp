#include "scene.h"

#include "scene_file.h"
#include "shapes.h"
#include "teapot.h"

#include <mirrorball/error.h>

#include <glm/common.hpp>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace examples {
namespace {

using mirrorball::Error;
using mirrorball::ErrorKind;

Mesh sphereReflector(const std::string& name)
{
    const std::string number = name.substr(name.find(':') + 1);
    char* end = nullptr;
    const float radius = std::strtof(number.c_str(), &end); // hex floats too
    const bool blank = number.empty() || std::isspace(static_cast<unsigned char>(number[0])) != 0;
    if (blank || end != number.c_str() + number.size()) {
        throw Error(ErrorKind::unknownName, "reflector " + name, "the radius is no number",
                    "write sphere:1.5");
    }
    if (!std::isfinite(radius) || radius <= 0.0f) {
        throw Error(ErrorKind::badArgument, "reflector " + name, "the radius must be positive and finite",
                    "write sphere:1.5");
    }
    Mesh mesh = meshOf("sphere", 0);
    appendSphere(mesh, glm::vec3(0.0f), radius, 64, 128);
    return mesh;
}

Mesh joined(const Scene& scene)
{
    Mesh all;
    all.name = scene.name;
    for (const Mesh& mesh : scene.meshes) {
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
        all.textureCoordinates.insert(all.textureCoordinates.end(), mesh.textureCoordinates.begin(),
                                      mesh.textureCoordinates.end());
        for (const auto& triangle : mesh.triangles) {
            all.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
        }
    }
    return all;
}

// Moves the centre of the bounding box to the origin.
Mesh centred(Mesh mesh)
{
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(-low);
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    for (glm::vec3& position : mesh.positions) {
        position -= 0.5f * (low + high);
    }
    return mesh;
}

} // namespace

Mesh loadReflector(const std::string& name)
{
    if (name.starts_with("sphere:")) {
        return sphereReflector(name);
    }
    if (name == "teapot") {
        return centred(teapot(16)); // 16,256 triangles
    }
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) {
        throw Error(ErrorKind::notFound, "reflector " + name, "no such shape and no such file",
                    "give sphere:radius, teapot or a model file");
    }
    return centred(joined(readSceneFile(name)));
}

} // namespace examples
