// Radiance's RGBE picture (Greg Ward, "Real Pixels", Graphics Gems II, 1991), both run-length encodings.
// Our own decoder, for stb_image 2.27 loops forever on a file that is cut short inside a run.
#include "io/decoders.h"
#include "io/file.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <sstream>

namespace mirrorball::io {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// Reads on through the bytes of the file; the end is an Error.
struct Reader
{
    const std::filesystem::path& path;
    const std::string& bytes;
    std::size_t position = 0;

    [[noreturn]] void refuse(const std::string& found) const
    {
        throw Error(ErrorKind::badFile, reading(path), found);
    }

    std::uint8_t byte()
    {
        if (position == bytes.size())
            refuse("the file is cut short");
        return static_cast<std::uint8_t>(bytes[position++]);
    }

    Rgbe pixel() { return {byte(), byte(), byte(), byte()}; }

    std::string line()
    {
        const std::size_t end = bytes.find('\n', position);
        if (end == std::string::npos)
            refuse("the file is cut short");
        const std::string text = bytes.substr(position, end - position);
        position = end + 1;
        return text;
    }
};

// A value is mantissa * 2^(exponent - 128 - 8); exponent 0 is black.
float valueOf(std::uint8_t mantissa, std::uint8_t exponent)
{
    return exponent == 0 ? 0.0f : std::min(std::ldexp(static_cast<float>(mantissa), exponent - 136), maxHalf);
}

// Leaves the reader at the first scanline.
void readHeader(Reader& reader, int& width, int& height)
{
    bool isRgbe = false;
    for (std::string line = reader.line(); !line.empty(); line = reader.line())
        isRgbe |= line == "FORMAT=32-bit_rle_rgbe";
    if (!isRgbe)
        reader.refuse("the pixels are not RGBE");
    std::istringstream resolution(reader.line());
    std::string yAxis;
    std::string xAxis;
    if (!(resolution >> yAxis >> height >> xAxis >> width) || yAxis != "-Y" || xAxis != "+X")
        reader.refuse("the scanlines do not go from top to bottom and left to right");
    checkSize(reader.path, width, height);
}

// Since Radiance 2: each of the four bytes by itself, as runs (count > 128) and literals.
void readPlanarScanline(Reader& reader, std::span<Rgbe> row)
{
    for (std::size_t plane = 0; plane < 4; ++plane)
        for (std::size_t x = 0; x < row.size();) {
            const std::uint8_t code = reader.byte();
            const bool isRun = code > 128;
            const std::size_t count = isRun ? code - 128u : code;
            if (count == 0 || count > row.size() - x)
                reader.refuse("a run does not fit its scanline");
            std::uint8_t value = 0;
            for (std::size_t k = 0; k < count; ++k) {
                if (!isRun || k == 0)
                    value = reader.byte();
                row[x++][plane] = value;
            }
        }
}

// Before: pixels as they are, where (1, 1, 1, n) repeats the last one n times, and a second such pixel in a
// row counts in 256s, and so on.
void readFlatScanline(Reader& reader, std::span<Rgbe> row, Rgbe pixel)
{
    unsigned int shift = 0;
    for (std::size_t x = 0;;) {
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
            const std::size_t count = shift < 32 ? std::size_t{pixel[3]} << shift : row.size() + 1;
            if (x == 0 || count > row.size() - x)
                reader.refuse("a run does not fit its scanline");
            std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
            x += count;
            shift += 8;
        } else {
            row[x++] = pixel;
            shift = 0;
        }
        if (x == row.size())
            return;
        pixel = reader.pixel();
    }
}

void readScanline(Reader& reader, std::span<Rgbe> row)
{
    constexpr std::size_t shortestPlanar = 8; // outside, the marker below would be an ordinary pixel
    constexpr std::size_t longestPlanar = 32767;
    const Rgbe first = reader.pixel();
    const bool isMarker = first[0] == 2 && first[1] == 2 && first[2] < 128;
    if (!isMarker || row.size() < shortestPlanar || row.size() > longestPlanar)
        readFlatScanline(reader, row, first);
    else if (first[2] * 256u + first[3] != row.size())
        reader.refuse("a scanline has another width than the picture");
    else
        readPlanarScanline(reader, row);
}

} // namespace

bool isHdr(const std::string& bytes)
{
    return bytes.starts_with("#?RADIANCE\n") || bytes.starts_with("#?RGBE\n");
}

Image decodeHdr(const std::filesystem::path& path, const std::string& bytes)
{
    Reader reader{path, bytes};
    Image image;
    readHeader(reader, image.width, image.height);
    image.channels = 3;

    // Grows with what is read, for a header may promise far more than the file holds.
    std::vector<Rgbe> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        readScanline(reader, row);
        for (const Rgbe& pixel : row)
            for (std::size_t channel = 0; channel < 3; ++channel)
                image.pixels.push_back(valueOf(pixel[channel], pixel[3]));
    }
    return image;
}

} // namespace mirrorball::io
