// PNG and JPEG through stb_image, which trusts its input more than we do: it reads zeros beyond the end of a
// file, and inflates whatever it finds. So it reads through callbacks that notice the end, and allocates
// through functions that know from the header how much a picture can need.
#include "io/decoders.h"
#include "io/file.h"
#include "io/jpeg_tables.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <type_traits>

namespace {

// The largest single allocation that the picture being decoded can need. stb hands no context to its
// allocator.
thread_local std::size_t allocationLimit = 0;

void* limitedAllocate(std::size_t size)
{
    return size <= allocationLimit ? std::malloc(size) : nullptr;
}

void* limitedReallocate(void* block, std::size_t size)
{
    return size <= allocationLimit ? std::realloc(block, size) : nullptr;
}

} // namespace

#define STBI_MALLOC(size) limitedAllocate(size)
#define STBI_REALLOC(block, size) limitedReallocate(block, size)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_FAILURE_USERMSG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#include <stb_image.h>
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace mirrorball::io {

namespace {

struct Source
{
    const std::string& bytes;
    std::size_t position = 0;
    bool readPastEnd = false;
};

// stb asks for whole buffers, so a short answer is ordinary; it asks again only when it needs a byte that is
// not there.
int readBytes(void* user, char* data, int size)
{
    Source& source = *static_cast<Source*>(user);
    const std::size_t count = std::min(static_cast<std::size_t>(size), source.bytes.size() - source.position);
    std::memcpy(data, source.bytes.data() + source.position, count);
    source.position += count;
    source.readPastEnd |= count == 0;
    return static_cast<int>(count);
}

void skipBytes(void* user, int count)
{
    Source& source = *static_cast<Source*>(user);
    source.position =
        std::min(source.position + static_cast<std::size_t>(std::max(count, 0)), source.bytes.size());
}

int isAtEnd(void* user)
{
    const Source& source = *static_cast<Source*>(user);
    return source.position == source.bytes.size() ? 1 : 0;
}

constexpr stbi_io_callbacks callbacks{readBytes, skipBytes, isAtEnd};

// Beyond the file's own bytes and the samples: JPEG rounds each side up to a block (at most 32), PNG adds a
// byte a row, and four 16-bit channels are the widest pixel. Buffers grow by doubling, hence twice; the
// constant is for stb's own structures (18 KiB in JPEG).
std::size_t allocationLimitFor(std::size_t fileBytes, int width, int height)
{
    const std::size_t widestPixel = 4 * sizeof(std::uint16_t);
    const std::size_t samples =
        (static_cast<std::size_t>(width) + 32) * (static_cast<std::size_t>(height) + 32) * widestPixel;
    return 2 * std::max(fileBytes, samples) + 65536;
}

[[noreturn]] void refuse(const std::filesystem::path& path, const Source& source)
{
    if (source.readPastEnd)
        throw Error(ErrorKind::badFile, reading(path), "the file is cut short");
    const char* reason = stbi_failure_reason();
    throw Error(ErrorKind::badFile, reading(path),
                "the picture is broken" +
                    (reason != nullptr ? " (" + std::string(reason) + ")" : std::string()));
}

} // namespace

bool isPng(const std::string& bytes)
{
    return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

bool isJpeg(const std::string& bytes)
{
    return bytes.starts_with("\xff\xd8\xff");
}

EncodedImage decodePngOrJpeg(const std::filesystem::path& path, const std::string& bytes)
{
    if (isJpeg(bytes))
        checkJpegTables(path, bytes);
    EncodedImage image;
    allocationLimit = allocationLimitFor(0, 1, 1);
    Source header{bytes};
    if (stbi_info_from_callbacks(&callbacks, &header, &image.width, &image.height, &image.channels) == 0)
        refuse(path, header);
    checkSize(path, image.width, image.height);

    allocationLimit = allocationLimitFor(bytes.size(), image.width, image.height);
    Source depth{bytes};
    const bool wide = stbi_is_16_bit_from_callbacks(&callbacks, &depth) != 0;
    const auto load = [&](auto loader) {
        Source source{bytes};
        auto* samples = loader(&callbacks, &source, &image.width, &image.height, &image.channels, 0);
        const std::unique_ptr<std::remove_pointer_t<decltype(samples)>, decltype(&std::free)> decoded(
            samples, std::free);
        if (decoded == nullptr || source.readPastEnd)
            refuse(path, source);
        const std::size_t count = static_cast<std::size_t>(image.width) *
                                  static_cast<std::size_t>(image.height) *
                                  static_cast<std::size_t>(image.channels);
        image.samples.assign(decoded.get(), decoded.get() + count);
    };
    if (wide)
        load(stbi_load_16_from_callbacks);
    else
        load(stbi_load_from_callbacks);
    image.white = wide ? 65535 : 255;
    return image;
}

std::string encodePng(int width, int height, int channels, const std::vector<std::uint8_t>& samples)
{
    std::string bytes;
    const auto append = [](void* user, void* data, int size) {
        static_cast<std::string*>(user)->append(static_cast<const char*>(data),
                                                static_cast<std::size_t>(size));
    };
    const int done =
        stbi_write_png_to_func(append, &bytes, width, height, channels, samples.data(), width * channels);
    return done != 0 ? bytes : std::string();
}

} // namespace mirrorball::io
