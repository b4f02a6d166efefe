// What a probe offers beside drawing a list of meshes: samples a texel, hosts that draw by themselves, maps
// that the host owns, sides that the host has drawn. Each is judged by an ordinary capture or by the scene's
// own formula, and leaves the host's state as it was.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/gl_state.h"
#include "support/hostile_state.h"
#include "support/six_walls.h"

#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>
#include <set>

using namespace mirrorball;

namespace {

constexpr int n = 12;

struct Image
{
    std::vector<float> colour, distance; // four floats a texel
};

Image read(const ReflectionMap& map)
{
    Image image{tests::readMap(map.colourTexture, map.map, map.n), {}};
    if (map.distanceTexture != 0)
        image.distance = tests::readMap(map.distanceTexture, map.map, map.n);
    return image;
}

void checkUnchanged(const std::function<void()>& call, const char* what)
{
    const auto changes = tests::changesBy(call);
    for (const std::string& change : changes)
        std::printf("%s: %s\n", what, change.c_str());
    CHECK(changes.empty());
}

ReflectionProbe::Desc descOf(MapKind map)
{
    return {.map = map, .n = n, .near = 0.1f, .far = 50.0f, .colour = ColourFormat::rgba32f};
}

void capture(ReflectionProbe& probe, const tests::SixWalls& walls)
{
    const CaptureMesh mesh = walls.mesh();
    probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw&) { walls.draw(); });
}

// k × k samples: each texel is the mean of the block that a map k times as fine has there, and its distance
// that of the block's middle sample.
void checkSupersampling(const tests::SixWalls& walls, MapKind map, int k)
{
    ReflectionProbe::Desc desc = descOf(map);
    desc.method = CaptureMethod::exact;
    desc.supersample = k;
    ReflectionProbe coarse(desc);
    checkUnchanged([&] { capture(coarse, walls); }, "supersampling");
    desc.supersample = 1;
    desc.n = n * k;
    ReflectionProbe fine(desc);
    capture(fine, walls);
    const Image reduced = read(coarse.map()), all = read(fine.map());
    const MapInfo& info = mapInfo(map);
    const auto width = static_cast<std::size_t>(info.widthInN * n),
               rows = static_cast<std::size_t>(info.heightInN * n * info.components),
               step = static_cast<std::size_t>(k);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < width; ++column) {
            const auto sample = [&](std::size_t x, std::size_t y) {
                return 4 * ((row * step + y) * width * step + column * step + x);
            };
            for (std::size_t channel = 0; channel < 4; ++channel) {
                double sum = 0.0;
                for (std::size_t y = 0; y < step; ++y)
                    for (std::size_t x = 0; x < step; ++x)
                        sum += static_cast<double>(all.colour[sample(x, y) + channel]);
                // k² roundings of sums of numbers up to k².
                CHECK_NEAR(reduced.colour[4 * (row * width + column) + channel], sum / (k * k), k * k * 6e-8);
            }
            CHECK(reduced.distance[4 * (row * width + column)] == all.distance[sample(step / 2, step / 2)]);
        }
}

