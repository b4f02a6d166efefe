// What a captured map shows, texel by texel, against the reference tracer.
#pragma once

#include "gl_scene.h"
#include "reference.h"

#include <mirrorball/capture/reflection_probe.h>

namespace tests {

struct Exactness
{
    std::size_t texels = 0;
    std::size_t shown = 0; // texels that show anything
    // Texels with another surface than the trace: neither the triangle nor the distance is the same.
    std::size_t wrong = 0;
    // Of these, those whose traced ray passes more than 1e-5 rad from an edge of what it hit.
    std::size_t wrongFarOff = 0;
    std::size_t holes = 0;      // nothing shown where the trace hits something
    double worstDistance = 0.0; // relative, over the texels that show the right surface

    double wrongPercent() const { return 100.0 * static_cast<double>(wrong) / static_cast<double>(texels); }
};

// Captures the scene with triangle numbers and traces every texel. `desc` says map, n, method, near and far;
// the probe is placed at `at` (in the world, offset included).
Exactness exactnessOf(const examples::Scene& scene, const glm::dvec3& at,
                      mirrorball::ReflectionProbe::Desc desc);

} // namespace tests
