#include "draw.h"

#include "renderer.h"

#include <mirrorball/headless/context.h>

#include <functional>

namespace render {

namespace {

using examples::Stats;
using examples::Stopwatch;

// Wall and CPU times of one pass over several frames.
struct Times
{
    std::vector<double> wall, cpu;

    void measure(const std::function<void()>& pass)
    {
        Stopwatch watch;
        pass();
        wall.push_back(watch.wallMilliseconds());
        cpu.push_back(watch.cpuMilliseconds());
    }
    void addTo(Stats& stats, const std::string& name) const
    {
        stats.add(name + "_wall_ms", examples::median(wall));
        stats.add(name + "_cpu_ms", examples::median(cpu));
    }
};

// Draws so many frames; what the last capture did.
mirrorball::CaptureReport measureFrames(const Canvas& canvas, Renderer& renderer, int frames, Stats& stats)
{
    renderer.capture(); // compiles what it needs
    const auto draw = [&] {
        canvas.drawScene();
        renderer.drawMirrors();
    };
    draw();
    mirrorball::CaptureReport report;
    Times pass1, pass2, reflectors, frame;
    for (int count = 0; count < frames; ++count) {
        pass1.measure([&] { report = renderer.capture(); });
        pass2.measure(draw);
        canvas.clear();
        reflectors.measure([&] { renderer.drawMirrors(); });
        frame.wall.push_back(pass1.wall.back() + pass2.wall.back());
        frame.cpu.push_back(pass1.cpu.back() + pass2.cpu.back());
    }
    pass1.addTo(stats, "pass1");
    pass2.addTo(stats, "pass2");
    reflectors.addTo(stats, "pass2_reflector");
    frame.addTo(stats, "frame");
    stats.add("frames_per_second", 1e3 / examples::median(frame.wall));
    draw();
    return report;
}

} // namespace

Picture drawPicture(const Setup& setup, const Options& options, Stats& stats)
{
    const mirrorball::headless::Context context;
    stats.add("driver", context.description());
    Canvas canvas(setup, options.view, options.pixels);
    mirrorball::CaptureProgram program = examples::phongCaptureProgram();
    Renderer renderer(setup, options, canvas, program);
    const mirrorball::CaptureReport report = measureFrames(canvas, renderer, options.frames, stats);
    stats.add("draws", report.draws);
    stats.add("draws_culled", report.drawsCulled);
    stats.add("triangles", static_cast<double>(report.triangles));
    stats.add("scene_triangles", static_cast<double>(canvas.scene().triangleCount()));
    stats.add("texels", static_cast<double>(report.texels));
    if (options.supersample > 1) {
        canvas.look(setup.camera, setup.camera.samples);
        canvas.drawScene();
        renderer.drawMirrors();
    }
    return canvas.picture();
}

void drawPath(const Setup& setup, const Options& options, const std::vector<Camera>& path,
              const std::function<void(const Picture&)>& use)
{
    const mirrorball::headless::Context context;
    Canvas canvas(setup, options.view, options.pixels);
    mirrorball::CaptureProgram program = examples::phongCaptureProgram();
    Renderer renderer(setup, options, canvas, program);
    renderer.capture();
    for (const Camera& camera : path) {
        canvas.look(camera, camera.samples);
        canvas.drawScene();
        renderer.drawMirrors();
        use(canvas.picture());
    }
}

} // namespace render
