// What the readers make of well-formed files, and what the writers put into them.
#include <mirrorball/io/image.h>

#include <mirrorball/error.h>

#include "io/samples.h"
#include "io/scratch.h"
#include "io/stb_writer.h"
#include "support/check.h"

#include <cstring>
#include <limits>
#include <string>

using namespace mirrorball::io;
using mirrorball::ErrorKind;
using namespace std::string_literals;
using tests::store;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const float nan = std::numeric_limits<float>::quiet_NaN();

// IEC 61966-2-1 once more, in long double, from its own wording.
long double linear(long double encoded)
{
    return encoded > 0.04045L ? powl((encoded + 0.055L) / 1.055L, 2.4L) : encoded / 12.92L;
}

// A float holds 24 bits; the reader computes in double and rounds once.
constexpr double floatRounding = 0x1p-24;

void checkPixels(const Image& image, int width, int height, const std::vector<float>& expected)
{
    CHECK(image.width == width && image.height == height);
    CHECK(image.pixels.size() == expected.size());
    CHECK(static_cast<std::size_t>(width * height * image.channels) == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK_NEAR(image.pixels[k], expected[k], floatRounding);
}

float srgb8(int code)
{
    return static_cast<float>(linear(code / 255.0L));
}

void everyCodeSurvivesPng(const tests::Scratch& scratch)
{
    std::string rows = "\0"s;
    for (int code = 0; code < 256; ++code)
        rows += static_cast<char>(code);
    store(scratch / "ramp", tests::png(256, 1, 8, 0, rows));
    const Image ramp = readImage(scratch / "ramp");
    CHECK(ramp.channels == 3);
    for (int code = 0; code < 256; ++code)
        CHECK_NEAR(ramp.pixels[static_cast<std::size_t>(3 * code + code % 3)], linear(code / 255.0L),
                   floatRounding);

    writePng(scratch / "ramp.png", ramp);
    CHECK(readImage(scratch / "ramp.png").pixels == ramp.pixels);
}

void pngColourTypes(const tests::Scratch& scratch)
{
    const auto read = [&](const std::string& bytes) {
        store(scratch / "x", bytes);
        return readImage(scratch / "x");
    };
    const float a = srgb8(10);
    const float b = srgb8(200);
    // Row 0 is the top scanline.
    checkPixels(read(tests::png(1, 2, 8, 0, "\0\x0a\0\xc8"s)), 1, 2, {a, a, a, b, b, b});
    checkPixels(read(tests::png(1, 1, 8, 4, "\0\x0a\x33"s)), 1, 1, {a, a, a, 0.2f});
    checkPixels(read(tests::png(1, 1, 8, 2, "\0\x0a\xc8\x0a"s)), 1, 1, {a, b, a});
    checkPixels(read(tests::png(1, 1, 8, 6, "\0\x0a\xc8\x0a\x33"s)), 1, 1, {a, b, a, 0.2f});
    const std::string palette = tests::pngChunk("PLTE", "\0\0\0\x0a\x0a\xc8"s);
    checkPixels(read(tests::png(2, 1, 1, 3, "\0\x40"s, palette)), 2, 1, {0, 0, 0, a, a, b});
    // A colour that is declared transparent makes alpha.
    const std::string key = tests::pngChunk("tRNS", "\0\x0a\0\xc8\0\x0a"s);
    checkPixels(read(tests::png(2, 1, 8, 2, "\0\x0a\xc8\x0a\x0a\x0a\x0a"s, key)), 2, 1,
                {a, b, a, 0, a, a, a, 1});
    // 16 bits: 0x1234 of 0xffff.
    const auto wide = static_cast<float>(linear(0x1234 / 65535.0L));
    checkPixels(read(tests::png(1, 1, 16, 0, "\0\x12\x34"s)), 1, 1, {wide, wide, wide});
    // Chunks that do not concern the pixels are skipped, however odd.
    checkPixels(read(tests::png(1, 1, 8, 0, "\0\x0a"s, tests::pngChunk("zTXt", "rubbish"))), 1, 1, {a, a, a});
}

void writePngRoundsAndClamps(const tests::Scratch& scratch)
{
    const float justBelow = static_cast<float>(linear(99.49L / 255));
    const float justAbove = static_cast<float>(linear(99.51L / 255));
    const Image image{
        3,
        2,
        2,
        {-1, -1, nan, nan, infinity, infinity, justBelow, 0.499f / 255, justAbove, 0.501f / 255, 0, 1}};
    writePng(scratch / "clamped.png", image);
    const float c = srgb8(99);
    const float d = srgb8(100);
    checkPixels(readImage(scratch / "clamped.png"), 3, 2,
                {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, c, c, c, 0, d, d, d, 1.0f / 255, 0, 0, 0, 1});
}

void hdrPixels(const tests::Scratch& scratch)
{
    const auto read = [&](const std::string& size, const std::string& pixels) {
        store(scratch / "x", tests::hdr(size, pixels));
        return readImage(scratch / "x");
    };
    // 128 * 2^(129 - 136) = 1. Exponent 0 is black whatever the mantissas say.
    checkPixels(read("-Y 1 +X 2", "\x80\x40\x20\x81\xff\xff\xff\0"s), 2, 1, {1, 0.5f, 0.25f, 0, 0, 0});
    // Exponent 255 is legal and reaches 1.7e38: clamped to the largest half.
    checkPixels(read("-Y 1 +X 1", "\xff\x01\0\xff"s), 1, 1, {maxHalf, maxHalf, 0});
    // A run of 8 and literals, byte plane by byte plane.
    checkPixels(read("-Y 1 +X 8", "\2\2\0\x08\x88\x80\x08\0\1\2\3\4\5\6\7\x88\0\x88\x88"s), 8, 1,
                {128, 0, 0, 128, 1, 0, 128, 2, 0, 128, 3, 0, 128, 4, 0, 128, 5, 0, 128, 6, 0, 128, 7, 0});
    // The old encoding: one pixel, repeated 2 + 1 * 256 times.
    const Image old = read("-Y 1 +X 259", "\x80\x80\x80\x81\1\1\1\2\1\1\1\1"s);
    checkPixels(old, 259, 1, std::vector<float>(3 * 259, 1.0f));
}

// An even area is its mean exactly; a code may move by one in the conversion to YCbCr and back.
void jpegIsSrgb(const tests::Scratch& scratch)
{
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 8; ++x)
            rgb.insert(rgb.end(), {static_cast<std::uint8_t>(y < 8 ? 200 : 20), 90, 40});
    store(scratch / "x", tests::jpeg(8, 16, rgb));
    const Image image = readImage(scratch / "x");
    CHECK(image.width == 8 && image.height == 16 && image.channels == 3);
    for (std::size_t k = 0; k < rgb.size(); ++k) {
        CHECK(image.pixels[k] >= srgb8(rgb[k] - 1));
        CHECK(image.pixels[k] <= srgb8(rgb[k] + 1));
    }
}

