// The scenes that need no file, each described in docs/scenes.md.
#pragma once

#include "scene.h"

namespace examples {

Scene roomScene();
Scene gardenScene();
Scene cardsScene();
Scene crowdScene(std::size_t triangles); // at least 1

// "builtin:<name>" by name; throws mirrorball::Error for a name that is none of these.
Scene builtinScene(const std::string& name);

// Adds a material and returns its index.
int addMaterial(Scene& scene, const char* name, const glm::vec3& diffuse, float specular = 0.0f,
                float shininess = 32.0f, int image = -1);

} // namespace examples
