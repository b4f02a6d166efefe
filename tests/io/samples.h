// Small files made by hand, byte by byte as their formats say, so that readers are not tested against our
// writers only.
#pragma once

#include <cstdint>
#include <string>

namespace tests {

inline std::string bigEndian(std::uint32_t value)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift & 0xFF);
    return bytes;
}

inline std::string littleEndian(std::uint32_t value)
{
    const std::string big = bigEndian(value);
    return {big.rbegin(), big.rend()};
}

// CRC-32 of the PNG specification, annex D.
inline std::uint32_t crc32(const std::string& bytes)
{
    std::uint32_t crc = 0xFFFFFFFF;
    for (char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
    }
    return ~crc;
}

inline std::string pngChunk(const std::string& type, const std::string& data)
{
    return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(crc32(type + data));
}

// A zlib stream of stored (uncompressed) deflate blocks, of at most 65535 bytes each.
inline std::string zlibStored(const std::string& bytes)
{
    std::string stream = "\x78\x01";
    std::uint32_t a = 1; // Adler-32: two sums modulo 65521
    std::uint32_t b = 0;
    for (char byte : bytes) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    for (std::size_t begin = 0; begin < bytes.size(); begin += 65535) {
        const std::string block = bytes.substr(begin, 65535);
        const auto length = static_cast<std::uint32_t>(block.size());
        stream += begin + 65535 >= bytes.size() ? '\1' : '\0';
        stream += littleEndian(length | (length ^ 0xFFFF) << 16) + block;
    }
    return stream + bigEndian(b << 16 | a);
}

// colourType: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA. `pixels` is a zlib stream; `between` holds
// chunks that stand before it.
inline std::string pngOf(std::uint32_t width, std::uint32_t height, int bits, int colourType,
                         const std::string& pixels, const std::string& between = {})
{
    const std::string header = bigEndian(width) + bigEndian(height) + static_cast<char>(bits) +
                               static_cast<char>(colourType) + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + between + pngChunk("IDAT", pixels) +
           pngChunk("IEND", "");
}

// The same of rows as they are, with a filter byte 0 before each.
inline std::string png(std::uint32_t width, std::uint32_t height, int bits, int colourType,
                       const std::string& rows, const std::string& between = {})
{
    return pngOf(width, height, bits, colourType, zlibStored(rows), between);
}

inline std::string hdr(const std::string& size, const std::string& pixels)
{
    return "#?RADIANCE\nSOFTWARE=by hand\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + pixels;
}

} // namespace tests
