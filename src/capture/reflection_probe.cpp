#include <mirrorball/capture/reflection_probe.h>

#include "capture/cheapest_pose.h"
#include "capture/layer_check.h"
#include "capture/map_textures.h"
#include "capture/pose.h"
#include "capture/probe_implementation.h"
#include "capture/views.h"
#include "finite.h"
#include "gl/context.h"
#include "gl/state_guard.h"
#include "number_text.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace mirrorball {

namespace {

using capture::MapSize;
using capture::RaisedFlag;
using capture::rigidPose;

void requireUsable(const CaptureMesh& mesh, const std::string& asked)
{
    if (mesh.program == nullptr)
        throw Error(ErrorKind::badArgument, asked, "a mesh has no program", "set CaptureMesh::program");
    const std::pair<std::string_view, std::optional<float>> sizes[] = {
        {"radius of the bounds", mesh.bounds ? std::optional(mesh.bounds->radius) : std::nullopt},
        {"longest edge", mesh.longestEdge},
        {"widest angle", mesh.widestAngle}};
    for (const auto& [name, size] : sizes)
        if (size && *size < 0.0f)
            throw Error(ErrorKind::badArgument, asked,
                        "the " + std::string(name) + " of a mesh is below 0: " + numberText(*size),
                        "give 0 or more, or leave it out");
}

} // namespace

ReflectionProbe::Implementation::Implementation(const Desc& given)
    : desc(given), frame(desc), farthestBlocks(capture::MapSize{}), hiddenFarthestBlocks(capture::MapSize{})
{
    capture::requirePossible(desc);
    abilities = gl::Abilities::ofCurrentContext();
    size = capture::mapSize(desc.map, desc.n);
    drawSize = capture::mapSize(desc.map, desc.n * desc.supersample);
    hiddenSize = capture::mapSize(desc.map, capture::hiddenN(desc.n));
    hiddenDrawSize = capture::mapSize(desc.map, capture::hiddenN(desc.n) * desc.supersample);
    farthestBlocks = capture::FarthestBlocks(drawSize);
    hiddenFarthestBlocks = capture::FarthestBlocks(hiddenDrawSize);
    // The host's materials use the first ones.
    firstUnit = gl::integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 2;
    const gl::StateGuard guard(abilities, 0, 1);
    guard.neutralise();
    glActiveTexture(GL_TEXTURE0);
    makeTextures();
    allAtOnce = desc.layers == LayerOrder::allAtOnce && (size.layers == 1 || capture::drawsIntoLayers());
    if (desc.mipLevels)
        filtered =
            capture::FilteredMap(desc.map, desc.n, capture::internalFormat(desc.colour),
                                 desc.method == CaptureMethod::perVertex ? capture::PastSeams::unknown
                                                                         : capture::PastSeams::captured);
    filter();
    publish();
    map.nearestLevel = 0; // until the first capture
}

void ReflectionProbe::Implementation::makeTextures()
{
    if (isBorrowed()) {
        capture::bindBorrowed(desc.colourTexture, GL_TEXTURE_2D_ARRAY, size, "a host's colour texture");
        capture::bindBorrowedDistances(desc.distanceTexture, size);
    }
    depth = capture::makeDepth(drawSize);
    const gl::Texture* const depthOfTexels = isSupersampled() ? nullptr : &depth;
    const auto make = [&](const capture::MapSize& each, int lastDistanceLevel = 0) {
        return capture::makeMapTextures(each, desc.colour, depthOfTexels, lastDistanceLevel);
    };
    front = isBorrowed() ? capture::borrowMapTextures(size, desc.colourTexture, desc.distanceTexture)
                         : make(size, nearestLevel());
    back = make(size, nearestLevel());
    clear(front.allLayers);
    if (isSupersampled())
        samples = capture::makeMapTextures(drawSize, desc.colour, &depth);
    if (desc.layersOfDepth < 2)
        return;
    hiddenFront = make(hiddenSize);
    hiddenBack = make(hiddenSize);
    clear(hiddenFront.allLayers);
    if (isSupersampled())
        hiddenSamples = capture::makeMapTextures(hiddenDrawSize, desc.colour, &depth);
    firstAround = capture::makeDistances(hiddenSize);
}

