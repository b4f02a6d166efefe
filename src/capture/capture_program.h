// The programs behind a CaptureProgram: one a combination of map, method and order of layers, compiled when
// first needed.
#pragma once

#include "capture/host_shader.h"

#include <mirrorball/capture/capture_program.h>
#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/gl/objects.h>

#include <compare>
#include <map>
#include <vector>

namespace mirrorball::capture {

struct Variant
{
    MapKind map;
    CaptureMethod method;
    LayerOrder layers;
    DepthTerm depthTerm;

    auto operator<=>(const Variant&) const = default;
};

struct LinkedProgram
{
    gl::Program program;
    // Uniform locations; -1 where a variant has none.
    int probeFromWorld, view, depth, range, size, clipFromDirection, inwardPlanes;
    bool usesClipDistances;
};

// A varying that the fragment shader reads.
struct Varying
{
    std::string type, name, arraySuffix, interpolation;
};

} // namespace mirrorball::capture

namespace mirrorball {

struct CaptureProgram::Implementation
{
    explicit Implementation(Desc givenDesc);

    // Compiles and links on first use. Throws Error badShader.
    const capture::LinkedProgram& program(const capture::Variant& variant);

    Desc desc;
    capture::HostShader vertex;
    capture::HostShader fragment;
    std::vector<capture::Varying> varyings;
    std::string colourOutput; // empty when its location is in a layout qualifier
    std::map<capture::Variant, capture::LinkedProgram> programs;
};

} // namespace mirrorball
