// Maps as the programs write them: one EXR a component, PREFIX_0.exr and so on, texture row 0 as the first
// scanline.
#pragma once

#include "gl_scene.h"

#include <mirrorball/io/image.h>
#include <mirrorball/reflect/reflection_map.h>

#include <filesystem>
#include <functional>
#include <vector>

namespace examples {

// One texel or pixel of a picture, before it is put into channels.
struct Sample
{
    glm::dvec3 colour{0.0}; // or position, normal; x is the triangle's number
    float alpha = 1.0f;
    float distance = std::numeric_limits<float>::infinity();
};

// R G B A in half (colour, normal) or 32-bit floats (position, triangle), and Z in 32-bit floats.
mirrorball::io::ExrImage exrOf(int width, int height, View view, const std::vector<Sample>& samples);

// What is written where nothing is seen: NaN for a position, -1 for a triangle, the background for a colour.
Sample nothingSeen(View view, const glm::vec3& background);

// The layers of a captured map. Positions are relative to `origin`, which is added in double.
std::vector<std::vector<Sample>> readMap(const mirrorball::ReflectionMap& map, View view,
                                         const glm::dvec3& origin, const glm::vec3& background);

// k × k samples of a layer make one texel of a layer of `width` texels: the mean colour; anything else, and the
// distance, is that of the sample nearest to the texel's centre.
std::vector<Sample> reduced(const std::vector<Sample>& samples, int width, int height, int k, View view);

// All files are written or none: they appear under temporary names first. Throws mirrorball::Error,
// unwritable.
void writeAll(const std::vector<std::pair<std::filesystem::path, mirrorball::io::ExrImage>>& files);

} // namespace examples
