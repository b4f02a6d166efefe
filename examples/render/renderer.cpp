#include "renderer.h"

namespace render {

using namespace examples;
using mirrorball::CaptureDraw;
using mirrorball::CaptureMesh;
using mirrorball::ReflectionProbe;

Renderer::Renderer(const Setup& setup, const Options& options, const Canvas& canvas,
                   mirrorball::CaptureProgram& captureProgram)
    : setup_(setup), canvas_(canvas), captureProgram_(captureProgram)
{
    for (const Mirror& mirror : setup.mirrors)
        addMirror(mirror, options);
    for (DrawnMirror& mirror : mirrors_)
        if (mirror.probe)
            listMeshes(mirror);
}

mirrorball::CaptureReport Renderer::capture()
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

void Renderer::drawMirrors() const
{
    int number = 0;
    for (const DrawnMirror& mirror : mirrors_)
        mirror.body.draw(canvas_.pictureView(), ++number, mirror.map(), mirror.settings);
}

void Renderer::addMirror(const Mirror& mirror, const Options& options)
{
    const mirrorball::MapKind map = mirror.source ? mirror.source->map : options.map;
    DrawnMirror drawn{GlReflector(mirror.reflector, setup_.origin, canvas_.view(),
                                  {.map = map, .lookup = options.lookup, .detail = options.detail}),
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
                                  .n = options.size,
                                  .worldFromProbe = mirror.worldFromProbe,
                                  .captureOrigin = setup_.origin,
                                  .near = static_cast<float>(mirror.near),
                                  .far = static_cast<float>(options.far),
                                  .mipLevels = options.detail != mirrorball::LevelOfDetail::first,
                                  .nearestDistances = options.lookup == mirrorball::Lookup::distance ||
                                                      options.lookup == mirrorball::Lookup::layered,
                                  .background = glm::vec4(setup_.scene.background, 1.0f),
                                  .method = options.method,
                                  .epsilon = static_cast<float>(options.epsilon),
                                  .nearFirst = options.nearFirst,
                                  .layersOfDepth = options.lookup == mirrorball::Lookup::layered ? 2 : 1});
    }
    mirrors_.push_back(std::move(drawn));
}

// The scene and the other reflectors, which are plain objects here; the reflector itself is left out. Nothing moves.
void Renderer::listMeshes(DrawnMirror& mirror)
{
    std::vector<const GlScene*> parts = {&canvas_.scene()};
    for (const DrawnMirror& other : mirrors_)
        if (&other != &mirror)
            parts.push_back(&other.body.plain());
    for (const GlScene* part : parts)
        for (CaptureMesh mesh : part->captureMeshes(captureProgram_, centreFromOrigin(mirror))) {
            mirror.pieces.push_back({part, mesh.id});
            mesh.id = mirror.meshes.size();
            mirror.meshes.push_back(mesh);
        }
}

glm::vec3 Renderer::centreFromOrigin(const DrawnMirror& mirror) const
{
    return glm::vec3(glm::dvec3(mirror.probe->desc().worldFromProbe[3]) - setup_.origin);
}

mirrorball::CaptureReport Renderer::capture(DrawnMirror& mirror)
{
    const PhongView phong{canvas_.pictureView().phong.light, centreFromOrigin(mirror)};
    return mirror.probe->capture(mirror.meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        const Piece& piece = mirror.pieces[mesh.id];
        piece.part->drawMesh(piece.mesh, draw.program, phong, 1, draw.primitive);
    });
}

} // namespace render
