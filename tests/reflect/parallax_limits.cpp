// What any look-up could reach with a captured map, beside what the library's reach. With the words of a command line
// of render:
//
//     parallax_limits builtin:room --reflector sphere:0.5 --pixels 1280x720
//
// `search` follows every ray in 2,000 steps through the texels of the first layer of depth, or of both. `told` knows
// the traced point: it shows that if the texel in its direction or one beside it holds it, and else what the search
// finds. So what `told` gets wrong is not in the map; what it colours wrong is left to the size of the texels.
#include "support/parallax.h"

#include "reference.h"
#include "renderer.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

using namespace mirrorball;

namespace {

constexpr int steps = 2000;
// As in lookup_march.glsl, which says why.
constexpr float slip = 0.03f, bend = 0.3f, alike = 1.3f;

struct Texel
{
    int component, x, y;

    friend bool operator==(const Texel&, const Texel&) = default;
};

// One layer of depth, read back.
class DepthLayer
{
public:
    DepthLayer(MapKind map, int n, unsigned int colours, unsigned int distances)
        : map_(map), width_(mapInfo(map).widthInN * n), height_(mapInfo(map).heightInN * n)
    {
        const auto texels = static_cast<std::size_t>(width_ * height_ * mapInfo(map).components);
        colours_.resize(texels);
        distances_.resize(texels);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glBindTexture(GL_TEXTURE_2D_ARRAY, colours);
        glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RGB, GL_FLOAT, colours_.data());
        glBindTexture(GL_TEXTURE_2D_ARRAY, distances);
        glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RED, GL_FLOAT, distances_.data());
    }

    Texel texel(const glm::vec3& direction) const
    {
        const MapCoordinate<float> at = coordinateFromDirection(map_, direction);
        return {at.component, static_cast<int>(at.uv.x * static_cast<float>(width_)),
                static_cast<int>(at.uv.y * static_cast<float>(height_))};
    }
    glm::vec3 direction(const Texel& texel) const
    {
        const glm::vec2 middle = (glm::vec2(texel.x, texel.y) + 0.5f) / glm::vec2(width_, height_);
        return directionFromSquare(map_, texel.component, glm::clamp(middle, 0.0f, 1.0f));
    }
    float distance(const Texel& texel) const { return distances_[indexOf(texel)]; }

    // Linear, between texels that show the nearest one's surface.
    glm::vec3 colour(const glm::vec3& direction) const
    {
        const MapCoordinate<float> at = coordinateFromDirection(map_, direction);
        const float here = distance(texel(direction));
        const glm::vec2 place = at.uv * glm::vec2(width_, height_) - 0.5f;
        const glm::vec2 low = glm::floor(place), share = place - low;
        glm::vec4 sum(0.0f);
        for (const int y : {0, 1})
            for (const int x : {0, 1}) {
                const Texel one{at.component, static_cast<int>(low.x) + x, static_cast<int>(low.y) + y};
                const float weight =
                    (x == 1 ? share.x : 1.0f - share.x) * (y == 1 ? share.y : 1.0f - share.y);
                const float there = distance(one);
                if (std::max(here, there) <= alike * std::min(here, there))
                    sum += weight * glm::vec4(colours_[indexOf(one)], 1.0f);
            }
        return glm::vec3(sum) / sum.w;
    }

    // Whether the texels at both ends of a step show one surface, which goes on beyond one of them.
    bool goesOn(const Texel& a, const Texel& b) const
    {
        const auto inverse = [&](int times) {
            return 1.0f / distance({a.component, b.x + times * (b.x - a.x), b.y + times * (b.y - a.y)});
        };
        const float change = inverse(0) - inverse(-1);
        const float bends = std::min(std::abs(inverse(-1) - inverse(-2) - change),
                                     std::abs(inverse(1) - inverse(0) - change));
        return a.component == b.component && bends <= bend * std::abs(change);
    }

private:
    // The nearest texel of the component, for one beyond it.
    std::size_t indexOf(const Texel& texel) const
    {
        const int x = std::clamp(texel.x, 0, width_ - 1), y = std::clamp(texel.y, 0, height_ - 1);
        return static_cast<std::size_t>((texel.component * height_ + y) * width_ + x);
    }

    MapKind map_;
    int width_, height_;
    std::vector<glm::vec3> colours_;
    std::vector<float> distances_;
};

