#include "capture/hidden.h"
#include "capture/probe_implementation.h"
#include "capture/uniforms.h"
#include "capture/views.h"
#include "gl/clear_guard.h"
#include "gl/context.h"
#include "gl/state_guard.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <atomic>

namespace mirrorball {

using capture::LinkedProgram;
using capture::Path;

namespace {

// Exact draws into a view from which leaving out what is hidden pays.
constexpr int fewestExactDraws = 32;

// The farthest distances are gathered after so many draws, twice as many, four times as many …
constexpr std::size_t firstBatch = 8;

} // namespace

// What the host's draws must be made of.
unsigned int ReflectionProbe::Implementation::primitive() const
{
    const bool cuts = desc.method == CaptureMethod::tessellated && !capture::isPiecewiseLinear(desc.map);
    return cuts ? GL_PATCHES : GL_TRIANGLES;
}

// What all draws into a view have in common.
void ReflectionProbe::Implementation::beginDraws(int view)
{
    static std::atomic<std::uint64_t> serials =
        0; // of the process: a program may draw for several probes in turn
    viewSerial = ++serials;
    const auto layer = static_cast<std::size_t>(view < 0 ? 0 : capture::layerOfView(desc.map, view));
    glBindFramebuffer(GL_FRAMEBUFFER, view < 0 ? target().allLayers.name() : target().layers[layer].name());
    glViewport(0, 0, targetSize().width, targetSize().height);
    for (GLenum plane = 0; plane < 3; ++plane)
        glDisable(GL_CLIP_DISTANCE0 + plane);
    glDisable(GL_CULL_FACE);
    // With all at once the geometry shader has turned front faces counter-clockwise.
    glFrontFace(view < 0 || capture::orientation(desc.map, view) > 0 ? GL_CCW : GL_CW);
    if (primitive() == GL_PATCHES)
        glPatchParameteri(GL_PATCH_VERTICES, 3);
    applied = {view, false, false};
}

unsigned int ReflectionProbe::Implementation::use(const CaptureMesh& mesh, int view, capture::Variant variant)
{
    variant.hides = hides && variant.path == Path::exact;
    LinkedProgram& linked = mesh.program->implementation().program(variant);
    if (!applied || applied->view != view)
        beginDraws(view);
    if (peeling || hides)
        bindToLastUnits(); // a host may clear all units after a draw
    // A host may end its draws with none; but programs used again are checked again, which costs more than a draw.
    if (gl::integer(GL_CURRENT_PROGRAM) != static_cast<int>(linked.program.name()))
        glUseProgram(linked.program.name());
    if (linked.preparedFor != viewSerial) {
        capture::setUniforms(linked, frame, desc.map, view, targetSize(), abilities.clipControl);
        glUniform1i(linked.firstAround, firstUnit);
        glUniform1f(linked.texelsPerSample, 1.0f / static_cast<float>(desc.supersample));
        glUniform1i(linked.layer, view < 0 ? 0 : capture::layerOfView(desc.map, view));
        glUniform1f(linked.separation, desc.layerSeparation);
        glUniform1i(linked.farthest, firstUnit + 1);
        glUniform1i(linked.cullBackFaces, mesh.cullBackFaces ? 1 : 0);
        linked.preparedFor = viewSerial;
        linked.cullsBackFaces = mesh.cullBackFaces;
    } else if (linked.cullsBackFaces != mesh.cullBackFaces) {
        glUniform1i(linked.cullBackFaces, mesh.cullBackFaces ? 1 : 0);
        linked.cullsBackFaces = mesh.cullBackFaces;
    }
    if (applied->clipDistances != linked.usesClipDistances) {
        applied->clipDistances = linked.usesClipDistances;
        for (GLenum plane = 0; plane < 3; ++plane)
            (linked.usesClipDistances ? glEnable : glDisable)(GL_CLIP_DISTANCE0 + plane);
    }
    // Covering polygons have no winding of their own: the geometry shader culls.
    const bool cullsFaces = mesh.cullBackFaces && variant.path != Path::exact;
    if (applied->cullsFaces != cullsFaces) {
        applied->cullsFaces = cullsFaces;
        (cullsFaces ? glEnable : glDisable)(GL_CULL_FACE);
    }
    ++report.draws;
    report.drawsExact += variant.path == Path::exact ? 1 : 0;
    report.drawsMapped += variant.path == Path::mapped ? 1 : 0;
    report.triangles += mesh.triangles;
    return linked.program.name();
}

void ReflectionProbe::Implementation::bindToLastUnits()
{
    const GLint active = gl::integer(GL_ACTIVE_TEXTURE);
    const GLuint textures[2] = {peeling ? firstAround.name() : 0u,
                                hides ? targetBlocks().texture().name() : 0u};
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
    const gl::StateGuard guard(abilities, 0, 1);
    guard.neutralise();
    hides = targetBlocks().gather(target().distance, capture::layerOfView(desc.map, view));
    applied.reset();
}

void ReflectionProbe::Implementation::begin(int view)
{
    const bool isFirstOfLayer = view < 0 || capture::layerOfView(desc.map, view) == view;
    hides = false;
    applied.reset();
    const gl::ClearGuard guard(abilities); // the callback may have masked anything
    if (view < 0)
        clear(target().allLayers);
    else if (isFirstOfLayer)
        clear(target().layers[static_cast<std::size_t>(view)]);
}

ReflectionProbe::Implementation::PlannedView
ReflectionProbe::Implementation::planOneView(int view, std::span<const CaptureMesh> meshes,
                                             const std::vector<bool>& wanted) const
{
    PlannedView plan{view};
    int exact = 0;
    for (std::size_t index = 0; index < meshes.size(); ++index) {
        if (!wanted[index] || (meshes[index].bounds && !frame.touches(view, *meshes[index].bounds))) {
            ++plan.culled;
            continue;
        }
        plan.draws.push_back({index, view, frame.variantOf(meshes[index], view, peeling)});
        exact += plan.draws.back().variant.path == Path::exact ? 1 : 0;
    }
    plan.nearFirst = desc.nearFirst && exact >= fewestExactDraws;
    if (plan.nearFirst)
        std::ranges::stable_sort(plan.draws, {}, [&](const PlannedDraw& planned) {
            return frame.distanceTo(meshes[planned.mesh]);
        });
    return plan;
}

// Where varyings leave no room for all layers in one draw, each view has its own.
ReflectionProbe::Implementation::PlannedView
ReflectionProbe::Implementation::planAllAtOnce(std::span<const CaptureMesh> meshes) const
{
    PlannedView plan{-1};
    for (std::size_t index = 0; index < meshes.size(); ++index) {
        const CaptureMesh& mesh = meshes[index];
        const capture::Variant together = frame.variantOf(mesh, -1, peeling);
        const bool fits = mesh.program->implementation().fits(together);
        bool isTouched = false;
        for (int view = 0; view < capture::viewCount(desc.map) && !(isTouched && fits); ++view) {
            if (mesh.bounds && !frame.touches(view, *mesh.bounds))
                continue;
            isTouched = true;
            plan.draws.push_back(fits ? PlannedDraw{index, -1, together}
                                      : PlannedDraw{index, view, frame.variantOf(mesh, view, peeling)});
        }
        plan.culled += isTouched ? 0 : 1;
    }
    return plan;
}

ReflectionProbe::Implementation::Plan
ReflectionProbe::Implementation::planOf(std::span<const CaptureMesh> meshes) const
{
    if (together())
        return {planAllAtOnce(meshes)};
    const std::vector<bool> wanted =
        peeling ? capture::mayBeHidden(meshes, frame, static_cast<double>(desc.layerSeparation))
                : std::vector<bool>(meshes.size(), true);
    Plan plan;
    for (int view = 0; view < capture::viewCount(desc.map); ++view)
        plan.push_back(planOneView(view, meshes, wanted));
    return plan;
}

void ReflectionProbe::Implementation::compile(const Plan& plan, std::span<const CaptureMesh> meshes) const
{
    for (const PlannedView& planned : plan)
        for (const PlannedDraw& each : planned.draws) {
            CaptureProgram::Implementation& program = meshes[each.mesh].program->implementation();
            capture::Variant variant = each.variant;
            program.program(variant);
            variant.hides = planned.nearFirst && variant.path == Path::exact;
            if (variant.hides)
                program.program(variant);
        }
    // Errors of a program show in the first capture, also where all its meshes are out of sight.
    for (const CaptureMesh& mesh : meshes)
        if (CaptureProgram::Implementation& program = mesh.program->implementation();
            program.programs.empty())
            program.program(frame.variantOf(mesh, 0, peeling));
}

void ReflectionProbe::Implementation::draw(const Plan& plan, std::span<const CaptureMesh> meshes,
                                           const DrawMesh& drawMesh)
{
    for (const PlannedView& planned : plan) {
        begin(planned.view);
        report.drawsCulled += planned.culled;
        std::size_t next = firstBatch;
        for (std::size_t turn = 0; turn < planned.draws.size(); ++turn) {
            if (planned.nearFirst && turn == next) {
                gatherFarthest(planned.view);
                next *= 2;
            }
            const auto& [mesh, view, variant] = planned.draws[turn];
            drawMesh(meshes[mesh], {use(meshes[mesh], view, variant), view, primitive()});
        }
    }
}

} // namespace mirrorball
