#include "io/file.h"

#include <mirrorball/error.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <system_error>

namespace fs = std::filesystem;

namespace mirrorball::io {

namespace {

// The decoders count bytes in int. No file within maxPixels needs as much.
constexpr std::uintmax_t maxFileBytes = std::numeric_limits<int>::max();

} // namespace

std::string reading(const fs::path& path)
{
    return "reading " + path.string();
}

std::string writing(const fs::path& path)
{
    return "writing " + path.string();
}

std::string readFile(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        throw Error(ErrorKind::notFound, reading(path), "there is no such file");
    if (status.type() == fs::file_type::none)
        throw Error(ErrorKind::notFound, reading(path), error.message());
    if (status.type() != fs::file_type::regular)
        throw Error(ErrorKind::notFound, reading(path), "it is not a regular file");

    std::ifstream stream(path, std::ios::binary);
    const std::uintmax_t size = fs::file_size(path, error);
    if (!stream || error)
        throw Error(ErrorKind::notFound, reading(path), "it cannot be opened", "check its permissions");
    if (size == 0)
        throw Error(ErrorKind::badFile, reading(path), "the file is empty");
    if (size > maxFileBytes)
        throw Error(ErrorKind::badFile, reading(path), "the file is larger than 2 GiB");

    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!stream)
        throw Error(ErrorKind::badFile, reading(path), "the file changed while it was read");
    return bytes;
}

void writeFile(const fs::path& path, const std::string& bytes)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(ErrorKind::unwritable, writing(path), "there is something that is not a regular file");
    // A link stays a link: what it points at is replaced.
    const fs::path target = fs::exists(status) ? fs::canonical(path, error) : path;

    // A name of its own, so that two writers of one file do not meet.
    fs::path temporary = target;
    temporary += ".partial-" + std::to_string(std::random_device{}());
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    const bool opened = stream.is_open();
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    const bool written = !stream.fail();
    if (written)
        fs::rename(temporary, target, error);
    if (written && !error)
        return;

    if (opened) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
    }
    throw Error(ErrorKind::unwritable, writing(path),
                !opened    ? "no file can be made there"
                : !written ? "the device refused the data"
                           : error.message(),
                "check the folder, its permissions and the free space");
}

} // namespace mirrorball::io
