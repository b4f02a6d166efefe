// The teapot's surface: it closes where it should, stands where Newell put it, and its normals are those of
// the surface.
#include "teapot.h"

#include "scene.h"

#include "support/check.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

using examples::Mesh;

namespace {

using Key = std::tuple<float, float, float>;

Key keyOf(const glm::vec3& p)
{
    return {p.x, p.y, p.z};
}

bool contains(const Mesh& mesh, const glm::vec3& point)
{
    return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const glm::vec3& p) { return glm::distance(p, point) < 1e-6f; });
}

// Four surfaces, joined by equal positions alone: body and lid are discs (Euler characteristic 1 each),
// handle and spout are open tubes (0). The lower end of the handle touches the body in one vertex, (−2, 0.9,
// 0), so there is one vertex less. Open edges: 4 n around the rim, 4 n around the lid, 2 n at each of the
// four ends of the tubes.
void testClosed(int n)
{
    const Mesh mesh = examples::teapot(n);
    std::map<Key, int> vertices;
    std::map<std::pair<int, int>, int> edges; // directed
    for (const auto& triangle : mesh.triangles) {
        int v[3];
        for (std::size_t k = 0; k < 3; ++k) {
            v[k] = vertices.emplace(keyOf(mesh.positions[triangle[k]]), static_cast<int>(vertices.size()))
                       .first->second;
        }
        for (int k = 0; k < 3; ++k) {
            CHECK(v[k] != v[(k + 1) % 3]);
            const int uses = ++edges[{v[k], v[(k + 1) % 3]}];
            CHECK(uses == 1); // all triangles turn the same way
        }
    }
    int undirected = 0;
    int open = 0;
    for (const auto& [edge, count] : edges) {
        const bool hasTwin = edges.contains({edge.second, edge.first});
        undirected += !hasTwin || edge.first < edge.second ? 1 : 0;
        open += hasTwin ? 0 : 1;
    }
    CHECK(static_cast<int>(mesh.triangles.size()) == 32 * 2 * n * n - 8 * n); // 8 n at the poles have no area
    CHECK(static_cast<int>(vertices.size()) - undirected + static_cast<int>(mesh.triangles.size()) == 1);
    CHECK(open == 16 * n);
}

void testPlace()
{
    const Mesh mesh = examples::teapot(16);
    glm::vec3 low(1e9f);
    glm::vec3 high(-1e9f);
    std::set<Key> points;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        points.insert(keyOf(p));
    }
    CHECK(low == glm::vec3(-3.0f, 0.0f, -2.0f));
    CHECK(high.y == 3.15f && high.z == 2.0f);
    CHECK(high.x > 3.4f && high.x < 3.525f); // the lip's largest control point
    for (const glm::vec3& p : mesh.positions) {
        CHECK(points.contains(keyOf({p.x, p.y, -p.z})));
    }
    // The ends of the lip's and the handle's outlines.
    CHECK(contains(mesh, {3.2f, 2.4f, 0.0f}) && contains(mesh, {2.8f, 2.4f, 0.0f}));
    CHECK(contains(mesh, {-1.5f, 2.25f, 0.0f}) && contains(mesh, {-1.9f, 0.6f, 0.0f}));
    // The poles: the knob's top and the bottom's middle.
    CHECK(contains(mesh, {0.0f, 3.15f, 0.0f}) && contains(mesh, {0.0f, 0.0f, 0.0f}));
}

