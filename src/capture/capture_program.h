// The programs behind a CaptureProgram: one a combination of map, method and order of layers, compiled when
// first needed.
#pragma once

#include "capture/varyings.h"

#include <mirrorball/capture/capture_program.h>
#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/gl/objects.h>

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

namespace mirrorball::capture {

// How a draw reaches the map. CaptureMethod says what the host asks for; this is what is done for one mesh.
enum class Path {
    linear,      // ordinary rasterisation, on cube and octahedral maps as exact as the rasteriser's snapping
                 // (1/256 texel)
    textbook,    // vertices mapped, w = 1
    mapped,      // vertices mapped, w = distance, so that varyings interpolate in perspective
    tessellated, // cut up, then mapped
    exact        // homogeneous rasterisation in direction space
};

struct Variant
{
    MapKind map;
    Path path;
    LayerOrder layers;
    DepthTerm depthTerm;
    bool large; // exact: of triangles that span many degrees, worth a closely fitting polygon each
    bool withinRange = false; // linear: no part of the mesh is nearer than near or beyond far
    bool ownPosition =
        true; // by mapped vertices: the distance is that of the library's own varying; else of the host's
    bool hides = false; // exact: leaves out what lies behind earlier draws
    bool peels = false; // draws only what lies behind the first layer of depth; one view at a time

    auto operator<=>(const Variant&) const = default;
};

struct LinkedProgram
{
    gl::Program program;
    // Uniform locations; -1 where a variant has none.
    int probeFromWorld, centre, view, depth, range, size, clipFromDirection, inwardPlanes, lineFromDirection,
        cullBackFaces, steps, firstAround, texelsPerSample, layer, separation, farthest;
    bool usesClipDistances;
    bool writesDepth;
    std::uint64_t preparedFor =
        0; // the view (ReflectionProbe::Implementation::viewSerial) that its uniforms are for
    bool cullsBackFaces = false; // the uniform, in that view
};

} // namespace mirrorball::capture

namespace mirrorball {

struct CaptureProgram::Implementation
{
    explicit Implementation(Desc givenDesc);

    // Compiles and links on first use. Throws Error badShader.
    capture::LinkedProgram& program(capture::Variant variant);

    void requirePosition() const; // throws Error badShader

    // The varying that reaches the fragment shader with what Desc::position says; null where none does.
    const capture::Varying* positionVarying() const;

    // Whether the geometry stage can write all layers of a variant at once.
    bool fits(const capture::Variant& variant) const;

    Desc desc;
    capture::HostShader vertex;
    capture::HostShader fragment;
    std::vector<capture::Varying> varyings;
    capture::Outputs outputs;
    std::map<capture::Variant, capture::LinkedProgram> programs;
};

} // namespace mirrorball
