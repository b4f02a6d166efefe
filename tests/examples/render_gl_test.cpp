// The program render against its own --reference, which is traced by other formulas: what the mirrors show,
// where everything is, several reflectors, positions far from the origin.
#include "examples/program.h"

#include <mirrorball/error.h>
#include <mirrorball/io/image.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

using tests::Scratch;

namespace {

const std::string program = RENDER_PROGRAM;

using Words = std::vector<std::string>;

Words operator+(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// An EXR of render, its top row first.
struct Picture
{
    int width, height;
    std::vector<glm::dvec3> values; // colour or position
    std::vector<double> distance;   // from the eye

    explicit Picture(const std::filesystem::path& file)
    {
        const mirrorball::io::ExrImage image = mirrorball::io::readExr(file);
        width = image.width;
        height = image.height;
        for (std::size_t index = 0; index < image.channels[0].values.size(); ++index) {
            const auto at = [&](const char* name) {
                return static_cast<double>(image.find(name)->values[index]);
            };
            values.emplace_back(at("R"), at("G"), at("B"));
            distance.push_back(at("Z"));
        }
    }

    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    const glm::dvec3& at(int x, int y) const { return values[index(x, y)]; }

    // The largest difference to the pixels around, 0 where all are the same; infinite where one of them is
    // not a number, at the border too.
    double unevenness(int x, int y) const
    {
        double largest = 0.0;
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i) {
                if (i < 0 || j < 0 || i >= width || j >= height)
                    return std::numeric_limits<double>::infinity();
                const double difference = glm::length(at(i, j) - at(x, y));
                if (!std::isfinite(difference))
                    return std::numeric_limits<double>::infinity();
                largest = std::max(largest, difference);
            }
        return largest;
    }
};

struct Pair
{
    Picture drawn, traced;
};

Pair both(const Scratch& scratch, const Words& words)
{
    tests::runWell(program, words + Words{"-o", scratch / "drawn.exr"});
    tests::runWell(program, words + Words{"--reference", "-o", scratch / "traced.exr"});
    const Pair pair{Picture(scratch / "drawn.exr"), Picture(scratch / "traced.exr")};
    CHECK(pair.drawn.width == pair.traced.width && pair.drawn.height == pair.traced.height);
    return pair;
}

// Of the pixels around which the traced picture varies by less than `evenness`, those that differ by more
// than `tolerance`, in per mille; at least a fifth of all pixels must be such.
double perMilleWrong(const Pair& pair, double evenness, double tolerance, const char* what)
{
    int compared = 0, wrong = 0;
    for (int y = 0; y < pair.drawn.height; ++y)
        for (int x = 0; x < pair.drawn.width; ++x) {
            if (!(pair.traced.unevenness(x, y) < evenness))
                continue;
            ++compared;
            wrong += glm::length(pair.drawn.at(x, y) - pair.traced.at(x, y)) < tolerance ? 0 : 1;
        }
    std::printf("%s: %d pixels compared, %d wrong\n", what, compared, wrong);
    CHECK(5 * compared > pair.drawn.width * pair.drawn.height);
    return 1e3 * wrong / compared;
}

double statistic(const std::filesystem::path& file, const std::string& name)
{
    const std::string text = tests::bytesOf(file);
    const std::size_t at = text.find("\"" + name + "\": ");
    CHECK(at != std::string::npos);
    return std::strtod(text.c_str() + at + name.size() + 4, nullptr);
}

// A ball so small that everything is infinitely far from it, close to the eye, so that the look-up by
// direction alone is right. It covers half of the picture's height.
const Words smallBall = {"builtin:room", "--reflector",     "sphere:0.01", "--at",     "1,0.5,-1",
                         "--eye",        "1.02,0.52,-0.96", "--look",      "1,0.5,-1", "--fov",
                         "50",           "--pixels",        "160x120",     "--far",    "100"};

// A texel of the map at this size is at most 0.5°; the colour changes within one only at edges, which are
// left out, and by shading, which is slow. A half float is good to 5e-4.
void testMirrorShowsTheRoom(const Scratch& scratch)
{
    for (const char* const map : {"tennis-ball", "tennis-ball-even", "dual-paraboloid", "cube",
                                  "equi-angular-cube", "octahedral", "equirectangular", "sphere-map"})
    {
        const Pair pair = both(scratch, smallBall + Words{"--map", map, "--probe-turn", "20,-40,70"});
        CHECK(perMilleWrong(pair, 0.03, 0.03, map) < 2.0);
    }
}

// On the scene itself both are right to the float's rounding; the mirror shows the place within a texel.
void testPositions(const Scratch& scratch)
{
    const Pair pair = both(scratch, smallBall + Words{"--view", "position"});
    const glm::dvec3 eye(1.02, 0.52, -0.96), ball(1.0, 0.5, -1.0);
    int onScene = 0, sceneWrong = 0, onBall = 0, ballWrong = 0;
    for (int y = 0; y < pair.drawn.height; ++y)
        for (int x = 0; x < pair.drawn.width; ++x) {
            const std::size_t index = pair.drawn.index(x, y);
            // From pixel to pixel the mirrored place moves much farther than the direct one.
            const double distance = pair.traced.distance[index];
            if (!(pair.traced.unevenness(x, y) < (distance > 0.1 ? 0.5 : 2.0)))
                continue;
            const glm::dvec3& traced = pair.traced.at(x, y);
            const double error = glm::length(pair.drawn.at(x, y) - traced);
            const bool isAsFar = std::abs(pair.drawn.distance[index] - distance) < 1e-4 * distance;
            if (distance > 0.1) {
                sceneWrong += error < 1e-3 * glm::length(traced - eye) && isAsFar ? 0 : 1;
                ++onScene;
            } else {
                // Half the diagonal of a texel is 0.0043 times the distance, more where the wall is seen at a
                // slant: at most 1 in 3 here.
                CHECK(isAsFar);
                ballWrong += error < 3 * 0.0043 * glm::length(traced - ball) ? 0 : 1;
                ++onBall;
            }
        }
    std::printf("positions: %d of the scene, %d wrong, %d in the ball, %d wrong\n", onScene, sceneWrong,
                onBall, ballWrong);
    CHECK(onScene > 4000 && onBall > 1000);
    // Steps of less than 0.5, such as those between books, are edges too; there a pixel may go either way.
    CHECK(sceneWrong * 1000 < onScene);
    CHECK(ballWrong * 200 < onBall);
}

// A million units away the picture is the same.
void testOffset(const Scratch& scratch)
{
    tests::runWell(program, smallBall + Words{"-o", scratch / "near.exr"});
    tests::runWell(program, smallBall + Words{"--offset", "1e6,-1e6,1e6", "-o", scratch / "far.exr"});
    const Pair pair{Picture(scratch / "far.exr"), Picture(scratch / "near.exr")};
    CHECK(perMilleWrong(pair, 0.03, 0.005, "a million away") == 0.0);
}

const std::array<glm::vec3, 6> faces = {glm::vec3(1, 0, 0), {0, 1, 1}, {0, 1, 0},
                                        {1, 0, 1},          {0, 0, 1}, {1, 1, 0}};

constexpr int faceSize = 64;

Words writeFaces(const Scratch& scratch)
{
    Words files;
    for (const glm::vec3& face : faces) {
        files.push_back(scratch / ("face" + std::to_string(files.size()) + ".png"));
        std::vector<float> texels;
        for (int texel = 0; texel < faceSize * faceSize; ++texel)
            texels.insert(texels.end(), {face.r, face.g, face.b});
        mirrorball::io::writePng(files.back(), {faceSize, faceSize, 3, texels});
    }
    return files;
}

// One ball mirrors six images, its neighbour a capture of this frame, in which the first is a plain object.
void testTwoReflectors(const Scratch& scratch)
{
    const Words words =
        Words{"builtin:room", "--eye",   "0,0,6",       "--look",   "0,0,0", "--fov",    "40",
              "--pixels",     "200x120", "--reflector", "sphere:1", "--at",  "-1.5,0,0", "--source"} +
        writeFaces(scratch) + Words{"--reflector", "sphere:1", "--at", "1.5,0,0"};
    const Pair pair = both(scratch, words);

    // The left ball by itself: faces are constant but for a texel on each side of their borders, and none of its
    // pixels depends on where the ball is.
    const double tangent = std::tan(0.5 * 40.0 * std::numbers::pi / 180.0);
    int compared = 0;
    std::array<int, 6> seen{};
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 100; ++x) {
            const glm::dvec3 ray = glm::normalize(
                glm::dvec3((2 * x + 1 - 200) / 120.0 * tangent, (120 - 2 * y - 1) / 120.0 * tangent, -1.0));
            const glm::dvec3 fromCentre = glm::dvec3(0, 0, 6) - glm::dvec3(-1.5, 0, 0);
            const double middle = -glm::dot(fromCentre, ray);
            const glm::dvec3 nearest = fromCentre + middle * ray;
            // Near the outline rounding decides.
            if (glm::length(nearest) > 0.99)
                continue;
            const glm::dvec3 normal = nearest - std::sqrt(1.0 - glm::dot(nearest, nearest)) * ray;
            const glm::dvec3 mirrored = ray - 2.0 * glm::dot(ray, normal) * normal;
            const glm::dvec3 size = glm::abs(mirrored);
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            std::array<double, 3> sorted = {size.x, size.y, size.z};
            std::sort(sorted.begin(), sorted.end());
            if (sorted[1] > (1.0 - 2.0 / faceSize) * sorted[2])
                continue;
            const int face = 2 * axis + (mirrored[axis] < 0.0 ? 1 : 0);
            CHECK(glm::length(pair.drawn.at(x, y) - glm::dvec3(faces[static_cast<std::size_t>(face)])) <
                  1e-3);
            ++seen[static_cast<std::size_t>(face)];
            ++compared;
        }
    std::printf("six images: %d pixels\n", compared);
    CHECK(compared > 1000);
    CHECK(*std::min_element(seen.begin(), seen.end()) > 0);

