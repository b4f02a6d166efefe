#include "scene.h"

#include "builtin.h"
#include "scene_file.h"

namespace examples {

std::size_t Scene::triangleCount() const
{
    std::size_t count = 0;
    for (const Mesh& mesh : meshes) {
        count += mesh.triangles.size();
    }
    return count;
}

Scene loadScene(const std::string& nameOrFile)
{
    return nameOrFile.starts_with("builtin:") ? builtinScene(nameOrFile) : readSceneFile(nameOrFile);
}

} // namespace examples
