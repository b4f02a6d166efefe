// What the command lines of capture and render have in common: the scene, the map and how it is drawn.
#pragma once

#include "command_line.h"
#include "scene.h"

#include <mirrorball/capture/reflection_probe.h>

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace examples {

// The values of --method: the one list of the programs.
std::vector<std::pair<std::string, mirrorball::CaptureMethod>> captureMethods();

struct CaptureOptions
{
    std::string scene;
    glm::dvec3 offset{0.0};          // moves everything, in double
    std::optional<glm::dvec3> light; // before offset; the scene's own where it is not given
    mirrorball::MapKind map = mirrorball::MapKind::tennisBall;
    int size = 256;
    mirrorball::CaptureMethod method = mirrorball::CaptureMethod::automatic;
    double epsilon = 1.0 / 16.0; // texels that automatic may be off by
    bool nearFirst = false;
    double far = 10000.0; // radial, from the probe
    int frames = 1;
    bool reference = false;
    std::string stats;
};

void addCaptureOptions(CLI::App& app, CaptureOptions& options);

// What drawing a map would refuse, for --reference, which needs no OpenGL. Throws mirrorball::Error,
// badArgument.
void requireAllowed(const CaptureOptions& options);
void requireRange(double near, double far);
void requireFinite(const glm::dvec3& vector, const std::string& option);

// The scene with its offset, and its light in the world.
Scene sceneOf(const CaptureOptions& options);
glm::dvec3 lightOf(const CaptureOptions& options, const Scene& scene);

// A pose at a point, turned about x, then y, then z of the world, in degrees.
glm::dmat4 poseOf(const glm::dvec3& centreInWorld, const glm::dvec3& degrees);

} // namespace examples
