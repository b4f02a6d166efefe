#include "options.h"

#include "stats.h"

#include <mirrorball/error.h>

#include <mirrorball/io/image.h>

#include <CLI/CLI.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace render {

namespace {

using namespace examples;
using mirrorball::Error;
using mirrorball::ErrorKind;

// Refuses what only later versions know, by name.
CLI::Validator notYet(const std::vector<std::string>& later)
{
    const auto check = [later](const std::string& text) {
        const bool isLater = std::find(later.begin(), later.end(), text) != later.end();
        return isLater ? "'" + text + "' is not in this version" : std::string();
    };
    return {check, ""};
}

void requirePositive(double value, const std::string& option)
{
    if (!(value > 0.0) || !std::isfinite(value))
        throw Error(ErrorKind::badArgument, option, "it is not a positive number", "give one above 0");
}

void requireAllowed(const ReflectorOptions& reflector)
{
    requireFinite(reflector.at, "--at");
    requireFinite(reflector.turn, "--probe-turn");
    requireFinite(reflector.tint, "--tint");
    if (glm::any(glm::lessThan(reflector.tint, glm::dvec3(0.0))))
        throw Error(ErrorKind::badArgument, "--tint", "a colour of it is negative", "give 0 or more");
    requirePositive(reflector.scale, "--scale");
    if (!(reflector.blend >= 0.0 && reflector.blend <= 1.0))
        throw Error(ErrorKind::badArgument, "--blend", "it is not between 0 and 1",
                    "0 is the reflector's own colour, 1 a perfect mirror");
}

void requireOutput(const Options& options)
{
    const std::string extension = std::filesystem::path(options.output).extension().string();
    if (extension != ".png" && extension != ".exr")
        throw Error(ErrorKind::badArgument, "the output '" + options.output + "'",
                    "its extension is neither .png nor .exr", "name it so");
    if (options.view == View::position && extension == ".png")
        throw Error(ErrorKind::badArgument, "--view position", "a PNG cannot hold it", "write an .exr");
    requireApart(options.stats, {options.output});
}

} // namespace

void CommandLine::addTo(CLI::App& app)
{
    addCaptureOptions(app, options_);
    addReflectorOptions(app);
    addCameraOptions(app);
    using mirrorball::Lookup;
    addChoice<Lookup>(app, "--lookup", options_.lookup,
                      {{"infinite", Lookup::infinite},
                       {"sphere", Lookup::sphere},
                       {"box", Lookup::box},
                       {"distance", Lookup::distance},
                       {"layered", Lookup::layered}},
                      "how a reflected ray finds its place in the map");
    using mirrorball::LevelOfDetail;
    addChoice<LevelOfDetail>(app, "--detail", options_.detail,
                             {{"first", LevelOfDetail::first},
                              {"isotropic", LevelOfDetail::isotropic},
                              {"anisotropic", LevelOfDetail::anisotropic}},
                             "the mip level that a mirroring pixel is filtered from");
    addOptionalVector(
        app, "--proxy-low", options_.proxyLow,
        "lower corner of the box, or of the ellipsoid's, that --lookup takes the surroundings for",
        "the scene's");
    addOptionalVector(app, "--proxy-high", options_.proxyHigh, "its upper corner", "the scene's");
    addChoice<View>(
        app, "--view", options_.view, {{"colour", View::colour}, {"position", View::position}},
        "what is written: the picture, or the world position of what is seen, in the mirrors too");
    addOptionalNumber(app, "--near", options_.near, "nearest radial distance from the probe",
                      "0.9 times the reflector's smallest half extent");
    addRequiredText(app, "-o,--output", options_.output, "OUT.png|exr",
                    "the picture, by its extension a PNG or an EXR");
    refuseOptions(app, {"--ior", "--roughness", "--blur"});
}

