#include "capture/pose.h"

#include "finite.h"

#include <mirrorball/error.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace mirrorball::capture {

Pose rigidPose(const glm::dmat4& worldFromProbe)
{
    const std::string asked = "a probe's pose";
    requireFinite(glm::value_ptr(worldFromProbe), 16, asked);
    const glm::dmat3 linear(worldFromProbe);
    const double scale = std::cbrt(std::abs(glm::determinant(linear)));
    if (!(scale > 0.0))
        throw Error(ErrorKind::badArgument, asked, "its scale is 0", "give a scale above 0");
    const glm::dmat3 rotation = linear / scale;
    // Rounding of a host's float matrices stays far below this; shear or unequal scale lies far above it.
    constexpr double tolerance = 1e-3;
    const glm::dmat3 unit = glm::transpose(rotation) * rotation;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(unit[column][row] - (column == row ? 1.0 : 0.0)) > tolerance)
                throw Error(ErrorKind::badArgument, asked, "it is not a rotation with uniform scale",
                            "leave out shear and unequal scale");
    if (glm::determinant(rotation) < 0.0)
        throw Error(ErrorKind::badArgument, asked, "it mirrors", "give a rotation with positive scale");
    glm::dmat4 rigid(rotation);
    rigid[3] = glm::dvec4(glm::dvec3(worldFromProbe[3]), 1.0);
    return {rigid, scale};
}

} // namespace mirrorball::capture
