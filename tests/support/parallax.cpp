#include "support/parallax.h"

#include "command_line.h"

#include "support/picture_error.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace tests {

namespace {

using mirrorball::Lookup;
using mirrorball::MapInfo;
using mirrorball::MapKind;

double angleInDegrees(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

bool isNothing(const glm::dvec3& position)
{
    return std::isnan(position.x);
}

} // namespace

std::vector<std::string> wordsOf(const HouseRoom& room)
{
    return {houseFile, "--at", room.at, "--eye", room.eye, "--light", room.light};
}

bool neverWorse(const ParallaxErrors& errors, const ParallaxErrors& infinite)
{
    return errors.mean <= infinite.mean && errors.p95 <= infinite.p95 &&
           errors.wrongPercent <= infinite.wrongPercent &&
           errors.grazingWrongPercent <= infinite.grazingWrongPercent && errors.psnr >= infinite.psnr &&
           errors.flip <= infinite.flip;
}

glm::dvec3 unitRay(const render::Camera& camera, int x, int y)
{
    const glm::dvec3 forward = glm::normalize(camera.look - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double side = 2.0 * std::tan(0.5 * camera.fovInRadians) / camera.samples.y;
    return glm::normalize(forward + side * ((x + 0.5 - 0.5 * camera.samples.x) * right -
                                            (y + 0.5 - 0.5 * camera.samples.y) * up));
}

render::Options renderOptions(const std::vector<std::string>& words)
{
    render::CommandLine line;
    std::vector<std::string> all = words;
    all.insert(all.end(), {"-o", "none.exr"});
    examples::parseWords(all, [&](CLI::App& app) { line.addTo(app); });
    return line.options();
}

int sizeOfEqualTexels(MapKind map)
{
    const auto texels = [](MapKind of, int n) {
        const MapInfo& info = mirrorball::mapInfo(of);
        return info.components * info.widthInN * info.heightInN * n * n;
    };
    int n = 1;
    while (texels(map, n + 1) <= texels(MapKind::tennisBall, 256))
        ++n;
    return n;
}

ParallaxJudge::ParallaxJudge(const render::Options& options)
    : options_(options), setup_(render::setupOf(options))
{
    options_.view = examples::View::position;
    positions_ = render::tracePicture(setup_, options_);
    options_.view = examples::View::colour;
    colours_ = render::tracePicture(setup_, options_);
}

render::Picture ParallaxJudge::draw(const render::Options& options, examples::View view) const
{
    render::Options viewed = options;
    viewed.view = view;
    examples::Stats unused;
    return render::drawPicture(setup_, viewed, unused);
}

ParallaxErrors ParallaxJudge::judge(MapKind map, Lookup lookup, std::optional<int> n) const
{
    render::Options options = options_;
    options.map = map;
    options.lookup = lookup;
    options.size = n.value_or(options.size);
    return judge(draw(options, examples::View::position), draw(options, examples::View::colour));
}

ParallaxErrors ParallaxJudge::judge(const render::Picture& drawn, const render::Picture& coloured) const
{
    const glm::dvec3 centre = setup_.mirrors[0].reflector.at;
    ParallaxErrors errors;
    std::vector<double> angles;
    int wrong = 0, grazing = 0, grazingWrong = 0;
    for (int y = 0; y < drawn.size.y; ++y)
        for (int x = 0; x < drawn.size.x; ++x) {
            const std::size_t index = static_cast<std::size_t>(y * drawn.size.x + x);
            const glm::dvec3& expected = positions_.samples[index].colour;
            const glm::dvec3& shown = drawn.samples[index].colour;
            if (positions_.reflectors[index] != 1 || drawn.reflectors[index] != 1 ||
                (isNothing(expected) && isNothing(shown)))
                continue;
            const glm::dvec3 ray = unitRay(setup_.camera, x, y);
            const glm::dvec3 surface =
                setup_.camera.eye + static_cast<double>(positions_.samples[index].distance) * ray;
            const glm::dvec3& mirrored = isNothing(expected) ? shown : expected;
            const double length = glm::distance(surface, mirrored);
            // The normal halves the angle between the eye and what is mirrored.
            const double cosine =
                std::sqrt(std::max(0.0, 0.5 * (1.0 - glm::dot(ray, (mirrored - surface) / length))));
            const bool isWrong = !(glm::distance(shown, expected) <= 0.03 * (1.0 + length));
            if (cosine < 0.1) {
                ++grazing;
                grazingWrong += isWrong ? 1 : 0;
                continue;
            }
            wrong += isWrong ? 1 : 0;
            ++errors.pixels;
            if (!isNothing(shown) && !isNothing(expected))
                angles.push_back(angleInDegrees(shown - centre, expected - centre));
        }
    const auto place =
        angles.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(angles.size()));
    std::nth_element(angles.begin(), place, angles.end());
    errors.p95 = *place;
    for (const double angle : angles) {
        errors.mean += angle / static_cast<double>(angles.size());
        errors.max = std::max(errors.max, angle);
    }
    errors.wrongPercent = 100.0 * wrong / errors.pixels;
    errors.grazingWrongPercent = grazing > 0 ? 100.0 * grazingWrong / grazing : 0.0;
    errors.psnr = psnrOf(coloured, colours_);
    errors.flip = flipOf(coloured, colours_);
    return errors;
}

} // namespace tests