// The middle of each curve in the plane z = 0 and the middle of patches, by (p0 + 3 p1 + 3 p2 + p3) / 8,
// worked out from Newell's numbers by hand.
void testMiddles()
{
    const Mesh mesh = examples::teapot(16);
    const glm::vec2 profile[] = {{1.403125f, 2.4984375f}, {1.84375f, 1.621875f}, {1.75f, 0.384375f},
                                 {1.284375f, 0.046875f},  {0.325f, 2.98125f},    {0.825f, 2.55f}};
    for (const glm::vec2& point : profile) { // rim, upper and lower body, bottom, knob, lid
        for (const glm::vec3& side :
             {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
        {
            CHECK(contains(mesh, point.x * side + glm::vec3(0, point.y, 0)));
        }
    }
    // Halfway around a quarter: (4 r + 3 t) / 8 in x and in z; t = 0.56 r, but 0.18275 there on the knob.
    CHECK(contains(mesh, {1.42f, 0.9f, -1.42f}));
    CHECK(contains(mesh, {0.23103125f, 2.98125f, -0.23103125f}));
    const glm::vec2 outlines[] = {{-2.625f, 2.19375f},      {-2.4125f, 1.996875f}, {-2.73125f, 1.1578125f},
                                  {-2.5375f, 1.35f},        {2.6875f, 1.44375f},   {2.3875f, 1.8f},
                                  {3.428125f, 2.47734375f}, {2.825f, 2.45625f}};
    for (const glm::vec2& point : outlines)
    { // handle, outside and inside, twice; spout, below and above, twice
        CHECK(contains(mesh, {point.x, point.y, 0.0f}));
    }
    // The sides of handle and spout: three quarters of the half width.
    for (const float side : {-1.0f, 1.0f}) {
        CHECK(contains(mesh, {-2.51875f, 2.0953125f, 0.225f * side}));
        CHECK(contains(mesh, {2.5375f, 1.621875f, 0.34125f * side}));
        CHECK(contains(mesh, {3.1265625f, 2.466796875f, 0.15f * side}));
    }
}

// Largest angle, as 1 − cosine, between a triangle's own normal and the analytic ones at its corners.
double worstNormal(int n)
{
    const Mesh mesh = examples::teapot(n);
    double worst = 0.0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t[0]]);
        const glm::dvec3 b(mesh.positions[t[1]]);
        const glm::dvec3 c(mesh.positions[t[2]]);
        const glm::dvec3 face = glm::normalize(glm::cross(b - a, c - a));
        for (const std::uint32_t corner : t) {
            worst = std::max(worst, 1.0 - glm::dot(face, glm::dvec3(mesh.normals[corner])));
        }
    }
    return worst;
}

void testNormals()
{
    const Mesh mesh = examples::teapot(16);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        CHECK_NEAR(glm::length(mesh.normals[i]), 1.0, 4e-7); // three roundings of float around 1
        if (mesh.positions[i] == glm::vec3(0.0f, 3.15f, 0.0f)) {
            CHECK(mesh.normals[i] == glm::vec3(0, 1, 0));
        }
        if (mesh.positions[i] == glm::vec3(0.0f)) {
            CHECK(mesh.normals[i] == glm::vec3(0, -1, 0));
        }
    }
    // The angle is proportional to the triangles' size, so 1 − cosine falls by nearly 4 with each halving; a
    // wrong normal would stay.
    for (const int n : {16, 32}) {
        CHECK(worstNormal(2 * n) < 0.4 * worstNormal(n));
    }
    // They point away from the axis of the body, and outward as a whole: by the divergence theorem the
    // triangles, wound the same way, enclose a positive volume.
    double volume = 0.0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t[0]]);
        volume +=
            glm::dot(a, glm::cross(glm::dvec3(mesh.positions[t[1]]), glm::dvec3(mesh.positions[t[2]]))) / 6.0;
    }
    CHECK(volume > 20.0);
}

void testReflector()
{
    const Mesh mesh = examples::loadReflector("teapot");
    glm::vec3 low(1e9f);
    glm::vec3 high(-1e9f);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    CHECK(glm::distance(low, -high) < 1e-6f);
    CHECK_NEAR(high.x - low.x, 6.4335, 1e-4);
}

} // namespace

int main()
{
    for (const int n : {2, 5, 16}) {
        testClosed(n);
    }
    testPlace();
    testMiddles();
    testNormals();
    testReflector();
}
