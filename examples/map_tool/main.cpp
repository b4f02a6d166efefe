// Maps on the command line: directions to texture coordinates and back, the GLSL of a map, how well maps
// sample.
#include "command_line.h"

#include <mirrorball/error.h>
#include <mirrorball/maps/glsl.h>
#include <mirrorball/maps/measures.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <vector>

namespace {

using mirrorball::Error;
using mirrorball::ErrorKind;
using mirrorball::MapKind;

// Measures take a minute there, and change little beyond.
constexpr int largestSide = 8192;

struct Options
{
    MapKind map = MapKind::tennisBall;
    std::optional<MapKind> measured; // none: all
    bool inDouble = false;
    mirrorball::GlslVersion version = mirrorball::GlslVersion::glsl330;
    std::string prefix = "mirrorball_";
    std::optional<int> size; // none: from texels
    double texels = 6 * 256 * 256;
};

// ---- forward and inverse: one answer a line --------------------------------------------------------

constexpr std::size_t longestQuote = 60; // of a line, in a message

[[noreturn]] void refuseLine(int number, const std::string& line, const std::string& wanted)
{
    throw Error(ErrorKind::badArgument, "line " + std::to_string(number) + " of the input",
                "'" + line.substr(0, longestQuote) + "' does not parse", "give " + wanted);
}

std::vector<std::string> words(const std::string& line)
{
    std::istringstream stream(line);
    std::vector<std::string> result;
    for (std::string word; stream >> word;)
        result.push_back(word);
    return result;
}

// Prints nothing before the last line has been read. Empty lines give nothing.
void answerLines(const std::string& wanted,
                 const std::function<std::optional<std::string>(const std::vector<std::string>&)>& answer)
{
    std::string output;
    std::string line;
    for (int number = 1; std::getline(std::cin, line); ++number) {
        const std::vector<std::string> parts = words(line);
        if (parts.empty())
            continue;
        const auto text = parts.size() == 3 ? answer(parts) : std::nullopt;
        if (!text)
            refuseLine(number, line, wanted);
        output += *text;
    }
    std::fputs(output.c_str(), stdout);
}

// As many digits as tell all numbers of the kind apart: 9 for float, 17 for double.
template <class Number>
std::string digits(Number number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", std::numeric_limits<Number>::max_digits10, double(number));
    return text;
}

// All of the word: decimal, C hex float, inf or nan. Read at its own precision, so that nothing is rounded
// twice.
template <class Number>
std::optional<Number> numberFromText(const std::string& text)
{
    char* end = nullptr;
    Number number;
    if constexpr (std::is_same_v<Number, float>)
        number = std::strtof(text.c_str(), &end);
    else
        number = std::strtod(text.c_str(), &end);
    return end == text.c_str() + text.size() ? std::optional(number) : std::nullopt;
}

template <class Number>
void forward(const Options& options)
{
    answerLines("three numbers: x y z",
                [&](const std::vector<std::string>& parts) -> std::optional<std::string> {
                    glm::vec<3, Number, glm::defaultp> direction;
                    for (int i = 0; i < 3; ++i) {
                        const auto number = numberFromText<Number>(parts[static_cast<std::size_t>(i)]);
                        if (!number)
                            return std::nullopt;
                        direction[i] = *number;
                    }
                    const auto [component, uv] = mirrorball::coordinateFromDirection(options.map, direction);
                    return std::to_string(component) + " " + digits(uv.x) + " " + digits(uv.y) + "\n";
                });
}

// -1 where it is none.
int componentFromText(const std::string& text, int components)
{
    for (int component = 0; component < components; ++component)
        if (text == std::to_string(component))
            return component;
    return -1;
}

template <class Number>
void inverse(const Options& options)
{
    const int components = mirrorball::mapInfo(options.map).components;
    answerLines("a component below " + std::to_string(components) + " and two numbers: component u v",
                [&](const std::vector<std::string>& parts) -> std::optional<std::string> {
                    const int component = componentFromText(parts[0], components);
                    const auto u = numberFromText<Number>(parts[1]);
                    const auto v = numberFromText<Number>(parts[2]);
                    if (component < 0 || !u || !v)
                        return std::nullopt;
                    const glm::vec<2, Number, glm::defaultp> uv(*u, *v);
                    const auto d = mirrorball::directionFromSquare(options.map, component, uv);
                    return digits(d.x) + " " + digits(d.y) + " " + digits(d.z) + "\n";
                });
}

// ---- measure ---------------------------------------------------------------------------------------

void printMeasures(const mirrorball::MapInfo& map, const Options& options)
{
    const int n = options.size ? *options.size : mirrorball::shortSideFromTexels(map.kind, options.texels);
    const mirrorball::MapMeasures m = mirrorball::mapMeasures(map.kind, n);
    constexpr double degrees = 180 / std::numbers::pi;
    const std::string size =
        std::to_string(map.components) + "x" + std::to_string(m.width) + "x" + std::to_string(m.height);
    std::printf("%-18s %12s %9lld %7.2f %9.4f %9.4f %9.4f %9.4f %9.4g %9.4g %9.4g\n", map.name.data(),
                size.c_str(), m.texels, 100.0 * static_cast<double>(m.used) / static_cast<double>(m.texels),
                m.worstDiagonal * degrees, m.meanDiagonal * degrees, m.largestSolidAngle,
                m.smallestSolidAngle, m.largestSolidAngle / m.smallestSolidAngle, m.worstStretch,
                m.meanStretch);
}

void measure(const Options& options)
{
    std::printf("%-18s %12s %9s %7s %9s %9s %9s %9s %9s %9s %9s\n", "map", "layers,size", "texels", "used_%",
                "diag_max", "diag_mean", "solid_max", "solid_min", "max/min", "aniso_max", "aniso_mean");
    for (const mirrorball::MapInfo& map : mirrorball::maps())
        if (!options.measured || *options.measured == map.kind)
            printMeasures(map, options);
}

void checkMeasured(const Options& options)
{
    if (options.size && (*options.size < 1 || *options.size > largestSide))
        throw Error(ErrorKind::badArgument, "--size " + std::to_string(*options.size), "not allowed",
                    "give 1 to " + std::to_string(largestSide));
    if (!(options.texels >= 1 && options.texels <= double(largestSide) * largestSide))
        throw Error(ErrorKind::badArgument, "--texels " + digits(float(options.texels)), "not allowed",
                    "give 1 to " + std::to_string(largestSide) + " squared");
}

// ---- The verbs -------------------------------------------------------------------------------------

void addPrecision(CLI::App& verb, Options& options)
{
    examples::addChoice<bool>(verb, "--precision", options.inDouble, {{"float", false}, {"double", true}},
                              "arithmetic");
}

void addForward(CLI::App& app, Options& options)
{
    CLI::App* const verb = app.add_subcommand("forward", "Read lines \"x y z\", print \"component u v\"");
    examples::addMap(*verb, options.map);
    addPrecision(*verb, options);
    verb->callback([&options] { options.inDouble ? forward<double>(options) : forward<float>(options); });
}

void addInverse(CLI::App& app, Options& options)
{
    CLI::App* const verb =
        app.add_subcommand("inverse", "Read lines \"component u v\", print \"x y z\", unit length");
    examples::addMap(*verb, options.map);
    addPrecision(*verb, options);
    verb->callback([&options] { options.inDouble ? inverse<double>(options) : inverse<float>(options); });
}

void addGlsl(CLI::App& app, Options& options)
{
    using enum mirrorball::GlslVersion;
    CLI::App* const verb = app.add_subcommand("glsl", "Print a map's GLSL functions");
    examples::addMap(*verb, options.map);
    examples::addChoice<mirrorball::GlslVersion>(
        *verb, "--version", options.version,
        {{"330", glsl330}, {"400", glsl400}, {"450", glsl450}, {"300es", es300}}, "GLSL version");
    verb->add_option("--prefix", options.prefix, "what every name begins with")->capture_default_str();
    verb->callback([&options] {
        std::fputs(mirrorball::mapGlsl(options.map, options.version, options.prefix).c_str(), stdout);
    });
}

void addMeasure(CLI::App& app, Options& options)
{
    CLI::App* const verb = app.add_subcommand(
        "measure", "Print texel angles (degrees), solid angles (1 = equal) and anisotropy");
    std::vector<std::pair<std::string, std::optional<MapKind>>> choices{{"all", std::nullopt}};
    for (const mirrorball::MapInfo& map : mirrorball::maps())
        choices.emplace_back(map.name, map.kind);
    examples::addChoice(*verb, "--map", options.measured, choices, "the map");
    CLI::Option* const size = examples::addOptionalInteger(*verb, "--size", options.size,
                                                           "texels across the short side", "from --texels");
    examples::addNumber(*verb, "--texels", options.texels, "texels in all, as near as a whole --size comes")
        ->excludes(size);
    verb->callback([&options] {
        checkMeasured(options);
        measure(options);
    });
}

void refuseConvert(CLI::App& app)
{
    CLI::App* const verb = app.add_subcommand("convert", "Not in this version")->group("");
    verb->allow_extras()->callback([] {
        throw Error(ErrorKind::unknownName, "map_tool convert", "not in this version of mirrorball",
                    "use forward, inverse, glsl or measure");
    });
}

void addVerbs(CLI::App& app, Options& options)
{
    // Not require_subcommand(1), which would hide the name of an unknown one.
    app.require_subcommand(0, 1);
    app.callback([&app] {
        if (app.get_subcommands().empty())
            throw CLI::RequiredError("A subcommand");
    });
    addForward(app, options);
    addInverse(app, options);
    addGlsl(app, options);
    addMeasure(app, options);
    refuseConvert(app);
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    return examples::runProgram(
        "map_tool", "Sphere maps: coordinates, GLSL and measures", argc, argv,
        [&](CLI::App& app) { addVerbs(app, options); },
        [] {
            if (std::fflush(stdout) != 0 || std::ferror(stdout))
                throw Error(ErrorKind::unwritable, "standard output", "cannot be written");
        });
}
