#include "capture/farthest_blocks.h"

#include "capture_shaders.h"
#include "gl/program.h"

#include <epoxy/gl.h>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <bit>

namespace mirrorball::capture {

namespace {

constexpr int blockWidth = 8; // of level 0, in texels

int powerOfTwoFrom(int number)
{
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(number)));
}

gl::Program link(int width)
{
    const std::string version = "#version 330 core\n#define WIDTH " + std::to_string(width) + "\n";
    const std::string name = "the farthest distances";
    return gl::linkProgram(
        {{GL_VERTEX_SHADER, version + std::string(shaders::copyVertex), "the vertex shader of " + name},
         {GL_FRAGMENT_SHADER, version + std::string(shaders::copyFarthest),
          "the fragment shader of " + name}},
        name);
}

} // namespace

FarthestBlocks::FarthestBlocks(const MapSize& size)
    : size_(size), blocks_{powerOfTwoFrom((size.width + blockWidth - 1) / blockWidth),
                           powerOfTwoFrom((size.height + blockWidth - 1) / blockWidth), size.layers},
      lastLevel_(std::bit_width(static_cast<unsigned>(std::max(blocks_.width, blocks_.height))) - 1)
{
}

void FarthestBlocks::make()
{
    ofTexels_ = link(blockWidth);
    ofBlocks_ = link(2);
    level_ = gl::Framebuffer::create();
    texture_ = gl::Texture::create();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    // Set before there are levels, from which Mesa tells what to allocate.
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, lastLevel_);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (int level = 0; level <= lastLevel_; ++level)
        glTexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_R32F, std::max(blocks_.width >> level, 1),
                     std::max(blocks_.height >> level, 1), blocks_.layers, 0, GL_RED, GL_FLOAT, nullptr);
}

bool FarthestBlocks::gather(const gl::Texture& distance, int layer)
{
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
    if (!texture_)
        make();
    pass_.prepare();
    glBindFramebuffer(GL_FRAMEBUFFER, level_.name());
    bool isComplete = true;
    glm::ivec2 from(size_.width, size_.height);
    for (int level = 0; level <= lastLevel_; ++level) {
        const glm::ivec2 to = glm::max(glm::ivec2(blocks_.width >> level, blocks_.height >> level), 1);
        glBindTexture(GL_TEXTURE_2D_ARRAY, (level == 0 ? distance : texture_).name());
        // Only the level that is read may be sampled while another one is drawn into.
        if (level > 0) {
            glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, level - 1);
            glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, level - 1);
        }
        const gl::Program& program = level == 0 ? ofTexels_ : ofBlocks_;
        const auto location = [&](const char* name) { return glGetUniformLocation(program.name(), name); };
        glUseProgram(program.name());
        glUniform1i(location("distances"), 0);
        glUniform1i(location("layer"), layer);
        glUniform2i(location("last"), from.x - 1, from.y - 1);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture_.name(), level, layer);
        glViewport(0, 0, to.x, to.y);
        isComplete = isComplete && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
        if (isComplete)
            pass_.draw();
        from = to;
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, lastLevel_);
    return isComplete;
}

} // namespace mirrorball::capture
