// A map made of images instead of a capture: six faces, a panorama, a sphere-map picture, any map's layers.
#pragma once

#include <mirrorball/export.h>
#include <mirrorball/gl/objects.h>
#include <mirrorball/reflect/reflection_map.h>

#include <span>

namespace mirrorball {

class MIRRORBALL_EXPORT ImageMap
{
public:
    // `layers` holds linear RGBA, four floats a texel, layer after layer, each of widthInN * n by heightInN *
    // n texels with texture row 0 (v = 0) first: the first scanline of an image file. Copied into an RGBA16F
    // texture, and into a filtered one. Throws Error badArgument when the number of floats does not fit
    // the map, or n the driver.
    ImageMap(MapKind map, int n, std::span<const float> layers);

    const ReflectionMap& map() const { return map_; }

    // Turns the map: rotation from map to world. The images are infinitely far, so there is no translation.
    void setRotation(const glm::dmat3& worldFromMap) { map_.worldFromProbe = glm::dmat4(worldFromMap); }

private:
    gl::Texture colour_, filtered_;
    ReflectionMap map_;
};

} // namespace mirrorball