    // The right ball mirrors grey where its neighbour is: the traced picture has it in the same place within
    // the parallax of a look-up by direction alone, so some pixel there is near the reflector's own grey in
    // both.
    const auto greyest = [](const Picture& picture) {
        int grey = 0;
        for (int y = 40; y < 80; ++y)
            for (int x = 105; x < 130; ++x) {
                const glm::dvec3 c = picture.at(x, y);
                grey += std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) < 0.01 ? 1 : 0;
            }
        return grey;
    };
    std::printf("grey neighbour: %d drawn, %d traced\n", greyest(pair.drawn), greyest(pair.traced));
    CHECK(greyest(pair.drawn) > 10 && greyest(pair.traced) > 10);
}

// How many pixels a sphere covers: its outline is a circle of angular radius asin(r / d), at any distance.
void testTrueSphere(const Scratch& scratch)
{
    for (const double distance : {3.0, 1e5}) {
        const double angle = std::asin(1.0 / distance);
        char eye[32], fov[32];
        std::snprintf(eye, sizeof eye, "0,0,%g", distance);
        std::snprintf(fov, sizeof fov, "%.9g", 4.0 * angle * 180.0 / std::numbers::pi);
        const Words words = {"builtin:garden",
                             "--reflector",
                             "sphere:1",
                             "--eye",
                             eye,
                             "--fov",
                             fov,
                             "--pixels",
                             "200x200",
                             "--stats",
                             scratch / "stats.json"};
        tests::runWell(program, words + Words{"-o", scratch / "sphere.png"});
        const double radius = 100.0 * std::tan(angle) / std::tan(2.0 * angle); // in pixels
        // The mean error of counting a disc's pixels grows with the square root of its radius; this is ten
        // times that.
        CHECK_NEAR(statistic(scratch / "stats.json", "reflector_pixels"), std::numbers::pi * radius * radius,
                   10.0 * std::sqrt(radius));
    }
    // From within nothing of it is seen.
    tests::runWell(program,
                   {"builtin:room", "--reflector", "sphere:1", "--eye", "0.3,0.2,0.1", "--look", "0,0,-2",
                    "--pixels", "64x48", "--stats", scratch / "stats.json", "-o", scratch / "within.png"});
    CHECK(statistic(scratch / "stats.json", "reflector_pixels") == 0.0);
}

