// The mip level that a pixel is filtered from is that of its footprint, by the map's Jacobian in double, within 1/32:
// next to borders, cuts and poles as elsewhere, whichever pixels share derivatives, and for rays that start off the
// centre.
#include "support/check.h"
#include "support/sampling.h"

#include "capture/filtered_map.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/maps/measures.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstdio>

using namespace mirrorball;

namespace {

constexpr double levelBound = 1.0 / 32.0;
constexpr int side = 64; // pixels of a picture
constexpr int n = 256;   // of the map

// A filtered map whose levels hold their own number.
class LevelMap
{
public:
    explicit LevelMap(MapKind kind)
        : layout_(capture::filteredLayout(kind, n)), texture_(gl::Texture::create())
    {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
        for (int level = 0; level < layout_.levels; ++level) {
            const int width = layout_.width >> level, height = layout_.height >> level;
            const int layers = mapInfo(kind).components;
            const std::vector<float> texels(static_cast<std::size_t>(width * height * layers),
                                            static_cast<float>(level));
            glTexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_R32F, width, height, layers, 0, GL_RED, GL_FLOAT,
                         texels.data());
        }
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, layout_.levels - 1);
        const MapInfo& info = mapInfo(kind);
        map_ = {kind, n, texture_.name()};
        map_.filteredColourTexture = texture_.name();
        map_.filteredFromSquare = {
            static_cast<float>(info.widthInN * n) / static_cast<float>(layout_.width),
            static_cast<float>(info.heightInN * n) / static_cast<float>(layout_.height), 0.0f, 0.0f};
    }

    const ReflectionMap& map() const { return map_; }
    double coarsest() const { return layout_.levels - 1; }

private:
    capture::FilteredLayout layout_;
    gl::Texture texture_;
    ReflectionMap map_;
};

// The level whose texels are as wide as the longer axis of a footprint.
double levelOf(MapKind map, const glm::dvec3& direction, const glm::dvec3& alongX, const glm::dvec3& alongY,
               double coarsest)
{
    const MapInfo& info = mapInfo(map);
    const glm::dvec2 texels(info.widthInN * n, info.heightInN * n);
    const int component = componentOf(map, direction);
    const double longest =
        std::max(glm::length(squareDerivative(map, component, direction, alongX) * texels),
                 glm::length(squareDerivative(map, component, direction, alongY) * texels));
    return std::clamp(std::log2(longest), 0.0, coarsest);
}

// A picture in which the direction is linear in the pixel's place: derivatives are differences exactly.
struct Field
{
    glm::dvec3 middle, right, up;

    glm::dvec3 at(int x, int y) const
    {
        const auto offset = [](int place) { return place + 0.5 - side / 2; };
        return middle + offset(x) * right + offset(y) * up;
    }
};

// Along each axis and each corner: poles, cuts, borders and where borders meet.
std::vector<Field> fields()
{
    std::vector<Field> result;
    for (const double step : {0.035, 0.009})
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    if (x == 0 && y == 0 && z == 0)
                        continue;
                    const glm::dvec3 middle = glm::normalize(glm::dvec3(x, y, z));
                    const glm::dvec3 right = glm::normalize(glm::cross(middle, glm::dvec3(0.6, 0.5, 0.4)));
                    result.push_back({middle, step * right, step * glm::cross(right, middle)});
                }
    return result;
}

// How far pictures are from what is expected of the pixel (x, y), in levels.
struct Worst
{
    double error = 0.0;
    int pixels = 0;
    int between = 0; // the finest and the coarsest level

    template <class Expected>
    void compare(const std::vector<glm::vec4>& shown, const Expected& expected, double coarsest)
    {
        for (int y = 1; y < side - 1; ++y) // a border pixel may differ with what lies beside the picture
            for (int x = 1; x < side - 1; ++x) {
                const double level = static_cast<double>(shown[static_cast<std::size_t>(y * side + x)].r);
                error = std::max(error, std::abs(level - expected(x, y)));
                ++pixels;
                between += level > 0.0 && level < coarsest ? 1 : 0;
            }
    }

    void check(MapKind kind, const char* what) const
    {
        std::printf("%-17s %s: off by at most %.4f levels; %d of %d pixels between levels\n",
                    mapInfo(kind).name.data(), what, error, between, pixels);
        CHECK(error <= levelBound);
        CHECK(between > pixels / 3);
    }
};

std::vector<glm::vec4> directionsOf(const Field& field)
{
    std::vector<glm::vec4> directions;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            directions.emplace_back(glm::vec3(field.at(x, y)), 0.0f);
    return directions;
}