const capture::MapTextures& ReflectionProbe::Implementation::target() const
{
    if (isSupersampled())
        return peeling ? hiddenSamples : samples;
    return peeling ? hiddenBack : back;
}

void ReflectionProbe::Implementation::clear(const gl::Framebuffer& layers) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, layers.name());
    glClearBufferfv(GL_COLOR, 0, glm::value_ptr(desc.background));
    const float nothing[4] = {std::numeric_limits<float>::infinity(), 0.0f, 0.0f, 0.0f};
    glClearBufferfv(GL_COLOR, 1, nothing);
    const float farthest = desc.depthTerm == DepthTerm::textbook ? 1.0f : 0.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void ReflectionProbe::Implementation::place()
{
    frame = capture::Frame(desc);
}

void ReflectionProbe::Implementation::publish()
{
    map = {desc.map,
           desc.n,
           isBorrowed() ? desc.colourTexture : front.colour.name(),
           isBorrowed() ? desc.distanceTexture : front.distance.name(),
           frame.worldFromProbe(),
           hiddenFront.colour.name(),
           hiddenFront.distance.name()};
    map.hiddenN = desc.layersOfDepth == 2 ? capture::hiddenN(desc.n) : 0;
    map.nearestLevel = nearestLevel();
    if (filtered)
        filtered.describeIn(map);
}

// Inside a StateGuard(0, 1) that is neutralised.
void ReflectionProbe::Implementation::filter()
{
    if (filtered)
        filtered.update(isBorrowed() ? desc.colourTexture : front.colour.name());
}

ReflectionProbe::ReflectionProbe(const Desc& desc) : implementation_(std::make_unique<Implementation>(desc))
{
}
ReflectionProbe::~ReflectionProbe() = default;
ReflectionProbe::ReflectionProbe(ReflectionProbe&&) noexcept = default;
ReflectionProbe& ReflectionProbe::operator=(ReflectionProbe&&) noexcept = default;

const ReflectionProbe::Desc& ReflectionProbe::desc() const
{
    return implementation_->desc;
}

float ReflectionProbe::near() const
{
    return implementation_->current().near();
}

void ReflectionProbe::setPose(const glm::dmat4& worldFromProbe)
{
    rigidPose(worldFromProbe); // throws before anything changes
    implementation_->desc.worldFromProbe = worldFromProbe;
}

glm::dmat4 ReflectionProbe::cheapestPose(std::span<const CaptureMesh> meshes) const
{
    return capture::cheapestPose(implementation_->desc, meshes);
}

void ReflectionProbe::setCaptureOrigin(const glm::dvec3& captureOrigin)
{
    requireFinite(glm::value_ptr(captureOrigin), 3, "a capture origin");
    implementation_->desc.captureOrigin = captureOrigin;
}

int ReflectionProbe::viewCount() const
{
    return capture::viewCount(implementation_->desc.map);
}

bool ReflectionProbe::touches(int view, const Sphere& bounds) const
{
    return implementation_->current().touches(view, bounds);
}

bool ReflectionProbe::touches(int view, const Box& bounds) const
{
    return implementation_->current().touches(view, bounds);
}

const ReflectionMap& ReflectionProbe::map() const
{
    return implementation_->map;
}

void ReflectionProbe::Implementation::requireReady() const
{
    if (capturing)
        throw Error(ErrorKind::hostBusy, "a capture of probe '" + desc.name + "'",
                    "this probe is being captured already", "call it after the draw callback has returned");
    gl::requireContext();
}