// Drawn by the host through views, the map is the same bit for bit.
void checkViews(const tests::SixWalls& walls, MapKind map, LayerOrder layers)
{
    ReflectionProbe::Desc desc = descOf(map);
    desc.layers = layers;
    ReflectionProbe listed(desc), own(desc);
    capture(listed, walls);
    std::multiset<int> ids;
    const auto drawScene = [&](CaptureView& view) {
        ids.insert(view.id());
        if (!view.touches(*walls.mesh().bounds))
            return;
        CHECK(view.use(walls.mesh()) != 0);
        walls.draw();
    };
    CaptureReport report;
    checkUnchanged([&] { report = own.capture(drawScene); }, "views");
    const std::multiset<int> first = ids;
    own.capture(drawScene);
    // Softpipe mistakes layers, and the library notices.
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const bool together =
        layers == LayerOrder::allAtOnce && (mapInfo(map).components == 1 || renderer != "softpipe");
    const std::size_t views = together ? 1 : static_cast<std::size_t>(own.viewCount());
    CHECK(first.size() == views && ids.size() == 2 * views); // the same ids again
    for (const int id : first)
        CHECK(ids.count(id) == 2);
    CHECK(report.draws == static_cast<int>(views));
    CHECK(tests::sameBits(read(listed.map()).colour, read(own.map()).colour));
    CHECK(tests::sameBits(read(listed.map()).distance, read(own.map()).distance));

    // Without bounds, exactly: where the walls' fine cuts change nothing, the same colours.
    own.capture([&](CaptureView& view) {
        view.use(*walls.mesh().program);
        walls.draw();
        CHECK_THROWS(own.capture([](CaptureView&) {}), ErrorKind::hostBusy);
        CHECK_THROWS(view.use(CaptureMesh{}), ErrorKind::badArgument);
    });
    const Image exact = read(own.map());
    for (std::size_t texel = 0; texel < exact.distance.size(); texel += 4)
        CHECK(std::isfinite(exact.distance[texel]));
}

// A view never misses what it sees: directions to points of a box belong to views that say they touch it. And
// a floor far below is not seen by the side of a cube that looks up.
void checkBoxes(MapKind map)
{
    ReflectionProbe probe(descOf(map));
    std::mt19937 generator(7);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto random = [&](float size) {
        return size * glm::vec3(uniform(generator), uniform(generator), uniform(generator));
    };
    for (int turn = 0; turn < 200; ++turn) {
        const glm::vec3 centre = random(20.0f), half = glm::abs(random(turn % 2 == 0 ? 1.0f : 15.0f));
        const Box box{centre - half, centre + half};
        for (int point = 0; point < 50; ++point) {
            const glm::vec3 p = centre + half * random(1.0f);
            if (glm::length(p) < 0.11f || glm::length(p) > 49.0f)
                continue;
            int view = componentOf(map, p);
            if (map == MapKind::octahedral)
                view = (p.x < 0.0f ? 1 : 0) + (p.y < 0.0f ? 2 : 0) + (p.z < 0.0f ? 4 : 0);
            CHECK(probe.touches(view, box));
        }
    }
    CHECK(!probe.touches(0, Box{glm::vec3(60.0f), glm::vec3(61.0f)})); // beyond far
    if (map == MapKind::cube) {
        const Box floor{glm::vec3(-4, -4, -4), glm::vec3(4, -3.9f, 4)};
        CHECK(!probe.touches(2, floor) && probe.touches(3, floor));
        const Box rod{glm::vec3(-10, -3, -0.1f), glm::vec3(10, -2.9f, 0.1f)};
        CHECK(!probe.touches(4, rod) && !probe.touches(5, rod) && probe.touches(0, rod));
    }
}

unsigned int makeTexture(GLenum target, GLenum format, int width, int height, int layers, const void* texels)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(target, texture);
    const GLenum channels = format == GL_R32F ? GL_RED : GL_RGBA;
    if (target == GL_TEXTURE_2D_ARRAY)
        glTexImage3D(target, 0, static_cast<GLint>(format), width, height, layers, 0, channels, GL_FLOAT,
                     texels);
    else
        glTexImage2D(target, 0, static_cast<GLint>(format), width, height, 0, channels, GL_FLOAT, texels);
    glBindTexture(target, 0);
    return texture;
}

