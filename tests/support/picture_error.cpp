#include "support/picture_error.h"

#include "support/flip.h"

#include <glm/common.hpp>

#include <cmath>

namespace tests {

namespace {

using render::Picture;

bool bothMirror(const Picture& drawn, const Picture& traced, std::size_t index)
{
    return drawn.reflectors[index] == 1 && traced.reflectors[index] == 1;
}

std::vector<glm::dvec3> coloursOf(const Picture& picture)
{
    std::vector<glm::dvec3> colours;
    for (const examples::Sample& sample : picture.samples)
        colours.push_back(sample.colour);
    return colours;
}

} // namespace

double encoded(double linear)
{
    const double value = glm::clamp(linear, 0.0, 1.0);
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

double psnrOf(const Picture& drawn, const Picture& traced)
{
    double sum = 0.0, count = 0.0;
    for (std::size_t index = 0; index < traced.samples.size(); ++index) {
        if (!bothMirror(drawn, traced, index))
            continue;
        for (int channel = 0; channel < 3; ++channel) {
            const double difference = encoded(drawn.samples[index].colour[channel]) -
                                      encoded(traced.samples[index].colour[channel]);
            sum += difference * difference;
            count += 1.0;
        }
    }
    return -10.0 * std::log10(sum / count);
}

double flipOf(const Picture& drawn, const Picture& traced)
{
    const std::vector<double> errors = flip(traced.size, coloursOf(traced), coloursOf(drawn));
    double sum = 0.0, count = 0.0;
    for (std::size_t index = 0; index < errors.size(); ++index)
        if (bothMirror(drawn, traced, index)) {
            sum += errors[index];
            count += 1.0;
        }
    return sum / count;
}

} // namespace tests
