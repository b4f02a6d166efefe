// Textures: decoding the image formats that stb_image reads.
#pragma once

#include "scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace examples {

// The decoded image with its bottom row first (texture coordinate v = 0 is the bottom in the files that
// Assimp hands on); nothing where it cannot be read.
std::optional<Image> readImage(const std::filesystem::path& file);
std::optional<Image> decodeImage(std::span<const std::uint8_t> bytes);

} // namespace examples
