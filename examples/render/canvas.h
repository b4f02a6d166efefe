// A picture while it is drawn: the scene on the GPU, the camera, and what is drawn into.
#pragma once

#include "gl_reflector.h"
#include "gl_target.h"
#include "picture.h"
#include "setup.h"

#include <optional>

namespace render {

// Needs a context. The setup outlives it.
class Canvas
{
public:
    // Sees the setup through its own camera.
    Canvas(const Setup& setup, examples::View view, const glm::ivec2& size);

    // From where, and how large, pictures are drawn from now on.
    void look(const Camera& camera, const glm::ivec2& size);

    void clear() const { target_->clear(setup_.scene.background); }
    // Clears first; what is drawn next, without clearing, is hidden by the scene where it is nearer.
    void drawScene() const;

    examples::View view() const { return view_; }
    const examples::PictureView& pictureView() const { return pictureView_; }
    const examples::GlScene& scene() const { return scene_; }

    Picture picture() const; // what was drawn

private:
    examples::Sample sampleOf(const glm::vec4& colour, float distance, int reflector) const;

    const Setup& setup_;
    examples::View view_;
    glm::ivec2 size_{0};
    examples::PictureView pictureView_;
    std::optional<examples::GlTarget> target_;
    examples::GlScene scene_;
    mirrorball::gl::Program sceneProgram_;
};

} // namespace render
