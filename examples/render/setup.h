// What is to be seen: the scene, the reflectors and the camera, the same for the drawn and the traced
// picture.
#pragma once

#include "options.h"
#include "reference.h"
#include "source.h"

#include <optional>
#include <vector>

namespace render {

struct Mirror
{
    examples::Reflector reflector;
    glm::dmat4 worldFromProbe;
    double near; // of the probe
    float blend;
    glm::vec3 tint;
    std::optional<Source> source;
};

struct Camera
{
    glm::dvec3 eye, look, up;
    double fovInRadians; // vertical
    glm::ivec2 samples;  // of the picture before it is reduced
};

struct Setup
{
    examples::Scene scene;
    std::vector<Mirror> mirrors;
    Camera camera;
    glm::dvec3 light;
    // Everything is drawn relative to this point: the centre of the first reflector.
    glm::dvec3 origin;
    glm::dmat4 worldFromProxy; // what --lookup sphere and box take the surroundings for
    double farthest;           // at least the distance from the eye to anything there is
};

// Reads the scene, the reflectors and their sources. Throws mirrorball::Error.
Setup setupOf(const Options& options);

} // namespace render
