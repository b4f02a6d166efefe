// A checkerboard, mirrored by a ball of few pixels: with mip levels the picture is nearer to one of many samples a
// pixel.
#include "support/check.h"
#include "support/sampling.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/reflect/image_map.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cstdio>

using namespace mirrorball;

namespace {

constexpr int side = 48;    // pixels across the ball's picture
constexpr int samples = 16; // of the reference, squared
constexpr int n = 256;
// Decibels. The checkerboard has a variance of 0.16, which is -8 dB: at half of the pixels or more it is gone, and
// there mip levels show the mean, which is right, and a single sample errs by all of it.
constexpr double leastGain = 6.0;

// Squares of 5° at the equator.
glm::vec3 checkerboard(const glm::dvec3& d)
{
    constexpr double squares = 36.0; // in half a turn
    const double longitude = std::atan2(d.x, d.z) / glm::pi<double>() * squares;
    const double latitude = std::asin(glm::clamp(d.y, -1.0, 1.0)) / glm::pi<double>() * squares;
    const bool isLight =
        (static_cast<long>(std::floor(longitude)) + static_cast<long>(std::floor(latitude))) % 2 == 0;
    return glm::vec3(isLight ? 0.9f : 0.1f);
}

// What the ball's normals mirror to an eye far along +z. Outside the ball, as at its rim.
std::vector<glm::vec4> mirroredDirections(int width)
{
    std::vector<glm::vec4> directions;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec2 p = 2.0 * (glm::dvec2(x, y) + 0.5) / static_cast<double>(width) - 1.0;
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(p, std::sqrt(std::max(1.0 - glm::dot(p, p), 0.0))));
            directions.emplace_back(2.0 * normal.z * normal - glm::dvec3(0, 0, 1), 0.0);
        }
    return directions;
}

// Decibels within nine tenths of the ball's radius.
double psnr(const std::vector<glm::vec4>& shown, const std::vector<double>& right)
{
    double squares = 0.0;
    int pixels = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (glm::length(2.0 * (glm::dvec2(x, y) + 0.5) / static_cast<double>(side) - 1.0) > 0.9)
                continue;
            const auto index = static_cast<std::size_t>(y * side + x);
            const double error = static_cast<double>(shown[index].r) - right[index];
            squares += error * error;
            ++pixels;
        }
    return -10.0 * std::log10(squares / pixels);
}

std::vector<double> reference()
{
    const std::vector<glm::vec4> directions = mirroredDirections(side * samples);
    std::vector<double> means(side * side);
    for (int y = 0; y < side * samples; ++y)
        for (int x = 0; x < side * samples; ++x) {
            const glm::dvec3 d(directions[static_cast<std::size_t>(y * side * samples + x)]);
            means[static_cast<std::size_t>(y / samples * side + x / samples)] +=
                static_cast<double>(checkerboard(glm::normalize(d)).r) / (samples * samples);
        }
    return means;
}

} // namespace

int main()
{
    const headless::Context context;
    const std::vector<double> right = reference();
    const std::vector<glm::vec4> directions = mirroredDirections(side);
    for (const MapInfo& info : maps()) {
        const ImageMap images(info.kind, n, tests::layersOf(info.kind, n, checkerboard));
        const auto quality = [&](LevelOfDetail detail) {
            const tests::SamplingProgram program({.map = info.kind, .detail = detail},
                                                 "mirrorball_lookUp(vec3(0.0), direction.xyz)");
            return psnr(program.draw(images.map(), directions, side), right);
        };
        const double first = quality(LevelOfDetail::first), isotropic = quality(LevelOfDetail::isotropic),
                     anisotropic = quality(LevelOfDetail::anisotropic);
        std::printf("%-17s first %.2f dB, isotropic %.2f dB, anisotropic %.2f dB\n", info.name.data(), first,
                    isotropic, anisotropic);
        CHECK(isotropic >= first + leastGain);
        CHECK(anisotropic >= first + leastGain);
    }
    CHECK(glGetError() == GL_NO_ERROR);
}
