// The scenes that are measured, and where the probe stands in each.
#pragma once

#include "scene.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tests::benchmark {

struct SceneChoice
{
    std::string_view name;   // as --scene spells it
    std::string_view source; // for examples::loadScene
    glm::dvec3 at;           // the probe's centre
    float near, far;         // radial; nothing of the scene is nearer or farther
    bool closed;             // no back face is seen from there, so that back faces may be culled
    bool quick;              // part of --quick
    bool everySize;          // measured at every size, not at n = 256 only
    // Roughly what a frame costs next to others, for the time left.
    double weight;
    // CPU time of six culled passes over six plain ones at n = 256, measured once with other code: six faces
    // in RGBA8 with a 24-bit depth buffer. Empty where nothing was measured.
    std::optional<double> culledOverPlain;
};

std::span<const SceneChoice> sceneChoices();

bool isModel(const SceneChoice& scene); // comes from a file
bool isThere(const SceneChoice& scene); // needs no file that is missing

// The same triangles, none of which shares a vertex with another.
examples::Scene withOwnVertices(const examples::Scene& scene);

} // namespace tests::benchmark
