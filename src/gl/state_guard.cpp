#include "gl/state_guard.h"

#include "gl/context.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <span>

namespace mirrorball::gl {

namespace {

struct TextureTarget
{
    GLenum target, binding;
};

// The targets that the library binds.
constexpr std::array<TextureTarget, 4> textureTargets = {
    {{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
     {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE},
     {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
     {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER}}};

constexpr std::array<GLenum, 14> transferParameterNames = {
    GL_PACK_SWAP_BYTES,    GL_PACK_LSB_FIRST,    GL_PACK_ROW_LENGTH,     GL_PACK_SKIP_ROWS,
    GL_PACK_SKIP_PIXELS,   GL_PACK_ALIGNMENT,    GL_PACK_SKIP_IMAGES,    GL_UNPACK_SWAP_BYTES,
    GL_UNPACK_LSB_FIRST,   GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SKIP_PIXELS, GL_UNPACK_ALIGNMENT};
constexpr std::array<GLenum, 2> moreTransferParameterNames = {GL_PACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES};

void setEnabled(GLenum capability, bool enabled)
{
    if (enabled)
        glEnable(capability);
    else
        glDisable(capability);
}

void setEnabled(GLenum capability, GLuint index, bool enabled)
{
    if (enabled)
        glEnablei(capability, index);
    else
        glDisablei(capability, index);
}

// A name that the host deleted meanwhile is restored as 0, since binding a dead name is an error.
template <class IsName>
GLuint alive(int name, IsName isName)
{
    const auto unsignedName = static_cast<GLuint>(name);
    return unsignedName != 0 && isName(unsignedName) ? unsignedName : 0u;
}

} // namespace

StateGuard::StateGuard(const Abilities& abilities, int firstUnit, int units) : abilities_(abilities)
{
    drawFramebuffer_ = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    readFramebuffer_ = integer(GL_READ_FRAMEBUFFER_BINDING);
    renderbuffer_ = integer(GL_RENDERBUFFER_BINDING);
    program_ = integer(GL_CURRENT_PROGRAM);
    pipeline_ = abilities_.pipelines ? integer(GL_PROGRAM_PIPELINE_BINDING) : 0;
    vertexArray_ = integer(GL_VERTEX_ARRAY_BINDING);
    arrayBuffer_ = integer(GL_ARRAY_BUFFER_BINDING);
    uniformBuffer_ = integer(GL_UNIFORM_BUFFER_BINDING);
    copyReadBuffer_ = integer(GL_COPY_READ_BUFFER_BINDING);
    copyWriteBuffer_ = integer(GL_COPY_WRITE_BUFFER_BINDING);
    readToggles();
    readFramebufferState();
    readRasterState();
    readTransferState();
    readUnits(firstUnit, units);
}

StateGuard::~StateGuard()
{
    restoreBindings();
    restoreUnits();
    restoreTransferState();
    restoreRasterState();
    restoreToggles();
}

void StateGuard::readToggles()
{
    for (const GLenum capability : abilities_.switches)
        toggles_.push_back({capability, glIsEnabled(capability) == GL_TRUE});
    // Also those with an index are asked without: a threaded driver remembers the two kinds of calls apart.
    for (const GLenum capability : {GLenum{GL_BLEND}, GLenum{GL_SCISSOR_TEST}})
        toggles_.push_back({capability, glIsEnabled(capability) == GL_TRUE});
    toggles_.push_back({GL_DEPTH_TEST, glIsEnabled(GL_DEPTH_TEST) == GL_TRUE});
    for (GLuint buffer = 0; buffer < static_cast<GLuint>(abilities_.drawBuffers); ++buffer)
        indexedToggles_.push_back({GL_BLEND, buffer, glIsEnabledi(GL_BLEND, buffer) == GL_TRUE});
    for (GLuint viewport = 0; viewport < static_cast<GLuint>(abilities_.viewports); ++viewport) {
        const bool enabled = abilities_.viewportArrays ? glIsEnabledi(GL_SCISSOR_TEST, viewport) == GL_TRUE
                                                       : glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
        indexedToggles_.push_back({GL_SCISSOR_TEST, viewport, enabled});
    }
}

void StateGuard::readFramebufferState()
{
    colourMasks_.resize(static_cast<std::size_t>(abilities_.drawBuffers));
    for (GLuint buffer = 0; buffer < colourMasks_.size(); ++buffer)
        glGetBooleani_v(GL_COLOR_WRITEMASK, buffer, colourMasks_[buffer].data());
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    depthFunction_ = integer(GL_DEPTH_FUNC);

    const auto viewports = static_cast<std::size_t>(abilities_.viewports);
    viewports_.resize(viewports);
    scissors_.resize(viewports);
    depthRanges_.resize(viewports);
    if (!abilities_.viewportArrays) {
        glGetFloatv(GL_VIEWPORT, viewports_[0].data());
        glGetIntegerv(GL_SCISSOR_BOX, scissors_[0].data());
        glGetDoublev(GL_DEPTH_RANGE, depthRanges_[0].data());
        return;
    }
    for (GLuint index = 0; index < viewports; ++index) {
        glGetFloati_v(GL_VIEWPORT, index, viewports_[index].data());
        glGetIntegeri_v(GL_SCISSOR_BOX, index, scissors_[index].data());
        glGetDoublei_v(GL_DEPTH_RANGE, index, depthRanges_[index].data());
    }
}

void StateGuard::readRasterState()
{
    blends_.resize(abilities_.indexedBlend ? static_cast<std::size_t>(abilities_.drawBuffers) : 1);
    for (GLuint buffer = 0; buffer < blends_.size(); ++buffer) {
        const auto read = [&](GLenum name) {
            GLint value = 0;
            if (abilities_.indexedBlend)
                glGetIntegeri_v(name, buffer, &value);
            else
                value = integer(name);
            return value;
        };
        blends_[buffer] = {{read(GL_BLEND_SRC_RGB), read(GL_BLEND_DST_RGB), read(GL_BLEND_SRC_ALPHA),
                            read(GL_BLEND_DST_ALPHA)},
                           {read(GL_BLEND_EQUATION_RGB), read(GL_BLEND_EQUATION_ALPHA)}};
    }
    cullFace_ = integer(GL_CULL_FACE_MODE);
    frontFace_ = integer(GL_FRONT_FACE);
    provokingVertex_ = integer(GL_PROVOKING_VERTEX);
    patchVertices_ = abilities_.patches ? integer(GL_PATCH_VERTICES) : 0;
    glGetIntegerv(GL_POLYGON_MODE, polygonModes_.data()); // core contexts answer one value, others two
    if (abilities_.compatibility)
        clampFragmentColour_ = integer(GL_CLAMP_FRAGMENT_COLOR);
    if (abilities_.clipControl) {
        clipOrigin_ = integer(GL_CLIP_ORIGIN);
        clipDepth_ = integer(GL_CLIP_DEPTH_MODE);
    }
    sampleMasks_.resize(static_cast<std::size_t>(abilities_.sampleMaskWords));
    for (GLuint word = 0; word < sampleMasks_.size(); ++word) {
        GLint64 mask = 0; // a 32-bit query may clamp the highest bit away
        glGetInteger64i_v(GL_SAMPLE_MASK_VALUE, word, &mask);
        sampleMasks_[word] = static_cast<unsigned int>(mask);
    }
}

void StateGuard::readTransferState()
{
    transferBuffers_ = {integer(GL_PIXEL_PACK_BUFFER_BINDING), integer(GL_PIXEL_UNPACK_BUFFER_BINDING)};
    for (const GLenum name : transferParameterNames)
        transferParameters_.push_back(integer(name));
    for (const GLenum name : moreTransferParameterNames)
        transferParameters_.push_back(integer(name));
}

void StateGuard::readUnits(int firstUnit, int units)
{
    activeUnit_ = integer(GL_ACTIVE_TEXTURE);
    firstUnit_ = firstUnit;
    for (int unit = 0; unit < units; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(firstUnit + unit));
        Unit saved;
        for (const TextureTarget& target : textureTargets)
            saved.textures.push_back(integer(target.binding));
        saved.sampler = integer(GL_SAMPLER_BINDING);
        units_.push_back(saved);
    }
    glActiveTexture(static_cast<GLenum>(activeUnit_));
}

void StateGuard::neutralise() const
{
    for (const GLenum capability : abilities_.switches)
        glDisable(capability);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDepthRange(0.0, 1.0);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    if (abilities_.compatibility)
        glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    if (abilities_.clipControl)
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    for (GLuint word = 0; word < sampleMasks_.size(); ++word)
        glSampleMaski(word, ~0u);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (const auto names : {std::span<const GLenum>(transferParameterNames),
                             std::span<const GLenum>(moreTransferParameterNames)})
        for (const GLenum name : names)
            glPixelStorei(name, name == GL_PACK_ALIGNMENT || name == GL_UNPACK_ALIGNMENT ? 1 : 0);
}

void StateGuard::restoreToggles() const
{
    for (const Toggle& toggle : toggles_)
        setEnabled(toggle.capability, toggle.enabled);
    for (const IndexedToggle& toggle : indexedToggles_) {
        if (toggle.capability == GL_SCISSOR_TEST && !abilities_.viewportArrays)
            continue;
        setEnabled(toggle.capability, toggle.index, toggle.enabled);
    }
}

void StateGuard::restoreRasterState() const
{
    for (GLuint buffer = 0; buffer < colourMasks_.size(); ++buffer) {
        const auto& mask = colourMasks_[buffer];
        glColorMaski(buffer, mask[0], mask[1], mask[2], mask[3]);
    }
    glDepthMask(depthMask_);
    glDepthFunc(static_cast<GLenum>(depthFunction_));
    if (abilities_.viewportArrays) {
        const auto count = static_cast<GLsizei>(viewports_.size());
        glViewportArrayv(0, count, viewports_[0].data());
        glScissorArrayv(0, count, scissors_[0].data());
        glDepthRangeArrayv(0, count, depthRanges_[0].data());
    } else {
        const auto& viewport = viewports_[0];
        glViewport(static_cast<GLint>(viewport[0]), static_cast<GLint>(viewport[1]),
                   static_cast<GLsizei>(viewport[2]), static_cast<GLsizei>(viewport[3]));
        glScissor(scissors_[0][0], scissors_[0][1], scissors_[0][2], scissors_[0][3]);
        glDepthRange(depthRanges_[0][0], depthRanges_[0][1]);
    }
    for (GLuint buffer = 0; buffer < blends_.size(); ++buffer) {
        const auto value = [](int name) { return static_cast<GLenum>(name); };
        const auto& [function, equation] = blends_[buffer];
        if (abilities_.indexedBlend) {
            glBlendFuncSeparatei(buffer, value(function[0]), value(function[1]), value(function[2]),
                                 value(function[3]));
            glBlendEquationSeparatei(buffer, value(equation[0]), value(equation[1]));
        } else {
            glBlendFuncSeparate(value(function[0]), value(function[1]), value(function[2]),
                                value(function[3]));
            glBlendEquationSeparate(value(equation[0]), value(equation[1]));
        }
    }
    glCullFace(static_cast<GLenum>(cullFace_));
    glFrontFace(static_cast<GLenum>(frontFace_));
    glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygonModes_[0]));
    if (polygonModes_[1] != 0 && polygonModes_[1] != polygonModes_[0])
        glPolygonMode(GL_BACK, static_cast<GLenum>(polygonModes_[1]));
    glProvokingVertex(static_cast<GLenum>(provokingVertex_));
    if (patchVertices_ > 0)
        glPatchParameteri(GL_PATCH_VERTICES, patchVertices_);
    if (abilities_.compatibility)
        glClampColor(GL_CLAMP_FRAGMENT_COLOR, static_cast<GLenum>(clampFragmentColour_));
    if (abilities_.clipControl)
        glClipControl(static_cast<GLenum>(clipOrigin_), static_cast<GLenum>(clipDepth_));
    for (GLuint word = 0; word < sampleMasks_.size(); ++word)
        glSampleMaski(word, sampleMasks_[word]);
}

