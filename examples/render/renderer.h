// Both passes with the library: a map for each mirror of a setup, and the mirrors in a picture.
#pragma once

#include "canvas.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/reflect/image_map.h>

#include <optional>
#include <vector>

namespace render {

// All that it is made with outlives it.
class Renderer
{
public:
    // The options' view is that of the canvas.
    Renderer(const Setup& setup, const Options& options, const Canvas& canvas,
             mirrorball::CaptureProgram& captureProgram);

    // The maps; what they hold together.
    mirrorball::CaptureReport capture();

    // After Canvas::drawScene, whose state holds.
    void drawMirrors() const;

    // Of a mirror of the setup, as it was captured last.
    const mirrorball::ReflectionMap& map(std::size_t mirror) const { return mirrors_[mirror].map(); }

private:
    // What a probe's meshes are drawn from, by their ids.
    struct Piece
    {
        const examples::GlScene* part;
        std::size_t mesh;
    };

    // One reflector and where its map comes from.
    struct DrawnMirror
    {
        examples::GlReflector body;
        std::optional<mirrorball::ReflectionProbe> probe;
        std::optional<mirrorball::ImageMap> images;
        mirrorball::MaterialSettings settings;
        std::vector<Piece> pieces = {};
        std::vector<mirrorball::CaptureMesh> meshes = {}; // of the pieces, as the probe wants them

        const mirrorball::ReflectionMap& map() const { return probe ? probe->map() : images->map(); }
    };

    void addMirror(const Mirror& mirror, const Options& options);
    void listMeshes(DrawnMirror& mirror);
    glm::vec3 centreFromOrigin(const DrawnMirror& mirror) const; // of the probe
    mirrorball::CaptureReport capture(DrawnMirror& mirror);

    const Setup& setup_;
    const Canvas& canvas_;
    mirrorball::CaptureProgram& captureProgram_;
    std::vector<DrawnMirror> mirrors_;
};

} // namespace render
