#include <mirrorball/reflect/image_map.h>

#include "capture/filtered_map.h"
#include "capture/map_textures.h"
#include "gl/context.h"
#include "gl/state_guard.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <string>

namespace mirrorball {

ImageMap::ImageMap(MapKind map, int n, std::span<const float> layers)
{
    gl::requireContext();
    capture::requireMapSize(map, n);
    const capture::MapSize size = capture::mapSize(map, n);
    const std::size_t needed = std::size_t{4} * static_cast<std::size_t>(size.width) *
                               static_cast<std::size_t>(size.height) * static_cast<std::size_t>(size.layers);
    if (layers.size() != needed)
        throw Error(ErrorKind::badArgument,
                    "a " + std::string(mapInfo(map).name) + " map of size " + std::to_string(n) +
                        " from images",
                    std::to_string(layers.size()) + " floats were given instead of " + std::to_string(needed),
                    "give every layer, four floats a texel");
    const gl::Abilities abilities = gl::Abilities::ofCurrentContext();
    const gl::StateGuard guard(abilities, 0, 1);
    guard.neutralise();
    glActiveTexture(GL_TEXTURE0);
    colour_ = gl::Texture::create();
    glBindTexture(GL_TEXTURE_2D_ARRAY, colour_.name());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, size.width, size.height, size.layers, 0, GL_RGBA,
                 GL_FLOAT, layers.data());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    map_ = {map, n, colour_.name(), 0, glm::dmat4(1.0)};
    capture::FilteredMap filtered(map, n, GL_RGBA16F, capture::PastSeams::unknown);
    filtered.update(colour_.name());
    filtered.describeIn(map_);
    filtered_ = std::move(filtered).takeTexture();
}

} // namespace mirrorball
