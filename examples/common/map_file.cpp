#include "map_file.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

namespace examples {

mirrorball::io::ExrImage exrOf(int width, int height, View view, const std::vector<Sample>& samples)
{
    using mirrorball::io::ExrType;
    const ExrType type = view == View::position || view == View::triangle ? ExrType::single : ExrType::half;
    mirrorball::io::ExrImage image{width, height, {}};
    for (const char* const name : {"R", "G", "B", "A"})
        image.channels.push_back({name, type, {}});
    image.channels.push_back({"Z", ExrType::single, {}});
    for (const Sample& sample : samples) {
        for (int channel = 0; channel < 3; ++channel)
            image.channels[static_cast<std::size_t>(channel)].values.push_back(
                static_cast<float>(sample.colour[channel]));
        image.channels[3].values.push_back(sample.alpha);
        image.channels[4].values.push_back(sample.distance);
    }
    return image;
}

Sample nothingSeen(View view, const glm::vec3& background)
{
    Sample sample;
    if (view == View::position)
        sample.colour = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    else if (view == View::triangle)
        sample.colour = glm::dvec3(-1.0);
    else if (view == View::colour)
        sample.colour = glm::dvec3(background);
    return sample;
}

std::vector<std::vector<Sample>> readMap(const mirrorball::ReflectionMap& map, View view,
                                         const glm::dvec3& origin, const glm::vec3& background)
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(map.map);
    const std::size_t texels =
        static_cast<std::size_t>(info.widthInN * map.n) * static_cast<std::size_t>(info.heightInN * map.n);
    const auto layers = static_cast<std::size_t>(info.components);
    std::vector<float> colour(4 * texels * layers), distance(texels * layers);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_2D_ARRAY, map.colourTexture);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA, GL_FLOAT, colour.data());
    glBindTexture(GL_TEXTURE_2D_ARRAY, map.distanceTexture);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RED, GL_FLOAT, distance.data());
    std::vector<std::vector<Sample>> result(layers, std::vector<Sample>(texels));
    for (std::size_t layer = 0; layer < layers; ++layer)
        for (std::size_t texel = 0; texel < texels; ++texel) {
            const std::size_t index = layer * texels + texel;
            Sample& sample = result[layer][texel];
            if (std::isinf(distance[index])) {
                sample = nothingSeen(view, background);
                continue;
            }
            const float* const rgba = &colour[4 * index];
            sample.colour = glm::dvec3(rgba[0], rgba[1], rgba[2]);
            if (view == View::position)
                sample.colour += origin;
            sample.alpha = rgba[3];
            sample.distance = distance[index];
        }
    return result;
}

std::vector<Sample> reduced(const std::vector<Sample>& samples, int width, int height, int k, View view)
{
    std::vector<Sample> texels;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto sampleAt = [&](int x, int y) -> const Sample& {
                return samples[static_cast<std::size_t>(row * k + y) * static_cast<std::size_t>(width * k) +
                               static_cast<std::size_t>(column * k + x)];
            };
            Sample texel = sampleAt(k / 2, k / 2);
            if (view == View::colour) {
                texel.colour = glm::dvec3(0.0);
                texel.alpha = 0.0f;
                for (int y = 0; y < k; ++y)
                    for (int x = 0; x < k; ++x) {
                        texel.colour += sampleAt(x, y).colour / static_cast<double>(k * k);
                        texel.alpha += sampleAt(x, y).alpha / static_cast<float>(k * k);
                    }
            }
            texels.push_back(texel);
        }
    return texels;
}

namespace {

// A rename that fails leaves some of the files: what would make it fail is asked for before.
void requireReplaceable(const std::filesystem::path& path)
{
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
        throw mirrorball::Error(mirrorball::ErrorKind::unwritable, "writing '" + path.string() + "'",
                                "'" + folder.string() + "' is not a folder", "make it first");
    const std::filesystem::file_status there = std::filesystem::status(path, error);
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        throw mirrorball::Error(mirrorball::ErrorKind::unwritable, "writing '" + path.string() + "'",
                                "there is something that is not a regular file");
}

} // namespace

void writeAll(const std::vector<std::pair<std::filesystem::path, mirrorball::io::ExrImage>>& files)
{
    for (const auto& [path, image] : files)
        requireReplaceable(path);
    std::vector<std::filesystem::path> partial;
    try {
        for (const auto& [path, image] : files) {
            partial.push_back(path.string() + ".partial");
            mirrorball::io::writeExr(partial.back(), image);
        }
        for (std::size_t index = 0; index < files.size(); ++index)
            std::filesystem::rename(partial[index], files[index].first);
    } catch (...) {
        std::error_code ignored;
        for (const std::filesystem::path& path : partial)
            std::filesystem::remove(path, ignored);
        throw;
    }
}

} // namespace examples
