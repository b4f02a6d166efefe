#include <mirrorball/capture/reflection_probe.h>

#include "capture/capture_program.h"
#include "capture/error_law.h"
#include "capture/map_textures.h"
#include "capture/views.h"
#include "gl/context.h"
#include "gl/state_guard.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <string>

namespace mirrorball {

namespace {

using capture::LinkedProgram;
using capture::MapSize;
using capture::Path;

// The rotation and translation of a pose with uniform scale, and the scale.
struct Pose
{
    glm::dmat4 worldFromProbe; // rigid
    double scale;
};

Pose rigidPose(const glm::dmat4& worldFromProbe)
{
    const std::string asked = "a probe's pose";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(worldFromProbe[column][row]))
                throw Error(ErrorKind::badArgument, asked, "an element is not finite", "give finite numbers");
    const glm::dmat3 linear(worldFromProbe);
    const double scale = std::cbrt(std::abs(glm::determinant(linear)));
    if (!(scale > 0.0))
        throw Error(ErrorKind::badArgument, asked, "its scale is 0", "give a scale above 0");
    const glm::dmat3 rotation = linear / scale;
    // Rounding of a host's float matrices stays far below this; shear or unequal scale lies far above it.
    constexpr double tolerance = 1e-3;
    const glm::dmat3 unit = glm::transpose(rotation) * rotation;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(unit[column][row] - (column == row ? 1.0 : 0.0)) > tolerance)
                throw Error(ErrorKind::badArgument, asked, "it is not a rotation with uniform scale",
                            "leave out shear and unequal scale");
    if (glm::determinant(rotation) < 0.0)
        throw Error(ErrorKind::badArgument, asked, "it mirrors", "give a rotation with positive scale");
    glm::dmat4 rigid(rotation);
    rigid[3] = glm::dvec4(glm::dvec3(worldFromProbe[3]), 1.0);
    return {rigid, scale};
}

void requireFinite(const glm::dvec3& point, const std::string& asked)
{
    if (!(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)))
        throw Error(ErrorKind::badArgument, asked, "a coordinate is not finite", "give finite numbers");
}

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
    MapSize size{};
    gl::Texture depth;
    capture::MapTextures front, back; // what pass 2 reads, and what a capture draws into
    capture::MapTextures hiddenFront, hiddenBack; // the same for the second layer of depth, if there is one
    int peelUnit = -1;                            // the texture unit through which it sees the first
    bool peeling = false;                         // drawing the second layer
    ReflectionMap map;
    bool capturing = false;
    CaptureReport report;

    explicit Implementation(const Desc& given);
    void checkRange();
    void place();
    void clear(const capture::MapTextures& textures) const;
    glm::dmat4 probeFromWorld() const; // from positions relative to captureOrigin
    bool touches(int view, const Sphere& bounds) const;
    void drawOneAtATime(std::span<const CaptureMesh> meshes, const DrawMesh& draw);
    void drawAllAtOnce(std::span<const CaptureMesh> meshes, const DrawMesh& draw);
    // Everything that may fail in a capture, before the state is touched.
    void compile(std::span<const CaptureMesh> meshes);
    capture::Variant variantOf(const CaptureMesh& mesh, int view) const;
    void drawMesh(const CaptureMesh& mesh, int view, const DrawMesh& draw);
    void setUniforms(const LinkedProgram& linked, int view) const;
    void bindFirstLayer() const;
    void drawSecondLayer(std::span<const CaptureMesh> meshes, const DrawMesh& draw);
    void publish();
};

ReflectionProbe::Implementation::Implementation(const Desc& given)
    : desc(given), pose(rigidPose(given.worldFromProbe))
{
    requireFinite(desc.captureOrigin, "a capture origin");
    checkRange();
    gl::requireContext();
    capture::requireMapSize(desc.map, desc.n);
    if (!(desc.epsilon > 0.0f))
        throw Error(ErrorKind::badArgument, "a probe's epsilon", "it is " + std::to_string(desc.epsilon),
                    "give a number of texels above 0");
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

    const gl::StateGuard guard(0, 1);
    guard.neutralise();
    glActiveTexture(GL_TEXTURE0);
    depth = capture::makeDepth(size);
    front = capture::makeMapTextures(size, desc.colour, depth);
    back = capture::makeMapTextures(size, desc.colour, depth);
    clear(front);
    if (desc.layersOfDepth == 2) {
        hiddenFront = capture::makeMapTextures(size, desc.colour, depth);
        hiddenBack = capture::makeMapTextures(size, desc.colour, depth);
        // The host's materials use the first ones.
        peelUnit = gl::integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1;
        clear(hiddenFront);
    }
    publish();
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

void ReflectionProbe::Implementation::clear(const capture::MapTextures& textures) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, textures.allLayers.name());
    glViewport(0, 0, size.width, size.height);
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
    glUniform2f(linked.size, static_cast<float>(size.width), static_cast<float>(size.height));

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
    else if (mesh.bounds && view >= 0 && // a draw into all layers at once has no one view to judge by
             capture::mappingSuffices(desc.map, view, seen, desc.n, static_cast<double>(desc.epsilon)))
        variant.path = Path::mapped;
    if (variant.path != Path::exact)
        variant.large = false;
    return variant;
}

