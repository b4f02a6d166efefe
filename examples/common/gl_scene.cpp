#include "gl_scene.h"

#include "phong_shaders.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cmath>

namespace examples {

namespace {

struct Vertex
{
    glm::vec3 position, normal;
    glm::vec2 textureCoordinate;
};

mirrorball::gl::Texture upload(const Image& image)
{
    mirrorball::gl::Texture texture = mirrorball::gl::Texture::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

mirrorball::Sphere boundsOf(const std::vector<Vertex>& vertices)
{
    glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low);
    for (const Vertex& vertex : vertices) {
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    mirrorball::Sphere bounds{0.5f * (low + high), 0.0f};
    for (const Vertex& vertex : vertices)
        bounds.radius = std::max(bounds.radius, glm::distance(bounds.centre, vertex.position));
    return bounds;
}

float longestEdge(const std::vector<glm::vec3>& points,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
    float longest = 0.0f;
    for (const auto& triangle : triangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            longest = std::max(longest,
                               glm::distance(points[triangle[corner]], points[triangle[(corner + 1) % 3]]));
    return longest;
}

// Meshes of no more triangles say how near they come, where their bounding spheres cannot.
constexpr std::size_t fewTriangles = 64;

float distanceToSegment(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b)
{
    const glm::vec3 ab = b - a;
    const float along = glm::dot(point - a, ab) / std::max(glm::dot(ab, ab), 1e-30f);
    return glm::distance(point, a + std::clamp(along, 0.0f, 1.0f) * ab);
}

float distanceToTriangle(const glm::vec3& point, const std::array<glm::vec3, 3>& corner)
{
    const glm::vec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    float nearest = std::numeric_limits<float>::infinity();
    bool isAbove = true; // all edges, seen along the normal
    for (std::size_t index = 0; index < 3; ++index) {
        const glm::vec3 &from = corner[index], &to = corner[(index + 1) % 3];
        nearest = std::min(nearest, distanceToSegment(point, from, to));
        isAbove = isAbove && glm::dot(glm::cross(normal, to - from), point - from) >= 0.0f;
    }
    const float area = glm::length(normal);
    return isAbove && area > 0.0f ? std::abs(glm::dot(point - corner[0], normal)) / area : nearest;
}

unsigned int compile(GLenum stage, const std::string& source)
{
    const GLuint shader = glCreateShader(stage);
    const char* const text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    return shader;
}

} // namespace

mirrorball::gl::Program linkProgram(const std::string& vertexSource, const std::string& fragmentSource)
{
    mirrorball::gl::Program program = mirrorball::gl::Program::create();
    const std::array<GLuint, 2> shaders = {compile(GL_VERTEX_SHADER, vertexSource),
                                           compile(GL_FRAGMENT_SHADER, fragmentSource)};
    std::string log(4096, '\0');
    for (const GLuint shader : shaders) {
        glAttachShader(program.name(), shader);
        glDeleteShader(shader); // goes with the program
    }
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE)
        return program;
    for (const GLuint shader : shaders) {
        GLsizei length = 0;
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        if (length > 0)
            throw mirrorball::Error(mirrorball::ErrorKind::badShader, "a shader",
                                    log.substr(0, std::size_t(length)));
    }
    GLsizei length = 0;
    glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    throw mirrorball::Error(mirrorball::ErrorKind::badShader, "a program",
                            log.substr(0, std::size_t(length)));
}

std::string phongVertexSource()
{
    return std::string(shaders::phongVert);
}

std::string fragmentPrelude(View view)
{
    return "#version 330 core\n#define VIEW " + std::to_string(static_cast<int>(view)) +
           "\n#define AMBIENT " + std::to_string(ambient) + "\n" + std::string(shaders::lighting);
}

std::string phongFragmentSource(View view)
{
    return fragmentPrelude(view) + std::string(shaders::surface) + std::string(shaders::phongFrag);
}

mirrorball::CaptureProgram phongCaptureProgram(View view)
{
    return mirrorball::CaptureProgram(
        {.name = "phong", .vertexSource = phongVertexSource(), .fragmentSource = phongFragmentSource(view)});
}

std::string pictureFragmentSource(View view)
{
    return fragmentPrelude(view) + std::string(shaders::surface) + std::string(shaders::pictureFrag);
}

GlScene::GlScene(const Scene& scene, const glm::dvec3& origin) : materials_(scene.materials)
{
    std::size_t firstTriangle = 0;
    for (const Mesh& mesh : scene.meshes) {
        meshes_.push_back(upload(mesh, scene.offset - origin));
        meshes_.back().firstTriangle = firstTriangle;
        firstTriangle += mesh.triangles.size();
    }
    for (const Image& image : scene.images)
        images_.push_back(examples::upload(image));
}

GlScene::GlMesh GlScene::upload(const Mesh& mesh, const glm::dvec3& worldOffset)
{
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t index = 0; index < vertices.size(); ++index)
        vertices[index] = {glm::vec3(glm::dvec3(mesh.positions[index]) + worldOffset), mesh.normals[index],
                           mesh.textureCoordinates[index]};
    GlMesh result;
    result.bounds = boundsOf(vertices);
    result.longestEdge = longestEdge(mesh.positions, mesh.triangles);
    for (const Vertex& vertex : vertices)
        result.positions.push_back(vertex.position);
    result.corners = mesh.triangles;
    result.triangleCount = mesh.triangles.size();
    result.material = mesh.material;
    result.vertexArray = mirrorball::gl::VertexArray::create();
    result.vertices = mirrorball::gl::Buffer::create();
    result.triangles = mirrorball::gl::Buffer::create();
    glBindVertexArray(result.vertexArray.name());
    glBindBuffer(GL_ARRAY_BUFFER, result.vertices.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, result.triangles.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(mesh.triangles[0])),
                 mesh.triangles.data(), GL_STATIC_DRAW);
    const auto attribute = [](GLuint location, GLint size, std::size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 2, offsetof(Vertex, textureCoordinate));
    glBindVertexArray(0);
    return result;
}

