// What is behind a ReflectionProbe: what it owns, and the steps of a capture. reflection_probe.cpp makes and publishes
// maps; probe_draws.cpp draws into them.
#pragma once

#include "capture/capture_program.h"
#include "capture/copies.h"
#include "capture/farthest_blocks.h"
#include "capture/filtered_map.h"
#include "capture/frame.h"
#include "capture/map_textures.h"
#include "gl/context.h"

#include <mirrorball/capture/reflection_probe.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace mirrorball {

namespace capture {

// True while it lives.
struct RaisedFlag
{
    explicit RaisedFlag(bool& given) : flag(given) { flag = true; }
    ~RaisedFlag() { flag = false; }
    RaisedFlag(const RaisedFlag&) = delete;
    RaisedFlag& operator=(const RaisedFlag&) = delete;
    bool& flag;
};

// Throws Error badArgument or unsupported for what no probe can be.
void requirePossible(const ReflectionProbe::Desc& desc);

} // namespace capture

struct ReflectionProbe::Implementation
{
    Desc desc;
    gl::Abilities abilities{}; // of the context that it lives in
    capture::Frame frame;
    capture::MapSize size{};                         // of a layer
    capture::MapSize drawSize{};                     // the same in samples
    capture::MapSize hiddenSize{}, hiddenDrawSize{}; // both of the second layer of depth
    gl::Texture depth;
    capture::MapTextures front, back;             // what pass 2 reads, and what the next capture fills
    capture::MapTextures hiddenFront, hiddenBack; // the same for the second layer of depth, if there is one
    capture::MapTextures samples, hiddenSamples;  // what is drawn into with several samples a texel
    gl::Texture firstAround; // of the first layer the nearest distance that each texel of the second covers
    capture::Copies copies;
    capture::FilteredMap filtered;
    bool peeling = false;                                         // drawing the second layer
    capture::FarthestBlocks farthestBlocks, hiddenFarthestBlocks; // of a view's draws so far
    bool hides = false;                                           // further draws leave out what those hide
    int firstUnit = 0;      // of two texture units, the last ones: firstAround and the farthest distances
    bool allAtOnce = false; // asked for, and the driver can
    ReflectionMap map;
    bool capturing = false;
    CaptureReport report;

    // One draw of the host's, and how it reaches the map.
    struct PlannedDraw
    {
        std::size_t mesh;
        int view; // < 0: all at once
        capture::Variant variant;
    };
    // What is drawn between one clear and the next.
    struct PlannedView
    {
        int view; // < 0: all of them
        std::vector<PlannedDraw> draws{};
        int culled = 0;
        bool nearFirst = false; // draws are sorted so, and what is hidden then is left out
    };
    using Plan = std::vector<PlannedView>; // of one layer of depth

    // What use() has set in a view. Nothing (empty) is taken as set after a clear, or when the host may have changed
    // it.
    struct Applied
    {
        int view;
        bool clipDistances, cullsFaces;
    };
    std::optional<Applied> applied;
    std::uint64_t viewSerial = 0; // of the view that `applied` is in: differs in all views of all probes

    explicit Implementation(const Desc& given);
    void place();
    // As the next capture would see it, or as the one under way does.
    capture::Frame current() const { return capturing ? frame : capture::Frame(desc); }
    void clear(const gl::Framebuffer& layers) const;
    bool isBorrowed() const { return desc.colourTexture != 0; }
    // The level of the distances that has blocks a quarter of n wide, 22.5 degrees; 0 for none.
    int nearestLevel() const
    {
        return isBorrowed() || !desc.nearestDistances
                   ? 0
                   : std::max(static_cast<int>(std::bit_width(static_cast<unsigned>(desc.n))) - 3, 0);
    }
    bool isSupersampled() const { return desc.supersample > 1; }
    // What is drawn into now, how large it is, and what is hidden there.
    const capture::MapTextures& target() const;
    const capture::MapSize& targetSize() const { return peeling ? hiddenDrawSize : drawSize; }
    capture::FarthestBlocks& targetBlocks() { return peeling ? hiddenFarthestBlocks : farthestBlocks; }
    void makeTextures();
    void requireReady() const;
    CaptureReport fill(const std::function<void()>& drawLayerOfDepth); // called for each
    void beginHidden();
    void finish();
    void filter();
    // A view's layer is cleared just before the first draw into it, while it is in a software rasteriser's cache;
    // all are before a draw into all at once (view < 0).
    void begin(int view);
    Plan planOf(std::span<const CaptureMesh> meshes) const;
    PlannedView planOneView(int view, std::span<const CaptureMesh> meshes,
                            const std::vector<bool>& wanted) const;
    PlannedView planAllAtOnce(std::span<const CaptureMesh> meshes) const;
    void draw(const Plan& plan, std::span<const CaptureMesh> meshes, const DrawMesh& drawMesh);
    // The first layer of depth only.
    bool together() const { return allAtOnce && !peeling; }
    // Everything that may fail in a capture, before the state is touched.
    void compile(const Plan& plan, std::span<const CaptureMesh> meshes) const;
    unsigned int use(const CaptureMesh& mesh, int view, capture::Variant variant);
    void beginDraws(int view);
    unsigned int primitive() const;
    void bindToLastUnits();
    // Between draws of the host's, whose state stays.
    void gatherFarthest(int view);
    void publish();
};

} // namespace mirrorball
