#include "teapot.h"

#include <glm/geometric.hpp>

#include <span>

namespace examples {
namespace {

// ---- Newell's control points, folded by their symmetries
// --------------------------------------------------------- z is up here, as in the original.

// A ring of control points around the axis: each quarter goes (r, 0), (r, t), (t, r), (0, r).
struct Ring
{
    double radius, tangent, height;
};

// The four quarters of the original approximate the circle by t = 0.56 r, not by the closer 0.5523 r.
constexpr Ring ring(double radius, double height)
{
    return {radius, 0.56 * radius, height};
}

// From the rim's inner edge over the rim, down the body and to the middle of the bottom.
constexpr Ring body[] = {ring(1.4, 2.4),    ring(1.3375, 2.53125), ring(1.4375, 2.53125), ring(1.5, 2.4),
                         ring(1.75, 1.875), ring(2.0, 1.35),       ring(2.0, 0.9),        ring(2.0, 0.45),
                         ring(1.5, 0.225),  ring(1.5, 0.15),       ring(1.5, 0.075),      ring(1.425, 0.0),
                         ring(0.0, 0.0)};

// From the top of the knob outward. In the original the knob's widest ring alone has t = 0.45.
constexpr Ring lid[] = {ring(0.0, 3.15), {0.8, 0.45, 3.15}, ring(0.0, 2.85), ring(0.2, 2.7),
                        ring(0.4, 2.55), ring(1.3, 2.55),   ring(1.3, 2.4)};

// A cross-section of a tube: half of it goes (x0, 0, z0), (x0, −w, z0), (x1, −w, z1), (x1, 0, z1); the other
// half is its mirror image in y = 0.
struct Section
{
    double x0, z0, x1, z1, w;
};

constexpr Section handle[] = {{-1.5, 2.25, -1.6, 2.025, 0.3}, {-2.5, 2.25, -2.3, 2.025, 0.3},
                              {-3.0, 2.25, -2.7, 2.025, 0.3}, {-3.0, 1.8, -2.7, 1.8, 0.3},
                              {-3.0, 1.35, -2.7, 1.575, 0.3}, {-2.65, 0.9375, -2.5, 1.125, 0.3},
                              {-1.9, 0.6, -2.0, 0.9, 0.3}};

constexpr Section spout[] = {{1.7, 0.6, 1.7, 1.425, 0.66},       {3.1, 0.825, 2.6, 1.425, 0.66},
                             {2.4, 2.025, 2.3, 2.1, 0.25},       {3.3, 2.4, 2.7, 2.4, 0.25},
                             {3.525, 2.49375, 2.8, 2.475, 0.25}, {3.45, 2.5125, 2.9, 2.475, 0.15},
                             {3.2, 2.4, 2.8, 2.4, 0.15}};

// ---- Patches
// ------------------------------------------------------------------------------------------------------

using Curve = std::array<glm::dvec3, 4>;
using Patch = std::array<Curve, 4>; // rows along v, points of a row along u

// i of n steps along a cubic curve. Turned around, the same points come out bit by bit: borders of patches
// close.
glm::dvec3 pointOn(const Curve& p, int i, int n)
{
    const double t = static_cast<double>(i) / n;
    const double s = static_cast<double>(n - i) / n;
    return (s * s * s * p[0] + t * t * t * p[3]) + (3.0 * (s * s * t) * p[1] + 3.0 * (t * t * s) * p[2]);
}

// The derivative, up to its factor of 3.
glm::dvec3 tangentOn(const Curve& p, int i, int n)
{
    const double t = static_cast<double>(i) / n;
    const double s = static_cast<double>(n - i) / n;
    return s * s * (p[1] - p[0]) + 2.0 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]);
}

// z up becomes y up: a quarter turn about x.
glm::vec3 turned(const glm::dvec3& v)
{
    return glm::vec3(glm::dvec3(v.x, v.z, -v.y));
}

