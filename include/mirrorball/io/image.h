// Component io: pictures and map files. PNG and JPEG hold sRGB and become linear here; HDR and EXR are linear
// already.
//
// Which decoder runs is decided by what is in the file, never by its name. Every reader throws Error:
// notFound where there is no regular file, badFile where it is empty, cut short, broken, of another kind or
// larger than maxPixels (judged from its header, before anything of that size is allocated). Every writer
// throws Error: badArgument for sizes that do not fit, unwritable otherwise; a file appears complete or not
// at all.
#pragma once

#include <mirrorball/export.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball::io {

// The most that one image may have, width times height.
inline constexpr long long maxPixels = 8192LL * 8192LL;

// The largest finite half: what half-float textures can hold.
inline constexpr float maxHalf = 65504.0f;

// Linear values, the channels of a pixel side by side; row 0 is the file's first scanline.
// 1 channel is grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha; alpha is not premultiplied by the readers.
struct Image
{
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> pixels; // width * height * channels
};

// A PNG, JPEG, HDR or EXR file with 3 channels, or 4 where it has alpha; grey is spread over RGB. 8- and
// 16-bit values are decoded by the sRGB curve whatever colour profile the file carries. HDR values are
// clamped to maxHalf, for the format reaches 1.7e38; EXR values come as they are. Of an EXR the channels R,
// G, B or Y, and A, are read.
MIRRORBALL_EXPORT Image readImage(const std::filesystem::path& path);

// Makes every value usable as radiance: NaN and negative become 0, whatever exceeds maxHalf becomes maxHalf.
// Returns how many values changed.
MIRRORBALL_EXPORT std::size_t sanitise(Image& image);

// 8 bits a channel, 1 to 4 channels: colour clamped to [0, 1], encoded by the sRGB curve and rounded to
// nearest, alpha the same without the curve; NaN becomes 0.
MIRRORBALL_EXPORT void writePng(const std::filesystem::path& path, const Image& image);

enum class ExrType { half, single }; // 16 or 32 bits in the file

struct ExrChannel
{
    std::string name; // "R", "Z", "normal.x"
    ExrType type = ExrType::half;
    std::vector<float> values; // width * height, row 0 first
};

struct ExrImage
{
    int width = 0;
    int height = 0;
    std::vector<ExrChannel> channels;

    // nullptr where there is none of that name.
    MIRRORBALL_EXPORT const ExrChannel* find(std::string_view name) const;
};

// All channels of a single-part scanline or tiled EXR, in alphabetical order; 32-bit unsigned integers become
// the nearest float. The picture is the display window, 0 where the data window does not cover it. Deep,
// multi-part and subsampled files are refused by name (badFile).
MIRRORBALL_EXPORT ExrImage readExr(const std::filesystem::path& path);

// Scanlines, ZIP compressed without loss. In half channels what exceeds maxHalf becomes infinity.
// badArgument also where two channels have one name, or a name is empty.
MIRRORBALL_EXPORT void writeExr(const std::filesystem::path& path, const ExrImage& image);

// The image's channels as EXR names them: Y, YA, RGB or RGBA.
MIRRORBALL_EXPORT ExrImage exrFromImage(const Image& image, ExrType type);

} // namespace mirrorball::io
