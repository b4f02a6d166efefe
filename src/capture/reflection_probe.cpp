#include <mirrorball/capture/reflection_probe.h>

#include "capture/capture_program.h"
#include "capture/copies.h"
#include "capture/error_law.h"
#include "capture/filtered_map.h"
#include "capture/layer_check.h"
#include "capture/map_textures.h"
#include "capture/pose.h"
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
using capture::Pose;
using capture::rigidPose;

bool hasClipControl()
{
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
}

// Depth is 1 at near and 0 at far, linear in 1 / w: floats are dense towards 0, so that the relative
// precision is the same at every distance. Returns (a, b) of z = a * w + b in clip space, where w is the
// radial distance (or the homogeneous coordinate of a linear view).
glm::dvec2 reversedDepth(double near, double far, bool zeroToOne)
{
    const double inverseFar = 1.0 / far; // 0 for an infinite far
    const double b = 1.0 / (1.0 / near - inverseFar);
    const double a = -b * inverseFar;
    // Without clip control z runs from -1 to 1 in OpenGL's own way, and some of the precision is lost.
    return zeroToOne ? glm::dvec2(a, b) : glm::dvec2(2.0 * a - 1.0, 2.0 * b);
}

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
    Pose pose{};
    float near = 0.0f;
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
    void checkRange();
    void place();
    void clear(const capture::MapTextures& textures, const MapSize& viewport) const;
    glm::dmat4 probeFromWorld() const; // from positions relative to captureOrigin
    bool touches(int view, const Sphere& bounds) const;
    bool touches(int view, const Box& bounds) const;
    bool isBorrowed() const { return desc.colourTexture != 0; }
    // The level of the distances that has blocks a quarter of n wide, 22.5 degrees; 0 for none.
    int nearestLevel() const
    {
        return isBorrowed()
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
    capture::Variant variantOf(const CaptureMesh& mesh, int view) const;
    unsigned int use(const CaptureMesh& mesh, int view);
    unsigned int primitive() const;
    void setUniforms(const LinkedProgram& linked, int view) const;
    void bindFirstLayer() const;
    void publish();
};

