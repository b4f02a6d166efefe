// Of what has been drawn into a map the farthest distance of every block of 8 × 8 texels, of 16 × 16, and so on up to a
// whole layer: what the geometry stage asks before it draws more (shaders/geometry_behind.glsl).
#pragma once

#include "capture/copies.h"
#include "capture/map_textures.h"

#include <mirrorball/gl/objects.h>

namespace mirrorball::capture {

class FarthestBlocks
{
public:
    // Of a map of this size. Nothing is made before the first gather.
    explicit FarthestBlocks(const MapSize& size);

    // False where the driver cannot draw into such levels: ask nothing then. Call inside a StateGuard(0, 1) that is
    // neutralised; depth tests are off then.
    bool gather(const gl::Texture& distance, int layer);

    const gl::Texture& texture() const { return texture_; } // 2D array, red

private:
    void make();

    MapSize size_;
    MapSize blocks_; // of level 0; powers of two
    int lastLevel_;
    gl::Texture texture_;
    gl::Framebuffer level_;
    gl::Program ofTexels_, ofBlocks_;
    FullScreenPass pass_;
};

} // namespace mirrorball::capture
