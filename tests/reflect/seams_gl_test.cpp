// A smooth environment shows no jump above 1/255 across any border, cut or pole of any map, at every mip level; what
// lies past the seams in the map's own texels, which belong to nobody, is never seen.
#include "support/check.h"
#include "support/sampling.h"

#include "capture/filtered_map.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/reflect/image_map.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cstdio>
#include <random>

using namespace mirrorball;

namespace {

constexpr double jumpBound = 1.0 / 255.0;
constexpr double seamWidth = 2e-6; // radians between the two sides, some roundings of a float direction

// Spherical harmonics of the orders 0 to 2, between 0.1 and 0.9.
double environment(const glm::dvec3& d)
{
    return 0.5 + 0.2 * glm::dot(d, glm::normalize(glm::dvec3(0.3, -0.5, 0.8))) +
           0.1 * (d.x * d.y - d.z * d.y + d.x * d.x - d.y * d.y);
}

// Great circles, through the poles and corners of all maps in several directions and many at random.
class Circle
{
public:
    Circle(const glm::dvec3& through, const glm::dvec3& other)
        : first_(glm::normalize(through)), second_(glm::normalize(glm::cross(first_, other)))
    {
    }
    glm::dvec3 at(double angle) const { return std::cos(angle) * first_ + std::sin(angle) * second_; }

private:
    glm::dvec3 first_, second_;
};

std::vector<Circle> circles()
{
    std::vector<Circle> result;
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    const auto anyDirection = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                for (int time = 0; time < 8 && (x != 0 || y != 0 || z != 0); ++time)
                    result.emplace_back(glm::dvec3(x, y, z), anyDirection());
    while (result.size() < 512)
        result.emplace_back(anyDirection(), anyDirection());
    return result;
}

// Whether the map's coordinates jump between two directions this close.
bool isApart(MapKind map, const glm::dvec3& a, const glm::dvec3& b, double allowed)
{
    const MapCoordinate<double> from = coordinateFromDirection(map, a), to = coordinateFromDirection(map, b);
    return from.component != to.component || glm::length(from.uv - to.uv) > allowed;
}

// Directions in pairs, the two sides of a seam, wherever a circle crosses one.
std::vector<glm::vec4> seamsOf(MapKind map)
{
    constexpr int steps = 2048;
    constexpr double jump = 0.05; // of (u, v)
    std::vector<glm::vec4> pairs;
    for (const Circle& circle : circles())
        for (int step = 0; step < steps; ++step) {
            double low = glm::two_pi<double>() * (step - 0.3) / steps;
            double high = low + glm::two_pi<double>() / steps;
            if (!isApart(map, circle.at(low), circle.at(high), jump))
                continue;
            while (high - low > seamWidth) {
                const double middle = 0.5 * (low + high);
                (isApart(map, circle.at(low), circle.at(middle), jump) ? high : low) = middle;
            }
            pairs.emplace_back(circle.at(low), 0.0);
            pairs.emplace_back(circle.at(high), 0.0);
        }
    return pairs;
}

void checkSeams(const MapInfo& info, const ReflectionMap& map, const std::vector<glm::vec4>& seams)
{
    const tests::SamplingProgram byLevel({.map = info.kind},
                                         "mirrorball_lookUpLevel(vec3(0.0), direction.xyz, level)",
                                         "uniform float level;\n");
    std::printf("%-17s n = %3d, %4zu crossings, largest jump times 255 by level:", info.name.data(), map.n,
                seams.size() / 2);
    for (int level = 0; level < capture::filteredLayout(info.kind, map.n).levels; ++level) {
        glUseProgram(byLevel.name());
        glUniform1f(glGetUniformLocation(byLevel.name(), "level"), static_cast<float>(level));
        const std::vector<glm::vec4> shown = byLevel.draw(map, seams, 512);
        float largest = 0.0f;
        for (std::size_t i = 0; i < shown.size(); i += 2)
            largest = std::max(largest, std::abs(shown[i].r - shown[i + 1].r));
        std::printf(" %.2f", static_cast<double>(largest) * 255.0);
        CHECK(static_cast<double>(largest) <= jumpBound);
    }
    std::printf("\n");
}

glm::vec3 grey(const glm::dvec3& direction)
{
    return glm::vec3(static_cast<float>(environment(direction)));
}

// As a capture leaves it: every texel shows its direction, those past the seams too.
void testCaptured(const MapInfo& info, int n, const std::vector<glm::vec4>& seams)
{
    const capture::MapSize size = capture::mapSize(info.kind, n);
    const std::vector<float> layers = tests::layersOf(info.kind, n, grey, tests::PastSeams::shown);
    const gl::Texture colours = gl::Texture::create();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, colours.name());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, size.width, size.height, size.layers, 0, GL_RGBA,
                 GL_FLOAT, layers.data());
    capture::FilteredMap filtered(info.kind, n, GL_RGBA32F, capture::PastSeams::captured);
    filtered.update(colours.name());
    ReflectionMap map{info.kind, n, colours.name()};
    filtered.describeIn(map);
    checkSeams(info, map, seams);
}

} // namespace

int main()
{
    const headless::Context context;
    for (const MapInfo& info : maps()) {
        const std::vector<glm::vec4> seams = seamsOf(info.kind);
        for (const int n : {16, 37, 64, 256})
            checkSeams(info, ImageMap(info.kind, n, tests::layersOf(info.kind, n, grey)).map(), seams);
        testCaptured(info, 32, seams);
        testCaptured(info, 129, seams);
    }
    CHECK(glGetError() == GL_NO_ERROR);
}
