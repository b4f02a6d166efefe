#include "capture/views.h"

#include <glm/geometric.hpp>

#include <cassert>
#include <cmath>

namespace mirrorball::capture {

namespace {

// Signs of octant 0 … 7: bit 0 is x, bit 1 y, bit 2 z; a set bit is the negative side.
glm::dvec3 octantSigns(int octant)
{
    return {(octant & 1) != 0 ? -1.0 : 1.0, (octant & 2) != 0 ? -1.0 : 1.0, (octant & 4) != 0 ? -1.0 : 1.0};
}

// A cube face's rows (s, t, major axis) from OpenGL's cube-map table.
glm::dmat3 faceRows(int face)
{
    constexpr double rows[6][3][3] = {
        {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
        {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    glm::dmat3 matrix;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            matrix[column][row] = rows[face][row][column];
    return matrix;
}

// All four side planes of a 90-degree pyramid around +z, and the sphere's place beside them.
bool pyramidTouches(const glm::dvec3& local, double radius)
{
    const double reach = radius * std::sqrt(2.0); // |x| - z at distance r from the plane x = z is r√2
    return std::abs(local.x) - local.z <= reach && std::abs(local.y) - local.z <= reach;
}

// A tennis-ball component in its own frame: latitudes within 45 degrees, longitudes within 135 degrees of +z.
bool seamTouches(const glm::dvec3& local, double radius)
{
    const double horizontal = std::hypot(local.x, local.z);
    const bool beyondLatitude = (std::abs(local.y) - horizontal) > radius * std::sqrt(2.0);
    // The 90-degree wedge around -z is left out: |x| < -z. Inside it, further than r from both of its sides.
    const bool inWedge = (-local.z - std::abs(local.x)) > radius * std::sqrt(2.0);
    return !beyondLatitude && !inWedge;
}

// What a tennis-ball component owns of that: everything in front, and behind only caps of 45 degrees around ±x.
// The caps' cone is as far from a point as the difference of its distances from axis and equator, over √2.
bool ownedSeamTouches(const glm::dvec3& local, double radius)
{
    const bool inFront = local.z >= -radius;
    const bool inCap = std::hypot(local.y, local.z) - std::abs(local.x) <= radius * std::sqrt(2.0);
    return inFront || inCap;
}

// A component's own frame, in which the middle of its layer is at +z.
glm::dvec3 localTennisBall(int view, const glm::dvec3& v)
{
    return view == 0 ? v : glm::dvec3(v.y, v.x, -v.z);
}

glm::dvec3 localParaboloid(int view, const glm::dvec3& v)
{
    return view == 0 ? glm::dvec3(v.x, v.y, -v.z) : v;
}

// A dual-paraboloid layer in its own frame: its corners reach 109.5 degrees from +z, where cos = -1/3. What
// lies in the cone around -z, further than the radius from its surface, is out of sight.
bool paraboloidTouches(const glm::dvec3& local, double radius)
{
    const double sine = std::sqrt(8.0) / 3.0, cosine = 1.0 / 3.0; // of the cone's half angle
    return sine * -local.z - cosine * std::hypot(local.x, local.y) <= radius;
}

} // namespace

bool isPiecewiseLinear(MapKind map)
{
    return map == MapKind::cube || map == MapKind::octahedral;
}

bool hasLinearViews(MapKind map)
{
    return isPiecewiseLinear(map) || map == MapKind::equiAngularCube;
}

int viewCount(MapKind map)
{
    return map == MapKind::octahedral ? 8 : mapInfo(map).components;
}

int layerOfView(MapKind map, int view)
{
    return map == MapKind::octahedral ? 0 : view;
}

LinearView linearView(MapKind map, int view)
{
    assert(hasLinearViews(map));
    if (map == MapKind::cube || map == MapKind::equiAngularCube)
        return {glm::mat3(faceRows(view)), glm::mat3(faceRows(view)), glm::mat3(0.0f)};
    const glm::dvec3 s = octantSigns(view);
    // w = |x| + |y| + |z|. The upper half is (x, y) / w, the lower is folded over: ((w - |y|) sign x, (w -
    // |x|) sign y) / w.
    const glm::dvec3 w = s;
    glm::dvec3 a(1, 0, 0), b(0, 1, 0);
    if (s.z < 0.0) {
        a = s.x * (w - glm::dvec3(0, s.y, 0));
        b = s.y * (w - glm::dvec3(s.x, 0, 0));
    }
    LinearView result;
    result.clipFromDirection = glm::transpose(glm::mat3(glm::vec3(a), glm::vec3(b), glm::vec3(w)));
    // Each octant reaches a hair over its border, so that no texel centre on the border falls between two
    // octants; 2^-20 of w is far below a texel and far above the rounding of the clipper.
    const double overlap = std::ldexp(1.0, -20);
    result.lineFromDirection = glm::transpose(glm::inverse(result.clipFromDirection));
    result.inwardPlanes = glm::transpose(glm::mat3(glm::vec3(glm::dvec3(s.x, 0, 0) + overlap * w),
                                                   glm::vec3(glm::dvec3(0, s.y, 0) + overlap * w),
                                                   glm::vec3(glm::dvec3(0, 0, s.z) + overlap * w)));
    return result;
}

LinearRange linearRange(MapKind map)
{
    return map == MapKind::cube ? LinearRange{1.0 / std::sqrt(3.0), 1.0} : LinearRange{1.0, std::sqrt(3.0)};
}

bool viewTouches(MapKind map, int view, const glm::dvec3& centre, double radius)
{
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
        return seamTouches(localTennisBall(view, centre), radius);
    case MapKind::dualParaboloid:
        return paraboloidTouches(localParaboloid(view, centre), radius);
    case MapKind::cube:
    case MapKind::equiAngularCube:
        return pyramidTouches(faceRows(view) * centre, radius);
    case MapKind::octahedral: {
        const glm::dvec3 local = octantSigns(view) * centre;
        return local.x >= -radius && local.y >= -radius && local.z >= -radius;
    }
    case MapKind::equirectangular:
    case MapKind::sphereMap:
        return true;
    }
    return true;
}

bool ownedTouches(MapKind map, int view, const glm::dvec3& centre, double radius, double beside)
{
    const double reach = radius + beside * (glm::length(centre) + radius);
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
        return ownedSeamTouches(localTennisBall(view, centre), reach);
    case MapKind::dualParaboloid:
        return localParaboloid(view, centre).z >= -reach;
    case MapKind::cube:
    case MapKind::equiAngularCube:
    case MapKind::octahedral:
    case MapKind::equirectangular:
    case MapKind::sphereMap:
        break; // their layers do not overlap
    }
    return true;
}

int orientation(MapKind map, int view)
{
    // Compares the map's own frame at an inner point with the frame as seen from the centre. On the map u
    // runs right and v up (row 0 is the bottom of the framebuffer). Every map keeps one sense throughout a
    // component.
    const int layer = layerOfView(map, view);
    const glm::dvec2 uv(0.53, 0.48);
    const double step = 1e-4;
    const glm::dvec3 here = directionFromSquare(map, layer, uv);
    const glm::dvec3 alongU = directionFromSquare(map, layer, uv + glm::dvec2(step, 0)) - here;
    const glm::dvec3 alongV = directionFromSquare(map, layer, uv + glm::dvec2(0, step)) - here;
    // Seen from the centre the sphere's outward side is away from the viewer, so a positive triple product is
    // a clockwise turn.
    return glm::dot(glm::cross(alongU, alongV), here) > 0.0 ? -1 : 1;
}

} // namespace mirrorball::capture
