#include "support/six_walls.h"

#include <epoxy/gl.h>

#include <array>
#include <vector>

namespace tests {

namespace {

constexpr float distance = 2.0f;

struct Vertex
{
    glm::vec3 position, colour;
};

// The wall's axis (0 to 2) and side, and its tangent coordinates relative to the wall's half side.
struct OnWall
{
    int wall;
    glm::dvec2 tangent;
};

OnWall onWall(const glm::dvec3& d)
{
    const glm::dvec3 a = glm::abs(d);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return {2 * axis + (d[axis] < 0.0 ? 1 : 0), glm::dvec2(d[(axis + 1) % 3], d[(axis + 2) % 3]) / a[axis]};
}

constexpr std::array<glm::vec3, 6> colours = {glm::vec3(1, 0, 0), glm::vec3(0, 1, 1), glm::vec3(0, 1, 0),
                                              glm::vec3(1, 0, 1), glm::vec3(0, 0, 1), glm::vec3(1, 1, 0)};

void addWall(std::vector<Vertex>& vertices, const glm::vec3& centre, int wall, int cuts)
{
    const int axis = wall / 2;
    const float side = wall % 2 == 0 ? distance : -distance;
    const auto corner = [&](int i, int j) {
        glm::vec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = distance * (2.0f * static_cast<float>(i) / static_cast<float>(cuts) - 1.0f);
        p[(axis + 2) % 3] = distance * (2.0f * static_cast<float>(j) / static_cast<float>(cuts) - 1.0f);
        return p;
    };
    for (int i = 0; i < cuts; ++i)
        for (int j = 0; j < cuts; ++j) {
            const bool dark = 2 * i >= cuts && 2 * j >= cuts;
            const glm::vec3 colour = colours[static_cast<std::size_t>(wall)] * (dark ? 0.5f : 1.0f);
            const std::array<glm::vec3, 4> q = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                                corner(i, j + 1)};
            for (const int index : {0, 1, 2, 0, 2, 3})
                vertices.push_back({centre + q[static_cast<std::size_t>(index)], colour});
        }
}

} // namespace

SixWalls::SixWalls(const glm::vec3& centre, int cuts) : program_(makeProgram()), centre_(centre)
{
    std::vector<Vertex> vertices;
    for (int wall = 0; wall < 6; ++wall)
        addWall(vertices, centre, wall, cuts);
    vertexCount_ = static_cast<int>(vertices.size());
    vertexArray_ = mirrorball::gl::VertexArray::create();
    buffer_ = mirrorball::gl::Buffer::create();
    glBindVertexArray(vertexArray_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                 GL_STATIC_DRAW);
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(attribute * sizeof(glm::vec3)));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

mirrorball::CaptureMesh SixWalls::mesh() const
{
    return {.program = &program_,
            .bounds = mirrorball::Sphere{centre_, distance * 1.7320509f},
            .triangles = static_cast<std::size_t>(vertexCount_ / 3)};
}

void SixWalls::draw() const
{
    glBindVertexArray(vertexArray_.name());
    glDrawArrays(GL_TRIANGLES, 0, vertexCount_);
}

glm::vec3 SixWalls::colourInDirection(const glm::dvec3& directionInWorld)
{
    const OnWall at = onWall(directionInWorld);
    const bool dark = at.tangent.x > 0.0 && at.tangent.y > 0.0;
    return colours[static_cast<std::size_t>(at.wall)] * (dark ? 0.5f : 1.0f);
}

double SixWalls::marginInDirection(const glm::dvec3& directionInWorld)
{
    const glm::dvec2 t = glm::abs(onWall(directionInWorld).tangent);
    return std::min(std::min(t.x, t.y), 1.0 - std::max(t.x, t.y));
}

mirrorball::CaptureProgram SixWalls::makeProgram()
{
    return mirrorball::CaptureProgram({.name = "six walls",
                                       .vertexSource = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 wallColour;
out vec3 positionInWorld;
flat out vec3 colourOfWall;
void main()
{
    positionInWorld = position;
    colourOfWall = wallColour;
    gl_Position = vec4(position, 1.0);
}
)",
                                       .fragmentSource = R"(#version 330 core
flat in vec3 colourOfWall;
out vec4 colour;
void main()
{
    colour = vec4(colourOfWall, 1.0);
}
)",
                                       .position = "positionInWorld"});
}

} // namespace tests
