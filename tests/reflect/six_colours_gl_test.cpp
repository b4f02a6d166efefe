// A six-colour cube map of 1 × 1 faces with nearest filtering, mirrored by a cube with flat normals, shows
// exactly the six colours where they belong.
#include "support/check.h"
#include "support/gl_image.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/reflect/image_map.h>
#include <mirrorball/reflect/probe_binding.h>
#include <mirrorball/reflect/reflection_material.h>

#include <epoxy/gl.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cstdio>
#include <optional>
#include <set>

using namespace mirrorball;

namespace {

constexpr int pixels = 200;
constexpr double fov = 0.9; // radians

// +X −X +Y −Y +Z −Z, each exact in half floats.
constexpr std::array<glm::vec3, 6> colours = {glm::vec3(1, 0, 0),    glm::vec3(0, 1, 1),
                                              glm::vec3(0, 1, 0),    glm::vec3(1, 0, 1),
                                              glm::vec3(0, 0, 0.5f), glm::vec3(1, 1, 0.25f)};

struct Vertex
{
    glm::vec3 position, normal;
};

// The cube from −1 to 1, counter-clockwise seen from outside.
std::vector<Vertex> cube()
{
    std::vector<Vertex> vertices;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const float sign = side % 2 == 0 ? 1.0f : -1.0f;
        glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
        normal[axis] = sign;
        u[(axis + 1) % 3] = sign;
        v[(axis + 2) % 3] = 1.0f;
        for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}})
            vertices.push_back({normal + corner.x * u + corner.y * v, normal});
    }
    return vertices;
}

// The normal where a ray from outside meets the cube first: the last of the three slabs that it enters.
std::optional<std::pair<glm::dvec3, glm::dvec3>> meetCube(const glm::dvec3& eye, const glm::dvec3& ray)
{
    double enter = 0.0, leave = 1e9;
    glm::dvec3 normal(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double sign = ray[axis] > 0.0 ? 1.0 : -1.0;
        const double in = (-sign - eye[axis]) / ray[axis], out = (sign - eye[axis]) / ray[axis];
        if (in > enter) {
            enter = in;
            normal = glm::dvec3(0.0);
            normal[axis] = -sign;
        }
        leave = std::min(leave, out);
    }
    if (!(enter < leave))
        return std::nullopt;
    return std::pair(eye + enter * ray, normal);
}

int largestAxis(const glm::dvec3& d)
{
    const glm::dvec3 a = glm::abs(d);
    return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

// How far the two largest coordinates are apart, relative: near 0 the colour is a matter of rounding.
double margin(const glm::dvec3& d)
{
    glm::dvec3 a = glm::abs(d);
    const double largest = a[largestAxis(a)];
    a[largestAxis(a)] = 0.0;
    return 1.0 - a[largestAxis(a)] / largest;
}

const char* const vertexSource = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clipFromWorld;
out vec3 positionInWorld;
flat out vec3 normalInWorld;
void main()
{
    positionInWorld = position;
    normalInWorld = normal;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

const char* const fragmentSource = R"(
in vec3 positionInWorld;
flat in vec3 normalInWorld;
uniform vec3 eyeInWorld;
out vec4 colour;
void main()
{
    colour = mirrorball_reflection(positionInWorld, normalInWorld, eyeInWorld);
}
)";

class MirrorCube
{
public:
    MirrorCube()
        : program_(tests::makeProgram(
              vertexSource, "#version 330 core\n" + reflectionGlsl({.map = MapKind::cube}) + fragmentSource)),
          binding_(program_), vertexArray_(gl::VertexArray::create()), buffer_(gl::Buffer::create())
    {
        const std::vector<Vertex> vertices = cube();
        count_ = static_cast<GLsizei>(vertices.size());
        glBindVertexArray(vertexArray_.name());
        glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                     vertices.data(), GL_STATIC_DRAW);
        for (GLuint attribute = 0; attribute < 2; ++attribute) {
            glEnableVertexAttribArray(attribute);
            glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                  reinterpret_cast<const void*>(attribute * sizeof(glm::vec3)));
        }
    }
    MirrorCube(const MirrorCube&) = delete;
    MirrorCube& operator=(const MirrorCube&) = delete;
    ~MirrorCube() { glDeleteProgram(program_); }

    std::vector<float> draw(const ReflectionMap& map, const glm::mat4& clipFromWorld,
                            const glm::vec3& eye) const
    {
        const tests::ColourTarget target(pixels, pixels);
        target.bind();
        glEnable(GL_CULL_FACE); // a convex body needs no depth
        glUseProgram(program_);
        glUniformMatrix4fv(glGetUniformLocation(program_, "clipFromWorld"), 1, GL_FALSE,
                           glm::value_ptr(clipFromWorld));
        glUniform3fv(glGetUniformLocation(program_, "eyeInWorld"), 1, glm::value_ptr(eye));
        const auto bound = binding_.bind(map, {.filtering = Filtering::nearest});
        glBindVertexArray(vertexArray_.name());
        glDrawArrays(GL_TRIANGLES, 0, count_);
        return target.read();
    }

