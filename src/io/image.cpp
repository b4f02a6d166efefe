#include <mirrorball/io/image.h>

#include "io/decoders.h"
#include "io/file.h"
#include "io/srgb.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball::io {

namespace {

std::size_t valueCount(const Image& image)
{
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
           static_cast<std::size_t>(image.channels);
}

bool hasAlpha(int channels)
{
    return channels == 2 || channels == 4;
}

// What stands at a channel of a grey, grey-alpha, RGB or RGBA pixel, asked for as RGB or RGBA.
int sourceChannel(int channel, int sourceChannels)
{
    if (channel == 3)
        return sourceChannels - 1;
    return sourceChannels <= 2 ? 0 : channel;
}

Image linearImage(const EncodedImage& encoded)
{
    std::vector<float> linear(static_cast<std::size_t>(encoded.white) + 1);
    for (std::size_t code = 0; code < linear.size(); ++code)
        linear[code] = static_cast<float>(linearFromSrgb(static_cast<double>(code) / encoded.white));

    Image image{encoded.width, encoded.height, hasAlpha(encoded.channels) ? 4 : 3, {}};
    image.pixels.reserve(valueCount(image));
    for (auto pixel = encoded.samples.begin(); pixel != encoded.samples.end(); pixel += encoded.channels)
        for (int channel = 0; channel < image.channels; ++channel) {
            const std::uint16_t code = pixel[sourceChannel(channel, encoded.channels)];
            image.pixels.push_back(channel == 3 ? static_cast<float>(code) / static_cast<float>(encoded.white)
                                                : linear[code]);
        }
    return image;
}

Image imageFromExr(const std::filesystem::path& path, const ExrImage& exr)
{
    const ExrChannel* grey = exr.find("Y");
    std::vector<const ExrChannel*> sources = {exr.find("R"), exr.find("G"), exr.find("B")};
    if (std::find(sources.begin(), sources.end(), nullptr) != sources.end()) {
        if (grey == nullptr) {
            std::string names;
            for (const ExrChannel& channel : exr.channels)
                names += " " + channel.name;
            throw Error(ErrorKind::badFile, reading(path),
                        "it has neither R, G and B nor Y among its channels" + names);
        }
        sources = {grey, grey, grey};
    }
    if (const ExrChannel* alpha = exr.find("A"))
        sources.push_back(alpha);

    Image image{exr.width, exr.height, static_cast<int>(sources.size()), {}};
    image.pixels.reserve(valueCount(image));
    for (std::size_t pixel = 0; pixel < sources[0]->values.size(); ++pixel)
        for (const ExrChannel* source : sources)
            image.pixels.push_back(source->values[pixel]);
    return image;
}

void checkForWriting(const std::filesystem::path& path, const Image& image)
{
    const bool sizesFit = image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4 &&
                          std::int64_t{image.width} * image.height <= maxPixels;
    if (!sizesFit || image.pixels.size() != valueCount(image))
        throw Error(ErrorKind::badArgument, writing(path),
                    std::to_string(image.pixels.size()) + " values are no picture of " +
                        std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels of " +
                        std::to_string(image.channels) + " channels");
}

// Code k stands for the values that encode nearer to k than to its neighbours: element k - 1 is where it
// begins.
std::array<float, 255> srgbCodeBorders()
{
    std::array<float, 255> borders{};
    for (std::size_t k = 0; k < borders.size(); ++k)
        borders[k] = static_cast<float>(linearFromSrgb((static_cast<double>(k) + 0.5) / 255.0));
    return borders;
}

} // namespace

void checkSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height)
{
    if (width > 0 && height > 0 && width <= maxPixels && height <= maxPixels && width * height <= maxPixels)
        return;
    throw Error(ErrorKind::badFile, reading(path),
                "it declares " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
                "1 to " + std::to_string(maxPixels) + " are supported");
}

Image readImage(const std::filesystem::path& path)
{
    const std::string bytes = readFile(path);
    if (isPng(bytes) || isJpeg(bytes))
        return linearImage(decodePngOrJpeg(path, bytes));
    if (isHdr(bytes))
        return decodeHdr(path, bytes);
    if (isExr(bytes))
        return imageFromExr(path, decodeExr(path, bytes));
    throw Error(ErrorKind::badFile, reading(path), "its content is none of PNG, JPEG, HDR and EXR");
}

std::size_t sanitise(Image& image)
{
    std::size_t changed = 0;
    for (float& value : image.pixels) {
        const float usable = value > 0.0f ? std::min(value, maxHalf) : 0.0f; // NaN is not > 0
        changed += usable == value ? 0 : 1;
        value = usable;
    }
    return changed;
}

void writePng(const std::filesystem::path& path, const Image& image)
{
    checkForWriting(path, image);
    const std::array<float, 255> borders = srgbCodeBorders();
    const auto colourCode = [&](float value) { // NaN would count as beyond every border
        return std::isnan(value) ? 0
                                 : std::upper_bound(borders.begin(), borders.end(), value) - borders.begin();
    };
    const auto alphaCode = [](float value) { // NaN is not > 0
        return value > 0.0f ? std::lround(std::min(value, 1.0f) * 255.0f) : 0;
    };

    std::vector<std::uint8_t> samples;
    samples.reserve(image.pixels.size());
    for (auto pixel = image.pixels.begin(); pixel != image.pixels.end(); pixel += image.channels)
        for (int channel = 0; channel < image.channels; ++channel) {
            const bool isAlpha = hasAlpha(image.channels) && channel == image.channels - 1;
            samples.push_back(
                static_cast<std::uint8_t>(isAlpha ? alphaCode(pixel[channel]) : colourCode(pixel[channel])));
        }
    const std::string bytes = encodePng(image.width, image.height, image.channels, samples);
    if (bytes.empty())
        throw Error(ErrorKind::unwritable, writing(path), "there is not enough memory to compress it");
    writeFile(path, bytes);
}

ExrImage exrFromImage(const Image& image, ExrType type)
{
    static constexpr const char* names[4][4] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    checkForWriting("EXR", image);
    ExrImage exr{image.width, image.height, {}};
    const auto stride = static_cast<std::size_t>(image.channels);
    for (std::size_t channel = 0; channel < stride; ++channel) {
        ExrChannel& target = exr.channels.emplace_back(ExrChannel{names[stride - 1][channel], type, {}});
        target.values.reserve(image.pixels.size() / stride);
        for (std::size_t value = channel; value < image.pixels.size(); value += stride)
            target.values.push_back(image.pixels[value]);
    }
    return exr;
}

} // namespace mirrorball::io
