// The scene that the example programs draw: triangles with Phong materials, from a file or built in.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace examples {

// Phong with one point light, the same in GLSL (phong.frag) and in the reference tracer, all linear RGB:
//   d = diffuse * (the image at the texture coordinate, if any)
//   E = unit vector to the viewer, N = the interpolated normal, unit length, negated where N·E < 0
//   L = unit vector to the light, R = 2 (N·L) N − L
//   colour = ambient * d + d * max(N·L, 0) + specular * (N·L > 0 ? max(R·E, 0)^shininess : 0)
// Alpha = diffuse.a * image alpha; a fragment with alpha < 0.5 is not there at all.
struct Material
{
    std::string name;
    glm::vec4 diffuse{0.8f, 0.8f, 0.8f, 1.0f};
    glm::vec3 specular{0.0f};
    float shininess = 32.0f;
    int image = -1; // index into Scene::images, multiplied onto diffuse; -1 for none
};

inline constexpr float ambient = 0.3f;

// 8-bit RGBA, sRGB encoded colour and linear alpha; row 0 is texture coordinate v = 0. Sampled bilinearly on
// the decoded (linear) values, repeating, without mipmaps.
struct Image
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

struct Mesh
{
    std::string name;
    std::vector<glm::vec3> positions;          // as in the file: world space before Scene::offset
    std::vector<glm::vec3> normals;            // one per position, unit length
    std::vector<glm::vec2> textureCoordinates; // one per position
    std::vector<std::array<std::uint32_t, 3>> triangles;
    int material = 0;
};

struct Scene
{
    std::string name;
    std::vector<Mesh> meshes; // drawn in this order; triangle numbers count through all of them from 0
    std::vector<Material> materials;
    std::vector<Image> images;
    glm::vec3 background{0.0f}; // linear RGB where nothing is seen
    glm::vec3 light{0.0f};      // default position of the light, before offset
    glm::dvec3 offset{0.0};     // world = position + offset, in double

    std::size_t triangleCount() const;
};

// A file that Assimp reads, or builtin:garden, builtin:room, builtin:cards, builtin:crowd:N (docs/scenes.md).
// Throws mirrorball::Error: unknownName for an unknown builtin, notFound, badFile (also: no triangle in it).
Scene loadScene(const std::string& nameOrFile);

// A reflector as triangles, moved so that the centre of its bounding box is the origin, in its own units
// otherwise: "sphere:r" (radius r, finely tessellated), "teapot" (the Utah teapot evaluated from its Bézier
// patches, with analytic normals, y up, in Newell's units: about 6.4 wide), or any model file (all its meshes
// joined).
Mesh loadReflector(const std::string& name);

} // namespace examples
