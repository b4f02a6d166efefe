// A probe's pose, checked and taken apart.
#pragma once

#include <glm/mat4x4.hpp>

namespace mirrorball::capture {

// The rotation and translation of a pose with uniform scale, and the scale.
struct Pose
{
    glm::dmat4 worldFromProbe; // rigid
    double scale;
};

// Throws Error badArgument for what is not finite, mirrors, shears or scales unequally.
Pose rigidPose(const glm::dmat4& worldFromProbe);

} // namespace mirrorball::capture
