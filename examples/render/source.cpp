#include "source.h"

#include <mirrorball/error.h>
#include <mirrorball/io/image.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace render {

namespace {

using mirrorball::Error;
using mirrorball::ErrorKind;
using mirrorball::MapKind;
using mirrorball::io::Image;

std::string sizeOf(const Image& image)
{
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

void append(std::vector<float>& layers, Image image)
{
    mirrorball::io::sanitise(image);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t pixel = 0; pixel < image.pixels.size(); pixel += channels) {
        layers.insert(layers.end(), &image.pixels[pixel], &image.pixels[pixel] + 3);
        layers.push_back(1.0f);
    }
}

Source readCube(const std::vector<std::string>& files)
{
    Source source{MapKind::cube, 0, {}};
    for (const std::string& file : files) {
        Image image = mirrorball::io::readImage(file);
        if (image.width != image.height)
            throw Error(ErrorKind::badFile, "'" + file + "' as a side of a cube",
                        "it is " + sizeOf(image) + " and not square", "give six square images");
        if (source.n != 0 && image.width != source.n)
            throw Error(ErrorKind::badFile, "'" + file + "' as a side of a cube",
                        "it is " + sizeOf(image) + ", and those before it have " + std::to_string(source.n),
                        "give six images of one size");
        source.n = image.width;
        append(source.layers, std::move(image));
    }
    return source;
}

Source readSphere(const std::string& file)
{
    Image image = mirrorball::io::readImage(file);
    Source source{MapKind::equirectangular, image.height, {}};
    if (image.width == image.height)
        source.map = MapKind::sphereMap;
    else if (image.width != 2 * image.height)
        throw Error(ErrorKind::badFile, "'" + file + "' as an image of the whole sphere",
                    "it is " + sizeOf(image),
                    "a panorama is twice as wide as high, a sphere-map image is square");
    append(source.layers, std::move(image));
    return source;
}

struct At
{
    int layer;
    glm::dvec2 uv;
};

// OpenGL 4.6, table 8.19.
At onCube(const glm::dvec3& d)
{
    const glm::dvec3 a = glm::abs(d);
    double s = 0.0, t = -d.y, major = 0.0;
    int layer = 0;
    if (a.x >= a.y && a.x >= a.z) {
        layer = d.x > 0.0 ? 0 : 1;
        major = a.x;
        s = d.x > 0.0 ? -d.z : d.z;
    } else if (a.y >= a.z) {
        layer = d.y > 0.0 ? 2 : 3;
        major = a.y;
        s = d.x;
        t = d.y > 0.0 ? d.z : -d.z;
    } else {
        layer = d.z > 0.0 ? 4 : 5;
        major = a.z;
        s = d.z > 0.0 ? d.x : -d.x;
    }
    return {layer, 0.5 * (glm::dvec2(s, t) / major + 1.0)};
}

At onSource(MapKind map, const glm::dvec3& direction)
{
    constexpr double pi = std::numbers::pi;
    const glm::dvec3 d = glm::normalize(direction);
    if (map == MapKind::cube)
        return onCube(d);
    if (map == MapKind::equirectangular)
        return {0, {0.5 + std::atan2(d.x, -d.z) / (2.0 * pi), std::acos(glm::clamp(d.y, -1.0, 1.0)) / pi}};
    const double m = 2.0 * std::sqrt(d.x * d.x + d.y * d.y + (d.z + 1.0) * (d.z + 1.0));
    return {0, m > 0.0 ? glm::dvec2(d.x / m + 0.5, d.y / m + 0.5) : glm::dvec2(1.0, 0.5)};
}

} // namespace

Source readSource(const std::vector<std::string>& files)
{
    if (files.size() == 6)
        return readCube(files);
    if (files.size() == 1)
        return readSphere(files[0]);
    throw Error(ErrorKind::badArgument, "--source with " + std::to_string(files.size()) + " files",
                "a cube has six and a panorama or sphere-map image one", "give six files or one");
}

glm::vec3 sourceColour(const Source& source, const glm::dvec3& direction)
{
    const At at = onSource(source.map, direction);
    const int height = source.n, width = source.map == MapKind::equirectangular ? 2 * height : height;
    const auto texel = [&](int x, int y) {
        const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
        const auto index =
            static_cast<std::size_t>(at.layer * height + row) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(column);
        const float* const rgba = &source.layers[4 * index];
        return glm::dvec3(rgba[0], rgba[1], rgba[2]);
    };
    const glm::dvec2 place = at.uv * glm::dvec2(width, height) - 0.5; // texel centres lie at halves
    const glm::dvec2 low = glm::floor(place), f = place - low;
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    return glm::vec3(glm::mix(glm::mix(texel(x, y), texel(x + 1, y), f.x),
                              glm::mix(texel(x, y + 1), texel(x + 1, y + 1), f.x), f.y));
}

} // namespace render
