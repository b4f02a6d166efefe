#include <mirrorball/capture/reflection_probe.h>

#include "capture/capture_program.h"
#include "capture/copies.h"
#include "capture/filtered_map.h"
#include "capture/frame.h"
#include "capture/hidden.h"
#include "capture/layer_check.h"
#include "capture/map_textures.h"
#include "capture/pose.h"
#include "capture/uniforms.h"
#include "capture/views.h"
#include "gl/context.h"
#include "gl/state_guard.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <bit>
#include <cmath>
#include <string>

namespace mirrorball {

namespace {

using capture::LinkedProgram;
using capture::MapSize;
using capture::Path;
using capture::rigidPose;

// True while it lives.
struct RaisedFlag
{
    explicit RaisedFlag(bool& given) : flag(given) { flag = true; }
    ~RaisedFlag() { flag = false; }
    RaisedFlag(const RaisedFlag&) = delete;
    RaisedFlag& operator=(const RaisedFlag&) = delete;
    bool& flag;
};

} // namespace

struct ReflectionProbe::Implementation
{
    Desc desc;
    capture::Frame frame;
    MapSize size{};     // of a layer
    MapSize drawSize{}; // the same in samples
    gl::Texture depth;
    capture::MapTextures front, back;             // what pass 2 reads, and what the next capture fills
    capture::MapTextures hiddenFront, hiddenBack; // the same for the second layer of depth, if there is one
    capture::MapTextures samples, hiddenSamples;  // what is drawn into with several samples a texel
    capture::Copies copies;
    capture::FilteredMap filtered;
    int peelUnit = -1;      // the texture unit through which it sees the first
    bool peeling = false;   // drawing the second layer
    bool allAtOnce = false; // asked for, and the driver can
    ReflectionMap map;
    bool capturing = false;
    CaptureReport report;

    explicit Implementation(const Desc& given);
    void place();
    // As the next capture would see it, or as the one under way does.
    capture::Frame current() const { return capturing ? frame : capture::Frame(desc); }
    void clear(const capture::MapTextures& textures, const MapSize& viewport) const;
    bool isBorrowed() const { return desc.colourTexture != 0; }
    // The level of the distances that has blocks a quarter of n wide, 22.5 degrees; 0 for none.
    int nearestLevel() const
    {
        return isBorrowed() || !desc.nearestDistances
                   ? 0
                   : std::max(static_cast<int>(std::bit_width(static_cast<unsigned>(desc.n))) - 3, 0);
    }
    bool isSupersampled() const { return desc.supersample > 1; }
    // What is drawn into now.
    const capture::MapTextures& target() const;
    void makeTextures();
    void requireReady() const;
    CaptureReport fill(const std::function<void()>& drawLayerOfDepth);
    void finish();
    void filter();
    void drawOneAtATime(std::span<const CaptureMesh> meshes, const DrawMesh& draw);
    void drawAllAtOnce(std::span<const CaptureMesh> meshes, const DrawMesh& draw);
    bool fitsAtOnce(const CaptureMesh& mesh) const;
    // Everything that may fail in a capture, before the state is touched.
    void compile(std::span<const CaptureMesh> meshes);
    unsigned int use(const CaptureMesh& mesh, int view);
    unsigned int primitive() const;
    void bindFirstLayer() const;
    void publish();
};

ReflectionProbe::Implementation::Implementation(const Desc& given) : desc(given), frame(desc)
{
    capture::requireFinite(desc.captureOrigin, "a capture origin");
    gl::requireContext();
    capture::requireMapSize(desc.map, desc.n, desc.supersample);
    if ((desc.colourTexture == 0) != (desc.distanceTexture == 0))
        throw Error(ErrorKind::badArgument, "a map that the host owns",
                    "only one of its two textures is given", "give colour and distance, or neither");
    if (!(desc.epsilon > 0.0f))
        throw Error(ErrorKind::badArgument, "a probe's epsilon", "it is " + std::to_string(desc.epsilon),
                    "give a number of texels above 0");
    if (desc.method == CaptureMethod::tessellated && epoxy_gl_version() < 40)
        throw Error(ErrorKind::unsupported, "tessellated capture", "the context is older than OpenGL 4.0",
                    "make a newer one or use exact");
    if (desc.method == CaptureMethod::tessellated && desc.layers == LayerOrder::allAtOnce)
        throw Error(ErrorKind::badArgument, "tessellated capture into all layers at once",
                    "there is no such order", "draw one layer at a time or use exact");
    const bool textbookMap = desc.map == MapKind::tennisBall || desc.map == MapKind::dualParaboloid;
    if (desc.depthTerm == DepthTerm::textbook && !(textbookMap && desc.method == CaptureMethod::perVertex))
        throw Error(ErrorKind::badArgument, "textbook depth terms",
                    "there are none for this method on the " + std::string(mapInfo(desc.map).name) + " map",
                    "use perVertex on tennis-ball or dual-paraboloid");
    if (desc.layersOfDepth < 1 || desc.layersOfDepth > 2 || !(desc.layerSeparation >= 0.0f))
        throw Error(ErrorKind::badArgument, "a probe's layers of depth",
                    std::to_string(desc.layersOfDepth) + ", separated by " +
                        std::to_string(desc.layerSeparation),
                    "ask for 1 or 2, separated by 0 or more");
    size = capture::mapSize(desc.map, desc.n);
    drawSize = capture::mapSize(desc.map, desc.n * desc.supersample);
    const gl::StateGuard guard(0, 1);
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
        capture::bindBorrowed(desc.distanceTexture, GL_TEXTURE_2D_ARRAY, size, "a host's distance texture");
    }
    depth = capture::makeDepth(drawSize);
    const gl::Texture* const depthOfTexels = isSupersampled() ? nullptr : &depth;
    const auto make = [&](int lastDistanceLevel = 0) {
        return capture::makeMapTextures(size, desc.colour, depthOfTexels, lastDistanceLevel);
    };
    front = isBorrowed() ? capture::borrowMapTextures(size, desc.colourTexture, desc.distanceTexture)
                         : make(nearestLevel());
    back = make(nearestLevel());
    clear(front, size);
    if (isSupersampled())
        samples = capture::makeMapTextures(drawSize, desc.colour, &depth);
    if (desc.layersOfDepth < 2)
        return;
    hiddenFront = make();
    hiddenBack = make();
    clear(hiddenFront, size);
    if (isSupersampled())
        hiddenSamples = capture::makeMapTextures(drawSize, desc.colour, &depth);
    // The host's materials use the first ones.
    peelUnit = gl::integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1;
}

