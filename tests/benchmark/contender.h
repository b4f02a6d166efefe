// What competes: something that draws the scene, seen from one point, into a map of the whole sphere.
#pragma once

#include "gl_scene.h"
#include "scenes.h"

#include <mirrorball/capture/reflection_probe.h>

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace tests::benchmark {

// The Phong shaders as capture programs, one a view. They outlive the scenes, so that each is compiled once.
class CapturePrograms
{
public:
    CapturePrograms();
    mirrorball::CaptureProgram& of(examples::View view) { return programs_[static_cast<std::size_t>(view)]; }

private:
    std::vector<mirrorball::CaptureProgram> programs_;
};

// A scene on the GPU and the probe in it. The probe's centre is (0, 0, 0) to all shaders.
class Stage
{
public:
    Stage(const SceneChoice& choice, const examples::Scene& scene, CapturePrograms& programs);

    const SceneChoice& choice() const { return choice_; }
    const examples::Scene& scene() const { return scene_; }
    std::vector<mirrorball::CaptureMesh> meshes(examples::View view, bool cullBackFaces) const;
    void drawMesh(std::size_t mesh, unsigned int program, int instances = 1,
                  unsigned int primitive = 4) const;

    // Lets draws end before the rasteriser (GL_RASTERIZER_DISCARD): what is left is vertex and geometry work.
    void endBeforeRasteriser(bool ends) { endsBeforeRasteriser_ = ends; }

    // A probe's, as ReflectionProbe::cheapestPose turns it.
    const glm::dmat4& cheapestPose(mirrorball::MapKind map) const;

    std::size_t triangleCount() const { return drawable_.triangleCount(); }
    std::size_t vertexCount() const;

private:
    const SceneChoice& choice_;
    const examples::Scene& scene_;
    CapturePrograms& programs_;
    examples::GlScene drawable_;
    examples::PhongView phong_;
    bool endsBeforeRasteriser_ = false;
    mutable std::map<mirrorball::MapKind, glm::dmat4> cheapestPoses_;
};

struct Work
{
    int draws = 0;
    std::size_t triangles = 0; // sent, counted once for each draw
};

// Layer after layer, row 0 first.
struct MapImages
{
    std::vector<float> rgba;
    std::vector<float> distance; // infinite where nothing was drawn
};

class Contender
{
public:
    virtual ~Contender() = default;

    virtual Work draw() = 0;
    virtual MapImages read() const = 0; // of the last draw
};

// The library's ways to draw a map. A new enumerator of CaptureMethod joins with one line in contender.cpp.
struct LibraryMethod
{
    std::string_view name;
    mirrorball::CaptureMethod method;
    mirrorball::LayerOrder layers;
    float epsilon; // texels, of those that approximate
    bool nearFirst = false;
    bool isTurned = false; // by cheapestPose
};
std::span<const LibraryMethod> libraryMethods();

std::unique_ptr<Contender> makeLibraryContender(const LibraryMethod& method, mirrorball::MapKind map, int n,
                                                const Stage& stage, bool cullBackFaces, examples::View view);

} // namespace tests::benchmark
