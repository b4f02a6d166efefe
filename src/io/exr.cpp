#include <mirrorball/io/image.h>

#include "io/decoders.h"
#include "io/file.h"

#include <mirrorball/error.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <set>

namespace mirrorball::io {

namespace {

// The most values that one file may decode to, over all its channels: 2 GiB of float.
constexpr std::int64_t maxValues = 8 * maxPixels;

// Walks the header's attributes before OpenEXR sees them, for it allocates what they declare. Nothing is
// copied here.
class HeaderWalk
{
public:
    HeaderWalk(const std::filesystem::path& filePath, const std::string& fileBytes)
        : path(filePath), bytes(fileBytes)
    {
    }

    void check()
    {
        const std::uint32_t version = integer();
        constexpr std::uint32_t deepBit = 0x800;
        constexpr std::uint32_t multiPartBit = 0x1000;
        if ((version & deepBit) != 0)
            refuse("it is a deep image", "flatten it first");
        if ((version & multiPartBit) != 0)
            refuse("it has several parts", "extract one first");
        while (bytes.at(position) != '\0')
            attribute();
    }

private:
    [[noreturn]] void refuse(const std::string& found, const std::string& advice = {}) const
    {
        throw Error(ErrorKind::badFile, reading(path), found, advice);
    }

    // The format is little-endian on every machine.
    std::uint32_t integer()
    {
        std::uint32_t value = 0;
        for (unsigned int shift = 0; shift < 32; shift += 8)
            value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(position++))) << shift;
        return value;
    }

    std::string_view word()
    {
        const std::size_t end = bytes.find('\0', position);
        if (end == std::string::npos)
            refuse("the file is cut short");
        const std::string_view text(bytes.data() + position, end - position);
        position = end + 1;
        return text;
    }

    void attribute()
    {
        word();
        const std::string_view type = word();
        const std::uint32_t size = integer();
        const std::size_t end = position + size;
        if (end >= bytes.size())
            refuse("the file is cut short");
        if (type == "box2i") {
            const auto xMin = static_cast<std::int32_t>(integer());
            const auto yMin = static_cast<std::int32_t>(integer());
            const auto xMax = static_cast<std::int32_t>(integer());
            const auto yMax = static_cast<std::int32_t>(integer());
            checkSize(path, std::int64_t{xMax} - xMin + 1, std::int64_t{yMax} - yMin + 1);
        } else if (type == "tiledesc") {
            const std::uint32_t width = integer();
            const std::uint32_t height = integer();
            checkSize(path, width, height);
        }
        position = end;
    }

    const std::filesystem::path& path;
    const std::string& bytes;
    std::size_t position = 4; // behind the magic number
};

struct Window
{
    int x;
    int y;
    int width;
    int height;
};

