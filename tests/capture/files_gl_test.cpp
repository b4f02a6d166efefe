// What the program writes with --method exact against what it writes with --reference, as a user compares them:
// every texel of every map, near the origin and, drawn from near to far, 1e6 units away.
//
//     files_gl_test [SCENE [N [x y z]]]
#include "examples/program.h"
#include "io/scratch.h"
#include "support/check.h"
#include "support/exactness.h"

#include <mirrorball/io/image.h>

#include <cstdio>

using namespace mirrorball;

namespace {

tests::Seen seenAt(const io::ExrImage& image, std::size_t texel)
{
    const auto distance = static_cast<double>(image.find("Z")->values[texel]);
    if (std::isinf(distance))
        return {};
    return {static_cast<std::uint32_t>(image.find("R")->values[texel] + 0.5f), distance};
}

std::string vectorText(const glm::dvec3& v)
{
    char text[128];
    std::snprintf(text, sizeof text, "%a,%a,%a", v.x, v.y, v.z);
    return text;
}

// `at` moves with the scene's offset.
void check(const examples::Scene& scene, const std::string& file, const glm::dvec3& at, const MapInfo& info,
           int n)
{
    const tests::Scratch folder;
    const std::string exact = folder / "exact", reference = folder / "reference";
    const std::vector<std::string> common = {
        file,       "--map", std::string(info.name), "--size",   std::to_string(n),       "--view",
        "triangle", "--at",  vectorText(at),         "--offset", vectorText(scene.offset)};
    const auto written = [&](std::vector<std::string> more, const std::string& prefix) {
        more.insert(more.begin(), common.begin(), common.end());
        more.insert(more.end(), {"-o", prefix});
        tests::runWell(CAPTURE_PROGRAM, more);
    };
    std::vector<std::string> drawing = {"--method", "exact"};
    if (scene.offset != glm::dvec3(0.0))
        drawing.push_back("--near-first");
    written(drawing, exact);
    written({"--reference"}, reference);

    const int width = info.widthInN * n, height = info.heightInN * n;
    tests::Exactness total;
    for (int component = 0; component < info.components; ++component) {
        const std::string ending = "_" + std::to_string(component) + ".exr";
        const io::ExrImage shown = io::readExr(exact + ending), traced = io::readExr(reference + ending);
        CHECK(shown.width == width && shown.height == height);
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const glm::dvec3 direction = examples::referenceDirection(
                    info.name, component, (column + 0.5) / width, (row + 0.5) / height);
                const std::size_t texel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(column);
                tests::compare(total, scene, scene.offset + at, direction, seenAt(shown, texel),
                               seenAt(traced, texel));
            }
    }
    std::printf("%s, offset %g: n = %d, %s: wrong %.5f %% (%zu of %zu, %zu far off), distance %.2g\n",
                file.c_str(), scene.offset.x, n, std::string(info.name).c_str(), total.wrongPercent(),
                total.wrong, total.texels, total.wrongFarOff, total.worstDistance);
    CHECK(total.shown > 0);
    CHECK(total.wrongPercent() <= 0.01);
    CHECK(total.wrongFarOff == 0);
    CHECK(total.worstDistance <= 1e-4);
}

} // namespace

int main(int argc, char** argv)
{
    const std::string file = argc > 1 ? argv[1] : "builtin:room";
    const int n = argc > 2 ? std::atoi(argv[2]) : 16;
    // By default where floats are unfriendly.
    const glm::dvec3 at = argc > 5 ? glm::dvec3(std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5]))
                                   : glm::dvec3(0.1, 1.0 / 3.0, 0.01);
    examples::Scene scene = examples::loadScene(file);
    for (const MapInfo& info : maps())
        for (const double offset : {0.0, 1e6}) {
            scene.offset = glm::dvec3(offset, -offset, offset);
            check(scene, file, at, info, n);
        }
    return 0;
}