// A place in the map; the layer of depth is 0 or 1.
struct Shown
{
    glm::vec3 direction;
    std::size_t layer = 0;
};

// Texels, those that share a side before those that share a corner.
constexpr std::pair<int, int> aroundAndMiddle[] = {{0, 0}, {1, 0},  {-1, 0}, {0, 1},  {0, -1},
                                                   {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};

struct Ray
{
    glm::vec3 start, direction;     // in the map's space
    std::optional<glm::vec3> meets; // the traced point
};

// The first place where the ray comes behind a surface by less than the slip, or behind one that goes on; else the last
// one before an edge.
Shown searched(const std::vector<DepthLayer>& layers, const Ray& ray)
{
    const float inverse = 1.0f / glm::length(ray.start);
    const glm::vec3 start = ray.start * inverse, towards = glm::normalize(ray.direction);
    Shown shown{towards};
    glm::vec3 previous = start;
    bool isBehind[2] = {false, false};
    for (int step = 1; step <= steps; ++step) {
        const float s = static_cast<float>(step) / static_cast<float>(steps);
        const glm::vec3 v = glm::mix(start, towards, s);
        const float reached = (1.0f - s) * inverse;
        for (std::size_t layer = 0; layer < layers.size(); ++layer) {
            const DepthLayer& depth = layers[layer];
            const Texel from = depth.texel(previous), to = depth.texel(v);
            const float behind = glm::length(v) / depth.distance(to) - reached;
            const bool crosses = behind >= 0.0f && !isBehind[layer] && (layer == 0 || step < steps);
            isBehind[layer] = behind >= 0.0f;
            if (crosses && (behind <= slip * reached || depth.goesOn(from, to)))
                return {v, layer};
            if (crosses && layer == 0)
                shown = {previous};
        }
        previous = v;
    }
    return shown;
}

// Of the texels around the traced point's direction the first whose distance is the point's.
Shown told(const std::vector<DepthLayer>& layers, const Ray& ray)
{
    const glm::vec3 direction = ray.meets.value_or(ray.direction);
    const float expected = ray.meets ? glm::length(*ray.meets) : std::numeric_limits<float>::infinity();
    Shown shown{direction};
    float least = std::numeric_limits<float>::infinity();
    for (const auto& [x, y] : aroundAndMiddle)
        for (std::size_t layer = 0; layer < layers.size(); ++layer) {
            const Texel middle = layers[layer].texel(direction);
            const Texel one{middle.component, middle.x + x, middle.y + y};
            const float ratio = layers[layer].distance(one) / expected;
            // Neither is anything where both are infinite.
            const float error = std::isnan(ratio) ? 0.0f : std::abs(ratio - 1.0f);
            const bool isBetter = error < least && least > slip;
            least = isBetter ? error : least;
            if (isBetter)
                shown = {one == middle ? direction : layers[layer].direction(one), layer};
        }
    return least <= slip ? shown : searched(layers, ray);
}

using LookUp = Shown (*)(const std::vector<DepthLayer>&, const Ray&);

// The first mirror of a setup, its map, and the rays that it reflects.
class Limits
{
public:
    explicit Limits(const render::Options& options)
        : judge_(options), setup_(judge_.setup()), tracer_(setup_.scene, setup_.camera.eye)
    {
        for (const render::Mirror& mirror : setup_.mirrors)
            tracer_.add(mirror.reflector);
        const headless::Context context;
        const render::Canvas canvas(setup_, examples::View::colour, options.pixels);
        CaptureProgram program = examples::phongCaptureProgram();
        render::Options layered = options;
        layered.lookup = Lookup::layered;
        render::Renderer renderer(setup_, layered, canvas, program);
        renderer.capture();
        const ReflectionMap& map = renderer.map(0);
        worldFromMap_ = glm::dmat3(map.worldFromProbe);
        layers_.emplace_back(map.map, map.n, map.colourTexture, map.distanceTexture);
        layers_.emplace_back(map.map, map.hiddenN, map.hiddenColourTexture, map.hiddenDistanceTexture);
    }

    tests::ParallaxErrors drawn(MapKind map, Lookup lookup) const { return judge_.judge(map, lookup); }

    // With so many layers of depth.
    tests::ParallaxErrors looked(LookUp lookUp, std::size_t depth) const
    {
        const std::vector<DepthLayer> layers(layers_.begin(),
                                             layers_.begin() + static_cast<std::ptrdiff_t>(depth));
        const glm::ivec2 size = setup_.camera.samples;
        const auto count = static_cast<std::size_t>(size.x * size.y);
        render::Picture positions{size, std::vector<examples::Sample>(count), std::vector<int>(count)};
        render::Picture colours = positions;
        examples::forEachRow(size.y, [&](int row) {
            for (int column = 0; column < size.x; ++column) {
                const std::optional<Ray> ray = rayAt(column, row);
                if (!ray)
                    continue;
                const auto index = static_cast<std::size_t>(row * size.x + column);
                const Shown shown = lookUp(layers, *ray);
                positions.reflectors[index] = colours.reflectors[index] = 1;
                positions.samples[index].colour = positionOf(shown);
                colours.samples[index].colour = glm::dvec3(layers_[shown.layer].colour(shown.direction));
            }
        });
        return judge_.judge(positions, colours);
    }

private:
    std::optional<Ray> rayAt(int column, int row) const
    {
        const examples::Seen seen =
            tracer_.look(setup_.camera.eye, tests::unitRay(setup_.camera, column, row), 0.0,
                         std::numeric_limits<double>::infinity());
        if (seen.kind != examples::SeenKind::reflector || seen.hit.reflector != 0)
            return std::nullopt;
        const auto inMap = [&](const glm::dvec3& v) { return glm::vec3(v * worldFromMap_); };
        const glm::dvec3& centre = setup_.mirrors[0].reflector.at;
        Ray ray{inMap(seen.hit.position - centre), inMap(seen.mirrorDirection), std::nullopt};
        if (seen.mirrored.found)
            ray.meets = inMap(seen.mirrored.position - centre);
        return ray;
    }

    glm::dvec3 positionOf(const Shown& shown) const
    {
        const DepthLayer& layer = layers_[shown.layer];
        const float distance = layer.distance(layer.texel(shown.direction));
        if (std::isinf(distance))
            return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
        const glm::dvec3 direction(glm::normalize(shown.direction));
        return setup_.mirrors[0].reflector.at + worldFromMap_ * (static_cast<double>(distance) * direction);
    }

    tests::ParallaxJudge judge_;
    const render::Setup& setup_;
    examples::ReferenceTracer tracer_;
    glm::dmat3 worldFromMap_{1.0};
    std::vector<DepthLayer> layers_;
};

void print(const char* what, const tests::ParallaxErrors& errors, const tests::ParallaxErrors& infinite)
{
    std::printf("| %s | %.3f° | %.2f %% | %.1f dB | %+.1f dB |\n", what, errors.mean, errors.wrongPercent,
                errors.psnr, errors.psnr - infinite.psnr);
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc == 2 && std::string_view(argv[1]) == "--help") {
        std::printf(
            "parallax_limits SCENE …: the words of a command line of render; render --help lists them\n");
        return 0;
    }
    const render::Options options = tests::renderOptions(std::vector<std::string>(argv + 1, argv + argc));
    const Limits limits(options);
    const tests::ParallaxErrors infinite = limits.drawn(options.map, Lookup::infinite);
    std::printf("| look-up | mean | wrong | PSNR | over infinite |\n|---|---|---|---|---|\n");
    print("`infinite`", infinite, infinite);
    print("`distance`", limits.drawn(options.map, Lookup::distance), infinite);
    print("search, first layer", limits.looked(searched, 1), infinite);
    print("told, first layer", limits.looked(told, 1), infinite);
    print("`layered`", limits.drawn(options.map, Lookup::layered), infinite);
    print("search, both layers", limits.looked(searched, 2), infinite);
    print("told, both layers", limits.looked(told, 2), infinite);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "parallax_limits: %s\n", error.what());
    return 1;
}
