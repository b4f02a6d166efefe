#include "capture/hidden.h"
#include "capture/probe_implementation.h"
#include "capture/uniforms.h"
#include "capture/views.h"
#include "gl/clear_guard.h"
#include "gl/context.h"

#include <epoxy/gl.h>

namespace mirrorball {

using capture::LinkedProgram;
using capture::Path;

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

void ReflectionProbe::Implementation::begin(int view) const
{
    const gl::ClearGuard guard; // the callback may have masked anything
    if (view < 0)
        clear(target().allLayers);
    else if (capture::layerOfView(desc.map, view) == view) // the first view of its layer
        clear(target().layers[static_cast<std::size_t>(view)]);
}

void ReflectionProbe::Implementation::drawOneAtATime(std::span<const CaptureMesh> meshes,
                                                     const DrawMesh& draw)
{
    const std::vector<bool> wanted =
        peeling ? capture::mayBeHidden(meshes, frame, static_cast<double>(desc.layerSeparation))
                : std::vector<bool>(meshes.size(), true);
    for (int view = 0; view < capture::viewCount(desc.map); ++view) {
        begin(view);
        for (std::size_t index = 0; index < meshes.size(); ++index) {
            const CaptureMesh& mesh = meshes[index];
            if (!wanted[index] || (mesh.bounds && !frame.touches(view, *mesh.bounds)))
                ++report.drawsCulled;
            else
                draw(mesh, {use(mesh, view), view, primitive()});
        }
    }
}

// Where varyings leave no room for all layers in one draw, each view has its own.
bool ReflectionProbe::Implementation::fitsAtOnce(const CaptureMesh& mesh) const
{
    return allAtOnce && mesh.program->implementation().fits(frame.variantOf(mesh, -1, peeling));
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
    if (desc.layersOfDepth == 2) {
        const capture::RaisedFlag raised(peeling);
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

} // namespace mirrorball