void StateGuard::restoreTransferState() const
{
    std::size_t index = 0;
    for (const GLenum name : transferParameterNames)
        glPixelStorei(name, transferParameters_[index++]);
    for (const GLenum name : moreTransferParameterNames)
        glPixelStorei(name, transferParameters_[index++]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, alive(transferBuffers_[0], glIsBuffer));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, alive(transferBuffers_[1], glIsBuffer));
}

void StateGuard::restoreUnits() const
{
    for (std::size_t unit = 0; unit < units_.size(); ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(firstUnit_) + static_cast<GLenum>(unit));
        for (std::size_t target = 0; target < textureTargets.size(); ++target)
            glBindTexture(textureTargets[target].target, alive(units_[unit].textures[target], glIsTexture));
        glBindSampler(static_cast<GLuint>(firstUnit_) + static_cast<GLuint>(unit),
                      alive(units_[unit].sampler, glIsSampler));
    }
    glActiveTexture(static_cast<GLenum>(activeUnit_));
}

void StateGuard::restoreBindings() const
{
    // A framebuffer name without an object yet (bound never) is not alive for glIsFramebuffer; 0 is always
    // fine.
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, alive(drawFramebuffer_, glIsFramebuffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, alive(readFramebuffer_, glIsFramebuffer));
    glBindRenderbuffer(GL_RENDERBUFFER, alive(renderbuffer_, glIsRenderbuffer));
    glBindVertexArray(alive(vertexArray_, glIsVertexArray));
    glBindBuffer(GL_ARRAY_BUFFER, alive(arrayBuffer_, glIsBuffer));
    glBindBuffer(GL_UNIFORM_BUFFER, alive(uniformBuffer_, glIsBuffer));
    glBindBuffer(GL_COPY_READ_BUFFER, alive(copyReadBuffer_, glIsBuffer));
    glBindBuffer(GL_COPY_WRITE_BUFFER, alive(copyWriteBuffer_, glIsBuffer));
    GLint pendingDeletion = GL_FALSE;
    if (alive(program_, glIsProgram) != 0)
        glGetProgramiv(static_cast<GLuint>(program_), GL_DELETE_STATUS, &pendingDeletion);
    if (abilities_.pipelines) {
        glUseProgram(0); // while a program is in use, Mesa ignores a change of the pipeline
        glBindProgramPipeline(alive(pipeline_, glIsProgramPipeline));
    }
    glUseProgram(pendingDeletion == GL_TRUE ? 0u : alive(program_, glIsProgram));
}

} // namespace mirrorball::gl
