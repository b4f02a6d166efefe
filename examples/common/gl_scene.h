// A Scene on the GPU: one vertex array a mesh, drawn with the Phong shaders of the example programs.
#pragma once

#include "scene.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/gl/objects.h>

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace examples {

// What the fragment shader writes: the number is that of #if VIEW in surface.glsl.
enum class View { colour = 0, position = 1, normal = 2, triangle = 3 };

// The vertex and fragment shader that draw the scene in pass 1, as text and as a program.
std::string phongVertexSource();
std::string phongFragmentSource(View view);
mirrorball::CaptureProgram phongCaptureProgram(View view = View::colour);

// The fragment shader that draws the scene into a picture: output 0 is the colour, output 1 the distance from
// the eye and 0, where a reflector writes its number from 1.
std::string pictureFragmentSource(View view);

// What such a fragment shader begins with: #version, VIEW, and phong() with its uniforms.
std::string fragmentPrelude(View view);

// What the Phong shader needs beside the material; positions relative to the GlScene's origin.
struct PhongView
{
    glm::vec3 light{0.0f};
    glm::vec3 eye{0.0f};
};

class GlScene
{
public:
    // Vertices are uploaded relative to `origin`, subtracted in double.
    GlScene(const Scene& scene, const glm::dvec3& origin);

    std::size_t meshCount() const { return meshes_.size(); }
    std::size_t triangleCount() const;

    // The meshes as a probe at `centre`, relative to the origin, wants them; ids are indices.
    std::vector<mirrorball::CaptureMesh> captureMeshes(mirrorball::CaptureProgram& program,
                                                       const glm::vec3& centre = glm::vec3(0.0f)) const;

    // Sets the material's uniforms on the program in use and draws, as often as asked in one call.
    void drawMesh(std::size_t mesh, unsigned int program, const PhongView& view, int instances = 1,
                  unsigned int primitive = 4 /* GL_TRIANGLES */) const;
    void drawAll(unsigned int program, const PhongView& view) const;

private:
    struct GlMesh
    {
        mirrorball::gl::VertexArray vertexArray;
        mirrorball::gl::Buffer vertices, triangles;
        std::size_t triangleCount, firstTriangle;
        int material;
        mirrorball::Sphere bounds;
        float longestEdge;
        std::vector<glm::vec3> positions; // in world space, relative to the origin
        std::vector<std::array<std::uint32_t, 3>> corners;
    };

    static GlMesh upload(const Mesh& mesh, const glm::dvec3& worldOffset);
    static std::optional<float> nearestDistance(const GlMesh& mesh, const glm::vec3& centre);
    static std::optional<float> widestAngle(const GlMesh& mesh, const glm::vec3& centre);

    std::vector<GlMesh> meshes_;
    std::vector<Material> materials_;
    std::vector<mirrorball::gl::Texture> images_;
};

// Compiles and links; throws mirrorball::Error with the log.
mirrorball::gl::Program linkProgram(const std::string& vertexSource, const std::string& fragmentSource);

} // namespace examples
