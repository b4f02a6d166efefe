#include "capture/uniforms.h"

#include "capture/views.h"

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec2.hpp>

#include <vector>

namespace mirrorball::capture {

namespace {

// Depth is 1 at near and 0 at far, linear in 1 / w: floats are dense towards 0, so that the relative
// precision is the same at every distance. Returns (a, b) of z = a * w + b in clip space, where w is the
// radial distance (or the homogeneous coordinate of a linear view).
glm::dvec2 reversedDepth(double near, double far, bool zeroToOne)
{
    const double inverseFar = 1.0 / far; // 0 for an infinite far
    const double b = 1.0 / (1.0 / near - inverseFar);
    const double a = -b * inverseFar;
    // Without clip control z runs from -1 to 1 in OpenGL's own way, and some of the precision is lost.
    return zeroToOne ? glm::dvec2(a, b) : glm::dvec2(2.0 * a - 1.0, 2.0 * b);
}

// The matrices of a view, or of all where they are drawn at once (view < 0).
void setLinearViews(const LinkedProgram& linked, MapKind map, int view)
{
    const int first = view < 0 ? 0 : view;
    const int count = view < 0 ? viewCount(map) : 1;
    std::vector<glm::mat3> clip, line, inward;
    for (int index = first; index < first + count; ++index) {
        const LinearView linear = linearView(map, index);
        clip.push_back(linear.clipFromDirection);
        line.push_back(linear.lineFromDirection);
        inward.push_back(linear.inwardPlanes);
    }
    glUniformMatrix3fv(linked.clipFromDirection, count, GL_FALSE, glm::value_ptr(clip[0]));
    glUniformMatrix3fv(linked.lineFromDirection, count, GL_FALSE, glm::value_ptr(line[0]));
    glUniformMatrix3fv(linked.inwardPlanes, count, GL_FALSE, glm::value_ptr(inward[0]));
}

} // namespace

void setUniforms(const LinkedProgram& linked, const Frame& frame, MapKind map, int view, const MapSize& size,
                 bool clipControl)
{
    const glm::mat4 matrix(frame.probeFromWorld());
    glUniformMatrix4fv(linked.probeFromWorld, 1, GL_FALSE, glm::value_ptr(matrix));
    const glm::vec3 centre(frame.centre());
    glUniform3fv(linked.centre, 1, glm::value_ptr(centre));
    glUniform1i(linked.view, view);
    glUniform2f(linked.range, frame.near(), frame.far());
    glUniform2f(linked.size, static_cast<float>(size.width), static_cast<float>(size.height));
    const LinearRange reach = isPiecewiseLinear(map) ? linearRange(map) : LinearRange{1.0, 1.0};
    const bool zeroToOne = linked.writesDepth || clipControl;
    const glm::dvec2 depth = reversedDepth(static_cast<double>(frame.near()) * reach.smallest,
                                           static_cast<double>(frame.far()) * reach.largest, zeroToOne);
    glUniform2f(linked.depth, static_cast<float>(depth.x), static_cast<float>(depth.y));
    glUniform1f(linked.steps, static_cast<float>(frame.tessellationSteps()));
    if (hasLinearViews(map))
        setLinearViews(linked, map, view);
}

} // namespace mirrorball::capture