std::size_t GlScene::triangleCount() const
{
    return meshes_.empty() ? 0 : meshes_.back().firstTriangle + meshes_.back().triangleCount;
}

std::optional<float> GlScene::nearestDistance(const GlMesh& mesh, const glm::vec3& centre)
{
    if (mesh.corners.size() > fewTriangles)
        return std::nullopt;
    float nearest = std::numeric_limits<float>::infinity();
    for (const auto& [a, b, c] : mesh.corners)
        nearest = std::min(
            nearest, distanceToTriangle(centre, {mesh.positions[a], mesh.positions[b], mesh.positions[c]}));
    return nearest;
}

std::optional<float> GlScene::widestAngle(const GlMesh& mesh, const glm::vec3& centre)
{
    if (glm::distance(mesh.bounds.centre, centre) - mesh.bounds.radius > 4.0f * mesh.longestEdge)
        return std::nullopt; // bounds say that it is below a quarter radian
    std::vector<glm::vec3> directions;
    for (const glm::vec3& position : mesh.positions)
        directions.push_back(glm::normalize(position - centre));
    return 2.0f * std::asin(std::min(0.5f * longestEdge(directions, mesh.corners), 1.0f));
}

std::vector<mirrorball::CaptureMesh> GlScene::captureMeshes(mirrorball::CaptureProgram& program,
                                                            const glm::vec3& centre) const
{
    std::vector<mirrorball::CaptureMesh> result;
    for (std::size_t index = 0; index < meshes_.size(); ++index)
        result.push_back({.program = &program,
                          .id = index,
                          .bounds = meshes_[index].bounds,
                          .longestEdge = meshes_[index].longestEdge,
                          .nearestDistance = nearestDistance(meshes_[index], centre),
                          .widestAngle = widestAngle(meshes_[index], centre),
                          .triangles = meshes_[index].triangleCount});
    return result;
}

void GlScene::drawMesh(std::size_t index, unsigned int program, const PhongView& view, int instances,
                       unsigned int primitive) const
{
    const GlMesh& mesh = meshes_[index];
    const Material& material = materials_[static_cast<std::size_t>(mesh.material)];
    const auto location = [&](const char* name) { return glGetUniformLocation(program, name); };
    glUniform4fv(location("diffuse"), 1, glm::value_ptr(material.diffuse));
    glUniform3fv(location("specular"), 1, glm::value_ptr(material.specular));
    glUniform1f(location("shininess"), material.shininess);
    glUniform1i(location("hasImage"), material.image >= 0 ? 1 : 0);
    glUniform1i(location("image"), 0);
    glUniform3fv(location("lightInWorld"), 1, glm::value_ptr(view.light));
    glUniform3fv(location("eyeInWorld"), 1, glm::value_ptr(view.eye));
    glUniform1i(location("firstTriangle"), static_cast<GLint>(mesh.firstTriangle));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D,
                  material.image >= 0 ? images_[static_cast<std::size_t>(material.image)].name() : 0u);
    glBindVertexArray(mesh.vertexArray.name());
    glDrawElementsInstanced(primitive, static_cast<GLsizei>(3 * mesh.triangleCount), GL_UNSIGNED_INT, nullptr,
                            instances);
}

void GlScene::drawAll(unsigned int program, const PhongView& view) const
{
    for (std::size_t index = 0; index < meshes_.size(); ++index)
        drawMesh(index, program, view);
}

} // namespace examples
