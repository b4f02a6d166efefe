// What a picture is drawn into where there is no window: 32-bit floats, so that files hold what was computed.
#pragma once

#include <mirrorball/gl/objects.h>
#include <mirrorball/io/image.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace examples {

// A framebuffer with output 0, the colour; output 1, the distance from the eye and the reflector's number;
// and a float depth.
class GlTarget
{
public:
    // Binds it. Throws mirrorball::Error: badArgument for a size beyond the driver's limit, unsupported.
    explicit GlTarget(const glm::ivec2& size);

    // Binds it, all of it the viewport; colour to the background, distance to infinity, depth to 0.
    void clear(const glm::vec3& background) const;

    // Row 0 is at the bottom.
    std::vector<glm::vec4> colour() const;
    std::vector<glm::vec2> distanceAndReflector() const;

    // The colours with the top row first, RGB.
    mirrorball::io::Image image() const;

private:
    void attach(const mirrorball::gl::Texture& texture, unsigned int attachment, unsigned int format,
                unsigned int channels) const;

    glm::ivec2 size_;
    mirrorball::gl::Framebuffer framebuffer_ = mirrorball::gl::Framebuffer::create();
    mirrorball::gl::Texture colour_ = mirrorball::gl::Texture::create();
    mirrorball::gl::Texture distanceAndReflector_ = mirrorball::gl::Texture::create();
    mirrorball::gl::Texture depth_ = mirrorball::gl::Texture::create();
};

} // namespace examples
