#include "picture.h"

#include <filesystem>

namespace render {

using namespace examples;

Picture reduced(const Picture& picture, int k, View view)
{
    if (k == 1)
        return picture;
    Picture result{picture.size / k, {}, {}};
    const auto indexOf = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.x) +
               static_cast<std::size_t>(x);
    };
    for (int y = 0; y < result.size.y; ++y)
        for (int x = 0; x < result.size.x; ++x) {
            const std::size_t middle = indexOf(k * x + k / 2, k * y + k / 2);
            Sample pixel = picture.samples[middle];
            if (view == View::colour) {
                pixel.colour = glm::dvec3(0.0);
                for (int j = 0; j < k; ++j)
                    for (int i = 0; i < k; ++i)
                        pixel.colour += picture.samples[indexOf(k * x + i, k * y + j)].colour;
                pixel.colour /= k * k;
            }
            result.samples.push_back(pixel);
            result.reflectors.push_back(picture.reflectors[middle]);
        }
    return result;
}

void writePicture(const Picture& picture, View view, const std::string& file)
{
    if (std::filesystem::path(file).extension() == ".exr")
        return mirrorball::io::writeExr(file, exrOf(picture.size.x, picture.size.y, view, picture.samples));
    mirrorball::io::Image image{picture.size.x, picture.size.y, 3, {}};
    for (const Sample& sample : picture.samples)
        for (int channel = 0; channel < 3; ++channel)
            image.pixels.push_back(static_cast<float>(sample.colour[channel]));
    mirrorball::io::writePng(file, image);
}

} // namespace render
