// The scene that the example programs draw: triangles with Phong materials, from a file or built in.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace examples
{

// Phong with one point light, the same in GLSL (phong.frag) and in the reference tracer, all linear RGB:
//   d = diffuse * (the image at the texture coordinate, if any)
//   N = the interpolated normal, unit length, turned to the side of the viewer
//       (if dot(geometric normal of the triangle, viewer - p) and dot(N, viewer - p) … N is negated where
//        dot(N, E) < 0, with E the unit vector to the viewer)
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

// 8-bit RGBA, sRGB encoded colour and linear alpha; row 0 is texture coordinate v = 0. Sampled bilinearly on the
// decoded (linear) values, repeating, without mipmaps.
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
    glm::vec3 background{0.0f};    // linear RGB where nothing is seen
    glm::vec3 light{0.0f};         // default position of the light, before offset
    glm::dvec3 offset{0.0};        // world = position + offset, in double

    std::size_t triangleCount() const;
};

// A file that Assimp reads, or builtin:garden, builtin:room, builtin:cards, builtin:crowd:N (docs/scenes.md).
// Throws mirrorball::Error: unknownName for an unknown builtin, notFound, badFile (also: no triangle in it).
Scene loadScene(const std::string& nameOrFile);

// A reflector as triangles around the origin: "sphere:r" (geodesic, for pass 1 of others), "teapot" (the Utah
// teapot from its Bézier patches), or any model file, centred on its bounding box's centre and scaled so that
// its bounding sphere about that centre has radius 1 (sphere:r and teapot too before `r` / scale apply: see .cpp).
Mesh loadReflector(const std::string& name);

} // namespace examples
