// A guard before stb_image 2.27, which writes beyond an array where a JPEG's Huffman table has more than 256
// codes.
#pragma once

#include <filesystem>
#include <string>

namespace mirrorball::io {

// Throws Error, badFile, where a table is impossible, a segment leaves the file, or the scans are too many.
void checkJpegTables(const std::filesystem::path& path, const std::string& bytes);

} // namespace mirrorball::io
