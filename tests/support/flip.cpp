#include "support/flip.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tests {

namespace {

constexpr double pi = std::numbers::pi;

constexpr double pixelsPerDegree = 0.7 * (3840 / 0.7) * (pi / 180.0);

// ---- Colours ---------------------------------------------------------------------------------------

// From the primaries of sRGB and white D65; in columns.
const glm::dmat3 xyzFromRgb({10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382},
                            {8788810.0 / 24577794, 8788810.0 / 12288897, 8788810.0 / 73733382},
                            {4435075.0 / 24577794, 887015.0 / 12288897, 70074185.0 / 73733382});
const glm::dmat3 rgbFromXyz = glm::inverse(xyzFromRgb);
const glm::dvec3 white = xyzFromRgb * glm::dvec3(1.0);

// Lightness and two opponent colours, of X, Y and Z relative to white: linear for YCxCz, after the cube root for
// L*a*b*.
glm::dvec3 opponent(const glm::dvec3& relative)
{
    return {116.0 * relative.y - 16.0, 500.0 * (relative.x - relative.y), 200.0 * (relative.y - relative.z)};
}

glm::dvec3 rgbFromYCxCz(const glm::dvec3& colour)
{
    const double y = (colour.x + 16.0) / 116.0;
    return rgbFromXyz * (white * glm::dvec3(y + colour.y / 500.0, y, y - colour.z / 200.0));
}

// L*a*b*, with less colour where it is darker (Hunt 1952).
glm::dvec3 huntLab(const glm::dvec3& rgb)
{
    const auto root = [](double t) {
        constexpr double delta = 6.0 / 29.0;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
    };
    const glm::dvec3 relative = xyzFromRgb * rgb / white;
    const glm::dvec3 lab = opponent({root(relative.x), root(relative.y), root(relative.z)});
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

// HyAB (Abasi, Tehran, Fairchild 2020), compressed by the paper's exponent q_c.
double colourDistance(const glm::dvec3& a, const glm::dvec3& b)
{
    const double distance = std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
    return std::pow(distance, 0.7);
}

// The lower 0.4 of the range, up to the largest distance, green to blue, take up 0.95 of the error.
double colourError(const glm::dvec3& a, const glm::dvec3& b)
{
    static const double largest = colourDistance(huntLab({0.0, 1.0, 0.0}), huntLab({0.0, 0.0, 1.0}));
    const double bend = 0.4 * largest, distance = colourDistance(a, b);
    return distance < bend ? 0.95 * distance / bend : 0.95 + 0.05 * (distance - bend) / (largest - bend);
}

// ---- Filters ---------------------------------------------------------------------------------------

using Plane = std::vector<double>;
using Kernel = std::vector<double>; // of odd length

// From -radius to length + radius: beyond the border the picture goes on as it is there.
std::vector<std::size_t> places(int length, int radius)
{
    std::vector<std::size_t> result;
    for (int place = -radius; place < length + radius; ++place)
        result.push_back(static_cast<std::size_t>(std::clamp(place, 0, length - 1)));
    return result;
}

// In x and then in y.
Plane filtered(const glm::ivec2& size, const Plane& plane, const Kernel& inX, const Kernel& inY)
{
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    const std::vector<std::size_t> columns = places(size.x, static_cast<int>(inX.size() / 2));
    const std::vector<std::size_t> rows = places(size.y, static_cast<int>(inY.size() / 2));
    Plane middle(plane.size()), result(plane.size());
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t k = 0; k < inX.size(); ++k)
            for (std::size_t x = 0; x < width; ++x)
                middle[y * width + x] += inX[k] * plane[y * width + columns[x + k]];
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t k = 0; k < inY.size(); ++k)
            for (std::size_t x = 0; x < width; ++x)
                result[y * width + x] += inY[k] * middle[rows[y + k] * width + x];
    return result;
}

// exp(-x² / (2 deviation²)) times what `weight` makes of x / deviation, x in pixels.
template <typename Weight>
Kernel gaussian(double deviation, int radius, const Weight& weight)
{
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x)
        kernel.push_back(weight(x / deviation) * std::exp(-0.5 * x * x / (deviation * deviation)));
    return kernel;
}

double sumOf(const Kernel& kernel)
{
    double sum = 0.0;
    for (const double value : kernel)
        sum += value;
    return sum;
}