// By dFdx and dFdy for all pixels, and with changes that the host gives.
void testInfinite(MapKind kind)
{
    const LevelMap levels(kind);
    const tests::SamplingProgram byDifferences({.map = kind}, "mirrorball_lookUp(vec3(0.0), direction.xyz)");
    const tests::SamplingProgram given(
        {.map = kind}, "mirrorball_lookUpGradient(vec3(0.0), direction.xyz, vec3(0.0), vec3(0.0), right, up)",
        "uniform vec3 right;\nuniform vec3 up;\n");
    Worst worst, worstGiven;
    for (const Field& field : fields()) {
        const std::vector<glm::vec4> directions = directionsOf(field);
        const auto expected = [&](int x, int y) {
            return levelOf(kind, field.at(x, y), field.right, field.up, levels.coarsest());
        };
        for (const glm::ivec2 shift : {glm::ivec2(0, 0), {1, 0}, {0, 1}})
            worst.compare(byDifferences.draw(levels.map(), directions, side, shift), expected,
                          levels.coarsest());
        glUseProgram(given.name());
        const glm::vec3 right(field.right), up(field.up);
        glUniform3fv(glGetUniformLocation(given.name(), "right"), 1, glm::value_ptr(right));
        glUniform3fv(glGetUniformLocation(given.name(), "up"), 1, glm::value_ptr(up));
        worstGiven.compare(given.draw(levels.map(), directions, side), expected, levels.coarsest());
    }
    worst.check(kind, "by differences");
    worstGiven.check(kind, "with changes given");
}

constexpr double proxyRadius = 4.0;
constexpr double mirrorRadius = 0.5;
const glm::dvec3 mirrorCentre(0.3, -0.2, 0.1); // the probe stays at the origin

struct Ray
{
    glm::dvec3 start, direction;
};

// Where the ball mirrors, at the point with that normal, to a distant eye behind it.
Ray mirrored(const glm::dvec3& normal, const glm::dvec3& toEye)
{
    const glm::dvec3 unit = glm::normalize(normal);
    return {mirrorCentre + mirrorRadius * unit, 2.0 * glm::dot(unit, toEye) * unit - toEye};
}

// A ball in a spherical proxy around the probe, whose surface faces the ray within a few degrees. What is expected is
// the differential of the ray's end on the proxy, with its distance fixed.
void testProxy(MapKind kind)
{
    const LevelMap levels(kind);
    const tests::SamplingProgram program(
        {.map = kind, .lookup = Lookup::sphere},
        "mirrorball_lookUp(vec3(0.3, -0.2, 0.1) + 0.5 * normalize(direction.xyz),\n"
        "                  mirrorball_reflected(direction.xyz, toEye))",
        "uniform vec3 toEye;\n");
    MaterialSettings settings;
    settings.worldFromProxy = glm::scale(glm::dmat4(1.0), glm::dvec3(proxyRadius));
    Worst worst;
    for (const Field& field : fields()) {
        const glm::dvec3 toEye = 3.0 * glm::normalize(field.middle);
        glUseProgram(program.name());
        const glm::vec3 eye(toEye);
        glUniform3fv(glGetUniformLocation(program.name(), "toEye"), 1, glm::value_ptr(eye));
        const auto expected = [&](int x, int y) {
            // The two by two pixels that share differences begin at even places.
            const int left = x & ~1, below = y & ~1;
            const Ray ray = mirrored(field.at(x, y), toEye);
            const auto distance = [&] {
                const glm::dvec3 d = glm::normalize(ray.direction);
                const double b = glm::dot(ray.start, d);
                return std::sqrt(b * b - glm::dot(ray.start, ray.start) + proxyRadius * proxyRadius) - b;
            }();
            const auto end = [&](int atX, int atY) {
                const Ray other = mirrored(field.at(atX, atY), toEye);
                return other.start + distance * glm::normalize(other.direction);
            };
            return levelOf(kind, end(x, y), end(left + 1, y) - end(left, y),
                           end(x, below + 1) - end(x, below), levels.coarsest());
        };
        worst.compare(program.draw(levels.map(), directionsOf(field), side, {}, settings), expected,
                      levels.coarsest());
    }
    worst.check(kind, "off the centre");
}

} // namespace

int main()
{
    const headless::Context context;
    for (const MapInfo& info : maps()) {
        testInfinite(info.kind);
        testProxy(info.kind);
    }
    CHECK(glGetError() == GL_NO_ERROR);
}
