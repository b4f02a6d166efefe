// How far a captured map is from the truth, which is traced with Embree at the same texels.
#pragma once

#include "contender.h"
#include "reference.h"

#include <mirrorball/maps/maps.h>

#include <functional>
#include <memory>
#include <vector>

namespace tests::benchmark {

// What a ray through a texel's centre meets.
struct TrueTexel
{
    std::size_t index;        // into MapImages, in texels
    glm::dvec3 unitDirection; // of the texel
    double distance;          // infinite where nothing is met
    double edgeAngle;         // to the nearest edge of the triangle that is met, radians
    std::uint32_t triangle;
};

// Of a probe turned like this. At most 2^19 texels, evenly spread over the map, of those whose centre's direction
// belongs to its texel.
std::vector<TrueTexel> traceMap(const examples::ReferenceTracer& tracer, const SceneChoice& scene,
                                mirrorball::MapKind map, int n,
                                const glm::dmat3& worldFromProbe = glm::dmat3(1.0));

struct Spread
{
    double mean = 0, p95 = 0, largest = 0;
};

// A texel is wrong where drawing and trace differ in what is seen: either sees nothing where the other sees
// something, or both see different triangles whose distances differ by more than 1e-4 of the true one
// (nearer than that, they are neighbours across an edge, or lie in each other). A triangle is told by its number, or
// by the drawn point lying on the true one: llvmpipe numbers tessellated triangles anew after each 341.
struct Errors
{
    std::size_t texels = 0; // judged
    double wrongPercent = 0;
    double wrongOffEdgePercent =
        0; // more than 1e-5 rad from any edge of the drawn (by its number) and of the true triangle
    double holePercent = 0;  // nothing drawn where there is something
    Spread relativeDistance; // |drawn − true| / true, where the texel is not wrong
    // The largest, more than 1e-5 rad from any edge of the true triangle.
    double largestRelativeDistanceOffEdges = 0;
    Spread directionDegrees; // between the texel and the point that is drawn there, wherever something
                             // is drawn
    double directionDegreesWhereWrong = 0; // its mean over wrong texels that show something
};

// The contender's maps with triangle numbers, positions and distances against the truth. `make` makes the
// contender for a view.
using MakeContender = std::function<std::unique_ptr<Contender>(examples::View)>;
Errors errorsOf(const MakeContender& make, const std::vector<TrueTexel>& truth, const examples::Scene& scene,
                const glm::dvec3& at);

} // namespace tests::benchmark