const capture::MapTextures& ReflectionProbe::Implementation::target() const
{
    if (isSupersampled())
        return peeling ? hiddenSamples : samples;
    return peeling ? hiddenBack : back;
}

void ReflectionProbe::Implementation::clear(const capture::MapTextures& textures,
                                            const MapSize& viewport) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, textures.allLayers.name());
    glViewport(0, 0, viewport.width, viewport.height);
    glClearBufferfv(GL_COLOR, 0, glm::value_ptr(desc.background));
    const float nothing[4] = {std::numeric_limits<float>::infinity(), 0.0f, 0.0f, 0.0f};
    glClearBufferfv(GL_COLOR, 1, nothing);
    const float farthest = desc.depthTerm == DepthTerm::textbook ? 1.0f : 0.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

// What the host's draws must be made of.
unsigned int ReflectionProbe::Implementation::primitive() const
{
    const bool cuts = desc.method == CaptureMethod::tessellated && !capture::isPiecewiseLinear(desc.map);
    return cuts ? GL_PATCHES : GL_TRIANGLES;
}

unsigned int ReflectionProbe::Implementation::use(const CaptureMesh& mesh, int view)
{
    const capture::Variant variant = frame.variantOf(mesh, view, peeling);
    const Path path = variant.path;
    const LinkedProgram& linked = mesh.program->implementation().program(variant);
    // Set again for every draw: the callback may have changed any of it.
    const auto layer = static_cast<std::size_t>(view < 0 ? 0 : capture::layerOfView(desc.map, view));
    glBindFramebuffer(GL_FRAMEBUFFER, view < 0 ? target().allLayers.name() : target().layers[layer].name());
    if (peeling)
        bindFirstLayer();
    glViewport(0, 0, drawSize.width, drawSize.height);
    glUseProgram(linked.program.name());
    capture::setUniforms(linked, frame, desc.map, view, drawSize);
    if (peeling) {
        glUniform1i(linked.firstDistance, peelUnit);
        glUniform1i(linked.layer, static_cast<GLint>(layer));
        glUniform1f(linked.separation, desc.layerSeparation);
    }
    for (GLenum plane = 0; plane < 3; ++plane)
        (linked.usesClipDistances ? glEnable : glDisable)(GL_CLIP_DISTANCE0 + plane);
    // Covering polygons have no winding of their own: the geometry shader culls.
    (mesh.cullBackFaces && path != Path::exact ? glEnable : glDisable)(GL_CULL_FACE);
    if (path == Path::tessellated)
        glPatchParameteri(GL_PATCH_VERTICES, 3);
    glUniform1i(linked.cullBackFaces, mesh.cullBackFaces ? 1 : 0);
    // With all at once the geometry shader has turned front faces counter-clockwise.
    glFrontFace(view < 0 || capture::orientation(desc.map, view) > 0 ? GL_CCW : GL_CW);
    ++report.draws;
    report.drawsExact += path == Path::exact ? 1 : 0;
    report.drawsMapped += path == Path::mapped ? 1 : 0;
    report.triangles += mesh.triangles;
    return linked.program.name();
}

void ReflectionProbe::Implementation::bindFirstLayer() const
{
    const GLint active = gl::integer(GL_ACTIVE_TEXTURE);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(peelUnit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, (isSupersampled() ? samples : back).distance.name());
    glBindSampler(static_cast<GLuint>(peelUnit), 0);
    glActiveTexture(static_cast<GLenum>(active));
}

