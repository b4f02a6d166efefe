// The reference that the library is judged by: rays traced with Embree, shaded and mirrored by separately
// written double formulas. It shares no map or shading code with the library.
#pragma once

#include "reference_direction.h"
#include "reference_geometry.h"
#include "scene.h"

#include <functional>
#include <vector>

namespace examples {

// A mirror in the scene: a true sphere (radius > 0), or else a mesh with interpolated normals.
struct Reflector
{
    glm::dvec3 at{0.0};  // the centre, in the world; the mesh's origin comes to lie there
    double radius = 0.0; // of the sphere, scaled already
    Mesh mesh;
    double scale = 1.0; // of the mesh
    Material material;  // how it looks where it is no mirror; its image is not used
};

enum class SeenKind { background, scene, reflector };

// What a ray from the eye shows.
struct Seen
{
    SeenKind kind = SeenKind::background;
    Hit hit;                         // the first surface; on a reflector hit.reflector says which
    Hit mirrored;                    // on a reflector: what the ray mirrored there meets
    glm::dvec3 mirrorDirection{0.0}; // on a reflector: unit length
};

class ReferenceTracer
{
public:
    // Distances are most accurate near `origin` (the probe's centre, or the eye). The scene must outlive the
    // tracer.
    ReferenceTracer(const Scene& scene, const glm::dvec3& origin);

    // Reflectors are numbered from 0 in this order.
    void add(Reflector reflector);

    // The scene alone, without reflectors; see ReferenceGeometry::trace.
    Hit trace(const glm::dvec3& originInWorld, const glm::dvec3& direction, double near, double far) const;

    // The nearest of scene and reflectors between near and far. On a reflector the ray is mirrored once at
    // the true surface (for a mesh: at the triangle, by its interpolated normal) and goes on, from distance 0
    // to far, through the scene and the other reflectors, which are seen as plain objects; the reflector
    // itself is left out, as it is from its own capture. So a ray that an interpolated normal mirrors into
    // the surface, as happens near the outline of a coarse mesh, meets what lies behind instead of the
    // reflector.
    Seen look(const glm::dvec3& eye, const glm::dvec3& direction, double near, double far) const;

    // Phong as scene.h states it; the background where nothing was hit. The light is in the world.
    glm::vec3 shade(const Hit& hit, const glm::dvec3& eye, const glm::dvec3& lightInWorld) const;

private:
    struct Placed
    {
        std::unique_ptr<Reflector> reflector;        // its address is known to Embree
        std::unique_ptr<ReferenceGeometry> geometry; // none for a sphere
    };

    Hit traceReflectors(const glm::dvec3& start, const glm::dvec3& direction, double near, double far,
                        int leftOut) const;

    const Scene* scene_;
    glm::dvec3 origin_;
    ReferenceGeometry geometry_;
    std::vector<Placed> reflectors_;
};

// Calls work(row) for each row from 0, on all cores; the first exception is thrown on when all have stopped.
void forEachRow(int rows, const std::function<void(int)>& work);

} // namespace examples
