// The views of a map: what is drawn at a time. A view is a component, or for the octahedral map an octant,
// and it knows what it can see.
#pragma once

#include <mirrorball/maps/maps.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace mirrorball::capture {

int viewCount(MapKind map);
int layerOfView(MapKind map, int view);

// Cube and octahedral maps are linear in homogeneous coordinates within a view, so that the rasteriser draws
// them exactly: (x, y, w) = clipFromDirection * direction.
bool isPiecewiseLinear(MapKind map);

struct LinearView
{
    glm::mat3 clipFromDirection;
    // The same for normals of planes through the centre: line . (x, y, w) = normal . direction.
    glm::mat3 lineFromDirection;
    // The view is where these are all >= 0 (times direction); a cube face is cut by its own frustum and needs
    // none.
    glm::mat3 inwardPlanes;
};

// Also the equi-angular cube has such coordinates, before its axes are bent.
bool hasLinearViews(MapKind map);
LinearView linearView(MapKind map, int view);

// How w of a linear view relates to the radial distance: smallest and largest w / |R| within the view.
struct LinearRange
{
    double smallest, largest;
};
LinearRange linearRange(MapKind map);

// Whether a sphere (in probe space) may touch the directions of a view; never false when it does.
bool viewTouches(MapKind map, int view, const glm::dvec3& centre, double radius);

// The same for the directions that the view's component owns, where layers show more than that. Within a radian times
// `beside` of them counts as well.
bool ownedTouches(MapKind map, int view, const glm::dvec3& centre, double radius, double beside);

// +1 where a counter-clockwise triangle as seen from the centre is counter-clockwise on the map, else -1.
int orientation(MapKind map, int view);

} // namespace mirrorball::capture