private:
    GLuint program_;
    ProbeBinding binding_;
    gl::VertexArray vertexArray_;
    gl::Buffer buffer_;
    GLsizei count_ = 0;
};

// Compares one view with what a ray through each pixel says; returns the sides whose colour was seen.
std::set<int> checkView(const MirrorCube& mirror, const ReflectionMap& map, const glm::dvec3& eye)
{
    const glm::dmat4 viewFromWorld = glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(0.1, 1.0, 0.05));
    const glm::dmat4 clipFromWorld = glm::perspective(fov, 1.0, 0.1, 100.0) * viewFromWorld;
    const std::vector<float> image = mirror.draw(map, glm::mat4(clipFromWorld), glm::vec3(eye));
    const glm::dmat3 worldFromView = glm::transpose(glm::dmat3(viewFromWorld));
    std::set<int> seen;
    int compared = 0;
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            const auto ndc = [](int index) { return 2.0 * (index + 0.5) / pixels - 1.0; };
            const double tangent = std::tan(0.5 * fov);
            const glm::dvec3 ray = worldFromView * glm::dvec3(tangent * ndc(x), tangent * ndc(y), -1.0);
            const auto met = meetCube(eye, ray);
            if (!met)
                continue;
            const auto& [position, normal] = *met;
            glm::dvec3 onSide = glm::abs(position);
            onSide[largestAxis(onSide)] = 0.0;
            // A pixel is 0.02 wide on the cube at most. Within 1e-4 of a border rounding decides.
            const bool nearEdge = onSide[largestAxis(onSide)] > 0.97;
            const glm::dvec3 mirrored = ray - 2.0 * glm::dot(ray, normal) * normal;
            if (nearEdge || margin(mirrored) < 1e-4)
                continue;
            const int axis = largestAxis(mirrored);
            const int side = 2 * axis + (mirrored[axis] < 0.0 ? 1 : 0);
            const float* const shown = &image[4 * static_cast<std::size_t>(y * pixels + x)];
            CHECK(glm::vec3(shown[0], shown[1], shown[2]) == colours[static_cast<std::size_t>(side)]);
            seen.insert(side);
            ++compared;
        }
    CHECK(compared > pixels * pixels / 10);
    return seen;
}

} // namespace

int main()
{
    const headless::Context context;
    std::vector<float> layers;
    for (const glm::vec3& colour : colours)
        layers.insert(layers.end(), {colour.r, colour.g, colour.b, 1.0f});
    const ImageMap images(MapKind::cube, 1, layers);
    const MirrorCube mirror;
    std::set<int> seen;
    for (const glm::dvec3 eye : {glm::dvec3(3.1, 2.3, 2.7),
                                 {-3.3, 2.1, 1.9},
                                 {2.2, -3.4, -2.4},
                                 {0.4, 0.3, -4.0},
                                 {-0.5, 4.1, 0.2},
                                 {3.9, -0.3, 0.6},
                                 {-2.0, -2.5, -3.0}})
        seen.merge(checkView(mirror, images.map(), eye));
    CHECK(seen.size() == 6);
    CHECK(glGetError() == GL_NO_ERROR);
}
