#include "draw.h"

#include "gl_reflector.h"
#include "gl_target.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/reflect/image_map.h>

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <functional>
#include <optional>

namespace render {

namespace {

using namespace examples;
using mirrorball::CaptureDraw;
using mirrorball::CaptureMesh;
using mirrorball::ReflectionProbe;

bool hasClipControl()
{
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
}

// Depth is near / distance: floats are dense where that is small, so a near plane very close to the eye costs
// no precision, and no far plane is needed. Without clip control depth has to pass through [-1, 1], which
// keeps only 24 bits, and the near plane moves out.
PictureView pictureView(const Setup& setup, const Camera& camera, const glm::ivec2& size)
{
    const double near = setup.farthest * (hasClipControl() ? 1e-6 : 1e-3);
    const glm::dvec3 eye = camera.eye - setup.origin;
    const glm::dmat4 viewFromWorld = glm::lookAt(eye, camera.look - setup.origin, camera.up);
    const double aspect = static_cast<double>(size.x) / size.y;
    const double tangent = std::tan(0.5 * camera.fovInRadians);
    glm::dmat4 clipFromView(0.0);
    clipFromView[0][0] = 1.0 / (tangent * aspect);
    clipFromView[1][1] = 1.0 / tangent;
    clipFromView[2][2] = hasClipControl() ? 0.0 : 1.0;
    clipFromView[3][2] = hasClipControl() ? near : 2.0 * near;
    clipFromView[2][3] = -1.0;

    const glm::dmat3 worldFromView = glm::transpose(glm::dmat3(viewFromWorld));
    const glm::dvec2 cotangents(1.0 / (tangent * aspect), 1.0 / tangent);
    const glm::dvec2 step = 2.0 / (cotangents * glm::dvec2(size));
    const glm::dmat3 rayFromPixel =
        worldFromView * glm::dmat3(glm::dvec3(step.x, 0.0, 0.0), glm::dvec3(0.0, step.y, 0.0),
                                   glm::dvec3(-1.0 / cotangents.x, -1.0 / cotangents.y, -1.0));
    PictureView view;
    view.clipFromWorld = glm::mat4(clipFromView * viewFromWorld);
    view.rayFromPixel = glm::mat3(rayFromPixel);
    view.depthFromClip = hasClipControl() ? glm::vec2(1.0f, 0.0f) : glm::vec2(0.5f, 0.5f);
    view.eye = eye;
    view.phong = {glm::vec3(setup.light - setup.origin), glm::vec3(eye)};
    return view;
}

// One reflector and where its map comes from.
struct DrawnMirror
{
    GlReflector body;
    std::optional<ReflectionProbe> probe;
    std::optional<mirrorball::ImageMap> images;
    mirrorball::MaterialSettings settings;

    const mirrorball::ReflectionMap& map() const { return probe ? probe->map() : images->map(); }
};

class Renderer
{
public:
    Renderer(const Setup& setup, const Options& options)
        : setup_(setup), options_(options), scene_(setup.scene, setup.origin),
          sceneProgram_(linkProgram(phongVertexSource(), pictureFragmentSource(options.view))),
          captureProgram_({.name = "phong",
                           .vertexSource = phongVertexSource(),
                           .fragmentSource = phongFragmentSource(View::colour)})
    {
        look(setup.camera, options.pixels);
        for (const Mirror& mirror : setup.mirrors)
            addMirror(mirror);
    }

    // From where, and how large, pictures are drawn from now on.
    void look(const Camera& camera, const glm::ivec2& size)
    {
        view_ = pictureView(setup_, camera, size);
        if (size != size_)
            target_.emplace(size);
        size_ = size;
    }

    // The maps; what they hold together.
    mirrorball::CaptureReport capture()
    {
        mirrorball::CaptureReport total;
        for (DrawnMirror& mirror : mirrors_) {
            if (!mirror.probe)
                continue;
            const mirrorball::CaptureReport report = capture(mirror);
            total.draws += report.draws;
            total.drawsCulled += report.drawsCulled;
            total.triangles += report.triangles;
            total.texels += report.texels;
        }
        return total;
    }

