// A picture in memory, drawn or traced, and its file.
#pragma once

#include "map_file.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace render {

struct Picture
{
    glm::ivec2 size{0};
    std::vector<examples::Sample> samples; // the top row first
    std::vector<int> reflectors;           // one a sample: its number from 1, or 0
};

// k × k samples become a pixel: the mean of their colours; distance, position and reflector are taken from
// one of them, never averaged.
Picture reduced(const Picture& picture, int k, examples::View view);

// As the extension of the file says, PNG or EXR. Throws mirrorball::Error: unwritable.
void writePicture(const Picture& picture, examples::View view, const std::string& file);

} // namespace render