void checkBorrowed(const tests::SixWalls& walls, MapKind map, int supersample)
{
    const MapInfo& info = mapInfo(map);
    ReflectionProbe::Desc desc = descOf(map);
    desc.supersample = supersample;
    ReflectionProbe own(desc);
    capture(own, walls);
    const auto array = [&](GLenum format, int width) {
        return makeTexture(GL_TEXTURE_2D_ARRAY, format, width, info.heightInN * n, info.components, nullptr);
    };
    desc.colourTexture = array(GL_RGBA32F, info.widthInN * n);
    desc.distanceTexture = array(GL_R32F, info.widthInN * n);
    {
        ReflectionProbe probe(desc);
        CHECK(probe.map().colourTexture == desc.colourTexture && probe.map().nearestLevel == 0);
        CHECK(probe.map().distanceTexture == desc.distanceTexture);
        checkUnchanged([&] { capture(probe, walls); }, "a borrowed map");
        CHECK(tests::sameBits(read(own.map()).colour, read(probe.map()).colour));
        CHECK(tests::sameBits(read(own.map()).distance, read(probe.map()).distance));
        // A capture that throws leaves the host's textures as they were.
        const CaptureMesh mesh = walls.mesh();
        try {
            probe.capture({&mesh, 1}, [](const CaptureMesh&, const CaptureDraw&) { throw 1; });
            CHECK(false);
        } catch (int) {
        }
        CHECK(tests::sameBits(read(own.map()).colour, read(probe.map()).colour));
    }
    CHECK(glIsTexture(desc.colourTexture) == GL_TRUE); // still the host's

    const auto refused = [](const ReflectionProbe::Desc& wrong) {
        checkUnchanged([&] { CHECK_THROWS(ReflectionProbe{wrong}, ErrorKind::badArgument); },
                       "a bad texture");
    };
    ReflectionProbe::Desc wrong = desc;
    wrong.distanceTexture = 0;
    refused(wrong);
    wrong.distanceTexture = 123456;
    refused(wrong);
    wrong.distanceTexture = makeTexture(GL_TEXTURE_2D, GL_R32F, n, n, 0, nullptr);
    refused(wrong);
    wrong.distanceTexture = array(GL_R32F, info.widthInN * n + 1);
    refused(wrong);
    wrong.distanceTexture = array(GL_RGBA8, info.widthInN * n); // no distance beyond 1
    refused(wrong);
    wrong.distanceTexture = wrong.colourTexture;
    refused(wrong);
    for (const unsigned int texture : {desc.colourTexture, desc.distanceTexture})
        glDeleteTextures(1, &texture);
}

// One level of the distances holds the nearest of each block, whether or not sizes divide.
void checkNearest(const tests::SixWalls& walls, MapKind map, int size)
{
    ReflectionProbe::Desc desc = descOf(map);
    desc.n = size;
    desc.nearestDistances = false;
    ReflectionProbe without(desc);
    capture(without, walls);
    CHECK(without.map().nearestLevel == 0);
    desc.nearestDistances = true;
    ReflectionProbe probe(desc);
    CHECK(probe.map().nearestLevel == 0); // nothing is known yet
    checkUnchanged([&] { capture(probe, walls); }, "gathering the nearest");
    const int level = probe.map().nearestLevel;
    CHECK(level > 0);
    const MapInfo& info = mapInfo(map);
    const int width = info.widthInN * size, height = info.heightInN * size;
    const int columns = width >> level, rows = height >> level;
    CHECK(size >> level >= 4 && size >> level < 8);
    for (int layer = 0; layer < info.components; ++layer) {
        const auto all = tests::readTextureLayer(probe.map().distanceTexture, layer, width, height);
        const auto nearest =
            tests::readTextureLayer(probe.map().distanceTexture, layer, columns, rows, level);
        const int step = std::max(size / 64, 1); // one texel every 1.4 degrees is asked
        for (int y = 0; y < height; y += step)
            for (int x = 0; x < width; x += step) {
                const int block = y * rows / height * columns + x * columns / width;
                CHECK(nearest[static_cast<std::size_t>(4 * block)] <=
                      all[static_cast<std::size_t>(4 * (y * width + x))]);
            }
        // Where sizes divide, no block holds what is not in it.
        for (int block = 0; size % 8 == 0 && block < columns * rows; ++block) {
            float least = std::numeric_limits<float>::infinity();
            for (int y = 0; y < height / rows; y += step)
                for (int x = 0; x < width / columns; x += step)
                    least = std::min(
                        least,
                        all[static_cast<std::size_t>(4 * ((block / columns * (height / rows) + y) * width +
                                                          block % columns * (width / columns) + x))]);
            CHECK(nearest[static_cast<std::size_t>(4 * block)] == least);
        }
    }
}

