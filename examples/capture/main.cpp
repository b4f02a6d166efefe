// capture: pass 1 by itself. Draws a scene, seen from a point, into a map and writes one EXR a component;
// with
// --reference the same texels are traced with Embree instead.
#include "command_line.h"
#include "gl_scene.h"
#include "map_file.h"
#include "reference.h"
#include "stats.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <iostream>
#include <optional>

namespace {

using namespace examples;
using mirrorball::CaptureMethod;
using mirrorball::MapKind;

struct Options
{
    std::string scene;
    glm::dvec3 at{0.0};
    glm::dvec3 turn{0.0}; // degrees about x, y, z
    glm::dvec3 offset{0.0};
    std::optional<glm::dvec3> light;
    MapKind map = MapKind::tennisBall;
    int size = 256;
    CaptureMethod method = CaptureMethod::perVertex;
    double near = 0.05;
    double far = 10000.0;
    View view = View::colour;
    bool reference = false;
    int frames = 1;
    std::string prefix;
    std::string stats;
};

using Files = std::vector<std::pair<std::filesystem::path, mirrorball::io::ExrImage>>;

glm::dmat4 poseOf(const Options& options)
{
    glm::dmat4 pose = glm::translate(glm::dmat4(1.0), options.at + options.offset);
    pose = glm::rotate(pose, glm::radians(options.turn.z), {0, 0, 1});
    pose = glm::rotate(pose, glm::radians(options.turn.y), {0, 1, 0});
    return glm::rotate(pose, glm::radians(options.turn.x), {1, 0, 0});
}

glm::dvec3 lightOf(const Options& options, const Scene& scene)
{
    return (options.light ? *options.light : glm::dvec3(scene.light)) + options.offset;
}

std::filesystem::path fileName(const Options& options, int component)
{
    return options.prefix + "_" + std::to_string(component) + ".exr";
}

// The same checks as a capture makes, for --reference, which needs no OpenGL.
void requireAllowed(const Options& options)
{
    if (options.size < 1 || options.size > 16384)
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--size " + std::to_string(options.size),
                                "a map has 1 to 16384 texels across", "ask for a size in that range");
    if (!(options.near > 0.0) || !std::isfinite(options.near) || !(options.far > options.near))
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--near and --far",
                                "they are not 0 < near < far", "give such numbers");
    for (const glm::dvec3& point :
         {options.at, options.turn, options.offset, options.light.value_or(glm::dvec3(0.0))})
        if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
            throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "a vector",
                                    "a coordinate is not finite", "give finite numbers");
    if (options.frames < 1)
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--frames", "it is less than 1",
                                "give 1 or more");
}

Files drawMap(const Options& options, const Scene& scene, Stats& stats)
{
    const mirrorball::headless::Context context;
    mirrorball::ReflectionProbe::Desc desc;
    desc.map = options.map;
    desc.n = options.size;
    desc.worldFromProbe = poseOf(options);
    desc.captureOrigin = options.at + options.offset;
    desc.near = static_cast<float>(options.near);
    desc.far = static_cast<float>(options.far);
    desc.colour = options.view == View::colour || options.view == View::normal
                      ? mirrorball::ColourFormat::rgba16f
                      : mirrorball::ColourFormat::rgba32f;
    desc.background = glm::vec4(scene.background, 1.0f);
    desc.method = options.method;
    mirrorball::ReflectionProbe probe(desc);
    const GlScene drawable(scene, desc.captureOrigin);
    mirrorball::CaptureProgram program({.name = "phong",
                                        .vertexSource = phongVertexSource(),
                                        .fragmentSource = phongFragmentSource(options.view)});
    const std::vector<mirrorball::CaptureMesh> meshes = drawable.captureMeshes(program);
    const PhongView phong{glm::vec3(lightOf(options, scene) - desc.captureOrigin), glm::vec3(0.0f)};
    const auto draw = [&](const mirrorball::CaptureMesh& mesh, const mirrorball::CaptureDraw& call) {
        drawable.drawMesh(mesh.id, call.program, phong);
    };
    mirrorball::CaptureReport report = probe.capture(meshes, draw); // compiles what it needs
    std::vector<double> wall, cpu;
    for (int frame = 0; frame < options.frames; ++frame) {
        Stopwatch watch;
        report = probe.capture(meshes, draw);
        wall.push_back(watch.wallMilliseconds());
        cpu.push_back(watch.cpuMilliseconds());
    }
    stats.add("driver", context.description());
    stats.add("pass1_wall_ms", median(wall));
    stats.add("pass1_cpu_ms", median(cpu));
    stats.add("draws", report.draws);
    stats.add("draws_culled", report.drawsCulled);
    stats.add("triangles", static_cast<double>(report.triangles));
    stats.add("scene_triangles", static_cast<double>(drawable.triangleCount()));
    stats.add("texels", static_cast<double>(report.texels));

    const auto layers = readMap(probe.map(), options.view, desc.captureOrigin, scene.background);
    const mirrorball::MapInfo& info = mirrorball::mapInfo(options.map);
    Files files;
    for (int component = 0; component < info.components; ++component)
        files.emplace_back(fileName(options, component),
                           exrOf(info.widthInN * options.size, info.heightInN * options.size, options.view,
                                 layers[static_cast<std::size_t>(component)]));
    return files;
}

