// Pass 1: a probe draws the scene, seen from its centre, into a map of the whole sphere of directions.
//
//     ReflectionProbe probe({.name = "teapot", .map = MapKind::tennisBall, .n = 256});
//     probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
//         setUniforms(draw.program, mesh.id);       // the program is in use already
//         drawTriangles(mesh.id);                   // bind a vertex array, glDrawElements
//     });
//     const ReflectionMap& map = probe.map();       // pass 2 reads this
//
// The host's GL state is the same after every call as before, whatever happens, and the last good map stays
// when a call throws. Distances are radial, from the probe's centre, in world units.
#pragma once

#include <mirrorball/capture/capture_program.h>
#include <mirrorball/export.h>
#include <mirrorball/maps/maps.h>
#include <mirrorball/reflect/reflection_map.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace mirrorball {

enum class CaptureMethod {
    automatic, // for each mesh and view, mapped vertices where that is proved good enough, else exact
    exact, // every texel's direction is tested against the triangle's edges: right however large triangles
           // are
    perVertex, // the textbook way: vertices are mapped and edges stay straight, so large triangles are wrong;
               // cube and octahedral maps are piecewise linear and therefore exact with every method
};

enum class LayerOrder {
    oneAtATime, // a draw for each component that a mesh touches
    allAtOnce,  // one draw a mesh; a geometry shader sends triangles to their layers
};

enum class DepthTerm {
    radial,  // one monotone function of the radial distance, the same for every method
    textbook // tennis-ball |R|/100 + b² - 0.75, dual-paraboloid -+ z|R|/100 - 0.9: perVertex on these maps
             // only
};

enum class ColourFormat { rgba16f, rgba32f, rgba8 };

struct Sphere
{
    glm::vec3 centre{0.0f}; // in world space, relative to captureOrigin
    float radius = 0.0f;
};

// One draw of the host's. Without bounds it is drawn into every component, and without bounds and the length
// of its longest edge, exactly. A host that displaces vertices (skinning) gives bounds that hold for the
// displaced ones.
struct CaptureMesh
{
    CaptureProgram* program = nullptr;
    std::uint64_t id = 0; // the host's own
    std::optional<Sphere> bounds = std::nullopt;
    float longestEdge = std::numeric_limits<float>::infinity(); // in world space
    std::size_t triangles = 0;                                  // for the report only
    bool cullBackFaces = false; // front faces are counter-clockwise as seen from the probe
};

// What the host's draw callback is told. The program is in use and the library's uniforms are set.
struct CaptureDraw
{
    unsigned int program; // GL name, to set the host's own uniforms on
    int view; // 0 … viewCount - 1: a component, or an octant of the octahedral map; -1 for all at once
};

// What the last capture did.
struct CaptureReport
{
    int draws = 0;
    int drawsCulled = 0;       // mesh-and-view pairs that were not drawn because they do not touch
    std::size_t triangles = 0; // sent, counted once for each draw
    int drawsExact = 0;        // of the draws: by exact capture …
    int drawsMapped = 0;       // … and by mapped vertices, where automatic found that enough
    std::size_t texels = 0;    // of the map
};

class MIRRORBALL_EXPORT ReflectionProbe
{
public:
    struct Desc
    {
        std::string name = "probe";
        MapKind map = MapKind::tennisBall;
        int n = 256; // texels across the short side of a component
        // Translation, rotation and uniform scale, so that a probe may sit in a node of the host's scene
        // graph. The rotation turns the map, the scale only stretches halfExtent.
        glm::dmat4 worldFromProbe{1.0};
        // World positions that the host's vertex shader hands over are relative to this point.
        glm::dvec3 captureOrigin{0.0};
        double halfExtent = 0.5;                  // half the side of the probe's cube, before scale
        std::optional<float> near = std::nullopt; // radial; halfExtent * scale unless given
        float far = 1000.0f;                      // radial; may be infinite
        ColourFormat colour = ColourFormat::rgba16f;
        glm::vec4 background{0.0f, 0.0f, 0.0f, 1.0f};
        CaptureMethod method = CaptureMethod::automatic;
        float epsilon =
            1.0f / 16.0f; // texels that automatic may be off by, in direction and relative distance
        LayerOrder layers = LayerOrder::oneAtATime;
        DepthTerm depthTerm = DepthTerm::radial;
        // 2: behind the first surface of each direction another one is captured, for Lookup::layered: the
        // nearest that is farther by layerSeparation, relative to the first distance (a minimum separation, as
        // in Mara, McGuire, Nowrouzezahrai, Luebke, "Deep G-buffers for stable global illumination
        // approximation", 2016), so that it is what the first one hides and not its own back.
        int layersOfDepth = 1;
        float layerSeparation = 0.1f;
    };

    using DrawMesh = std::function<void(const CaptureMesh&, const CaptureDraw&)>;

    // Needs a current context of OpenGL 3.3 or later. Throws Error badArgument, noContext or unsupported.
    explicit ReflectionProbe(const Desc& desc);
    ~ReflectionProbe();
    ReflectionProbe(ReflectionProbe&&) noexcept;
    ReflectionProbe& operator=(ReflectionProbe&&) noexcept;

    const Desc& desc() const;
    float near() const; // as resolved

    // Moves the probe; takes effect with the next capture.
    void setPose(const glm::dmat4& worldFromProbe);
    void setCaptureOrigin(const glm::dvec3& captureOrigin);

    // Draws the meshes into a new map and swaps it in when all of it is done. What the callback throws is
    // passed on after the state is restored. Throws Error hostBusy when called from inside a capture of the
    // same probe.
    CaptureReport capture(std::span<const CaptureMesh> meshes, const DrawMesh& draw);

    // Whether something inside these bounds could be seen in a view. Bounds in world space, relative to
    // captureOrigin.
    int viewCount() const;
    bool touches(int view, const Sphere& bounds) const;

    // The last complete capture; before the first one, the background everywhere.
    const ReflectionMap& map() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace mirrorball
