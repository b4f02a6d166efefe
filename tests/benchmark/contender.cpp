#include "contender.h"

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>

namespace tests::benchmark {

namespace {

using examples::View;
using mirrorball::CaptureMethod;
using mirrorball::LayerOrder;

// The library's own; and the coarsest that still means something, which is the cheapest: edges pass the right texels by
// no more than to their next one.
constexpr float usual = 1.0f / 16.0f, coarsest = 0.5f;

constexpr LibraryMethod methods[] = {
    {"automatic", CaptureMethod::automatic, LayerOrder::oneAtATime, usual},
    {"automatic-near-first", CaptureMethod::automatic, LayerOrder::oneAtATime, usual, true, false},
    {"automatic-turned", CaptureMethod::automatic, LayerOrder::oneAtATime, usual, false, true},
    {"exact", CaptureMethod::exact, LayerOrder::oneAtATime, usual},
    {"perVertex", CaptureMethod::perVertex, LayerOrder::oneAtATime, usual},
    {"tessellated", CaptureMethod::tessellated, LayerOrder::oneAtATime, coarsest},
    {"exact-all-at-once", CaptureMethod::exact, LayerOrder::allAtOnce, usual},
    {"perVertex-all-at-once", CaptureMethod::perVertex, LayerOrder::allAtOnce, usual},
};

class LibraryContender : public Contender
{
public:
    LibraryContender(const mirrorball::ReflectionProbe::Desc& desc, const Stage& stage, bool cullBackFaces,
                     View view)
        : stage_(stage), probe_(desc), meshes_(stage.meshes(view, cullBackFaces))
    {
    }

    Work draw() override
    {
        const mirrorball::CaptureReport report = probe_.capture(
            meshes_, [&](const mirrorball::CaptureMesh& mesh, const mirrorball::CaptureDraw& call) {
                stage_.drawMesh(mesh.id, call.program, 1, call.primitive);
            });
        return {report.draws, report.triangles};
    }

    MapImages read() const override
    {
        const mirrorball::ReflectionMap& map = probe_.map();
        const mirrorball::MapInfo& info = mirrorball::mapInfo(map.map);
        const std::size_t texels = static_cast<std::size_t>(info.widthInN * map.n) *
                                   static_cast<std::size_t>(info.heightInN * map.n) *
                                   static_cast<std::size_t>(info.components);
        MapImages images{std::vector<float>(4 * texels), std::vector<float>(texels)};
        glBindTexture(GL_TEXTURE_2D_ARRAY, map.colourTexture);
        glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA, GL_FLOAT, images.rgba.data());
        glBindTexture(GL_TEXTURE_2D_ARRAY, map.distanceTexture);
        glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RED, GL_FLOAT, images.distance.data());
        return images;
    }

private:
    const Stage& stage_;
    mirrorball::ReflectionProbe probe_;
    std::vector<mirrorball::CaptureMesh> meshes_;
};

} // namespace

CapturePrograms::CapturePrograms()
{
    for (const View view : {View::colour, View::position, View::normal, View::triangle})
        programs_.push_back(examples::phongCaptureProgram(view));
}

Stage::Stage(const SceneChoice& choice, const examples::Scene& scene, CapturePrograms& programs)
    : choice_(choice), scene_(scene), programs_(programs),
      drawable_(scene, choice.at), phong_{glm::vec3(glm::dvec3(scene.light) - choice.at), glm::vec3(0.0f)}
{
}

std::vector<mirrorball::CaptureMesh> Stage::meshes(View view, bool cullBackFaces) const
{
    std::vector<mirrorball::CaptureMesh> meshes = drawable_.captureMeshes(programs_.of(view));
    for (mirrorball::CaptureMesh& mesh : meshes)
        mesh.cullBackFaces = cullBackFaces;
    return meshes;
}

const glm::dmat4& Stage::cheapestPose(mirrorball::MapKind map) const
{
    const auto [pose, isNew] = cheapestPoses_.try_emplace(map);
    if (isNew) {
        const mirrorball::ReflectionProbe probe(
            {.map = map,
             .worldFromProbe = glm::translate(glm::dmat4(1.0), choice_.at),
             .captureOrigin = choice_.at,
             .near = choice_.near,
             .far = choice_.far,
             .mipLevels = false});
        pose->second = probe.cheapestPose(meshes(View::colour, false));
    }
    return pose->second;
}

void Stage::drawMesh(std::size_t mesh, unsigned int program, int instances, unsigned int primitive) const
{
    if (endsBeforeRasteriser_)
        glEnable(GL_RASTERIZER_DISCARD);
    drawable_.drawMesh(mesh, program, phong_, instances, primitive);
    if (endsBeforeRasteriser_)
        glDisable(GL_RASTERIZER_DISCARD);
}

std::size_t Stage::vertexCount() const
{
    std::size_t count = 0;
    for (const examples::Mesh& mesh : scene_.meshes)
        count += mesh.positions.size();
    return count;
}

std::span<const LibraryMethod> libraryMethods()
{
    return methods;
}

std::unique_ptr<Contender> makeLibraryContender(const LibraryMethod& method, mirrorball::MapKind map, int n,
                                                const Stage& stage, bool cullBackFaces, View view)
{
    const SceneChoice& choice = stage.choice();
    mirrorball::ReflectionProbe::Desc desc;
    desc.map = map;
    desc.n = n;
    desc.worldFromProbe =
        method.isTurned ? stage.cheapestPose(map) : glm::translate(glm::dmat4(1.0), choice.at);
    desc.captureOrigin = choice.at;
    desc.near = choice.near;
    desc.far = choice.far;
    // Positions and triangle numbers need whole floats.
    desc.colour =
        view == View::colour ? mirrorball::ColourFormat::rgba16f : mirrorball::ColourFormat::rgba32f;
    desc.background = glm::vec4(stage.scene().background, 1.0f);
    desc.mipLevels = desc.nearestDistances = false; // which no rival has
    desc.method = method.method;
    desc.epsilon = method.epsilon;
    desc.layers = method.layers;
    desc.nearFirst = method.nearFirst;
    return std::make_unique<LibraryContender>(desc, stage, cullBackFaces, view);
}

} // namespace tests::benchmark