Sample traced(const Options& options, const Scene& scene, const ReferenceTracer& tracer,
              const glm::dvec3& direction)
{
    const glm::dvec3 centre = options.at + options.offset;
    const Hit hit = tracer.trace(centre, direction, options.near, options.far);
    Sample sample = nothingSeen(options.view, scene.background);
    if (!hit.found)
        return sample;
    sample.distance = static_cast<float>(hit.distance);
    if (options.view == View::position)
        sample.colour = hit.position;
    else if (options.view == View::normal)
        sample.colour = glm::dot(hit.normal, direction) > 0.0 ? -hit.normal : hit.normal;
    else if (options.view == View::triangle)
        sample.colour = glm::dvec3(hit.triangle, 0.0, 0.0);
    else
        sample.colour = glm::dvec3(tracer.shade(hit, centre, lightOf(options, scene)));
    return sample;
}

Files traceMap(const Options& options, const Scene& scene)
{
    const glm::dmat3 worldFromProbe(poseOf(options));
    const ReferenceTracer tracer(scene, options.at + options.offset);
    const mirrorball::MapInfo& info = mirrorball::mapInfo(options.map);
    const int width = info.widthInN * options.size, height = info.heightInN * options.size;
    Files files;
    for (int component = 0; component < info.components; ++component) {
        std::vector<Sample> samples(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        forEachRow(height, [&](int row) {
            for (int column = 0; column < width; ++column) {
                const glm::dvec3 direction =
                    worldFromProbe *
                    referenceDirection(info.name, component, (column + 0.5) / width, (row + 0.5) / height);
                samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(column)] = traced(options, scene, tracer, direction);
            }
        });
        files.emplace_back(fileName(options, component), exrOf(width, height, options.view, samples));
    }
    return files;
}

void run(const Options& options)
{
    requireAllowed(options);
    Scene scene = loadScene(options.scene);
    scene.offset = options.offset;
    Stats stats;
    stats.add("scene", options.scene);
    stats.add("map", std::string(mirrorball::mapInfo(options.map).name));
    stats.add("size", options.size);
    const Files files = options.reference ? traceMap(options, scene) : drawMap(options, scene, stats);
    writeAll(files);
    if (!options.stats.empty())
        stats.write(options.stats);
    for (const auto& [path, image] : files)
        std::cout << path.string() << '\n';
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app{
        "Draws a scene, seen from a point, into a map of the whole sphere: one EXR file a component."};
    app.name("capture");
    app.add_option("SCENE", options.scene,
                   "a model file, builtin:garden, builtin:room, builtin:cards or builtin:crowd:N")
        ->required();
    addVector(app, "--at", options.at, "the probe's centre");
    addVector(app, "--probe-turn", options.turn, "turns the probe about x, then y, then z, in degrees");
    addVector(app, "--offset", options.offset, "moves scene, probe and light, in double");
    glm::dvec3 light(0.0);
    CLI::Option* const lightOption =
        addVector(app, "--light", light, "the point light (default: the scene's own)");
    lightOption->default_str("");
    addMap(app, options.map);
    addInteger(app, "--size", options.size, "texels across the short side of a component");
    addChoice<CaptureMethod>(app, "--method", options.method, {{"perVertex", CaptureMethod::perVertex}},
                             "how triangles are drawn");
    addNumber(app, "--near", options.near, "nearest radial distance");
    addNumber(app, "--far", options.far, "farthest radial distance");
    addChoice<View>(app, "--view", options.view,
                    {{"colour", View::colour},
                     {"position", View::position},
                     {"normal", View::normal},
                     {"triangle", View::triangle}},
                    "what is written");
    addInteger(app, "--frames", options.frames, "how often it is drawn; times are medians");
    app.add_flag("--reference", options.reference, "trace the texels with Embree instead");
    app.add_option("-o,--output", options.prefix, "writes PREFIX_0.exr and so on")
        ->required()
        ->type_name("PREFIX");
    app.add_option("--stats", options.stats, "writes counts and times as JSON")->type_name("FILE");
    return runProgram(app, argc, argv, [&] {
        if (lightOption->count() > 0)
            options.light = light;
        run(options);
    });
}
