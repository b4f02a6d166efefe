#include "gl_target.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>
#include <string>

namespace examples {

using mirrorball::Error;
using mirrorball::ErrorKind;

namespace {

template <class Vector>
std::vector<Vector> read(const mirrorball::gl::Texture& texture, const glm::ivec2& size, GLenum channels)
{
    std::vector<Vector> values(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glGetTexImage(GL_TEXTURE_2D, 0, channels, GL_FLOAT, values.data());
    return values;
}

} // namespace

GlTarget::GlTarget(const glm::ivec2& size) : size_(size)
{
    const std::string asked =
        "a picture of " + std::to_string(size.x) + "x" + std::to_string(size.y) + " samples";
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (std::max(size.x, size.y) > limit)
        throw Error(ErrorKind::badArgument, asked, "the driver's limit is " + std::to_string(limit),
                    "ask for a smaller one");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    attach(colour_, GL_COLOR_ATTACHMENT0, GL_RGBA32F, GL_RGBA);
    attach(distanceAndReflector_, GL_COLOR_ATTACHMENT1, GL_RG32F, GL_RG);
    attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, buffers);
    if (glGetError() == GL_OUT_OF_MEMORY ||
        glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorKind::unsupported, asked, "the driver cannot make a framebuffer for it",
                    "ask for a smaller one");
}

void GlTarget::attach(const mirrorball::gl::Texture& texture, unsigned int attachment, unsigned int format,
                      unsigned int channels) const
{
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size_.x, size_.y, 0, channels, GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.name(), 0);
}

void GlTarget::clear(const glm::vec3& background) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size_.x, size_.y);
    const glm::vec4 colour(background, 1.0f);
    const float nothing[4] = {std::numeric_limits<float>::infinity(), 0.0f, 0.0f, 0.0f};
    const float farthest = 0.0f;
    glClearBufferfv(GL_COLOR, 0, glm::value_ptr(colour));
    glClearBufferfv(GL_COLOR, 1, nothing);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

std::vector<glm::vec4> GlTarget::colour() const
{
    return read<glm::vec4>(colour_, size_, GL_RGBA);
}

std::vector<glm::vec2> GlTarget::distanceAndReflector() const
{
    return read<glm::vec2>(distanceAndReflector_, size_, GL_RG);
}

mirrorball::io::Image GlTarget::image() const
{
    mirrorball::io::Image image{size_.x, size_.y, 3, {}};
    const std::vector<glm::vec4> pixels = colour();
    const auto width = static_cast<std::ptrdiff_t>(size_.x);
    for (auto end = pixels.end(); end != pixels.begin(); end -= width)
        for (auto pixel = end - width; pixel != end; ++pixel)
            image.pixels.insert(image.pixels.end(), {pixel->r, pixel->g, pixel->b});
    return image;
}

} // namespace examples
