// A map's colours as pass 2 filters them: each layer in the middle of a larger one, whose guard texels hold
// what is seen in their own directions, with mip levels. Guard texels are wide enough at level 0 that the
// boxes of every level, those outside included, average colours of the right directions: no level needs a
// rule of its own.
#pragma once

#include "capture/copies.h"

#include <mirrorball/gl/objects.h>
#include <mirrorball/reflect/reflection_map.h>

namespace mirrorball::capture {

// In texels of level 0. Both sizes are multiples of 2^(levels - 1), so that every level is half of the one
// before exactly.
struct FilteredLayout
{
    int width, height;
    int guard; // before the first column and row; after the last ones there are at least as many
    int levels;
};

FilteredLayout filteredLayout(MapKind map, int n);

// Of a map's own texels, those whose directions belong to another component are held ...
enum class PastSeams {
    captured, // to show what is seen there, as all others
    unknown   // not to: images are often black there
};

class FilteredMap
{
public:
    FilteredMap() = default; // none

    // For RGBA textures of this internal format. Throws Error badArgument when the driver's limit on texture
    // sizes is exceeded, and unsupported. Call inside a StateGuard(0, 1) that is neutralised, as update.
    FilteredMap(MapKind map, int n, unsigned int internalFormat, PastSeams pastSeams);

    // Fills all levels from a map's colours. NaN becomes 0 and infinity the format's largest number: one such
    // texel would spoil every level. Leaves depth tests off.
    void update(unsigned int colourTexture);

    // Sets what describes this in a ReflectionMap.
    void describeIn(ReflectionMap& map) const;

    // For a map that is filled once.
    gl::Texture takeTexture() && { return std::move(texture_); }

    explicit operator bool() const noexcept { return static_cast<bool>(texture_); }

private:
    // From the texture bound to unit 0.
    void fillFirstLevel();
    void drawGuards();
    void fillRim(int level);
    void useProgram(const gl::Program& program) const;
    void attach(int level, int layer) const;

    MapKind map_{};
    int n_ = 0;
    FilteredLayout layout_{};
    float largest_ = 0.0f;
    bool copies_ = false; // all of the map's own texels as they are
    gl::Texture texture_;
    gl::Framebuffer framebuffer_;
    gl::Program copy_, fill_, rim_; // rim_: of the sphere map only
    FullScreenPass pass_;
};

} // namespace mirrorball::capture