// Six sides with a colour of their own in every texel come back as they were.
void checkTakenOver(GLenum target, tests::HostileState& hostile)
{
    ReflectionProbe probe(descOf(MapKind::cube));
    const SideTarget kind = target == GL_TEXTURE_2D ? SideTarget::texture2d : SideTarget::rectangle;
    std::array<unsigned int, 6> sides{};
    std::vector<float> expected;
    for (std::size_t side = 0; side < 6; ++side) {
        std::vector<float> texels;
        for (int texel = 0; texel < n * n; ++texel)
            for (const float value : {static_cast<float>(side), static_cast<float>(texel % n),
                                      static_cast<float>(texel / n), 0.5f})
                texels.push_back(value);
        sides[side] = makeTexture(target, GL_RGBA32F, n, n, 0, texels.data());
        expected.insert(expected.end(), texels.begin(), texels.end());
    }
    checkUnchanged([&] { probe.takeOver(sides, kind); }, "taking over");
    CHECK(tests::sameBits(read(probe.map()).colour, expected));
    CHECK(probe.map().distanceTexture == 0 && probe.map().nearestLevel == 0);
    for (const std::string& name : hostile.names()) {
        hostile.apply({name});
        checkUnchanged([&] { probe.takeOver(sides, kind); }, name.c_str());
        hostile.undo();
        if (!tests::sameBits(read(probe.map()).colour, expected))
            std::printf("%s: another image\n", name.c_str());
        CHECK(tests::sameBits(read(probe.map()).colour, expected));
    }
    auto wrong = sides;
    wrong[5] = makeTexture(target, GL_RGBA32F, n + 1, n, 0, nullptr);
    const auto refused = [&](ReflectionProbe& by, SideTarget as) {
        checkUnchanged([&] { CHECK_THROWS(by.takeOver(wrong, as), ErrorKind::badArgument); }, "a bad side");
    };
    refused(probe, kind);
    wrong[5] = 0;
    refused(probe, kind);
    wrong = sides;
    refused(probe, kind == SideTarget::texture2d ? SideTarget::rectangle : SideTarget::texture2d);
    ReflectionProbe tennisBall(descOf(MapKind::tennisBall));
    refused(tennisBall, kind);
    CHECK(tests::sameBits(read(probe.map()).colour, expected)); // the last good map
    glDeleteTextures(6, sides.data());
}

} // namespace

// [MAP]: that map only.
int main(int argc, char** argv)
{
    const headless::Context context;
    const std::string only = argc > 1 ? argv[1] : "";
    const tests::SixWalls walls(glm::vec3(0.0f), 8);
    tests::HostileState hostile;
    for (const MapInfo& info : maps()) {
        if (!only.empty() && info.name != only)
            continue;
        for (const int size : {16, 32, 45, 64, 128, 256})
            checkNearest(walls, info.kind, size);
        checkSupersampling(walls, info.kind, info.components == 1 ? 4 : 3);
        checkViews(walls, info.kind, LayerOrder::oneAtATime);
        checkViews(walls, info.kind, LayerOrder::allAtOnce);
        checkBoxes(info.kind);
        checkBorrowed(walls, info.kind, info.components == 1 ? 2 : 1);
    }
    checkTakenOver(GL_TEXTURE_2D, hostile);
    checkTakenOver(GL_TEXTURE_RECTANGLE, hostile);
    CHECK(tests::takeErrors().empty());
    return 0;
}