// The point and outward normal at step (i, j).
void appendVertex(Mesh& mesh, const Patch& patch, int i, int j, int n)
{
    Curve alongU;
    Curve alongV;
    for (std::size_t k = 0; k < 4; ++k) {
        const Curve column{patch[0][k], patch[1][k], patch[2][k], patch[3][k]};
        alongU[k] = pointOn(column, j, n);
        alongV[k] = pointOn(patch[k], i, n);
    }
    const glm::dvec3 point = pointOn(alongU, i, n);
    glm::dvec3 normal = glm::cross(tangentOn(alongV, j, n), tangentOn(alongU, i, n));
    if (point.x == 0.0 && point.y == 0.0) {
        // A pole, where the ring has shrunk to a point: the middle of the bottom or the top of the knob.
        normal = {0.0, 0.0, point.z > 0.0 ? 1.0 : -1.0};
    }
    mesh.positions.push_back(turned(point));
    mesh.normals.push_back(turned(glm::normalize(normal)));
    mesh.textureCoordinates.push_back(glm::vec2(i, j) / static_cast<float>(n));
}

void appendPatch(Mesh& mesh, const Patch& patch, int n)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto stride = static_cast<std::uint32_t>(n + 1);
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            appendVertex(mesh, patch, i, j, n);
        }
    }
    const auto append = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto& p = mesh.positions;
        if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) { // at a pole one side of the square is a point
            mesh.triangles.push_back({a, b, c});
        }
    };
    for (std::uint32_t j = 0; j + 1 < stride; ++j) {
        for (std::uint32_t i = 0; i + 1 < stride; ++i) {
            const std::uint32_t a = first + j * stride + i;
            append(a, a + stride, a + stride + 1);
            append(a, a + stride + 1, a + 1);
        }
    }
}

Curve quarter(const Ring& r, int number)
{
    Curve curve{glm::dvec3(r.radius, 0.0, r.height), glm::dvec3(r.radius, r.tangent, r.height),
                glm::dvec3(r.tangent, r.radius, r.height), glm::dvec3(0.0, r.radius, r.height)};
    for (; number > 0; --number) {
        for (glm::dvec3& point : curve) {
            point = {-point.y, point.x, point.z};
        }
    }
    return curve;
}

Curve half(const Section& s, bool mirrored)
{
    if (mirrored) {
        return {glm::dvec3(s.x1, 0.0, s.z1), glm::dvec3(s.x1, s.w, s.z1), glm::dvec3(s.x0, s.w, s.z0),
                glm::dvec3(s.x0, 0.0, s.z0)};
    }
    return {glm::dvec3(s.x0, 0.0, s.z0), glm::dvec3(s.x0, -s.w, s.z0), glm::dvec3(s.x1, -s.w, s.z1),
            glm::dvec3(s.x1, 0.0, s.z1)};
}

// Every three steps along the rows a new patch begins, on the last row of the one before.
void appendRevolved(Mesh& mesh, std::span<const Ring> rings, int n)
{
    for (std::size_t row = 0; row + 3 < rings.size(); row += 3) {
        for (int q = 0; q < 4; ++q) {
            appendPatch(mesh,
                        {quarter(rings[row], q), quarter(rings[row + 1], q), quarter(rings[row + 2], q),
                         quarter(rings[row + 3], q)},
                        n);
        }
    }
}

void appendTube(Mesh& mesh, std::span<const Section> sections, int n)
{
    for (std::size_t row = 0; row + 3 < sections.size(); row += 3) {
        for (const bool mirrored : {false, true}) {
            appendPatch(mesh,
                        {half(sections[row], mirrored), half(sections[row + 1], mirrored),
                         half(sections[row + 2], mirrored), half(sections[row + 3], mirrored)},
                        n);
        }
    }
}

} // namespace

Mesh teapot(int subdivisions)
{
    Mesh mesh;
    mesh.name = "teapot";
    appendRevolved(mesh, body, subdivisions);
    appendRevolved(mesh, lid, subdivisions);
    appendTube(mesh, handle, subdivisions);
    appendTube(mesh, spout, subdivisions);
    return mesh;
}

} // namespace examples
