// What stb's writer makes and the library does not: JPEG files, and deflated bytes.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace tests {

// 8-bit RGB, row 0 on top, at the best quality.
inline std::string jpeg(int width, int height, const std::vector<std::uint8_t>& rgb)
{
    std::string bytes;
    const auto append = [](void* user, void* data, int size) {
        static_cast<std::string*>(user)->append(static_cast<const char*>(data),
                                                static_cast<std::size_t>(size));
    };
    stbi_write_jpg_to_func(append, &bytes, width, height, 3, rgb.data(), 100);
    return bytes;
}

// A zlib stream, compressed.
inline std::string zlibDeflated(std::string bytes)
{
    int size = 0;
    unsigned char* stream = stbi_zlib_compress(reinterpret_cast<unsigned char*>(bytes.data()),
                                               static_cast<int>(bytes.size()), &size, 8);
    const std::string result(reinterpret_cast<char*>(stream), static_cast<std::size_t>(size));
    std::free(stream);
    return result;
}

} // namespace tests