void ReflectionProbe::Implementation::drawMesh(const CaptureMesh& mesh, int view, const DrawMesh& draw)
{
    const capture::Variant variant = variantOf(mesh, view);
    const Path path = variant.path;
    const LinkedProgram& linked = mesh.program->implementation().program(variant);
    // Set again for every draw: the callback may have changed any of it.
    const auto layer = static_cast<std::size_t>(view < 0 ? 0 : capture::layerOfView(desc.map, view));
    const capture::MapTextures& target = peeling ? hiddenBack : back;
    glBindFramebuffer(GL_FRAMEBUFFER, view < 0 ? target.allLayers.name() : target.layers[layer].name());
    if (peeling)
        bindFirstLayer();
    glViewport(0, 0, size.width, size.height);
    glUseProgram(linked.program.name());
    setUniforms(linked, view);
    for (GLenum plane = 0; plane < 3; ++plane)
        (linked.usesClipDistances ? glEnable : glDisable)(GL_CLIP_DISTANCE0 + plane);
    // Covering polygons have no winding of their own: the geometry shader culls.
    (mesh.cullBackFaces && path != Path::exact ? glEnable : glDisable)(GL_CULL_FACE);
    glUniform1i(linked.cullBackFaces, mesh.cullBackFaces ? 1 : 0);
    // With all at once the geometry shader has turned front faces counter-clockwise.
    glFrontFace(view < 0 || capture::orientation(desc.map, view) > 0 ? GL_CCW : GL_CW);
    draw(mesh, {linked.program.name(), view});
    ++report.draws;
    report.drawsExact += path == Path::exact ? 1 : 0;
    report.drawsMapped += path == Path::mapped ? 1 : 0;
    report.triangles += mesh.triangles;
}

void ReflectionProbe::Implementation::bindFirstLayer() const
{
    const GLint active = gl::integer(GL_ACTIVE_TEXTURE);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(peelUnit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, back.distance.name());
    glBindSampler(static_cast<GLuint>(peelUnit), 0);
    glActiveTexture(static_cast<GLenum>(active));
}

void ReflectionProbe::Implementation::drawSecondLayer(std::span<const CaptureMesh> meshes,
                                                      const DrawMesh& draw)
{
    const RaisedFlag raised(peeling);
    clear(hiddenBack);
    drawOneAtATime(meshes, draw);
}

void ReflectionProbe::Implementation::drawOneAtATime(std::span<const CaptureMesh> meshes,
                                                     const DrawMesh& draw)
{
    for (int view = 0; view < capture::viewCount(desc.map); ++view)
        for (const CaptureMesh& mesh : meshes) {
            if (mesh.bounds && !touches(view, *mesh.bounds))
                ++report.drawsCulled;
            else
                drawMesh(mesh, view, draw);
        }
}

void ReflectionProbe::Implementation::drawAllAtOnce(std::span<const CaptureMesh> meshes, const DrawMesh& draw)
{
    for (const CaptureMesh& mesh : meshes) {
        bool touched = !mesh.bounds;
        for (int view = 0; view < capture::viewCount(desc.map) && !touched; ++view)
            touched = touches(view, *mesh.bounds);
        if (touched)
            drawMesh(mesh, -1, draw);
        else
            ++report.drawsCulled;
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
    const bool together = desc.layers == LayerOrder::allAtOnce;
    for (const CaptureMesh& mesh : meshes)
        for (int view = together ? -1 : 0; view < (together ? 0 : capture::viewCount(desc.map)); ++view)
            mesh.program->implementation().program(variantOf(mesh, view));
}

void ReflectionProbe::Implementation::place()
{
    pose = rigidPose(desc.worldFromProbe);
    checkRange();
}

void ReflectionProbe::Implementation::publish()
{
    map = {desc.map, desc.n, front.colour.name(), front.distance.name(), pose.worldFromProbe,
           hiddenFront.colour.name(), hiddenFront.distance.name()};
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
    requireFinite(captureOrigin, "a capture origin");
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

const ReflectionMap& ReflectionProbe::map() const
{
    return implementation_->map;
}

CaptureReport ReflectionProbe::capture(std::span<const CaptureMesh> meshes, const DrawMesh& draw)
{
    Implementation& self = *implementation_;
    if (self.capturing)
        throw Error(ErrorKind::hostBusy, "a capture of probe '" + self.desc.name + "'",
                    "this probe is being captured already", "call it after the draw callback has returned");
    gl::requireContext();
    for (const CaptureMesh& mesh : meshes) {
        if (mesh.program == nullptr)
            throw Error(ErrorKind::badArgument, "a capture of probe '" + self.desc.name + "'",
                        "a mesh has no program", "set CaptureMesh::program");
    }
    self.place();
    self.compile(meshes);

    const RaisedFlag capturing(self.capturing);
    const gl::StateGuard guard(std::max(self.peelUnit, 0), self.peelUnit < 0 ? 0 : 1);
    guard.neutralise();
    if (self.desc.depthTerm == DepthTerm::radial) {
        glDepthFunc(GL_GREATER);
        if (hasClipControl())
            glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    self.report = {};
    self.report.texels = static_cast<std::size_t>(self.size.width) *
                         static_cast<std::size_t>(self.size.height) *
                         static_cast<std::size_t>(self.size.layers);
    self.clear(self.back);
    if (self.desc.layers == LayerOrder::allAtOnce)
        self.drawAllAtOnce(meshes, draw);
    else
        self.drawOneAtATime(meshes, draw);
    if (self.desc.layersOfDepth == 2)
        self.drawSecondLayer(meshes, draw);
    std::swap(self.front, self.back);
    std::swap(self.hiddenFront, self.hiddenBack);
    self.publish();
    return self.report;
}

} // namespace mirrorball
