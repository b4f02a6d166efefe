// One decoder a kind of file; readImage chooses. Each throws Error, badFile, in the name of `path`.
#pragma once

#include <mirrorball/io/image.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mirrorball::io {

// Throws Error, badFile, unless both are positive and their product is at most maxPixels.
void checkSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height);

bool isPng(const std::string& bytes);
bool isJpeg(const std::string& bytes);
bool isHdr(const std::string& bytes);
bool isExr(const std::string& bytes);

// PNG and JPEG, 8 or 16 bits, as they stand in the file: sRGB encoded, 1 to 4 channels, each 0 to `white`.
struct EncodedImage
{
    int width = 0;
    int height = 0;
    int channels = 0;
    int white = 255;
    std::vector<std::uint16_t> samples;
};
EncodedImage decodePngOrJpeg(const std::filesystem::path& path, const std::string& bytes);

Image decodeHdr(const std::filesystem::path& path, const std::string& bytes);
ExrImage decodeExr(const std::filesystem::path& path, const std::string& bytes);

// The bytes of a PNG file; an empty string where memory ran out.
std::string encodePng(int width, int height, int channels, const std::vector<std::uint8_t>& samples);

} // namespace mirrorball::io
