#include "image_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

// The decoder is compiled into this file alone, so that it cannot clash with another copy in the program.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#include <stb_image.h>

namespace examples {

std::optional<Image> decodeImage(std::span<const std::uint8_t> bytes)
{
    // The largest 2D texture that every driver we know takes; more than that is not worth 1 GiB of memory.
    constexpr int largestSide = 16384;
    const auto size = static_cast<int>(std::min<std::size_t>(bytes.size(), 1u << 30));
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0 || width > largestSide ||
        height > largestSide)
    {
        return std::nullopt;
    }
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) {
        return std::nullopt;
    }
    Image image{width, height, {}};
    const std::ptrdiff_t row = std::ptrdiff_t{4} * width;
    image.rgba.reserve(static_cast<std::size_t>(row * height));
    for (std::ptrdiff_t y = height - 1; y >= 0; --y) {
        image.rgba.insert(image.rgba.end(), pixels.get() + y * row, pixels.get() + (y + 1) * row);
    }
    return image;
}

std::optional<Image> readImage(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) {
        return std::nullopt;
    }
    std::ifstream stream(file, std::ios::binary);
    const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
    return decodeImage(bytes);
}

} // namespace examples
