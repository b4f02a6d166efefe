#include "capture/hidden.h"
#include "capture/probe_implementation.h"
#include "capture/uniforms.h"
#include "capture/views.h"
#include "gl/clear_guard.h"
#include "gl/context.h"
#include "gl/state_guard.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace mirrorball {

using capture::LinkedProgram;
using capture::Path;

namespace {

// Exact draws into a view from which leaving out what is hidden pays.
constexpr int fewestExactDraws = 32;

// The farthest distances are gathered after so many draws, twice as many, four times as many …
constexpr std::size_t firstBatch = 8;

} // namespace

std::vector<bool> ReflectionProbe::Implementation::wantedInLayer(std::span<const CaptureMesh> meshes) const
{
    return peeling ? capture::mayBeHidden(meshes, frame, static_cast<double>(desc.layerSeparation))
                   : std::vector<bool>(meshes.size(), true);
}

// What the host's draws must be made of.
unsigned int ReflectionProbe::Implementation::primitive() const
{
    const bool cuts = desc.method == CaptureMethod::tessellated && !capture::isPiecewiseLinear(desc.map);
    return cuts ? GL_PATCHES : GL_TRIANGLES;
}

unsigned int ReflectionProbe::Implementation::use(const CaptureMesh& mesh, int view)
{
    const capture::Variant variant = frame.variantOf(mesh, view, peeling, hides);
    const Path path = variant.path;
    const LinkedProgram& linked = mesh.program->implementation().program(variant);
    // Set again for every draw: the callback may have changed any of it.
    const auto layer = static_cast<std::size_t>(view < 0 ? 0 : capture::layerOfView(desc.map, view));
    glBindFramebuffer(GL_FRAMEBUFFER, view < 0 ? target().allLayers.name() : target().layers[layer].name());
    if (peeling || variant.hides)
        bindToLastUnits();
    glViewport(0, 0, drawSize.width, drawSize.height);
    glUseProgram(linked.program.name());
    capture::setUniforms(linked, frame, desc.map, view, drawSize);
    if (peeling) {
        glUniform1i(linked.firstDistance, firstUnit);
        glUniform1i(linked.layer, static_cast<GLint>(layer));
        glUniform1f(linked.separation, desc.layerSeparation);
    }
    if (variant.hides)
        glUniform1i(linked.farthest, firstUnit + 1);
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

void ReflectionProbe::Implementation::bindToLastUnits() const
{
    const GLint active = gl::integer(GL_ACTIVE_TEXTURE);
    const GLuint textures[2] = {peeling ? (isSupersampled() ? samples : back).distance.name() : 0u,
                                hides ? farthestBlocks.texture().name() : 0u};
    for (GLuint index = 0; index < 2; ++index) {
        if (textures[index] == 0)
            continue;
        glActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(firstUnit) + index);
        glBindTexture(GL_TEXTURE_2D_ARRAY, textures[index]);
        glBindSampler(static_cast<GLuint>(firstUnit) + index, 0);
    }
    glActiveTexture(static_cast<GLenum>(active));
}

void ReflectionProbe::Implementation::gatherFarthest(int view)
{
    const gl::StateGuard guard(0, 1);
    guard.neutralise();
    hides = farthestBlocks.gather(target().distance, capture::layerOfView(desc.map, view));
}

void ReflectionProbe::Implementation::begin(int view)
{
    const bool isFirstOfLayer = view < 0 || capture::layerOfView(desc.map, view) == view;
    hides = false;
    const gl::ClearGuard guard; // the callback may have masked anything
    if (view < 0)
        clear(target().allLayers);
    else if (isFirstOfLayer)
        clear(target().layers[static_cast<std::size_t>(view)]);
}

ReflectionProbe::Implementation::Draws
ReflectionProbe::Implementation::drawsInto(int view, std::span<const CaptureMesh> meshes,
                                           const std::vector<bool>& wanted) const
{
    Draws draws;
    int exact = 0;
    for (std::size_t index = 0; index < meshes.size(); ++index) {
        if (!wanted[index] || (meshes[index].bounds && !frame.touches(view, *meshes[index].bounds)))
            continue;
        draws.meshes.push_back(index);
        exact += frame.variantOf(meshes[index], view, peeling, true).hides ? 1 : 0;
    }
    draws.nearFirst = desc.nearFirst && exact >= fewestExactDraws;
    if (draws.nearFirst)
        std::ranges::stable_sort(draws.meshes, {},
                                 [&](std::size_t index) { return frame.distanceTo(meshes[index]); });
    return draws;
}

void ReflectionProbe::Implementation::drawOneAtATime(std::span<const CaptureMesh> meshes,
                                                     const DrawMesh& draw)
{
    const std::vector<bool> wanted = wantedInLayer(meshes);
    for (int view = 0; view < capture::viewCount(desc.map); ++view) {
        begin(view);
        const Draws draws = drawsInto(view, meshes, wanted);
        report.drawsCulled += static_cast<int>(meshes.size() - draws.meshes.size());
        std::size_t next = firstBatch;
        for (std::size_t turn = 0; turn < draws.meshes.size(); ++turn) {
            if (draws.nearFirst && turn == next) {
                gatherFarthest(view);
                next *= 2;
            }
            const CaptureMesh& mesh = meshes[draws.meshes[turn]];
            draw(mesh, {use(mesh, view), view, primitive()});
        }
    }
}

// Where varyings leave no room for all layers in one draw, each view has its own.
bool ReflectionProbe::Implementation::fitsAtOnce(const CaptureMesh& mesh) const
{
    return together() && mesh.program->implementation().fits(frame.variantOf(mesh, -1, peeling, false));
}

void ReflectionProbe::Implementation::drawAllAtOnce(std::span<const CaptureMesh> meshes, const DrawMesh& draw)
{
    begin(-1);
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
    compileLayer(meshes);
    if (desc.layersOfDepth == 2) {
        const capture::RaisedFlag isPeeling(peeling);
        compileLayer(meshes);
    }
}

void ReflectionProbe::Implementation::compileLayer(std::span<const CaptureMesh> meshes)
{
    const std::vector<bool> wanted = wantedInLayer(meshes);
    const auto compileFor = [&](const CaptureMesh& mesh, int view, bool hiding) {
        mesh.program->implementation().program(frame.variantOf(mesh, view, peeling, hiding));
    };
    for (const CaptureMesh& mesh : meshes)
        if (fitsAtOnce(mesh))
            compileFor(mesh, -1, false);
    for (int view = 0; view < capture::viewCount(desc.map); ++view) {
        const bool nearFirst = !together() && drawsInto(view, meshes, wanted).nearFirst;
        for (const CaptureMesh& mesh : meshes) {
            if (fitsAtOnce(mesh))
                continue;
            compileFor(mesh, view, false);
            if (nearFirst)
                compileFor(mesh, view, true);
        }
    }
}

} // namespace mirrorball