Window windowFromBox(const IMATH_NAMESPACE::Box2i& box)
{
    return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

// `values` fill the window `data`; the answer fills `display`, 0 where they do not meet.
std::vector<float> moved(std::vector<float> values, const Window& data, const Window& display)
{
    if (data.x == display.x && data.y == display.y && data.width == display.width &&
        data.height == display.height)
        return values;
    std::vector<float> result(static_cast<std::size_t>(display.width) *
                              static_cast<std::size_t>(display.height));
    // 64 bits, for windows may lie anywhere among the 32-bit integers.
    const std::int64_t dx = std::int64_t{data.x} - display.x;
    const std::int64_t dy = std::int64_t{data.y} - display.y;
    const std::int64_t xBegin = std::max<std::int64_t>(0, dx);
    const std::int64_t xEnd = std::min<std::int64_t>(display.width, dx + data.width);
    for (std::int64_t y = std::max<std::int64_t>(0, dy);
         y < std::min<std::int64_t>(display.height, dy + data.height); ++y)
        if (xBegin < xEnd)
            std::copy_n(values.begin() + (y - dy) * data.width + (xBegin - dx), xEnd - xBegin,
                        result.begin() + y * display.width + xBegin);
    return result;
}

Imf::Slice floatSlice(const float* values, const Window& window)
{
    return Imf::Slice::Make(Imf::FLOAT, values, IMATH_NAMESPACE::V2i(window.x, window.y), window.width,
                            window.height);
}

ExrImage decode(const std::filesystem::path& path, const std::string& bytes)
{
    Imf::StdISStream stream;
    stream.str(bytes);
    Imf::InputFile file(stream);
    const Window data = windowFromBox(file.header().dataWindow());
    const Window display = windowFromBox(file.header().displayWindow());

    const Imf::ChannelList& list = file.header().channels();
    std::int64_t channelCount = 0;
    for (auto channel = list.begin(); channel != list.end(); ++channel)
        ++channelCount;
    if (channelCount *
            std::max(std::int64_t{data.width} * data.height, std::int64_t{display.width} * display.height) >
        maxValues)
        throw Error(ErrorKind::badFile, reading(path),
                    "its " + std::to_string(channelCount) + " channels exceed 2 GiB decoded");

    ExrImage image{display.width, display.height, {}};
    Imf::FrameBuffer frameBuffer;
    for (auto channel = list.begin(); channel != list.end(); ++channel) {
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            throw Error(ErrorKind::badFile, reading(path),
                        std::string("channel ") + channel.name() + " is subsampled");
        const ExrType type = channel.channel().type == Imf::HALF ? ExrType::half : ExrType::single;
        image.channels.push_back({channel.name(), type, {}});
        std::vector<float>& values = image.channels.back().values;
        values.resize(static_cast<std::size_t>(data.width) * static_cast<std::size_t>(data.height));
        frameBuffer.insert(channel.name(), floatSlice(values.data(), data));
    }
    file.setFrameBuffer(frameBuffer);
    file.readPixels(data.y, data.y + data.height - 1);
    for (ExrChannel& channel : image.channels)
        channel.values = moved(std::move(channel.values), data, display);
    return image;
}

void checkForWriting(const std::filesystem::path& path, const ExrImage& image)
{
    const auto refuse = [&](const std::string& found) {
        throw Error(ErrorKind::badArgument, writing(path), found);
    };
    const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
    if (image.width <= 0 || image.height <= 0 || std::int64_t{image.width} * image.height > maxPixels)
        refuse(size + " are no picture");
    if (image.channels.empty())
        refuse("there is no channel");
    std::set<std::string_view> names;
    for (const ExrChannel& channel : image.channels) {
        if (channel.name.empty() || channel.name.find('\0') != std::string::npos ||
            !names.insert(channel.name).second)
            refuse("a channel's name is empty or comes twice: \"" + channel.name + "\"");
        if (channel.values.size() !=
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
            refuse("channel " + channel.name + " has " + std::to_string(channel.values.size()) +
                   " values for " + size);
    }
}

std::string encode(const ExrImage& image)
{
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frameBuffer;
    std::vector<std::vector<half>> halves; // OpenEXR writes the type that it is handed
    for (const ExrChannel& channel : image.channels) {
        const bool isHalf = channel.type == ExrType::half;
        header.channels().insert(channel.name, Imf::Channel(isHalf ? Imf::HALF : Imf::FLOAT));
        if (isHalf)
            halves.emplace_back(channel.values.begin(), channel.values.end());
        const IMATH_NAMESPACE::V2i origin(0, 0);
        frameBuffer.insert(
            channel.name,
            isHalf ? Imf::Slice::Make(Imf::HALF, halves.back().data(), origin, image.width, image.height)
                   : Imf::Slice::Make(Imf::FLOAT, channel.values.data(), origin, image.width, image.height));
    }
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header); // its destructor completes the stream
        file.setFrameBuffer(frameBuffer);
        file.writePixels(image.height);
    }
    return stream.str();
}

} // namespace

bool isExr(const std::string& bytes)
{
    return bytes.starts_with("\x76\x2f\x31\x01");
}

const ExrChannel* ExrImage::find(std::string_view name) const
{
    const auto found =
        std::find_if(channels.begin(), channels.end(), [&](const auto& c) { return c.name == name; });
    return found != channels.end() ? &*found : nullptr;
}

ExrImage decodeExr(const std::filesystem::path& path, const std::string& bytes)
{
    try {
        HeaderWalk(path, bytes).check();
        return decode(path, bytes);
    } catch (const Error&) {
        throw;
    } catch (const std::out_of_range&) {
        throw Error(ErrorKind::badFile, reading(path), "the file is cut short");
    } catch (const std::exception& error) {
        throw Error(ErrorKind::badFile, reading(path),
                    std::string("OpenEXR refused it (") + error.what() + ")");
    }
}

ExrImage readExr(const std::filesystem::path& path)
{
    const std::string bytes = readFile(path);
    if (!isExr(bytes))
        throw Error(ErrorKind::badFile, reading(path), "its content is not EXR");
    return decodeExr(path, bytes);
}

void writeExr(const std::filesystem::path& path, const ExrImage& image)
{
    checkForWriting(path, image);
    std::string bytes;
    try {
        bytes = encode(image);
    } catch (const std::exception& error) {
        throw Error(ErrorKind::unwritable, writing(path),
                    std::string("OpenEXR refused it (") + error.what() + ")");
    }
    writeFile(path, bytes);
}

} // namespace mirrorball::io
