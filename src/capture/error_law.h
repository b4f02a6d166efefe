// How far a straight edge on a map lies from the true great-circle arc, and when that is little enough to map
// vertices and be done.
//
// Along a great circle a map's point moves with acceleration f''; over an arc of angle t the straight edge,
// traversed at constant speed, is off by at most n * max|f''| * t² / 8 texels, sideways (the silhouette) and
// lengthways (varyings and distance) together. bendOf bounds max|f''| / 8, in units of n.
#pragma once

#include <mirrorball/maps/maps.h>

#include <glm/vec3.hpp>

#include <optional>

namespace mirrorball::capture {

// A mesh as seen from the probe, in the probe's frame.
struct MeshBounds
{
    glm::dvec3 centre;
    double radius;
    double longestEdge;
};

// For everything within a sphere around `centre` as seen in a view: the bend in units of n a radian²; nothing
// where a cut, a pole or another singular point of the chart is in reach.
std::optional<double> bendOf(MapKind map, int view, const glm::dvec3& centre, double radius);

// Whether mapped vertices keep direction within epsilon texels and distance, relative, within epsilon texel
// angles.
bool mappingSuffices(MapKind map, int view, const MeshBounds& mesh, int n, double epsilon);

// Pieces a radian that tessellation needs for the same accuracy, within the views of every map but near the poles of
// those that have some.
double tessellationSteps(int n, double epsilon);

} // namespace mirrorball::capture