void exrKeepsEveryBit(const tests::Scratch& scratch)
{
    ExrImage image{3, 2, {}};
    const std::vector<float> depths = {1, 1e-30f, infinity, -3.4e38f, 0x1.fffffep3f, nan};
    const std::vector<float> halves = {0, 0.5f, maxHalf, -2, 0x1p-24f, infinity};
    image.channels = {
        {"Z", ExrType::single, depths}, {"R", ExrType::half, halves}, {"normal.x", ExrType::half, halves}};
    writeExr(scratch / "x.exr", image);
    const ExrImage back = readExr(scratch / "x.exr");
    CHECK(back.width == 3 && back.height == 2 && back.channels.size() == 3);
    CHECK(back.channels[0].name == "R" && back.channels[0].type == ExrType::half &&
          back.channels[0].values == halves);
    CHECK(back.find("normal.x")->values == halves);
    CHECK(back.find("Z")->type == ExrType::single);
    CHECK(std::memcmp(back.find("Z")->values.data(), depths.data(), sizeof(float) * depths.size()) == 0);
    CHECK(back.find("G") == nullptr);

    // Half rounds to nearest, and overflows to infinity.
    image.channels = {{"Y", ExrType::half, {1.0f / 3, 1e6f, 2049, 0, 0, 0}}};
    writeExr(scratch / "x.exr", image);
    const Image grey = readImage(scratch / "x.exr");
    CHECK(grey.channels == 3 && grey.pixels[2] == 0x1.554p-2f && grey.pixels[3] == infinity &&
          grey.pixels[6] == 2048);
}

void exrAsImage(const tests::Scratch& scratch)
{
    const Image image{2, 1, 4, {1, 2, 3, 0.5f, -4, nan, 1e5f, 1}};
    writeExr(scratch / "x.exr", exrFromImage(image, ExrType::single));
    Image back = readImage(scratch / "x.exr");
    CHECK(std::memcmp(back.pixels.data(), image.pixels.data(), sizeof(float) * 8) == 0);
    CHECK(sanitise(back) == 3);
    CHECK((back.pixels == std::vector<float>{1, 2, 3, 0.5f, 0, 0, maxHalf, 1}));
    CHECK(sanitise(back) == 0);
    for (int channels = 1; channels <= 4; ++channels) {
        const ExrImage exr = exrFromImage(
            {1, 1, channels, std::vector<float>(static_cast<std::size_t>(channels), 0.25f)}, ExrType::half);
        writeExr(scratch / "y.exr", exr);
        const Image read = readImage(scratch / "y.exr");
        CHECK(read.channels == (channels % 2 == 0 ? 4 : 3) && read.pixels.back() == 0.25f);
    }
}

void refusesWhatIsNoPicture(const tests::Scratch& scratch)
{
    const auto path = scratch / "never.png";
    CHECK_THROWS(writePng(path, {0, 1, 3, {}}), ErrorKind::badArgument);
    CHECK_THROWS(writePng(path, {1, 1, 3, {1, 1}}), ErrorKind::badArgument);
    CHECK_THROWS(writePng(path, {1, 1, 5, {1, 1, 1, 1, 1}}), ErrorKind::badArgument);
    CHECK_THROWS(writeExr(path, {1, 1, {}}), ErrorKind::badArgument);
    CHECK_THROWS(writeExr(path, {1, 1, {{"", ExrType::half, {1}}}}), ErrorKind::badArgument);
    CHECK_THROWS(writeExr(path, {1, 1, {{"R", ExrType::half, {1}}, {"R", ExrType::half, {1}}}}),
                 ErrorKind::badArgument);
    CHECK_THROWS(writeExr(path, {1, 2, {{"R", ExrType::half, {1}}}}), ErrorKind::badArgument);
    CHECK(!std::filesystem::exists(path));
}

} // namespace

int main()
{
    const tests::Scratch scratch;
    everyCodeSurvivesPng(scratch);
    pngColourTypes(scratch);
    writePngRoundsAndClamps(scratch);
    jpegIsSrgb(scratch);
    hdrPixels(scratch);
    exrKeepsEveryBit(scratch);
    exrAsImage(scratch);
    refusesWhatIsNoPicture(scratch);
}