    void clear() const { target_->clear(setup_.scene.background); }

    // The picture.
    void draw() const
    {
        clear();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        if (hasClipControl())
            glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glUseProgram(sceneProgram_.name());
        glUniformMatrix4fv(glGetUniformLocation(sceneProgram_.name(), "clipFromWorld"), 1, GL_FALSE,
                           glm::value_ptr(view_.clipFromWorld));
        scene_.drawAll(sceneProgram_.name(), view_.phong);
        drawMirrors();
    }

    // As part of draw, whose state holds.
    void drawMirrors() const
    {
        int number = 0;
        for (const DrawnMirror& mirror : mirrors_)
            mirror.body.draw(view_, ++number, mirror.map(), mirror.settings);
    }

    Picture picture() const;
    std::size_t triangleCount() const { return scene_.triangleCount(); }

private:
    void addMirror(const Mirror& mirror);
    mirrorball::CaptureReport capture(DrawnMirror& mirror);
    Sample sampleOf(const glm::vec4& colour, float distance, int reflector) const;

    const Setup& setup_;
    const Options& options_;
    glm::ivec2 size_{0};
    PictureView view_;
    std::optional<GlTarget> target_;
    GlScene scene_;
    mirrorball::gl::Program sceneProgram_;
    mirrorball::CaptureProgram captureProgram_;
    std::vector<DrawnMirror> mirrors_;
};

void Renderer::addMirror(const Mirror& mirror)
{
    const mirrorball::MapKind map = mirror.source ? mirror.source->map : options_.map;
    DrawnMirror drawn{GlReflector(mirror.reflector, setup_.origin, options_.view,
                                  {.map = map, .lookup = options_.lookup, .detail = options_.detail}),
                      {},
                      {},
                      {.tint = mirror.tint,
                       .blend = mirror.blend,
                       .origin = setup_.origin,
                       .worldFromProxy = setup_.worldFromProxy}};
    if (mirror.source) {
        drawn.images.emplace(map, mirror.source->n, mirror.source->layers);
        drawn.images->setRotation(glm::dmat3(mirror.worldFromProbe));
    } else {
        drawn.probe.emplace(
            ReflectionProbe::Desc{.map = map,
                                  .n = options_.size,
                                  .worldFromProbe = mirror.worldFromProbe,
                                  .captureOrigin = setup_.origin,
                                  .near = static_cast<float>(mirror.near),
                                  .far = static_cast<float>(options_.far),
                                  .mipLevels = options_.detail != mirrorball::LevelOfDetail::first,
                                  .background = glm::vec4(setup_.scene.background, 1.0f),
                                  .method = options_.method,
                                  .epsilon = static_cast<float>(options_.epsilon),
                                  .layersOfDepth = options_.lookup == mirrorball::Lookup::layered ? 2 : 1});
    }
    mirrors_.push_back(std::move(drawn));
}

// The scene and the other reflectors, which are plain objects here; the reflector itself is left out.
mirrorball::CaptureReport Renderer::capture(DrawnMirror& mirror)
{
    std::vector<const GlScene*> parts = {&scene_};
    for (const DrawnMirror& other : mirrors_)
        if (&other != &mirror)
            parts.push_back(&other.body.plain());

    struct Piece
    {
        const GlScene* part;
        std::size_t mesh;
    };
    std::vector<Piece> pieces;
    std::vector<CaptureMesh> meshes;
    for (const GlScene* part : parts)
        for (CaptureMesh mesh : part->captureMeshes(captureProgram_)) {
            pieces.push_back({part, mesh.id});
            mesh.id = meshes.size();
            meshes.push_back(mesh);
        }
    const glm::dvec3 centre(mirror.probe->desc().worldFromProbe[3]);
    const PhongView phong{view_.phong.light, glm::vec3(centre - setup_.origin)};
    return mirror.probe->capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        pieces[mesh.id].part->drawMesh(pieces[mesh.id].mesh, draw.program, phong, 1, draw.primitive);
    });
}

