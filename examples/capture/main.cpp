// capture: pass 1 by itself. Draws a scene, seen from a point, into a map and writes one EXR a component; with
// --reference the same texels are traced with Embree instead.
#include "capture_options.h"
#include "gl_scene.h"
#include "map_file.h"
#include "reference.h"
#include "stats.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <filesystem>
#include <iostream>

namespace {

using namespace examples;

struct Options : CaptureOptions
{
    glm::dvec3 at{0.0};
    glm::dvec3 turn{0.0}; // degrees about x, y, z
    double near = 0.05;
    int supersample = 1;
    View view = View::colour;
    std::string prefix;

    glm::dvec3 centre() const { return at + offset; }
    int samplesAcross() const { return size * supersample; }
};

using Files = std::vector<std::pair<std::filesystem::path, mirrorball::io::ExrImage>>;

std::filesystem::path fileName(const Options& options, int component)
{
    return options.prefix + "_" + std::to_string(component) + ".exr";
}

// samples: k × k a texel.
Files::value_type fileOf(const Options& options, int component, const std::vector<Sample>& samples, int k)
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(options.map);
    const int width = info.widthInN * options.size, height = info.heightInN * options.size;
    return {fileName(options, component),
            exrOf(width, height, options.view,
                  k == 1 ? samples : reduced(samples, width, height, k, options.view))};
}

Files drawMap(const Options& options, const Scene& scene, Stats& stats)
{
    const mirrorball::headless::Context context;
    mirrorball::ReflectionProbe::Desc desc;
    desc.map = options.map;
    // Only colours have a mean: of anything else every sample is captured, and one is written.
    const bool isAveraged = options.view == View::colour;
    desc.n = isAveraged ? options.size : options.samplesAcross();
    desc.supersample = isAveraged ? options.supersample : 1;
    desc.worldFromProbe = poseOf(options.centre(), options.turn);
    desc.captureOrigin = options.centre();
    desc.near = static_cast<float>(options.near);
    desc.far = static_cast<float>(options.far);
    desc.colour = options.view == View::colour || options.view == View::normal
                      ? mirrorball::ColourFormat::rgba16f
                      : mirrorball::ColourFormat::rgba32f;
    desc.background = glm::vec4(scene.background, 1.0f);
    desc.method = options.method;
    desc.epsilon = static_cast<float>(options.epsilon);
    desc.nearFirst = options.nearFirst;
    desc.mipLevels = desc.nearestDistances = false; // of the map alone a file is made
    desc.pastSeams = true;                          // and of all of it
    mirrorball::ReflectionProbe probe(desc);
    const GlScene drawable(scene, desc.captureOrigin);
    mirrorball::CaptureProgram program = phongCaptureProgram(options.view);
    const std::vector<mirrorball::CaptureMesh> meshes = drawable.captureMeshes(program);
    const PhongView phong{glm::vec3(lightOf(options, scene) - desc.captureOrigin), glm::vec3(0.0f)};
    const auto draw = [&](const mirrorball::CaptureMesh& mesh, const mirrorball::CaptureDraw& call) {
        drawable.drawMesh(mesh.id, call.program, phong, 1, call.primitive);
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
    stats.add("draws_exact", report.drawsExact);
    stats.add("draws_mapped", report.drawsMapped);
    stats.add("triangles", static_cast<double>(report.triangles));
    stats.add("scene_triangles", static_cast<double>(drawable.triangleCount()));
    stats.add("texels", static_cast<double>(report.texels));

    const auto layers = readMap(probe.map(), options.view, desc.captureOrigin, scene.background);
    Files files;
    for (const std::vector<Sample>& layer : layers)
        files.push_back(
            fileOf(options, static_cast<int>(files.size()), layer, isAveraged ? 1 : options.supersample));
    return files;
}

Sample traced(const Options& options, const Scene& scene, const ReferenceTracer& tracer,
              const glm::dvec3& direction)
{
    const glm::dvec3 centre = options.centre();
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
    const glm::dmat3 worldFromProbe(poseOf(options.centre(), options.turn));
    const ReferenceTracer tracer(scene, options.centre());
    const mirrorball::MapInfo& info = mirrorball::mapInfo(options.map);
    const int width = info.widthInN * options.samplesAcross(),
              height = info.heightInN * options.samplesAcross();
    Files files;
    for (int component = 0; component < info.components; ++component) {
        std::vector<Sample> samples(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        forEachRow(height, [&](int row) {
            for (int column = 0; column < width; ++column) {
                const glm::dvec3 direction =
                    worldFromProbe * referenceRay(info.name, component, column, row, width, height);
                samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(column)] = traced(options, scene, tracer, direction);
            }
        });
        files.push_back(fileOf(options, component, samples, options.supersample));
    }
    return files;
}

void run(const Options& options)
{
    requireAllowed(options);
    if (std::filesystem::path(options.prefix).filename().empty())
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "the output '" + options.prefix + "'",
                                "it ends where the files' names would begin", "add a name");
    if (options.supersample < 1 || options.supersample > 16)
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument,
                                "--supersample " + std::to_string(options.supersample),
                                "a texel has 1 to 16 by as many samples", "ask for a number in that range");
    if (options.samplesAcross() > 16384)
        throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--size times --supersample",
                                "a map has at most 16384 samples across", "ask for less");
    requireRange(options.near, options.far);
    requireFinite(options.at, "--at");
    requireFinite(options.turn, "--probe-turn");
    for (int component = 0; component < mirrorball::mapInfo(options.map).components; ++component)
        requireApart(options.stats, {fileName(options, component)});
    const Scene scene = sceneOf(options);
    Stats stats;
    stats.add("scene", options.scene);
    stats.add("map", std::string(mirrorball::mapInfo(options.map).name));
    stats.add("size", options.size);
    const Files files = options.reference ? traceMap(options, scene) : drawMap(options, scene, stats);
    writeWithStats(stats, options.stats, [&] { writeAll(files); });
    for (const auto& [path, image] : files)
        std::cout << path.string() << '\n';
}

void addOptions(CLI::App& app, Options& options)
{
    addCaptureOptions(app, options);
    addVector(app, "--at", options.at, "the probe's centre");
    addVector(app, "--probe-turn", options.turn, "turns the probe about x, then y, then z, in degrees");
    addNumber(app, "--near", options.near, "nearest radial distance from the probe");
    addChoice<View>(app, "--view", options.view,
                    {{"colour", View::colour},
                     {"position", View::position},
                     {"normal", View::normal},
                     {"triangle", View::triangle}},
                    "what is written");
    addRequiredText(app, "-o,--output", options.prefix, "PREFIX", "writes PREFIX_0.exr and so on");
    addInteger(app, "--supersample", options.supersample,
               "k x k samples a texel; colours are averaged, anything else is of one sample");
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    return runProgram(
        "capture",
        "Draws a scene, seen from a point, into a map of the whole sphere: one EXR file a component.", argc,
        argv, [&](CLI::App& app) { addOptions(app, options); }, [&] { run(options); });
}