// Everything between a cleared map and a complete one that is swapped in.
CaptureReport ReflectionProbe::Implementation::fill(const std::function<void()>& drawLayerOfDepth)
{
    const RaisedFlag isCapturing(capturing);
    const gl::StateGuard guard(abilities, firstUnit, 2);
    guard.neutralise();
    if (desc.depthTerm == DepthTerm::radial) {
        glDepthFunc(GL_GREATER);
        if (abilities.clipControl)
            glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    report = {};
    report.texels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                    static_cast<std::size_t>(size.layers);
    drawLayerOfDepth();
    if (desc.layersOfDepth == 2) {
        beginHidden();
        const RaisedFlag isPeeling(peeling);
        drawLayerOfDepth();
    }
    finish();
    return report;
}

// A texel of the second layer may hold what any texel of the first around it hides.
void ReflectionProbe::Implementation::beginHidden()
{
    const gl::StateGuard guard(abilities, 0, 1);
    guard.neutralise(); // the callback may have changed anything
    copies.gatherNearest(target().distance, firstAround, hiddenSize);
}

void ReflectionProbe::Implementation::finish()
{
    const gl::StateGuard guard(abilities, 0, 2);
    guard.neutralise(); // the callback may have changed anything
    if (isSupersampled())
        copies.reduce(samples, back, size, desc.supersample);
    if (isSupersampled() && desc.layersOfDepth == 2)
        copies.reduce(hiddenSamples, hiddenBack, hiddenSize, desc.supersample);
    if (nearestLevel() > 0)
        copies.gatherNearestLevel(desc.layersOfDepth == 2 ? firstAround : back.distance, back.distance, size,
                                  nearestLevel());
    if (isBorrowed())
        copies.reduce(back, front, size, 1);
    if (!isBorrowed())
        std::swap(front, back);
    std::swap(hiddenFront, hiddenBack);
    filter();
    publish();
}

CaptureReport ReflectionProbe::capture(std::span<const CaptureMesh> meshes, const DrawMesh& draw)
{
    Implementation& self = *implementation_;
    self.requireReady();
    const std::string asked = "a capture of probe '" + self.desc.name + "'";
    if (!draw && !meshes.empty())
        throw Error(ErrorKind::badArgument, asked, "there is no function to draw with", "hand one over");
    for (const CaptureMesh& mesh : meshes)
        requireUsable(mesh, asked);
    self.place();
    const auto planned = [&] {
        Implementation::Plan plan = self.planOf(meshes);
        self.compile(plan, meshes);
        return plan;
    };
    const Implementation::Plan first = planned();
    Implementation::Plan second;
    if (self.desc.layersOfDepth == 2) {
        const RaisedFlag isPeeling(self.peeling);
        second = planned();
    }
    return self.fill([&] { self.draw(self.peeling ? second : first, meshes, draw); });
}

CaptureReport ReflectionProbe::capture(const DrawScene& drawScene)
{
    Implementation& self = *implementation_;
    self.requireReady();
    if (!drawScene)
        throw Error(ErrorKind::badArgument, "a capture of probe '" + self.desc.name + "'",
                    "there is no function to draw with", "hand one over");
    self.place();
    return self.fill([&] {
        const bool together = self.together();
        for (int id = together ? -1 : 0; id < (together ? 0 : viewCount()); ++id) {
            self.begin(id);
            CaptureView view(self, id);
            drawScene(view);
        }
    });
}

void ReflectionProbe::takeOver(std::span<const unsigned int, 6> sides, SideTarget target)
{
    Implementation& self = *implementation_;
    self.requireReady();
    if (self.desc.map != MapKind::cube)
        throw Error(ErrorKind::badArgument, "six sides for probe '" + self.desc.name + "'",
                    "its map is " + std::string(mapInfo(self.desc.map).name), "use a cube map");
    self.place();
    const gl::StateGuard guard(self.abilities, 0, 2);
    guard.neutralise();
    for (int side = 0; side < 6; ++side)
        self.copies.copySide(sides[static_cast<std::size_t>(side)], target, self.back, side, self.size);
    if (self.isBorrowed())
        self.copies.reduce(self.back, self.front, self.size, 1);
    else
        std::swap(self.front, self.back);
    self.filter();
    self.publish();
    self.map.distanceTexture = self.map.hiddenColourTexture = self.map.hiddenDistanceTexture = 0;
    self.map.hiddenN = 0;
    self.map.nearestLevel = 0;
}

bool CaptureView::touches(const Sphere& bounds) const
{
    return view_ < 0 || probe_->frame.touches(view_, bounds);
}

bool CaptureView::touches(const Box& bounds) const
{
    return view_ < 0 || probe_->frame.touches(view_, bounds);
}

unsigned int CaptureView::use(CaptureProgram& program)
{
    return use(CaptureMesh{.program = &program});
}

unsigned int CaptureView::use(const CaptureMesh& mesh)
{
    requireUsable(mesh, "a view of probe '" + probe_->desc.name + "'");
    probe_->applied.reset(); // the host may have used another framebuffer
    return probe_->use(mesh, view_, probe_->frame.variantOf(mesh, view_, probe_->peeling));
}

} // namespace mirrorball
