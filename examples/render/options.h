// The command line of render.
#pragma once

#include "capture_options.h"
#include "map_file.h"

#include <mirrorball/reflect/reflection_material.h>

#include <optional>
#include <string>
#include <vector>

namespace render {

// One reflector: what is given after its --reflector, and for the rest what was given before the first one.
struct ReflectorOptions
{
    std::string shape = "sphere:1"; // or teapot, or a model file
    glm::dvec3 at{0.0};             // the centre of reflector and probe, before --offset
    double scale = 1.0;
    glm::dvec3 turn{0.0};            // of the probe, or of the source, in degrees about x, y, z
    std::vector<std::string> source; // image files that it mirrors instead of the scene
    double blend = 1.0;
    glm::dvec3 tint{1.0};
};

struct Options : examples::CaptureOptions
{
    std::vector<ReflectorOptions> reflectors; // at least one
    std::optional<glm::dvec3> eye, look;      // before --offset
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fov = 45.0; // vertical, in degrees
    glm::ivec2 pixels{640, 480};
    int supersample = 1;        // k × k samples a pixel
    std::optional<double> near; // of the probes
    mirrorball::Lookup lookup = mirrorball::Lookup::infinite;
    mirrorball::LevelOfDetail detail = mirrorball::LevelOfDetail::first;
    std::optional<glm::dvec3> proxyLow, proxyHigh; // corners of the proxy, before --offset
    examples::View view = examples::View::colour;
    std::string output;
};

// Collects the options while they are parsed, and has to stay where it is meanwhile.
class CommandLine
{
public:
    CommandLine() = default;
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    void addTo(CLI::App& app);

    // After parsing.
    Options options() const;

private:
    void addReflectorOptions(CLI::App& app);
    void addCameraOptions(CLI::App& app);
    void beginReflector(const std::string& shape);

    Options options_;
    ReflectorOptions defaults_, current_; // `current_` is filled by the options as they come
    bool hasReflector_ = false;
    int material_ = 0; // mirror, the only one yet
};

// Throws mirrorball::Error, badArgument, for values that are not allowed.
void requireAllowed(const Options& options);

} // namespace render
