// Pass 1: a probe draws the scene, seen from its centre, into a map of the whole sphere of directions.
//
//     ReflectionProbe probe({.name = "teapot", .map = MapKind::tennisBall, .n = 256});
//     probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
//         setUniforms(draw.program, mesh.id);       // the program is in use already
//         drawTriangles(mesh.id);                   // bind a vertex array, glDrawElements
//     });
//     const ReflectionMap& map = probe.map();       // pass 2 reads this
//
// A host that walks through its scene by itself takes the second capture() and asks each CaptureView.
//
// The host's GL state is the same after every call as before, whatever happens, and the last good map stays
// when a call throws. Distances are radial, from the probe's centre, in world units.
#pragma once

#include <mirrorball/capture/capture_types.h>
#include <mirrorball/export.h>
#include <mirrorball/maps/maps.h>
#include <mirrorball/reflect/reflection_map.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace mirrorball {

class CaptureView;

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
        // Half the side of a cube around the centre with nothing in it but the reflector, before scale.
        double halfExtent = 0.5;
        // Radial distances in world units, not scaled; far may be infinite. What is nearer or farther is not drawn.
        std::optional<float> near = std::nullopt; // halfExtent * scale unless given
        float far = 1000.0f;
        ColourFormat colour = ColourFormat::rgba16f;
        // k: k × k samples a texel, for smooth edges. Colour is their mean; distance is that of one of them,
        // the nearest to the texel's centre.
        int supersample = 1;
        // A map that the host owns: GL_TEXTURE_2D_ARRAY of the map's size, which are borrowed and written to
        // at the end of a capture. 0: the probe makes its own; `colour` is then the format. Distances need floats:
        // GL_R32F, or GL_R16F where 1/2048 of them is near enough.
        unsigned int colourTexture = 0;
        unsigned int distanceTexture = 0;
        // Mip levels and guard texels for LevelOfDetail and for filtering across borders, in a texture of
        // their own, some 3/2 of the colours; docs/reflection.md has the cost.
        bool mipLevels = true;
        // The nearest distances of blocks of texels, at which the look-ups `distance` and `layered` begin; without
        // them they begin at the mirror. Other look-ups have no use for them.
        bool nearestDistances = true;
        // Layers of the tennis-ball and dual-paraboloid maps overlap, and texels past a seam belong to another
        // component. Whether all that is seen there is drawn into them, for a host that uses whole layers. The library
        // reads them only for mipLevels and with two layers of depth, and then they are drawn whatever this says.
        bool pastSeams = false;
        glm::vec4 background{0.0f, 0.0f, 0.0f, 1.0f};
        CaptureMethod method = CaptureMethod::automatic;
        float epsilon =
            1.0f / 16.0f; // texels that automatic may be off by, in direction and relative distance
        LayerOrder layers = LayerOrder::oneAtATime;
        // For scenes with many surfaces behind one another: where 32 meshes or more are drawn exactly into a view, one
        // layer at a time, they are from near to far instead of in the host's order, and triangles that lie behind
        // what is drawn already are left out. Of surfaces in one place, the first one drawn is shown: that may be
        // another one then than in the host's own picture. For the capture that is given meshes.
        bool nearFirst = false;
        DepthTerm depthTerm = DepthTerm::radial;
        // 2: behind the first surface of each direction another one is captured, for Lookup::layered: the
        // nearest that is farther by layerSeparation, relative to the nearest first distance around it (a minimum
        // separation, as in Mara, McGuire, Nowrouzezahrai, Luebke, "Deep G-buffers for stable global illumination
        // approximation", 2016), so that it is what the first one hides and not its own back. The second layer is a
        // map of size n / 2, rounded down, or 1: the reflection sees little of it.
        int layersOfDepth = 1;
        float layerSeparation = 0.3f;
    };

    using DrawMesh = std::function<void(const CaptureMesh&, const CaptureDraw&)>;
    using DrawScene = std::function<void(CaptureView&)>;

    // Needs a current context of OpenGL 3.3 or later. Throws Error badArgument, noContext, unsupported or, while
    // transform feedback is active, hostBusy.
    explicit ReflectionProbe(const Desc& desc);
    ~ReflectionProbe();
    ReflectionProbe(ReflectionProbe&&) noexcept;
    ReflectionProbe& operator=(ReflectionProbe&&) noexcept;

    const Desc& desc() const;
    float near() const; // as resolved

    // Moves the probe; takes effect with the next capture. Throws Error badArgument for a pose that shears, mirrors,
    // scales unevenly or is not finite.
    void setPose(const glm::dmat4& worldFromProbe);
    void setCaptureOrigin(const glm::dvec3& captureOrigin);

    // The pose, turned about the probe's centre, from which a capture of these meshes sends the fewest triangles
    // (CaptureMesh::triangles; of equals, that of the fewest draws), since seams pass between them: the present one or
    // the best of 256 turns spread evenly. Look-ups follow the pose, so that mirrors look the same. For a probe that
    // stands still: it asks touches() 257 times for each mesh and view. Only meshes with bounds tell anything.
    glm::dmat4 cheapestPose(std::span<const CaptureMesh> meshes) const;

    // Draws the meshes into a new map and swaps it in when all of it is done: each mesh once for each view that it
    // touches, and with two layers of depth once more where it may be hidden. What the callback throws is passed on
    // after the state is restored. Throws Error badShader where a program does not compile or its varyings find no
    // room, badArgument for a mesh or a range that cannot be, hostBusy from inside a capture of the same probe, and
    // what the constructor throws.
    CaptureReport capture(std::span<const CaptureMesh> meshes, const DrawMesh& draw);

    // The same, drawn by the host itself: called once for each view, or once in all with allAtOnce; for the second
    // layer of depth once more for each view. The host's order is kept, also with nearFirst.
    CaptureReport capture(const DrawScene& drawScene);

    // Takes over six sides that the host has drawn itself, +X -X +Y -Y +Z -Z, each of n × n texels laid out
    // as OpenGL's cube maps are (row 0 is t = 0); for the cube map. Their distances are not known. Throws
    // Error badArgument with the last good map unchanged.
    void takeOver(std::span<const unsigned int, 6> sides, SideTarget target);

    // Whether something inside these bounds could be seen in a view. Bounds in world space, relative to
    // captureOrigin.
    int viewCount() const;
    bool touches(int view, const Sphere& bounds) const;
    bool touches(int view, const Box& bounds) const;

    // The last complete capture; before the first one, the background everywhere. It stays until the next one: where
    // nothing has moved, a host leaves capture() out. Each capture changes the texture names, so that a copy of this
    // goes stale; its pose is that of its capture.
    const ReflectionMap& map() const;

private:
    friend class CaptureView;
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

// What a host that draws by itself is handed: one view of a probe. Valid during the call only.
class MIRRORBALL_EXPORT CaptureView
{
public:
    // 0 … viewCount - 1, or -1 for all at once; the same view has it in every capture of this probe, so that
    // what a host keeps for each of its views (shadows, culling) can be told apart.
    int id() const { return view_; }

    bool touches(const Sphere& bounds) const;
    bool touches(const Box& bounds) const;

    // Makes the program current for drawing into this view, the library's uniforms set; returns its GL name
    // for the host's own. Without a mesh's bounds and longest edge, draws are exact. To be called again after
    // the host has used another program or framebuffer; each call counts as a draw in the report.
    unsigned int use(CaptureProgram& program);
    unsigned int use(const CaptureMesh& mesh);

private:
    friend class ReflectionProbe;
    CaptureView(ReflectionProbe::Implementation& probe, int view) : probe_(&probe), view_(view) {}

    ReflectionProbe::Implementation* probe_;
    int view_;
};

} // namespace mirrorball
