// A probe's pose, checked and taken apart.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <string>

namespace mirrorball::capture {

// The rotation and translation of a pose with uniform scale, and the scale.
struct Pose
{
    glm::dmat4 worldFromProbe; // rigid
    double scale;
};

// Throws Error badArgument for what is not finite, mirrors, shears or scales unequally.
Pose rigidPose(const glm::dmat4& worldFromProbe);

// Throws Error badArgument.
void requireFinite(const glm::dvec3& point, const std::string& asked);

} // namespace mirrorball::capture
