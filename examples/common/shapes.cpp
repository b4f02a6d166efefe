#include "shapes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace examples {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

std::uint32_t appendVertex(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal,
                           const glm::vec2& uv)
{
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.textureCoordinates.push_back(uv);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

// (cos, sin) of i / count of a turn, exactly the same for i = 0 and i = count: surfaces of revolution close.
glm::vec2 onCircle(int i, int count)
{
    const double angle = turn * (i % count) / count;
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

// The two triangles of a grid cell whose lower left vertex is `first`, in a grid of rows of `stride`
// vertices.
void appendCell(Mesh& mesh, std::uint32_t first, std::uint32_t stride)
{
    mesh.triangles.push_back({first, first + 1, first + stride + 1});
    mesh.triangles.push_back({first, first + stride + 1, first + stride});
}

void appendGrid(Mesh& mesh, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                const glm::vec2& repeats, int subdivisions)
{
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto stride = static_cast<std::uint32_t>(subdivisions + 1);
    for (int row = 0; row <= subdivisions; ++row) {
        for (int column = 0; column <= subdivisions; ++column) {
            const glm::vec2 uv = glm::vec2(column, row) / static_cast<float>(subdivisions);
            appendVertex(mesh, corner + uv.x * u + uv.y * v, normal, uv * repeats);
        }
    }
    for (std::uint32_t row = 0; row + 1 < stride; ++row) {
        for (std::uint32_t column = 0; column + 1 < stride; ++column) {
            appendCell(mesh, first + row * stride + column, stride);
        }
    }
}

// A horizontal disc as a fan around its centre, facing up or down.
void appendDisc(Mesh& mesh, const glm::vec3& centre, float radius, float up, int sectors)
{
    const glm::vec3 normal(0.0f, up, 0.0f);
    const std::uint32_t middle = appendVertex(mesh, centre, normal, {0.5f, 0.5f});
    for (int i = 0; i <= sectors; ++i) {
        const glm::vec2 c = onCircle(i, sectors);
        appendVertex(mesh, centre + glm::vec3(radius * c.x, 0.0f, radius * c.y), normal, 0.5f + 0.5f * c);
    }
    for (auto i = middle + 1; i <= middle + static_cast<std::uint32_t>(sectors); ++i) {
        mesh.triangles.push_back(up > 0.0f ? std::array{middle, i + 1, i} : std::array{middle, i, i + 1});
    }
}

} // namespace

Mesh meshOf(const char* name, int material)
{
    Mesh mesh;
    mesh.name = name;
    mesh.material = material;
    return mesh;
}

void appendQuad(Mesh& mesh, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                const glm::vec2& repeats)
{
    appendGrid(mesh, corner, u, v, repeats, 1);
}

void appendBox(Mesh& mesh, const glm::vec3& low, const glm::vec3& high, int subdivisions)
{
    const glm::vec3 x(high.x - low.x, 0.0f, 0.0f);
    const glm::vec3 y(0.0f, high.y - low.y, 0.0f);
    const glm::vec3 z(0.0f, 0.0f, high.z - low.z);
    const glm::vec2 once(1.0f);
    appendGrid(mesh, low + x + z, -z, y, once, subdivisions);
    appendGrid(mesh, low, z, y, once, subdivisions);
    appendGrid(mesh, low + y + z, x, -z, once, subdivisions);
    appendGrid(mesh, low, x, z, once, subdivisions);
    appendGrid(mesh, low + z, x, y, once, subdivisions);
    appendGrid(mesh, low + x, -x, y, once, subdivisions);
}

void appendSphere(Mesh& mesh, const glm::vec3& centre, float radius, int rings, int sectors)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto stride = static_cast<std::uint32_t>(sectors + 1);
    for (int ring = 0; ring <= rings; ++ring) {
        // The poles exactly on the axis: sin(π) is not 0 in floating point.
        const bool pole = ring == 0 || ring == rings;
        const double latitude = turn / 2.0 * ring / rings;
        const float sine = pole ? 0.0f : static_cast<float>(std::sin(latitude));
        const auto cosine = static_cast<float>(std::cos(latitude));
        for (int sector = 0; sector <= sectors; ++sector) {
            const glm::vec2 c = onCircle(sector, sectors);
            const glm::vec3 normal = glm::normalize(glm::vec3(sine * c.y, -cosine, sine * c.x));
            appendVertex(mesh, centre + radius * normal, normal,
                         glm::vec2(sector, ring) / glm::vec2(sectors, rings));
        }
    }
    for (std::uint32_t ring = 0; ring < static_cast<std::uint32_t>(rings); ++ring) {
        for (std::uint32_t sector = 0; sector + 1 < stride; ++sector) {
            const std::uint32_t a = first + ring * stride + sector;
            if (ring > 0) {
                mesh.triangles.push_back({a, a + 1, a + stride + 1});
            }
            if (ring + 1 < static_cast<std::uint32_t>(rings)) {
                mesh.triangles.push_back({a, a + stride + 1, a + stride});
            }
        }
    }
}

void appendTorus(Mesh& mesh, const glm::vec3& centre, const glm::vec3& axis, float radius, float tubeRadius,
                 int rings, int sectors)
{
    const glm::vec3 other = std::abs(axis.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 s = glm::normalize(glm::cross(axis, other));
    const glm::vec3 t = glm::cross(axis, s);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto stride = static_cast<std::uint32_t>(sectors + 1);
    for (int ring = 0; ring <= rings; ++ring) {
        const glm::vec2 large = onCircle(ring, rings);
        const glm::vec3 outward = large.x * s + large.y * t;
        for (int sector = 0; sector <= sectors; ++sector) {
            const glm::vec2 small = onCircle(sector, sectors);
            const glm::vec3 normal = glm::normalize(small.x * outward - small.y * axis);
            appendVertex(mesh, centre + radius * outward + tubeRadius * normal, normal,
                         glm::vec2(sector, ring) / glm::vec2(sectors, rings));
        }
    }
    for (std::uint32_t ring = 0; ring < static_cast<std::uint32_t>(rings); ++ring) {
        for (std::uint32_t sector = 0; sector + 1 < stride; ++sector) {
            appendCell(mesh, first + ring * stride + sector, stride);
        }
    }
}

void appendColumn(Mesh& mesh, const glm::vec3& base, float bottomRadius, float topRadius, float height,
                  int sectors)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto stride = static_cast<std::uint32_t>(sectors + 1);
    for (int row = 0; row < 2; ++row) {
        const float radius = row == 0 ? bottomRadius : topRadius;
        for (int i = 0; i <= sectors; ++i) {
            const glm::vec2 c = onCircle(i, sectors);
            const glm::vec3 normal =
                glm::normalize(glm::vec3(height * c.y, bottomRadius - topRadius, height * c.x));
            appendVertex(mesh, base + glm::vec3(radius * c.y, static_cast<float>(row) * height, radius * c.x),
                         normal, {static_cast<float>(i) / static_cast<float>(sectors), row});
        }
    }
    for (std::uint32_t i = 0; i + 1 < stride; ++i) {
        appendCell(mesh, first + i, stride);
    }
    appendDisc(mesh, base + glm::vec3(0.0f, height, 0.0f), topRadius, 1.0f, sectors);
    appendDisc(mesh, base, bottomRadius, -1.0f, sectors);
}

} // namespace examples
