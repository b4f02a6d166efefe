// Triangles that rays are traced against: found by Embree in float, then measured again in double.
#pragma once

#include "scene.h"

#include <limits>
#include <memory>
#include <span>

namespace examples {

struct Hit
{
    bool found = false;
    double distance = std::numeric_limits<double>::infinity();     // along the unit direction
    glm::dvec3 position{std::numeric_limits<double>::quiet_NaN()}; // in the world
    glm::dvec3 normal{0.0};     // interpolated, unit length, as the mesh has it (not turned to the viewer)
    std::uint32_t triangle = 0; // number over all meshes of the scene, or of the reflector
    int reflector = -1;         // the reflector that was hit; -1 for the scene
    int material = -1;          // index into Scene::materials; meaningless on a reflector
    glm::vec3 colour{0.0f};     // diffuse colour times image, linear
    // Between the ray and the nearest edge of the triangle, in radians. The triangle is found in float:
    // within some 1e-6 of an edge it may be the neighbour of the right one, and across a silhouette also
    // something behind.
    double edgeAngle = std::numeric_limits<double>::infinity();
};

// A mesh as it is placed: world = offset + scale * position. What it points to must outlive the geometry.
struct PlacedMesh
{
    const Mesh* mesh = nullptr;
    const Material* material = nullptr;
    const Image* image = nullptr; // none: nullptr
    double scale = 1.0;
    glm::dvec3 offset{0.0};
};

class ReferenceGeometry
{
public:
    // Vertices are rounded to float relative to `origin`. Triangles with a NaN or infinite vertex are left
    // out (by Embree, as are those beyond 1.844e18), but counted. Throws mirrorball::Error: unsupported.
    ReferenceGeometry(std::span<const PlacedMesh> meshes, const glm::dvec3& origin);
    ~ReferenceGeometry();
    ReferenceGeometry(ReferenceGeometry&&) noexcept;
    ReferenceGeometry& operator=(ReferenceGeometry&&) noexcept;

    // The nearest triangle, from either side, with near <= distance <= far; where alpha is below 0.5 there is
    // none. The direction needs no unit length. May be called from several threads at once.
    Hit trace(const glm::dvec3& originInWorld, const glm::dvec3& direction, double near, double far) const;

private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
};

// In radians between a unit direction and the nearest edge of a triangle, both as seen from the origin.
double angleToEdges(const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b,
                    const glm::dvec3& c);

// Linear RGB and alpha of an image: bilinear on decoded texels, repeating.
glm::dvec4 sampleImage(const Image& image, const glm::dvec2& textureCoordinate);

} // namespace examples
