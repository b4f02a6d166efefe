// Drawing without a scene: a map made smaller, a host's image copied into a layer, texel by texel.
#pragma once

#include "capture/map_textures.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/gl/objects.h>

namespace mirrorball::capture {

// A triangle over the whole viewport, with shaders::copyVertex. Prepared inside a StateGuard that is
// neutralised; depth tests are off then.
class FullScreenPass
{
public:
    void prepare();
    void draw(int instances = 1) const;

private:
    gl::VertexArray noAttributes_;
};

class Copies
{
public:
    // Call all inside a StateGuard(0, 1) that is neutralised; they leave depth tests off.

    // k × k samples of `from` become a texel of `to`: the mean colour, and the distance of the sample nearest
    // to the centre. size is that of `to`. k = 1 copies.
    void reduce(const MapTextures& from, const MapTextures& to, const MapSize& size, int k);

    // A texture of the host's into one layer's colour. Throws Error badArgument, before anything is drawn,
    // where it is no texture of that target, of width x height and of floats or normalised numbers.
    void copySide(unsigned int texture, SideTarget target, const MapTextures& to, int layer,
                  const MapSize& size);

    // Distances into a texture of this size and as many layers: of the block of texels that each one of it covers the
    // nearest.
    void gatherNearest(const gl::Texture& from, const gl::Texture& to, const MapSize& size);

    // Fills a level of a distance texture whose level 0 has this size; the levels between are not filled. All texels of
    // `from` are asked, which holds the nearest of each few, or of the texture itself one every 1.4 degrees or so each
    // way.
    void gatherNearestLevel(const gl::Texture& from, const gl::Texture& distance, const MapSize& size,
                            int level);

private:
    void makeShared();
    void beginGather(const gl::Texture& from);
    void gather(const gl::Texture& to, int level, const MapSize& size, int stride);

    gl::Program reduce_, nearestOfBlock_, copy2d_, copyRectangle_;
    FullScreenPass pass_;
    gl::Sampler nearest_;
    gl::Framebuffer level_;
};

// Binds a texture of the host's and checks what it is; `asked` names it in the Error badArgument. Levels
// below the first are not looked at. layers: 0 for a target without.
void bindBorrowed(unsigned int texture, unsigned int target, const MapSize& size, const std::string& asked);

// The same of a map's distances, which need floats.
void bindBorrowedDistances(unsigned int texture, const MapSize& size);

} // namespace mirrorball::capture
