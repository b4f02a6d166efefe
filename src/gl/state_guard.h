// Keeps the host's GL state across one call of ours: everything that the library changes is read on
// construction, set to what drawing into our own framebuffers needs by neutralise(), and put back by the
// destructor on every way out, exceptions included. The stencil is only switched off: its reference value
// cannot be read back whole from a framebuffer without a stencil. docs/gl_state.md lists the items.
#pragma once

#include "gl/context.h"

#include <array>
#include <vector>

namespace mirrorball::gl {

class StateGuard
{
public:
    // Saves also the texture and sampler bindings of units [firstUnit, firstUnit + units). `abilities`: of the current
    // context; they outlive the guard.
    StateGuard(const Abilities& abilities, int firstUnit, int units);
    StateGuard(Abilities&&, int, int) = delete;
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

    // Fixed-function state as our passes want it: everything that could mask, clip, blend or discard is off,
    // depth test and writes are on (GL_LESS), clip control is OpenGL's default, polygons are filled.
    void neutralise() const;

private:
    struct Toggle
    {
        unsigned int capability;
        bool enabled;
    };
    struct IndexedToggle
    {
        unsigned int capability;
        unsigned int index;
        bool enabled;
    };
    struct Blend
    {
        std::array<int, 4> function; // source RGB, destination RGB, source alpha, destination alpha
        std::array<int, 2> equation; // RGB, alpha
    };
    struct Unit
    {
        std::vector<int> textures; // one a target, in the order of textureTargets()
        int sampler;
    };

    void readToggles();
    void readFramebufferState();
    void readRasterState();
    void readTransferState();
    void readUnits(int firstUnit, int units);
    void restoreToggles() const;
    void restoreRasterState() const;
    void restoreTransferState() const;
    void restoreUnits() const;
    void restoreBindings() const;

    const Abilities& abilities_;
    std::vector<Toggle> toggles_;
    std::vector<IndexedToggle> indexedToggles_;
    int drawFramebuffer_ = 0, readFramebuffer_ = 0, renderbuffer_ = 0;
    int program_ = 0, pipeline_ = 0, vertexArray_ = 0, arrayBuffer_ = 0;
    int uniformBuffer_ = 0, copyReadBuffer_ = 0, copyWriteBuffer_ = 0;
    std::vector<std::array<float, 4>> viewports_;
    std::vector<std::array<double, 2>> depthRanges_;
    std::vector<std::array<int, 4>> scissors_;
    std::vector<std::array<unsigned char, 4>> colourMasks_;
    std::vector<Blend> blends_;
    unsigned char depthMask_ = 1;
    int depthFunction_ = 0, cullFace_ = 0, frontFace_ = 0, provokingVertex_ = 0, patchVertices_ = 0;
    std::array<int, 2> polygonModes_{}; // front, back
    int clampFragmentColour_ = 0;       // compatibility contexts only
    int clipOrigin_ = 0, clipDepth_ = 0;
    std::vector<unsigned int> sampleMasks_;
    std::array<int, 2> transferBuffers_{}; // pack, unpack
    std::vector<int> transferParameters_;
    int activeUnit_ = 0;
    int firstUnit_ = 0;
    std::vector<Unit> units_;
};

} // namespace mirrorball::gl
