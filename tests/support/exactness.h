// What a captured map shows, texel by texel, against the reference tracer.
#pragma once

#include "gl_scene.h"
#include "reference.h"

#include <mirrorball/capture/reflection_probe.h>

#include <optional>

namespace tests {

struct Exactness
{
    std::size_t texels = 0;
    std::size_t shown = 0; // texels that show anything
    // Texels with another surface than the trace, by their distances: to 1e-4, relative.
    std::size_t wrong = 0;
    // Of these, those that lie more than 1e-5 rad from every edge of what is shown and of what is traced.
    std::size_t wrongFarOff = 0;
    // Of the wrong ones, those within 6e-8 rad of an edge: half a float's last digit.
    std::size_t ties = 0;
    std::size_t holes = 0;      // nothing shown where the trace hits something
    double worstDistance = 0.0; // relative, over the other texels

    double wrongPercent() const { return 100.0 * static_cast<double>(wrong) / static_cast<double>(texels); }
};

// What one texel of a map shows, and what the trace has there; no triangle where nothing is seen.
struct Seen
{
    std::optional<std::uint32_t> triangle;
    double distance = 0.0;
};

// Counts the texel whose centre is in this unit direction from `at`.
void compare(Exactness& result, const examples::Scene& scene, const glm::dvec3& at,
             const glm::dvec3& direction, const Seen& shown, const Seen& traced);

void add(Exactness& total, const Exactness& part);

// Captures the scene with triangle numbers and traces every texel. `desc` says map, n, method, near and far, and how
// the probe is turned; it is placed at `at` (in the world, offset included).
Exactness exactnessOf(const examples::Scene& scene, const glm::dvec3& at,
                      mirrorball::ReflectionProbe::Desc desc);

} // namespace tests