void ReflectionProbe::Implementation::drawOneAtATime(std::span<const CaptureMesh> meshes,
                                                     const DrawMesh& draw)
{
    const std::vector<bool> wanted =
        peeling ? capture::mayBeHidden(meshes, frame, static_cast<double>(desc.layerSeparation))
                : std::vector<bool>(meshes.size(), true);
    for (int view = 0; view < capture::viewCount(desc.map); ++view)
        for (std::size_t index = 0; index < meshes.size(); ++index) {
            const CaptureMesh& mesh = meshes[index];
            if (!wanted[index] || (mesh.bounds && !frame.touches(view, *mesh.bounds)))
                ++report.drawsCulled;
            else
                draw(mesh, {use(mesh, view), view, primitive()});
        }
}

// Where varyings leave no room for all layers in one draw, each view has its own.
bool ReflectionProbe::Implementation::fitsAtOnce(const CaptureMesh& mesh) const
{
    return allAtOnce && mesh.program->implementation().fits(frame.variantOf(mesh, -1, peeling));
}

void ReflectionProbe::Implementation::drawAllAtOnce(std::span<const CaptureMesh> meshes, const DrawMesh& draw)
{
    for (const CaptureMesh& mesh : meshes) {
        std::vector<int> touched;
        for (int view = 0; view < capture::viewCount(desc.map); ++view)
            if (!mesh.bounds || frame.touches(view, *mesh.bounds))
                touched.push_back(view);
        if (touched.empty())
            ++report.drawsCulled;
        else if (fitsAtOnce(mesh))
            touched = {-1};
        for (const int view : touched)
            draw(mesh, {use(mesh, view), view, primitive()});
    }
}

void ReflectionProbe::Implementation::compile(std::span<const CaptureMesh> meshes)
{
    if (desc.layersOfDepth == 2) {
        const RaisedFlag raised(peeling);
        for (const CaptureMesh& mesh : meshes)
            for (int view = 0; view < capture::viewCount(desc.map); ++view)
                mesh.program->implementation().program(frame.variantOf(mesh, view, peeling));
    }
    for (const CaptureMesh& mesh : meshes) {
        const bool together = fitsAtOnce(mesh);
        for (int view = together ? -1 : 0; view < (together ? 0 : capture::viewCount(desc.map)); ++view)
            mesh.program->implementation().program(frame.variantOf(mesh, view, peeling));
    }
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

void ReflectionProbe::setCaptureOrigin(const glm::dvec3& captureOrigin)
{
    capture::requireFinite(captureOrigin, "a capture origin");
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
    const gl::StateGuard guard(std::max(peelUnit, 0), peelUnit < 0 ? 0 : 1);
    guard.neutralise();
    if (desc.depthTerm == DepthTerm::radial) {
        glDepthFunc(GL_GREATER);
        if (capture::hasClipControl())
            glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    report = {};
    report.texels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                    static_cast<std::size_t>(size.layers);
    clear(target(), drawSize);
    drawLayerOfDepth();
    if (desc.layersOfDepth == 2) {
        const RaisedFlag isPeeling(peeling);
        clear(target(), drawSize);
        drawLayerOfDepth();
    }
    finish();
    return report;
}

void ReflectionProbe::Implementation::finish()
{
    const gl::StateGuard guard(0, 2);
    guard.neutralise(); // the callback may have changed anything
    if (isSupersampled())
        copies.reduce(samples, back, size, desc.supersample);
    if (isSupersampled() && desc.layersOfDepth == 2)
        copies.reduce(hiddenSamples, hiddenBack, size, desc.supersample);
    if (nearestLevel() > 0)
        copies.gatherNearest(back.distance, size, nearestLevel());
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
    for (const CaptureMesh& mesh : meshes) {
        if (mesh.program == nullptr)
            throw Error(ErrorKind::badArgument, "a capture of probe '" + self.desc.name + "'",
                        "a mesh has no program", "set CaptureMesh::program");
    }
    self.place();
    self.compile(meshes);
    return self.fill([&] {
        if (self.allAtOnce && !self.peeling)
            self.drawAllAtOnce(meshes, draw);
        else
            self.drawOneAtATime(meshes, draw);
    });
}

CaptureReport ReflectionProbe::capture(const DrawScene& drawScene)
{
    Implementation& self = *implementation_;
    self.requireReady();
    self.place();
    return self.fill([&] {
        const bool together = self.allAtOnce && !self.peeling;
        for (int id = together ? -1 : 0; id < (together ? 0 : viewCount()); ++id) {
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
    const gl::StateGuard guard(0, 2);
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
    if (mesh.program == nullptr)
        throw Error(ErrorKind::badArgument, "a view of probe '" + probe_->desc.name + "'",
                    "a mesh has no program", "set CaptureMesh::program");
    return probe_->use(mesh, view_);
}

} // namespace mirrorball