Sample Renderer::sampleOf(const glm::vec4& colour, float distance, int reflector) const
{
    Sample sample = nothingSeen(options_.view, setup_.scene.background);
    if (std::isinf(distance))
        return sample;
    sample.distance = distance;
    if (options_.view == View::colour) {
        sample.colour = glm::dvec3(colour);
        return sample;
    }
    // Images are infinitely far: there is no position.
    const bool showsImages =
        reflector > 0 && mirrors_[static_cast<std::size_t>(reflector - 1)].images.has_value();
    if (colour.a > 0.0f && !showsImages)
        sample.colour = glm::dvec3(colour) + setup_.origin;
    return sample;
}

Picture Renderer::picture() const
{
    Picture picture{size_, {}, {}};
    const std::vector<glm::vec4> colours = target_->colour();
    const std::vector<glm::vec2> others = target_->distanceAndReflector();
    for (int row = picture.size.y - 1; row >= 0; --row)
        for (int column = 0; column < picture.size.x; ++column) {
            const std::size_t index =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.size.x) +
                static_cast<std::size_t>(column);
            const int reflector = static_cast<int>(others[index].y);
            picture.samples.push_back(sampleOf(colours[index], others[index].x, reflector));
            picture.reflectors.push_back(reflector);
        }
    return picture;
}

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
        stats.add(name + "_wall_ms", median(wall));
        stats.add(name + "_cpu_ms", median(cpu));
    }
};

// Draws so many frames; what the last capture did.
mirrorball::CaptureReport measureFrames(Renderer& renderer, int frames, Stats& stats)
{
    renderer.capture(); // compiles what it needs
    renderer.draw();
    mirrorball::CaptureReport report;
    Times pass1, pass2, reflectors, frame;
    for (int count = 0; count < frames; ++count) {
        pass1.measure([&] { report = renderer.capture(); });
        pass2.measure([&] { renderer.draw(); });
        renderer.clear();
        reflectors.measure([&] { renderer.drawMirrors(); });
        frame.wall.push_back(pass1.wall.back() + pass2.wall.back());
        frame.cpu.push_back(pass1.cpu.back() + pass2.cpu.back());
    }
    pass1.addTo(stats, "pass1");
    pass2.addTo(stats, "pass2");
    reflectors.addTo(stats, "pass2_reflector");
    frame.addTo(stats, "frame");
    stats.add("frames_per_second", 1e3 / median(frame.wall));
    renderer.draw();
    return report;
}

} // namespace

Picture drawPicture(const Setup& setup, const Options& options, Stats& stats)
{
    const mirrorball::headless::Context context;
    stats.add("driver", context.description());
    Renderer renderer(setup, options);
    const mirrorball::CaptureReport report = measureFrames(renderer, options.frames, stats);
    stats.add("draws", report.draws);
    stats.add("draws_culled", report.drawsCulled);
    stats.add("triangles", static_cast<double>(report.triangles));
    stats.add("scene_triangles", static_cast<double>(renderer.triangleCount()));
    stats.add("texels", static_cast<double>(report.texels));
    if (options.supersample > 1) {
        renderer.look(setup.camera, setup.camera.samples);
        renderer.draw();
    }
    return renderer.picture();
}

void drawPath(const Setup& setup, const Options& options, const std::vector<Camera>& path,
              const std::function<void(const Picture&)>& use)
{
    const mirrorball::headless::Context context;
    Renderer renderer(setup, options);
    renderer.capture();
    for (const Camera& camera : path) {
        renderer.look(camera, camera.samples);
        renderer.draw();
        use(renderer.picture());
    }
}

} // namespace render
