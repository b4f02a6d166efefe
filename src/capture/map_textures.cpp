#include "capture/map_textures.h"

#include "gl/context.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace mirrorball::capture {

namespace {

gl::Texture makeLayers(const MapSize& size, GLenum internalFormat, GLenum format, GLenum filter,
                       int lastLevel = 0)
{
    gl::Texture texture = gl::Texture::create();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
    for (int level = 0; level <= lastLevel; ++level)
        glTexImage3D(GL_TEXTURE_2D_ARRAY, level, static_cast<GLint>(internalFormat), size.width >> level,
                     size.height >> level, size.layers, 0, format, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, lastLevel);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

constexpr std::array<GLenum, 2> drawBuffers = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

void requireComplete(const MapSize& size)
{
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorKind::unsupported,
                    "a framebuffer of " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                        " x " + std::to_string(size.layers),
                    "the driver cannot draw into it, or has no memory for it (framebuffer status " +
                        std::to_string(status) + ")",
                    "try a smaller map or another format");
}

// depth: 0 for none.
void attach(MapTextures& textures, const MapSize& size, unsigned int colour, unsigned int distance,
            unsigned int depth)
{
    for (int layer = 0; layer < size.layers; ++layer) {
        textures.layers.push_back(gl::Framebuffer::create());
        glBindFramebuffer(GL_FRAMEBUFFER, textures.layers.back().name());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour, 0, layer);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, distance, 0, layer);
        if (depth != 0)
            glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth, 0, layer);
        glDrawBuffers(2, drawBuffers.data());
        requireComplete(size);
    }
    textures.allLayers = gl::Framebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, textures.allLayers.name());
    glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour, 0);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, distance, 0);
    if (depth != 0)
        glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth, 0);
    glDrawBuffers(2, drawBuffers.data());
    requireComplete(size);
}

} // namespace

unsigned int internalFormat(ColourFormat format)
{
    switch (format) {
    case ColourFormat::rgba16f:
        return GL_RGBA16F;
    case ColourFormat::rgba32f:
        return GL_RGBA32F;
    case ColourFormat::rgba8:
        return GL_RGBA8;
    }
    return GL_RGBA16F;
}

MapSize mapSize(MapKind map, int n)
{
    const MapInfo& info = mapInfo(map);
    return {info.widthInN * n, info.heightInN * n, info.components};
}

int hiddenN(int n)
{
    return std::max(n / 2, 1);
}

void requireMapSize(MapKind map, int n, int supersample)
{
    const std::string asked = "a " + std::string(mapInfo(map).name) + " map of size " + std::to_string(n) +
                              (supersample == 1 ? ""
                                                : " with " + std::to_string(supersample) + " x " +
                                                      std::to_string(supersample) + " samples a texel");
    if (n < 1)
        throw Error(ErrorKind::badArgument, asked, "a map has at least 1 texel across", "ask for 1 or more");
    if (supersample < 1)
        throw Error(ErrorKind::badArgument, asked, "a texel has at least 1 sample", "ask for 1 or more");
    const MapInfo& info = mapInfo(map);
    const int largest =
        std::min(gl::integer(GL_MAX_TEXTURE_SIZE),
                 std::min(gl::integer(GL_MAX_VIEWPORT_DIMS), gl::integer(GL_MAX_RENDERBUFFER_SIZE)));
    const int limit = largest / std::max(info.widthInN, info.heightInN) / supersample;
    if (n > limit)
        throw Error(ErrorKind::badArgument, asked, "this driver's limit is " + std::to_string(limit),
                    limit > 0 ? "ask for that or less" : "ask for fewer samples");
}

gl::Texture makeDepth(const MapSize& size)
{
    return makeLayers(size, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_NEAREST);
}

gl::Texture makeDistances(const MapSize& size, int lastLevel)
{
    return makeLayers(size, GL_R32F, GL_RED, GL_NEAREST, lastLevel);
}

MapTextures makeMapTextures(const MapSize& size, ColourFormat format, const gl::Texture* depth,
                            int lastDistanceLevel)
{
    MapTextures result;
    result.colour = makeLayers(size, internalFormat(format), GL_RGBA, GL_LINEAR);
    result.distance = makeDistances(size, lastDistanceLevel);
    attach(result, size, result.colour.name(), result.distance.name(), depth == nullptr ? 0 : depth->name());
    return result;
}

MapTextures borrowMapTextures(const MapSize& size, unsigned int colour, unsigned int distance)
{
    MapTextures result;
    attach(result, size, colour, distance, 0);
    return result;
}

} // namespace mirrorball::capture
