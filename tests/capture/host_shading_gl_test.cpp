// What the host's fragment shader does beside its colour: textures get the right mipmap level, discard cuts away.
#include "support/check.h"
#include "support/driver.h"
#include "support/wall_patches.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

using namespace mirrorball;
using namespace tests;

namespace {

// A texture whose level k holds the number k: what the host's texture() finds is the level that its footprint
// asks for. Expected from the map's Jacobian: level = log2 of the longer of the two changes of the coordinate
// (times the texture's size) over one texel. llvmpipe chooses levels from differences within 2 × 2 texels,
// which is the derivative at the middle of the quad: over so short a way it changes by little.
void checkLevels(const WallPatches& walls, MapKind map, CaptureMethod method)
{
    constexpr int levels = 11, side = 1 << (levels - 1);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    for (int level = 0; level < levels; ++level) {
        const std::vector<float> texels(static_cast<std::size_t>(side >> level) *
                                            static_cast<std::size_t>(side >> level),
                                        static_cast<float>(level));
        glTexImage2D(GL_TEXTURE_2D, level, GL_R32F, side >> level, side >> level, 0, GL_RED, GL_FLOAT,
                     texels.data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    const std::string fragment = R"(#version 330 core
in vec3 positionInWorld;
uniform sampler2D levels;
out vec4 colour;
void main() { colour = vec4(texture(levels, positionInWorld.xy).x, 0.0, 0.0, 1.0); }
)";
    constexpr int size = 48;
    ReflectionProbe probe(descOf({map, method, LayerOrder::oneAtATime}, size));
    CaptureProgram program({.name = "levels", .vertexSource = plainVertex, .fragmentSource = fragment});
    const std::vector<Texel> texels = captured(probe, program, walls);
    glDeleteTextures(1, &texture);
    const MapInfo& info = mapInfo(map);
    const int width = info.widthInN * size, height = info.heightInN * size;
    std::size_t judged = 0;
    double worst = 0.0;
    for (std::size_t index = 0; index < texels.size(); ++index) {
        const Texel& texel = texels[index];
        const glm::dvec3 size3 = glm::abs(texel.direction);
        // The walls z = ±2, away from their borders, where a quad lies on two walls.
        if (!(size3.z > 1.15 * size3.x && size3.z > 1.15 * size3.y))
            continue;
        const auto perLayer = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        const int layer = static_cast<int>(index / perLayer),
                  row = static_cast<int>(index % perLayer) / width,
                  column = static_cast<int>(index % perLayer) % width;
        // The differences within the quad.
        const auto shownAt = [&](double x, double y) {
            const glm::dvec3 d = directionFromSquare(map, layer, glm::dvec2(x / width, y / height));
            return glm::dvec2(d) * (2.0 / std::abs(d.z)) * static_cast<double>(side);
        };
        const double x = column / 2 * 2 + 0.5, y = row / 2 * 2 + 0.5;
        // Outside its disc, and in quads on the rim, the sphere map shows one direction over and over.
        if (map == MapKind::sphereMap &&
            std::hypot(x + 0.5 - 0.5 * width, y + 0.5 - 0.5 * height) > 0.47 * width)
            continue;
        double low = 1e9, high = -1e9;
        for (const double other : {0.0, 1.0}) {
            const double alongX = glm::length(shownAt(x + 1.0, y + other) - shownAt(x, y + other));
            const double alongY = glm::length(shownAt(x + other, y + 1.0) - shownAt(x + other, y));
            low = std::min(low, std::log2(std::max(alongX, alongY)));
            high = std::max(high, std::log2(std::max(alongX, alongY)));
        }
        // OpenGL allows the greatest of the four derivatives for the longer of two vectors of two, which softpipe
        // takes, or their sum; NVIDIA's lies between.
        if (isSoftpipe() || isNvidia())
            low -= 0.5;
        if (isNvidia())
            high += 0.5;
        const auto level = static_cast<double>(texel.colour.x);
        CHECK(std::isfinite(level));
        worst = std::max({worst, low - level, level - high});
        ++judged;
    }
    std::printf("%s: levels off by %.3f at most\n", std::string(info.name).c_str(), worst);
    // The two rows and columns of a quad differ by less than 1/8 of a level; llvmpipe's own log2 is good to 1/16.
    CHECK(worst < 0.125);
    CHECK(judged > texels.size() / 32);
}

// Leaves of which every other stripe is cut away by discard show what is behind: here nothing.
void checkDiscard(const WallPatches& walls)
{
    const std::string fragment = R"(#version 330 core
in vec3 positionInWorld;
out vec4 colour;
void main()
{
    if (fract(positionInWorld.x) < 0.5)
        discard;
    colour = vec4(positionInWorld, 1.0);
}
)";
    for (const CapturePath& path : capturePaths()) {
        ReflectionProbe probe(descOf(path));
        CaptureProgram program({.name = "leaves", .vertexSource = plainVertex, .fragmentSource = fragment});
        for (const Texel& texel : captured(probe, program, walls)) {
            const glm::dvec3 size3 = glm::abs(texel.direction);
            const double x = texel.direction.x * 2.0 / std::max({size3.x, size3.y, size3.z});
            const double part = x - std::floor(x);
            const double margin = path.method == CaptureMethod::exact ? 1e-4 : 0.05; // bend and snapping
            if (path.method == CaptureMethod::perVertex ||
                std::min({part, std::abs(part - 0.5), 1.0 - part}) < margin)
                continue;
            CHECK(std::isinf(texel.distance) == (part < 0.5));
        }
    }
}

} // namespace

int main()
{
    const headless::Context context;
    const WallPatches walls;
    for (const MapInfo& info : maps())
        // Softpipe is lower than this by a quarter of a level at one texel near the sphere map's rim.
        if (!isSoftpipe() || info.kind != MapKind::sphereMap)
            checkLevels(walls, info.kind, CaptureMethod::exact);
    checkDiscard(walls);
    return 0;
}
