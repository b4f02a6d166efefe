#include "capture/copies.h"

#include "capture_shaders.h"
#include "gl/context.h"
#include "gl/program.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <algorithm>

namespace mirrorball::capture {

namespace {

gl::Program link(std::string_view fragment, const std::string& define, const std::string& name)
{
    const std::string version = "#version 330 core\n";
    return gl::linkProgram(
        {{GL_VERTEX_SHADER, version + std::string(shaders::copyVertex), "the vertex shader of " + name},
         {GL_FRAGMENT_SHADER, version + define + std::string(fragment), "the fragment shader of " + name}},
        name);
}

// Into all layers: softpipe's mistake with them (layer_check.h) needs discard or a depth test.
gl::Program linkNearest()
{
    const std::string version = "#version 330 core\n", name = "the nearest of many distances";
    return gl::linkProgram(
        {{GL_VERTEX_SHADER, version + std::string(shaders::copyVertex), "the vertex shader of " + name},
         {GL_GEOMETRY_SHADER, version + std::string(shaders::copyLayersGeometry),
          "the geometry shader of " + name},
         {GL_FRAGMENT_SHADER, version + std::string(shaders::copyNearest), "the fragment shader of " + name}},
        name);
}

GLenum bindingOf(GLenum target)
{
    switch (target) {
    case GL_TEXTURE_RECTANGLE:
        return GL_TEXTURE_BINDING_RECTANGLE;
    case GL_TEXTURE_2D_ARRAY:
        return GL_TEXTURE_BINDING_2D_ARRAY;
    default:
        return GL_TEXTURE_BINDING_2D;
    }
}

int levelParameter(GLenum target, GLenum name)
{
    GLint value = 0;
    glGetTexLevelParameteriv(target, 0, name, &value);
    return value;
}

std::string sizeText(const MapSize& size)
{
    return std::to_string(size.width) + " x " + std::to_string(size.height) +
           (size.layers > 0 ? " x " + std::to_string(size.layers) : "");
}

} // namespace

void bindBorrowed(unsigned int texture, unsigned int target, const MapSize& size, const std::string& asked)
{
    if (glIsTexture(texture) == GL_FALSE)
        throw Error(ErrorKind::badArgument, asked, std::to_string(texture) + " is not a texture",
                    "give the name of one");
    glBindTexture(target, texture);
    if (gl::integer(bindingOf(target)) != static_cast<int>(texture)) {
        glGetError(); // the refusal
        throw Error(ErrorKind::badArgument, asked, "the texture is of another target",
                    size.layers > 0 ? "make it a GL_TEXTURE_2D_ARRAY" : "say which target it has");
    }
    const MapSize found = {levelParameter(target, GL_TEXTURE_WIDTH),
                           levelParameter(target, GL_TEXTURE_HEIGHT),
                           size.layers > 0 ? levelParameter(target, GL_TEXTURE_DEPTH) : 0};
    if (found.width != size.width || found.height != size.height || found.layers != size.layers)
        throw Error(ErrorKind::badArgument, asked, "its size is " + sizeText(found),
                    "make it " + sizeText(size));
    const int type = levelParameter(target, GL_TEXTURE_RED_TYPE);
    if (type != GL_FLOAT && type != GL_UNSIGNED_NORMALIZED && type != GL_SIGNED_NORMALIZED)
        throw Error(ErrorKind::badArgument, asked, "its texels are integers or have no red component",
                    "use a format of floats or normalised numbers");
}

void bindBorrowedDistances(unsigned int texture, const MapSize& size)
{
    const std::string asked = "a host's distance texture";
    bindBorrowed(texture, GL_TEXTURE_2D_ARRAY, size, asked);
    if (levelParameter(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_RED_TYPE) != GL_FLOAT)
        throw Error(ErrorKind::badArgument, asked, "its texels end at 1",
                    "use a format of floats, such as GL_R32F");
}

void FullScreenPass::prepare()
{
    if (!noAttributes_)
        noAttributes_ = gl::VertexArray::create();
    glBindVertexArray(noAttributes_.name());
    for (GLenum plane = 0; plane < 3; ++plane)
        glDisable(GL_CLIP_DISTANCE0 + plane);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

void FullScreenPass::draw(int instances) const
{
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3, instances);
}

void Copies::makeShared()
{
    if (!nearest_) {
        nearest_ = gl::Sampler::create();
        glSamplerParameteri(nearest_.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glSamplerParameteri(nearest_.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glSamplerParameteri(nearest_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glSamplerParameteri(nearest_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    pass_.prepare();
}

void Copies::reduce(const MapTextures& from, const MapTextures& to, const MapSize& size, int k)
{
    if (!reduce_)
        reduce_ = link(shaders::copyReduce, "", "the reduction of samples");
    makeShared();
    glUseProgram(reduce_.name());
    const auto location = [&](const char* name) { return glGetUniformLocation(reduce_.name(), name); };
    const unsigned int textures[2] = {from.colour.name(), from.distance.name()};
    for (int unit = 0; unit < 2; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D_ARRAY, textures[unit]);
        glBindSampler(static_cast<GLuint>(unit), nearest_.name());
    }
    glUniform1i(location("colours"), 0);
    glUniform1i(location("distances"), 1);
    glUniform1i(location("k"), k);
    glViewport(0, 0, size.width, size.height);
    for (int layer = 0; layer < size.layers; ++layer) {
        glBindFramebuffer(GL_FRAMEBUFFER, to.layers[static_cast<std::size_t>(layer)].name());
        glUniform1i(location("layer"), layer);
        pass_.draw();
    }
}

void Copies::beginGather(const gl::Texture& from)
{
    if (!nearestOfBlock_) {
        nearestOfBlock_ = linkNearest();
        level_ = gl::Framebuffer::create();
    }
    makeShared();
    glUseProgram(nearestOfBlock_.name());
    glUniform1i(glGetUniformLocation(nearestOfBlock_.name(), "distances"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, from.name());
    glBindSampler(0, nearest_.name());
    glBindFramebuffer(GL_FRAMEBUFFER, level_.name());
}

// From the base level of what is bound.
void Copies::gather(const gl::Texture& to, int level, const MapSize& size, int stride)
{
    const auto location = [&](const char* name) {
        return glGetUniformLocation(nearestOfBlock_.name(), name);
    };
    glUniform2i(location("size"), size.width, size.height);
    glUniform1i(location("stride"), stride);
    glViewport(0, 0, size.width, size.height);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, to.name(), level);
    pass_.draw(size.layers);
}

void Copies::gatherNearest(const gl::Texture& from, const gl::Texture& to, const MapSize& size)
{
    beginGather(from);
    gather(to, 0, size, 1);
}

void Copies::gatherNearestLevel(const gl::Texture& from, const gl::Texture& distance, const MapSize& size,
                                int level)
{
    const auto sizeOf = [&](int each) {
        return MapSize{size.width >> each, size.height >> each, size.layers};
    };
    const auto readOnly = [](int base, int last) {
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, base);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, last);
    };
    // In two stages, so that no fragment has to look at thousands of texels. Only the level that is read may be sampled
    // while another one is drawn into.
    const int between = level / 2;
    const bool isItself = &from == &distance;
    // 16 texels along a block, which is 22.5 degrees wide, and two at least along one of those between.
    const int stride = isItself ? std::max(1, std::min((1 << level) / 16, (1 << between) / 2)) : 1;
    if (between > 0) {
        beginGather(distance);
        readOnly(0, 0);
        beginGather(from);
        gather(distance, between, sizeOf(between), stride);
    }
    beginGather(distance);
    readOnly(between, between);
    gather(distance, level, sizeOf(level), 1);
    readOnly(0, level);
}

void Copies::copySide(unsigned int texture, SideTarget target, const MapTextures& to, int layer,
                      const MapSize& size)
{
    const bool isRectangle = target == SideTarget::rectangle;
    gl::Program& program = isRectangle ? copyRectangle_ : copy2d_;
    if (!program)
        program = link(shaders::copySide,
                       "#define MIRRORBALL_RECTANGLE " + std::to_string(isRectangle ? 1 : 0) + "\n",
                       "copying a side");
    makeShared();
    glActiveTexture(GL_TEXTURE0);
    bindBorrowed(texture, isRectangle ? GL_TEXTURE_RECTANGLE : GL_TEXTURE_2D, {size.width, size.height, 0},
                 "side " + std::to_string(layer) + " of a cube map");
    glBindSampler(0, nearest_.name());
    glUseProgram(program.name());
    glUniform1i(glGetUniformLocation(program.name(), "side"), 0);
    glViewport(0, 0, size.width, size.height);
    glBindFramebuffer(GL_FRAMEBUFFER, to.layers[static_cast<std::size_t>(layer)].name());
    pass_.draw();
}

} // namespace mirrorball::capture
