#include "gl/context.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <string>
#include <utility>

namespace mirrorball::gl {

bool contextIsCurrent() noexcept
{
    // epoxy reports version 0 when glGetString answers nothing, which is what a thread without a context
    // gets.
    return epoxy_gl_version() != 0;
}

void requireContext()
{
    const std::string asked = "OpenGL 3.3";
    if (!contextIsCurrent())
        throw Error(ErrorKind::noContext, asked, "no context is current on this thread",
                    "make one current first");
    const std::string found = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (!epoxy_is_desktop_gl() || epoxy_gl_version() < 33)
        throw Error(ErrorKind::unsupported, asked, "the current context is " + found,
                    "make a desktop context of version 3.3 or later");
    const bool hasTransformFeedbackState =
        epoxy_gl_version() >= 40 || epoxy_has_gl_extension("GL_ARB_transform_feedback2");
    if (hasTransformFeedbackState && integer(GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 &&
        integer(GL_TRANSFORM_FEEDBACK_PAUSED) == 0)
        throw Error(ErrorKind::hostBusy, "a capture", "transform feedback is active",
                    "end or pause it first");
}

int integer(unsigned int name)
{
    GLint values[16] = {}; // more than any state has but lists of formats
    glGetIntegerv(name, values);
    return values[0];
}

Abilities Abilities::ofCurrentContext()
{
    const auto has = [](int version, const char* extension) {
        return epoxy_gl_version() >= version || epoxy_has_gl_extension(extension);
    };
    Abilities all{};
    all.viewportArrays = has(41, "GL_ARB_viewport_array");
    all.clipControl = has(45, "GL_ARB_clip_control");
    all.pipelines = has(41, "GL_ARB_separate_shader_objects");
    all.indexedBlend = has(40, "GL_ARB_draw_buffers_blend");
    all.patches = epoxy_gl_version() >= 40;
    all.compatibility = (integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
    all.drawBuffers = integer(GL_MAX_DRAW_BUFFERS);
    all.viewports = all.viewportArrays ? integer(GL_MAX_VIEWPORTS) : 1;
    all.sampleMaskWords = integer(GL_MAX_SAMPLE_MASK_WORDS);

    all.switches = {GL_STENCIL_TEST,        GL_COLOR_LOGIC_OP,     GL_DITHER,
                    GL_FRAMEBUFFER_SRGB,    GL_CULL_FACE,          GL_POLYGON_OFFSET_FILL,
                    GL_POLYGON_SMOOTH,      GL_RASTERIZER_DISCARD, GL_SAMPLE_ALPHA_TO_COVERAGE,
                    GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE,    GL_SAMPLE_MASK,
                    GL_DEPTH_CLAMP,         GL_PRIMITIVE_RESTART};
    if (has(40, "GL_ARB_sample_shading"))
        all.switches.push_back(GL_SAMPLE_SHADING);
    if (has(43, "GL_ARB_ES3_compatibility"))
        all.switches.push_back(GL_PRIMITIVE_RESTART_FIXED_INDEX);
    if (all.compatibility)
        all.switches.insert(all.switches.end(), {GL_ALPHA_TEST, GL_POLYGON_STIPPLE});
    constexpr std::pair<const char*, GLenum> ofExtensions[] = {
        {"GL_EXT_depth_bounds_test", GL_DEPTH_BOUNDS_TEST_EXT},
        {"GL_EXT_raster_multisample", GL_RASTER_MULTISAMPLE_EXT},
        {"GL_NV_conservative_raster", GL_CONSERVATIVE_RASTERIZATION_NV},
        {"GL_INTEL_conservative_rasterization", GL_CONSERVATIVE_RASTERIZATION_INTEL},
        {"GL_NV_shading_rate_image", GL_SHADING_RATE_IMAGE_NV}};
    for (const auto& [extension, capability] : ofExtensions)
        if (epoxy_has_gl_extension(extension))
            all.switches.push_back(capability);
    for (int plane = 0; plane < integer(GL_MAX_CLIP_DISTANCES); ++plane)
        all.switches.push_back(GL_CLIP_DISTANCE0 + static_cast<GLenum>(plane));
    return all;
}

} // namespace mirrorball::gl
