// render: both passes. Draws a scene with mirrors in it; with --reference the same picture is traced with
// Embree instead.
#include "command_line.h"
#include "draw.h"
#include "options.h"
#include "setup.h"
#include "stats.h"
#include "trace.h"

#include <algorithm>
#include <iostream>

namespace {

void run(const render::Options& options)
{
    render::requireAllowed(options);
    const render::Setup setup = render::setupOf(options);
    examples::Stats stats;
    stats.add("scene", options.scene);
    stats.add("map", std::string(mirrorball::mapInfo(options.map).name));
    stats.add("size", options.size);
    render::Picture picture =
        options.reference ? render::tracePicture(setup, options) : render::drawPicture(setup, options, stats);
    picture = render::reduced(picture, options.supersample, options.view);
    const auto reflectorPixels = std::count_if(picture.reflectors.begin(), picture.reflectors.end(),
                                               [](int reflector) { return reflector > 0; });
    stats.add("pixels", static_cast<double>(picture.samples.size()));
    stats.add("reflector_pixels", static_cast<double>(reflectorPixels));
    examples::writeWithStats(stats, options.stats,
                             [&] { render::writePicture(picture, options.view, options.output); });
    std::cout << options.output << '\n';
}

} // namespace

int main(int argc, char** argv)
{
    render::CommandLine line;
    return examples::runProgram(
        "render", "Draws a scene with mirrors in it, in two passes.", argc, argv,
        [&](CLI::App& app) { line.addTo(app); }, [&] { run(line.options()); });
}
