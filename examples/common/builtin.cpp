#include "builtin.h"

#include <mirrorball/error.h>

namespace examples {

int addMaterial(Scene& scene, const char* name, const glm::vec3& diffuse, float specular, float shininess,
                int image)
{
    scene.materials.push_back({name, glm::vec4(diffuse, 1.0f), glm::vec3(specular), shininess, image});
    return static_cast<int>(scene.materials.size() - 1);
}

Scene builtinScene(const std::string& name)
{
    if (name == "builtin:room") {
        return roomScene();
    }
    if (name == "builtin:garden") {
        return gardenScene();
    }
    throw mirrorball::Error(mirrorball::ErrorKind::unknownName, "scene " + name,
                            "no built-in scene has this name",
                            "there are builtin:garden, builtin:room, builtin:cards and builtin:crowd:N");
}

} // namespace examples
