// Whole files, read and written at once.
#pragma once

#include <filesystem>
#include <string>

namespace mirrorball::io {

// What every message about a file begins with.
std::string reading(const std::filesystem::path& path);
std::string writing(const std::filesystem::path& path);

// Throws Error as image.h says; never returns an empty string.
std::string readFile(const std::filesystem::path& path);

// Through a temporary beside it that is renamed when complete. Throws Error, unwritable, leaving nothing
// behind.
void writeFile(const std::filesystem::path& path, const std::string& bytes);

} // namespace mirrorball::io