// Positive values sum to 1, and so do the absolute negative ones.
Kernel normalised(Kernel kernel)
{
    double positive = 0.0, negative = 0.0;
    for (const double value : kernel)
        (value > 0.0 ? positive : negative) += std::abs(value);
    for (double& value : kernel)
        value /= value > 0.0 ? positive : negative;
    return kernel;
}

// One Gaussian of a contrast sensitivity a √(π/b) exp(-π² x² / b), x in degrees.
struct Sensitivity
{
    double a, b;
};

// What the eye still resolves of one channel: a sum of Gaussians, together of sum 1. All channels have the radius of
// the widest, three times its deviation.
Plane seen(const glm::ivec2& size, const Plane& plane, const std::vector<Sensitivity>& sensitivities)
{
    const auto deviation = [](double b) { return std::sqrt(b / (2.0 * pi * pi)) * pixelsPerDegree; };
    constexpr double widest = 0.04;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation(widest)));
    Plane sum(plane.size());
    double weights = 0.0;
    for (const Sensitivity& sensitivity : sensitivities) {
        const Kernel kernel = gaussian(deviation(sensitivity.b), radius, [](double) { return 1.0; });
        const double factor = sensitivity.a * std::sqrt(pi / sensitivity.b);
        const Plane part = filtered(size, plane, kernel, kernel);
        for (std::size_t index = 0; index < sum.size(); ++index)
            sum[index] += factor * part[index];
        weights += factor * sumOf(kernel) * sumOf(kernel);
    }
    for (double& value : sum)
        value /= weights;
    return sum;
}

// ---- One picture -----------------------------------------------------------------------------------

struct Seen
{
    std::vector<glm::dvec3> colours; // Hunt-adjusted L*a*b*
    Plane edges, points;             // how strong they are
};

// First or second derivatives of luminance: the strength of what they find in either direction.
Plane features(const glm::ivec2& size, const Plane& luminance, const Kernel& derivative, const Kernel& across)
{
    Plane strength = filtered(size, luminance, derivative, across);
    const Plane inY = filtered(size, luminance, across, derivative);
    for (std::size_t index = 0; index < strength.size(); ++index)
        strength[index] = std::hypot(strength[index], inY[index]);
    return strength;
}

Seen seenOf(const glm::ivec2& size, const std::vector<glm::dvec3>& picture)
{
    Plane channels[3], luminance;
    for (const glm::dvec3& colour : picture) {
        const glm::dvec3 relative = xyzFromRgb * glm::clamp(colour, 0.0, 1.0) / white;
        const glm::dvec3 yCxCz = opponent(relative);
        luminance.push_back(relative.y);
        for (int channel = 0; channel < 3; ++channel)
            channels[channel].push_back(yCxCz[channel]);
    }
    const Plane achromatic = seen(size, channels[0], {{1.0, 0.0047}});
    const Plane redGreen = seen(size, channels[1], {{1.0, 0.0053}});
    const Plane blueYellow = seen(size, channels[2], {{34.1, 0.04}, {13.5, 0.025}});
    Seen result;
    for (std::size_t index = 0; index < picture.size(); ++index) {
        const glm::dvec3 rgb = rgbFromYCxCz({achromatic[index], redGreen[index], blueYellow[index]});
        result.colours.push_back(huntLab(glm::clamp(rgb, 0.0, 1.0)));
    }
    // Edges are 0.082 degrees wide.
    const double deviation = 0.5 * 0.082 * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto kernel = [&](const auto& weight) { return normalised(gaussian(deviation, radius, weight)); };
    const Kernel across = kernel([](double) { return 1.0; });
    result.edges = features(size, luminance, kernel([](double x) { return -x; }), across);
    result.points = features(size, luminance, kernel([](double x) { return x * x - 1.0; }), across);
    return result;
}

} // namespace

std::vector<double> flip(const glm::ivec2& size, const std::vector<glm::dvec3>& reference,
                         const std::vector<glm::dvec3>& test)
{
    const Seen a = seenOf(size, reference), b = seenOf(size, test);
    std::vector<double> errors;
    for (std::size_t index = 0; index < reference.size(); ++index) {
        const double feature =
            std::max(std::abs(a.edges[index] - b.edges[index]), std::abs(a.points[index] - b.points[index]));
        const double featureError = std::sqrt(feature / std::numbers::sqrt2);
        errors.push_back(std::pow(colourError(a.colours[index], b.colours[index]), 1.0 - featureError));
    }
    return errors;
}

} // namespace tests