void testMesh(const Scratch& scratch)
{
    const Words words = {"builtin:room",
                         "--reflector",
                         "teapot",
                         "--scale",
                         "0.5",
                         "--blend",
                         "0",
                         "--pixels",
                         "200x150",
                         "--stats",
                         scratch / "stats.json"};
    const Pair pair = both(scratch, words);
    const double traced = statistic(scratch / "stats.json", "reflector_pixels");
    std::printf("teapot: %g pixels\n", traced);
    tests::runWell(program, words + Words{"-o", scratch / "again.exr"});
    const double drawn = statistic(scratch / "stats.json", "reflector_pixels");
    CHECK(traced > 2000);
    CHECK_NEAR(drawn, traced, 0.005 * traced); // only along the outline
    // Without reflection everything agrees but at edges: half floats in the file, 5e-4 of at most 2.
    CHECK(perMilleWrong(pair, 0.05, 5e-3, "teapot of its own colour") < 1.0);
}

// k × k samples are averaged: an edge pixel lies between its neighbours, and even areas stay as they are.
void testSupersample(const Scratch& scratch)
{
    const Words once = {smallBall[0], "--reflector",     "sphere:0.01", "--at",     "1,0.5,-1",
                        "--eye",      "1.02,0.52,-0.96", "--look",      "1,0.5,-1", "--fov",
                        "50",         "--pixels",        "80x60"};
    tests::runWell(program, once + Words{"-o", scratch / "1.exr"});
    tests::runWell(program, once + Words{"--supersample", "3", "-o", scratch / "3.exr"});
    const Pair pair{Picture(scratch / "3.exr"), Picture(scratch / "1.exr")};
    CHECK(pair.drawn.width == 80 && pair.drawn.height == 60);
    // Some pixels hold an object too small for a sample in each pixel around.
    CHECK(perMilleWrong(pair, 0.03, 0.03, "3 by 3 samples") < 20.0);
    // The middle one of 3 × 3 is the pixel's centre, but for the snapping of rasterisers that interpolate what they
    // snap.
    for (std::size_t index = 0; index < pair.drawn.distance.size(); ++index)
        CHECK_NEAR(pair.drawn.distance[index], pair.traced.distance[index],
                   5e-4 * pair.traced.distance[index]);
}

} // namespace

int main()
{
    const Scratch scratch;
    testMirrorShowsTheRoom(scratch);
    testPositions(scratch);
    testOffset(scratch);
    testTwoReflectors(scratch);
    testTrueSphere(scratch);
    testMesh(scratch);
    testSupersample(scratch);
}