void CommandLine::addReflectorOptions(CLI::App& app)
{
    const std::string group =
        "Reflectors (given after a --reflector: for that one; before the first: for all)";
    const auto perReflector = [&](CLI::Option* option) { option->trigger_on_parse()->group(group); };
    perReflector(app.add_option_function<std::string>(
                        "--reflector", [this](const std::string& shape) { beginReflector(shape); },
                        "sphere:radius, teapot or a model file; may be repeated")
                     ->type_name("SHAPE")
                     ->default_str(current_.shape));
    perReflector(addVector(app, "--at", current_.at, "the centre of reflector and probe"));
    perReflector(addNumber(app, "--scale", current_.scale, "multiplies the reflector's own units"));
    perReflector(addVector(app, "--probe-turn", current_.turn,
                           "turns the probe, or the source, about x, then y, then z, in degrees"));
    perReflector(
        app.add_option_function<std::vector<std::string>>(
               "--source", [this](const std::vector<std::string>& files) { current_.source = files; },
               "mirrors images instead of the scene: six of a cube, +X -X +Y -Y +Z -Z, or one panorama "
               "(2:1), or one sphere-map image (1:1)")
            ->expected(1, 6)
            ->check(notAnOption)
            ->type_name("FILE"));
    perReflector(addNumber(app, "--blend", current_.blend, "0: its own colour only, 1: reflection only"));
    perReflector(addVector(app, "--tint", current_.tint, "multiplied onto the reflection, linear r,g,b"));
    static const std::vector<std::pair<std::string, int>> materials = {{"mirror", 0}};
    perReflector(
        addChoice(app, "--material", material_, materials, "what it is made of")
            ->check(notYet({"refract", "glass", "water", "diamond", "fresnel", "rough", "diffuse"})));
}

void CommandLine::addCameraOptions(CLI::App& app)
{
    addOptionalVector(app, "--eye", options_.eye, "where the camera is", "in front of the first reflector");
    addOptionalVector(app, "--look", options_.look, "what it looks at", "the first reflector");
    addVector(app, "--up", options_.up, "upwards in the picture");
    addNumber(app, "--fov", options_.fov, "vertical field of view in degrees");
    addSize(app, "--pixels", options_.pixels, "size of the picture");
    addInteger(app, "--supersample", options_.supersample,
               "k by k samples a pixel in what is written; times are those of one");
}

void CommandLine::beginReflector(const std::string& shape)
{
    if (hasReflector_)
        options_.reflectors.push_back(current_);
    else
        defaults_ = current_;
    hasReflector_ = true;
    current_ = defaults_;
    current_.shape = shape;
}

Options CommandLine::options() const
{
    Options options = options_;
    options.reflectors.push_back(current_);
    return options;
}

void requireAllowed(const Options& options)
{
    examples::requireAllowed(options);
    for (const ReflectorOptions& reflector : options.reflectors)
        requireAllowed(reflector);
    requireFinite(options.eye.value_or(glm::dvec3(0.0)), "--eye");
    requireFinite(options.look.value_or(glm::dvec3(0.0)), "--look");
    requireFinite(options.proxyLow.value_or(glm::dvec3(0.0)), "--proxy-low");
    requireFinite(options.proxyHigh.value_or(glm::dvec3(0.0)), "--proxy-high");
    if (options.proxyLow && options.proxyHigh &&
        !glm::all(glm::lessThan(*options.proxyLow, *options.proxyHigh)))
        throw Error(ErrorKind::badArgument, "--proxy-low and --proxy-high",
                    "the lower corner is not below the upper one in x, y and z", "give the box's corners so");
    requireFinite(options.up, "--up");
    if (!(options.fov > 0.0 && options.fov < 180.0))
        throw Error(ErrorKind::badArgument, "--fov", "it is not between 0 and 180 degrees", "try 45");
    if (options.supersample < 1 || options.supersample > 16)
        throw Error(ErrorKind::badArgument, "--supersample " + std::to_string(options.supersample),
                    "it is not between 1 and 16", "try 3");
    const glm::dvec2 samples = glm::dvec2(options.pixels) * static_cast<double>(options.supersample);
    if (!(samples.x >= 1.0 && samples.y >= 1.0) ||
        samples.x * samples.y > static_cast<double>(mirrorball::io::maxPixels))
        throw Error(ErrorKind::badArgument,
                    "--pixels " + std::to_string(options.pixels.x) + "x" + std::to_string(options.pixels.y),
                    "a picture has 1 to " + std::to_string(mirrorball::io::maxPixels) + " samples",
                    "ask for a size in that range");
    requireOutput(options);
}

} // namespace render
