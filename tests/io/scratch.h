// A folder that goes away with its test, and whole files as strings.
#pragma once

#include "support/check.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace tests {

class Scratch
{
public:
    Scratch() : folder(std::filesystem::temp_directory_path() / name())
    {
        std::filesystem::create_directory(folder);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { std::filesystem::remove_all(folder); }

    std::filesystem::path operator/(const std::string& file) const { return folder / file; }

    std::ptrdiff_t fileCount() const
    {
        return std::distance(std::filesystem::directory_iterator(folder),
                             std::filesystem::directory_iterator());
    }

private:
    static std::string name() { return "mirrorball-test-" + std::to_string(std::random_device{}()); }

    std::filesystem::path folder;
};

inline std::string bytesOf(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    CHECK(stream.is_open());
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void store(const std::filesystem::path& path, const std::string& bytes)
{
    std::filesystem::remove(path); // ext4 waits for the disk where a file is truncated and written anew
    std::ofstream stream(path, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    CHECK(stream.good());
}

} // namespace tests
