// The plain types of pass 1: how a map is drawn, what is drawn into it and what came of it.
#pragma once

#include <mirrorball/capture/capture_program.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace mirrorball {

enum class CaptureMethod {
    // For each mesh and view, mapped vertices where that is proved good enough, else exact.
    automatic,
    // Every texel's direction is tested against the triangle's edges: right however large triangles are.
    exact,
    // The textbook way: vertices are mapped and edges stay straight, so large triangles are wrong. Cube and
    // octahedral maps are piecewise linear and therefore exact with every method.
    perVertex,
    // The usual remedy, for comparison: tessellation shaders cut triangles until mapped vertices are within
    // epsilon, up to 64 pieces an edge. Needs OpenGL 4.0, one layer at a time, and a host that draws with
    // CaptureDraw::primitive.
    tessellated,
};

enum class LayerOrder {
    oneAtATime, // a draw for each component that a mesh touches
    // One draw a mesh; a geometry shader sends triangles to their layers. Where a probe finds on construction
    // that the driver does that wrong (Mesa's softpipe), it draws one at a time.
    allAtOnce,
};

enum class DepthTerm {
    // One monotone function of the radial distance, the same for every method.
    radial,
    // tennis-ball |R|/100 + b² - 0.75, dual-paraboloid -+ z|R|/100 - 0.9: perVertex on these maps only.
    textbook
};

enum class ColourFormat { rgba16f, rgba32f, rgba8 };

struct Sphere
{
    glm::vec3 centre{0.0f}; // in world space, relative to captureOrigin
    float radius = 0.0f;
};

struct Box // axis-parallel, in world space, relative to captureOrigin
{
    glm::vec3 low{0.0f};
    glm::vec3 high{0.0f};
};

// One draw of the host's. Without bounds it is drawn into every component, and without bounds or the length
// of its longest edge exactly. A host that displaces vertices (skinning) gives bounds that hold for the
// displaced ones. What is NaN counts as not given; a radius, edge or angle below 0 is refused.
struct CaptureMesh
{
    CaptureProgram* program = nullptr;
    std::uint64_t id = 0; // the host's own
    std::optional<Sphere> bounds = std::nullopt;
    float longestEdge = std::numeric_limits<float>::infinity(); // in world space
    // No part of it is nearer to the probe than this, in world units: more than bounds around the probe can tell, as of
    // a room's walls. Spares the second layer of depth what nothing can hide, and cube and octahedral maps, where
    // bounds end before far, a test against the probe's near, which keeps a rasteriser from testing depth early. Where
    // the promise is not kept, parts nearer than near are drawn, and the second layer lacks surfaces. 0 and less
    // promise nothing.
    std::optional<float> nearestDistance = std::nullopt;
    // No edge of a triangle spans a wider angle than this, in radians, as seen from the probe: more than bounds that
    // hold the probe can tell. Below 0.26 (14.9 degrees) it spares exact capture what only wider triangles need; else
    // it has no effect. Where the promise is not kept, the map is right and takes longer.
    std::optional<float> widestAngle = std::nullopt;
    std::size_t triangles = 0;  // for the report and for cheapestPose
    bool cullBackFaces = false; // front faces are counter-clockwise as seen from the probe
};

// What the host's draw callback is told. The program is in use and the library's uniforms are set. Framebuffer,
// viewport, culling and the like are set once for all draws into a view: the callback may change vertex arrays,
// buffers, textures, samplers, its own uniforms and the current program, and leaves the rest as it is
// (docs/gl_state.md).
struct CaptureDraw
{
    // GL name of one of the programs that a CaptureProgram becomes; another one may come when a mesh or the probe
    // moves. Their uniforms are apart: set all of the host's own on this one, samplers and blocks too, and keep
    // locations by this name. The eye of shading is the probe's centre, and no camera's frustum culls.
    unsigned int program;
    int view; // 0 … viewCount - 1: a component, or an octant of the octahedral map; -1 for all at once
    // What glDraw* takes: GL_TRIANGLES (4), or GL_PATCHES for `tessellated` only, which draws nothing else.
    unsigned int primitive = 4;
};

// The target of a texture that the host hands over.
enum class SideTarget { texture2d, rectangle };

// What the last capture did.
struct CaptureReport
{
    int draws = 0;
    // Mesh-and-view pairs that were not drawn, because they do not touch or, for the second layer of depth, because
    // nothing can lie before them.
    int drawsCulled = 0;
    std::size_t triangles = 0; // sent, counted once for each draw
    // Of the draws: by exact capture, and by mapped vertices where automatic found that enough. Neither counts the
    // linear draws of cube and octahedral maps, nor perVertex and tessellated ones.
    int drawsExact = 0;
    int drawsMapped = 0;
    std::size_t texels = 0; // of the map
};

} // namespace mirrorball
