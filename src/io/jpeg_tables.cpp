#include "io/jpeg_tables.h"
#include "io/file.h"

#include <mirrorball/error.h>

#include <cstdint>

namespace mirrorball::io {

namespace {

// Marker codes of ITU-T T.81, table B.1: what follows a byte 0xFF.
constexpr std::uint8_t defineHuffmanTables = 0xC4;
constexpr std::uint8_t firstRestart = 0xD0;
constexpr std::uint8_t lastRestart = 0xD7;
constexpr std::uint8_t startOfImage = 0xD8;
constexpr std::uint8_t endOfImage = 0xD9;
constexpr std::uint8_t startOfScan = 0xDA;
constexpr std::uint8_t stuffing = 0x00;

// A progressive file has about ten scans. Each costs a pass over the picture and may be a few bytes long.
constexpr int maxScans = 500;

class Walk
{
public:
    Walk(const std::filesystem::path& filePath, const std::string& fileBytes)
        : path(filePath), bytes(fileBytes)
    {
    }

    void check()
    {
        int scans = 0;
        for (std::uint8_t marker = nextMarker(); marker != endOfImage; marker = nextMarker()) {
            if (marker == startOfImage || isInsideScan(marker))
                continue; // these have no length, and the pixels of a scan contain the latter
            const std::size_t begin = position;
            const std::size_t length = static_cast<std::size_t>(byte()) << 8 | byte();
            if (marker == defineHuffmanTables)
                checkTables(begin + length);
            else
                position = begin + length;
            scans += marker == startOfScan ? 1 : 0;
            if (scans > maxScans)
                refuse("it has more than " + std::to_string(maxScans) + " scans");
        }
    }

private:
    [[noreturn]] void refuse(const std::string& found) const
    {
        throw Error(ErrorKind::badFile, reading(path), found);
    }

    std::uint8_t byte()
    {
        if (position >= bytes.size())
            refuse("the file is cut short");
        return static_cast<std::uint8_t>(bytes[position++]);
    }

    // The first byte after 0xFF that is not 0xFF, wherever it comes: between segments decoders skip what they
    // do not know.
    std::uint8_t nextMarker()
    {
        while (byte() != 0xFF) {
        }
        std::uint8_t marker = byte();
        while (marker == 0xFF)
            marker = byte();
        return marker;
    }

    static bool isInsideScan(std::uint8_t marker)
    {
        return marker == stuffing || (marker >= firstRestart && marker <= lastRestart);
    }

    // Each table: its number, how many codes there are of each of 16 lengths, and a byte for every code.
    void checkTables(std::size_t end)
    {
        while (position < end) {
            byte();
            std::size_t codes = 0;
            for (int length = 1; length <= 16; ++length)
                codes += byte();
            if (codes > 256)
                refuse("a Huffman table has more than 256 codes");
            position += codes;
        }
    }

    const std::filesystem::path& path;
    const std::string& bytes;
    std::size_t position = 0;
};

} // namespace

void checkJpegTables(const std::filesystem::path& path, const std::string& bytes)
{
    Walk(path, bytes).check();
}

} // namespace mirrorball::io
