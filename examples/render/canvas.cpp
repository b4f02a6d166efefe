#include "canvas.h"

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace render {

using namespace examples;

namespace {

bool hasClipControl()
{
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
}

// Depth is near / distance: floats are dense where that is small, so a near plane very close to the eye costs
// no precision, and no far plane is needed. Without clip control depth has to pass through [-1, 1], which
// keeps only 24 bits, and the near plane moves out.
PictureView pictureViewOf(const Setup& setup, const Camera& camera, const glm::ivec2& size)
{
    const double near = setup.farthest * (hasClipControl() ? 1e-6 : 1e-3);
    const glm::dvec3 eye = camera.eye - setup.origin;
    const glm::dmat4 viewFromWorld = glm::lookAt(eye, camera.look - setup.origin, camera.up);
    const double aspect = static_cast<double>(size.x) / size.y;
    const double tangent = std::tan(0.5 * camera.fovInRadians);
    glm::dmat4 clipFromView(0.0);
    clipFromView[0][0] = 1.0 / (tangent * aspect);
    clipFromView[1][1] = 1.0 / tangent;
    clipFromView[2][2] = hasClipControl() ? 0.0 : 1.0;
    clipFromView[3][2] = hasClipControl() ? near : 2.0 * near;
    clipFromView[2][3] = -1.0;

    const glm::dmat3 worldFromView = glm::transpose(glm::dmat3(viewFromWorld));
    const glm::dvec2 cotangents(1.0 / (tangent * aspect), 1.0 / tangent);
    const glm::dvec2 step = 2.0 / (cotangents * glm::dvec2(size));
    const glm::dmat3 rayFromPixel =
        worldFromView * glm::dmat3(glm::dvec3(step.x, 0.0, 0.0), glm::dvec3(0.0, step.y, 0.0),
                                   glm::dvec3(-1.0 / cotangents.x, -1.0 / cotangents.y, -1.0));
    PictureView view;
    view.clipFromWorld = glm::mat4(clipFromView * viewFromWorld);
    view.rayFromPixel = glm::mat3(rayFromPixel);
    view.depthFromClip = hasClipControl() ? glm::vec2(1.0f, 0.0f) : glm::vec2(0.5f, 0.5f);
    view.eye = eye;
    view.phong = {glm::vec3(setup.light - setup.origin), glm::vec3(eye)};
    return view;
}

} // namespace

Canvas::Canvas(const Setup& setup, View view, const glm::ivec2& size)
    : setup_(setup), view_(view), scene_(setup.scene, setup.origin),
      sceneProgram_(linkProgram(phongVertexSource(), pictureFragmentSource(view)))
{
    look(setup.camera, size);
}

void Canvas::look(const Camera& camera, const glm::ivec2& size)
{
    pictureView_ = pictureViewOf(setup_, camera, size);
    if (size != size_)
        target_.emplace(size);
    size_ = size;
}

void Canvas::drawScene() const
{
    clear();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    if (hasClipControl())
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glUseProgram(sceneProgram_.name());
    glUniformMatrix4fv(glGetUniformLocation(sceneProgram_.name(), "clipFromWorld"), 1, GL_FALSE,
                       glm::value_ptr(pictureView_.clipFromWorld));
    scene_.drawAll(sceneProgram_.name(), pictureView_.phong);
}

Sample Canvas::sampleOf(const glm::vec4& colour, float distance, int reflector) const
{
    Sample sample = nothingSeen(view_, setup_.scene.background);
    if (std::isinf(distance))
        return sample;
    sample.distance = distance;
    if (view_ == View::colour) {
        sample.colour = glm::dvec3(colour);
        return sample;
    }
    // Images are infinitely far: there is no position.
    const bool showsImages =
        reflector > 0 && setup_.mirrors[static_cast<std::size_t>(reflector - 1)].source.has_value();
    if (colour.a > 0.0f && !showsImages)
        sample.colour = glm::dvec3(colour) + setup_.origin;
    return sample;
}

Picture Canvas::picture() const
{
    Picture picture{size_, {}, {}};
    const std::vector<glm::vec4> colours = target_->colour();
    const std::vector<glm::vec2> others = target_->distanceAndReflector();
    for (int row = picture.size.y - 1; row >= 0; --row)
        for (int column = 0; column < picture.size.x; ++column) {
            const std::size_t index =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.size.x) +
                static_cast<std::size_t>(column);
            const int reflector = static_cast<int>(others[index].y);
            picture.samples.push_back(sampleOf(colours[index], others[index].x, reflector));
            picture.reflectors.push_back(reflector);
        }
    return picture;
}

} // namespace render