ReflectionProbe::Implementation::Implementation(const Desc& given)
    : desc(given), pose(rigidPose(given.worldFromProbe))
{
    capture::requireFinite(desc.captureOrigin, "a capture origin");
    checkRange();
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

void ReflectionProbe::Implementation::checkRange()
{
    if (!(desc.halfExtent >= 0.0) || !std::isfinite(desc.halfExtent))
        throw Error(ErrorKind::badArgument, "a probe's half extent",
                    "it is " + std::to_string(desc.halfExtent), "give a finite number that is not negative");
    near = desc.near ? *desc.near : static_cast<float>(desc.halfExtent * pose.scale);
    const std::string found = "near is " + std::to_string(near) + " and far is " + std::to_string(desc.far);
    if (!(near > 0.0f) || !std::isfinite(near) || !(desc.far > near))
        throw Error(ErrorKind::badArgument, "the range of a probe", found, "give 0 < near < far");
}

glm::dmat4 ReflectionProbe::Implementation::probeFromWorld() const
{
    glm::dmat4 relative = pose.worldFromProbe;
    relative[3] = glm::dvec4(glm::dvec3(relative[3]) - desc.captureOrigin, 1.0);
    return glm::inverse(relative);
}

bool ReflectionProbe::Implementation::touches(int view, const Sphere& bounds) const
{
    const glm::dvec3 centre(probeFromWorld() * glm::dvec4(glm::dvec3(bounds.centre), 1.0));
    const double distance = glm::length(centre);
    // The host's bounds and vertices are floats: allow for the rounding of both.
    const double radius = static_cast<double>(bounds.radius) * (1.0 + 1e-5) + distance * 1e-6;
    if (std::isnan(distance) || std::isnan(radius))
        return true;
    if (distance + radius < static_cast<double>(near) || distance - radius > static_cast<double>(desc.far))
        return false;
    return capture::viewTouches(desc.map, view, centre, radius);
}

bool ReflectionProbe::Implementation::touches(int view, const Box& bounds) const
{
    // Spheres around parts of a box fit closely where one around a long or flat box would not.
    constexpr double partsAlongLongest = 8.0;
    const glm::dvec3 low(bounds.low), extent = glm::dvec3(bounds.high) - low;
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (!(std::min({extent.x, extent.y, extent.z}) >= 0.0) || !std::isfinite(longest))
        return true; // no box: nothing is known
    glm::ivec3 parts(1);
    for (int axis = 0; axis < 3 && longest > 0.0; ++axis)
        parts[axis] = std::max(1, static_cast<int>(std::ceil(extent[axis] * partsAlongLongest / longest)));
    const glm::dvec3 part = extent / glm::dvec3(parts);
    for (int x = 0; x < parts.x; ++x)
        for (int y = 0; y < parts.y; ++y)
            for (int z = 0; z < parts.z; ++z) {
                const glm::dvec3 centre = low + part * (glm::dvec3(x, y, z) + 0.5);
                // The centre is rounded to float: half an ulp of it, in three coordinates.
                const double rounding = 1.1e-7 * glm::length(centre);
                const double radius = (0.5 * glm::length(part) + rounding) * (1.0 + 1e-6);
                if (touches(view, Sphere{glm::vec3(centre), static_cast<float>(radius)}))
                    return true;
            }
    return false;
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

void ReflectionProbe::Implementation::setUniforms(const LinkedProgram& linked, int view) const
{
    const glm::mat4 matrix(probeFromWorld());
    glUniformMatrix4fv(linked.probeFromWorld, 1, GL_FALSE, glm::value_ptr(matrix));
    glUniform1i(linked.view, view);
    glUniform2f(linked.range, near, desc.far);
    glUniform2f(linked.size, static_cast<float>(drawSize.width), static_cast<float>(drawSize.height));

    if (linked.firstDistance >= 0) {
        glUniform1i(linked.firstDistance, peelUnit);
        glUniform1i(linked.layer, capture::layerOfView(desc.map, view));
        glUniform1f(linked.separation, desc.layerSeparation);
    }

    const capture::LinearRange reach = capture::isPiecewiseLinear(desc.map) ? capture::linearRange(desc.map)
                                                                            : capture::LinearRange{1.0, 1.0};
    const bool zeroToOne = linked.writesDepth || hasClipControl();
    const glm::dvec2 depthTerms = reversedDepth(static_cast<double>(near) * reach.smallest,
                                                static_cast<double>(desc.far) * reach.largest, zeroToOne);
    glUniform2f(linked.depth, static_cast<float>(depthTerms.x), static_cast<float>(depthTerms.y));
    if (!capture::hasLinearViews(desc.map))
        return;
    const int views = capture::viewCount(desc.map);
    std::vector<glm::mat3> clip, line, inward;
    for (int index = 0; index < views; ++index) {
        const capture::LinearView linear = capture::linearView(desc.map, index);
        clip.push_back(linear.clipFromDirection);
        line.push_back(linear.lineFromDirection);
        inward.push_back(linear.inwardPlanes);
    }
    glUniformMatrix3fv(linked.clipFromDirection, views, GL_FALSE, glm::value_ptr(clip[0]));
    glUniformMatrix3fv(linked.lineFromDirection, views, GL_FALSE, glm::value_ptr(line[0]));
    glUniformMatrix3fv(linked.inwardPlanes, views, GL_FALSE, glm::value_ptr(inward[0]));
}

capture::Variant ReflectionProbe::Implementation::variantOf(const CaptureMesh& mesh, int view) const
{
    capture::Variant variant{desc.map, Path::exact, view < 0 ? LayerOrder::allAtOnce : LayerOrder::oneAtATime,
                             desc.depthTerm, true};
    variant.peels = peeling;
    // Triangles that span less than this are nearly straight on the map, and a simple polygon covers each
    // closely.
    constexpr double largeSpan = 0.45;
    capture::MeshBounds seen{};
    if (mesh.bounds) {
        seen = {glm::dvec3(probeFromWorld() * glm::dvec4(glm::dvec3(mesh.bounds->centre), 1.0)),
                static_cast<double>(mesh.bounds->radius), static_cast<double>(mesh.longestEdge)};
        variant.large = !(seen.longestEdge < largeSpan * (glm::length(seen.centre) - seen.radius));
    }
    if (desc.method == CaptureMethod::exact)
        return variant;
    if (capture::isPiecewiseLinear(desc.map))
        variant.path = Path::linear;
    else if (desc.method == CaptureMethod::perVertex)
        variant.path = Path::textbook;
    else if (desc.method == CaptureMethod::tessellated)
        variant.path = Path::tessellated;
    else if (mesh.bounds && view >= 0 && // a draw into all layers at once has no one view to judge by
             capture::mappingSuffices(desc.map, view, seen, desc.n, static_cast<double>(desc.epsilon)))
        variant.path = Path::mapped;
    if (variant.path != Path::exact)
        variant.large = false;
    return variant;
}

// What the host's draws must be made of.
unsigned int ReflectionProbe::Implementation::primitive() const
{
    const bool cuts = desc.method == CaptureMethod::tessellated && !capture::isPiecewiseLinear(desc.map);
    return cuts ? GL_PATCHES : GL_TRIANGLES;
}

unsigned int ReflectionProbe::Implementation::use(const CaptureMesh& mesh, int view)
{
    const capture::Variant variant = variantOf(mesh, view);
    const Path path = variant.path;
    const LinkedProgram& linked = mesh.program->implementation().program(variant);
    // Set again for every draw: the callback may have changed any of it.
    const auto layer = static_cast<std::size_t>(view < 0 ? 0 : capture::layerOfView(desc.map, view));
    glBindFramebuffer(GL_FRAMEBUFFER, view < 0 ? target().allLayers.name() : target().layers[layer].name());
    if (peeling)
        bindFirstLayer();
    glViewport(0, 0, drawSize.width, drawSize.height);
    glUseProgram(linked.program.name());
    setUniforms(linked, view);
    for (GLenum plane = 0; plane < 3; ++plane)
        (linked.usesClipDistances ? glEnable : glDisable)(GL_CLIP_DISTANCE0 + plane);
    // Covering polygons have no winding of their own: the geometry shader culls.
    (mesh.cullBackFaces && path != Path::exact ? glEnable : glDisable)(GL_CULL_FACE);
    if (path == Path::tessellated) {
        glUniform1f(linked.steps, static_cast<float>(
                                      capture::tessellationSteps(desc.n, static_cast<double>(desc.epsilon))));
        glPatchParameteri(GL_PATCH_VERTICES, 3);
    }
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
    for (int view = 0; view < capture::viewCount(desc.map); ++view)
        for (const CaptureMesh& mesh : meshes) {
            if (mesh.bounds && !touches(view, *mesh.bounds))
                ++report.drawsCulled;
            else
                draw(mesh, {use(mesh, view), view, primitive()});
        }
}

// Where varyings leave no room for all layers in one draw, each view has its own.
bool ReflectionProbe::Implementation::fitsAtOnce(const CaptureMesh& mesh) const
{
    return allAtOnce && mesh.program->implementation().fits(variantOf(mesh, -1));
}

void ReflectionProbe::Implementation::drawAllAtOnce(std::span<const CaptureMesh> meshes, const DrawMesh& draw)
{
    for (const CaptureMesh& mesh : meshes) {
        std::vector<int> touched;
        for (int view = 0; view < capture::viewCount(desc.map); ++view)
            if (!mesh.bounds || touches(view, *mesh.bounds))
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
                mesh.program->implementation().program(variantOf(mesh, view));
    }
    for (const CaptureMesh& mesh : meshes) {
        const bool together = fitsAtOnce(mesh);
        for (int view = together ? -1 : 0; view < (together ? 0 : capture::viewCount(desc.map)); ++view)
            mesh.program->implementation().program(variantOf(mesh, view));
    }
}

void ReflectionProbe::Implementation::place()
{
    pose = rigidPose(desc.worldFromProbe);
    checkRange();
}

void ReflectionProbe::Implementation::publish()
{
    map = {desc.map,
           desc.n,
           isBorrowed() ? desc.colourTexture : front.colour.name(),
           isBorrowed() ? desc.distanceTexture : front.distance.name(),
           pose.worldFromProbe,
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
    return implementation_->near;
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
    return implementation_->touches(view, bounds);
}

bool ReflectionProbe::touches(int view, const Box& bounds) const
{
    return implementation_->touches(view, bounds);
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
        if (hasClipControl())
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
    return view_ < 0 || probe_->touches(view_, bounds);
}

bool CaptureView::touches(const Box& bounds) const
{
    return view_ < 0 || probe_->touches(view_, bounds);
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
