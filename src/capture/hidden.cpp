#include "capture/hidden.h"

#include "capture/map_textures.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace mirrorball::capture {

namespace {

constexpr int cellsAlong = 8; // of a cube face's side; a cell is 11 degrees wide
constexpr std::size_t cellCount = 6 * cellsAlong * cellsAlong;

// A cone that holds a cell of a cube face.
struct Cell
{
    glm::dvec3 middle;
    double angle;
};

std::array<Cell, cellCount> makeCells()
{
    std::array<Cell, cellCount> cells;
    std::size_t next = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (int row = 0; row < cellsAlong; ++row)
                for (int column = 0; column < cellsAlong; ++column) {
                    const auto direction = [&](double across, double along) {
                        glm::dvec3 v;
                        v[axis] = side;
                        v[(axis + 1) % 3] = 2.0 * (column + across) / cellsAlong - 1.0;
                        v[(axis + 2) % 3] = 2.0 * (row + along) / cellsAlong - 1.0;
                        return glm::normalize(v);
                    };
                    Cell& cell = cells[next++];
                    cell = {direction(0.5, 0.5), 0.0};
                    for (const double across : {0.0, 1.0})
                        for (const double along : {0.0, 1.0})
                            cell.angle = std::max(cell.angle,
                                                  std::acos(glm::dot(cell.middle, direction(across, along))));
                }
    return cells;
}

// What bounds tell of a mesh as seen from the probe, with room for the rounding of the host's floats.
struct Seen
{
    glm::dvec3 direction{0.0};
    double angle = std::numbers::pi; // it lies within a cone of this half angle
    double nearest = 0.0;
    double farthest = std::numeric_limits<double>::infinity();
};

Seen seenOf(const CaptureMesh& mesh, const Frame& frame)
{
    constexpr double rounding = 1e-5;
    Seen seen;
    if (mesh.bounds) {
        const glm::dvec3 centre(frame.probeFromWorld() * glm::dvec4(glm::dvec3(mesh.bounds->centre), 1.0));
        const double distance = glm::length(centre);
        const double radius = static_cast<double>(mesh.bounds->radius) + rounding * distance;
        if (std::isfinite(distance) && std::isfinite(radius)) {
            seen.farthest = distance + radius;
            if (distance > radius)
                seen = {centre / distance, std::asin(radius / distance), distance - radius, seen.farthest};
        }
    }
    if (mesh.nearestDistance)
        seen.nearest = std::max(seen.nearest, static_cast<double>(*mesh.nearestDistance) * (1.0 - rounding));
    seen.nearest = std::max(seen.nearest, static_cast<double>(frame.near()));
    return seen;
}

// From the middle of a texel of the second layer to that of any of the first which it covers a part of, at most: half a
// diagonal of each.
double texelAngle(const Frame& frame)
{
    if (frame.map() == MapKind::sphereMap) // stretched without end around its rim
        return std::numbers::pi;
    // Times n; the equirectangular map's 4.44 is the widest of the others.
    const double diagonal = frame.map() == MapKind::octahedral ? 8.6 : 4.5;
    return 0.5 * diagonal * (1.0 / hiddenN(frame.n()) + 1.0 / frame.n());
}

bool overlaps(const Cell& cell, const Seen& seen, double texel)
{
    const double reach = cell.angle + seen.angle + texel + 1e-6;
    return reach >= std::numbers::pi || glm::dot(cell.middle, seen.direction) >= std::cos(reach);
}

} // namespace

std::vector<bool> mayBeHidden(std::span<const CaptureMesh> meshes, const Frame& frame, double separation)
{
    static const std::array<Cell, cellCount> cells = makeCells();
    const double texel = texelAngle(frame);
    std::vector<Seen> seen;
    std::array<double, cellCount> nearest;
    nearest.fill(std::numeric_limits<double>::infinity());
    for (const CaptureMesh& mesh : meshes) {
        seen.push_back(seenOf(mesh, frame));
        for (std::size_t index = 0; index < cellCount; ++index)
            if (overlaps(cells[index], seen.back(), texel))
                nearest[index] = std::min(nearest[index], seen.back().nearest);
    }
    std::vector<bool> result;
    for (const Seen& each : seen) {
        double first = std::numeric_limits<double>::infinity();
        for (std::size_t index = 0; index < cellCount; ++index)
            if (overlaps(cells[index], each, texel))
                first = std::min(first, nearest[index]);
        result.push_back(each.farthest > (1.0 + separation) * first);
    }
    return result;
}

} // namespace mirrorball::capture
