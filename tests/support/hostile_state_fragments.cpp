// What happens to a fragment: depth, stencil, blending, masks, samples; clear values and pixel storage.
#include "support/hostile_state_entries.h"

namespace tests {

namespace {

constexpr HostileEntry fragments[] = {
    {"depth test never passes", always,
     [](const HostObjects&) {
         glEnable(GL_DEPTH_TEST);
         glDepthFunc(GL_NEVER);
     },
     [](const HostObjects&) {
         glDisable(GL_DEPTH_TEST);
         glDepthFunc(GL_LESS);
     }},
    {"depth writes off", always, [](const HostObjects&) { glDepthMask(GL_FALSE); },
     [](const HostObjects&) { glDepthMask(GL_TRUE); }},
    {"depth clamp", always, [](const HostObjects&) { glEnable(GL_DEPTH_CLAMP); },
     [](const HostObjects&) { glDisable(GL_DEPTH_CLAMP); }},
    {"depth bounds", depthBounds,
     [](const HostObjects&) {
         glEnable(GL_DEPTH_BOUNDS_TEST_EXT);
         glDepthBoundsEXT(0.25, 0.5);
     },
     [](const HostObjects&) {
         glDisable(GL_DEPTH_BOUNDS_TEST_EXT);
         glDepthBoundsEXT(0.0, 1.0);
     }},
    {"stencil test never passes", always,
     [](const HostObjects&) {
         glEnable(GL_STENCIL_TEST);
         glStencilFuncSeparate(GL_FRONT, GL_NEVER, 1, 0x0f);
         glStencilFuncSeparate(GL_BACK, GL_LESS, 2, 0xf0);
         glStencilOpSeparate(GL_FRONT, GL_INVERT, GL_INCR, GL_DECR);
         glStencilOpSeparate(GL_BACK, GL_ZERO, GL_REPLACE, GL_INCR_WRAP);
         glStencilMaskSeparate(GL_FRONT, 0x55);
         glStencilMaskSeparate(GL_BACK, 0xaa);
     },
     [](const HostObjects& host) {
         glDisable(GL_STENCIL_TEST);
         glStencilFunc(GL_ALWAYS, 0, host.stencilMask);
         glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
         glStencilMask(host.stencilMask);
     }},
    {"colour writes off", always,
     [](const HostObjects&) { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); },
     [](const HostObjects&) { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }},
    {"colour masks all different", always,
     [](const HostObjects&) {
         const auto bit = [](GLuint i, GLuint mask) { return static_cast<GLboolean>(((i + 1) & mask) == 0); };
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_DRAW_BUFFERS)); ++i)
             glColorMaski(i, bit(i, 1), bit(i, 2), bit(i, 4), bit(i, 8));
     },
     [](const HostObjects&) { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }},
    {"blending to nothing", always,
     [](const HostObjects&) {
         glEnable(GL_BLEND);
         glBlendFuncSeparate(GL_ZERO, GL_CONSTANT_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR);
         glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MIN);
         glBlendColor(0.25f, 0.5f, 0.75f, 0.125f);
     },
     [](const HostObjects&) {
         glDisable(GL_BLEND);
         glBlendFunc(GL_ONE, GL_ZERO);
         glBlendEquation(GL_FUNC_ADD);
         glBlendColor(0.0f, 0.0f, 0.0f, 0.0f);
     }},
    {"blending on every second draw buffer", always,
     [](const HostObjects&) {
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_DRAW_BUFFERS)); i += 2)
             glEnablei(GL_BLEND, i);
     },
     [](const HostObjects&) { glDisable(GL_BLEND); }},
    {"blend functions all different", drawBuffersBlend,
     [](const HostObjects&) {
         constexpr GLenum factors[] = {GL_SRC_ALPHA, GL_DST_ALPHA, GL_SRC_COLOR, GL_DST_COLOR};
         constexpr GLenum equations[] = {GL_MAX, GL_MIN, GL_FUNC_SUBTRACT};
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_DRAW_BUFFERS)); ++i) {
             glBlendFuncSeparatei(i, factors[i % 4], factors[(i + 1) % 4], factors[(i + 2) % 4],
                                  factors[(i + 3) % 4]);
             glBlendEquationSeparatei(i, equations[i % 3], equations[(i + 1) % 3]);
         }
     },
     [](const HostObjects&) {
         glBlendFunc(GL_ONE, GL_ZERO);
         glBlendEquation(GL_FUNC_ADD);
     }},
    {"advanced blending incoherent", advancedBlend,
     [](const HostObjects&) { glDisable(GL_BLEND_ADVANCED_COHERENT_KHR); },
     [](const HostObjects&) { glEnable(GL_BLEND_ADVANCED_COHERENT_KHR); }},
    {"logic op clear", always,
     [](const HostObjects&) {
         glEnable(GL_COLOR_LOGIC_OP);
         glLogicOp(GL_CLEAR);
     },
     [](const HostObjects&) {
         glDisable(GL_COLOR_LOGIC_OP);
         glLogicOp(GL_COPY);
     }},
    {"dither off", always, [](const HostObjects&) { glDisable(GL_DITHER); },
     [](const HostObjects&) { glEnable(GL_DITHER); }},
    {"framebuffer sRGB", always, [](const HostObjects&) { glEnable(GL_FRAMEBUFFER_SRGB); },
     [](const HostObjects&) { glDisable(GL_FRAMEBUFFER_SRGB); }},
    {"multisampling off", always, [](const HostObjects&) { glDisable(GL_MULTISAMPLE); },
     [](const HostObjects&) { glEnable(GL_MULTISAMPLE); }},
    {"sample mask empty", always,
     [](const HostObjects&) {
         glEnable(GL_SAMPLE_MASK);
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_SAMPLE_MASK_WORDS)); ++i)
             glSampleMaski(i, 0);
     },
     [](const HostObjects&) {
         glDisable(GL_SAMPLE_MASK);
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_SAMPLE_MASK_WORDS)); ++i)
             glSampleMaski(i, ~0u);
     }},
    {"sample coverage inverted", always,
     [](const HostObjects&) {
         glEnable(GL_SAMPLE_COVERAGE);
         glSampleCoverage(0.75f, GL_TRUE);
     },
     [](const HostObjects&) {
         glDisable(GL_SAMPLE_COVERAGE);
         glSampleCoverage(1.0f, GL_FALSE);
     }},
    {"alpha to coverage and to one", always,
     [](const HostObjects&) {
         glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
         glEnable(GL_SAMPLE_ALPHA_TO_ONE);
     },
     [](const HostObjects&) {
         glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
         glDisable(GL_SAMPLE_ALPHA_TO_ONE);
     }},
    {"sample shading", sampleShading,
     [](const HostObjects&) {
         glEnable(GL_SAMPLE_SHADING);
         glMinSampleShading(1.0f);
     },
     [](const HostObjects&) {
         glDisable(GL_SAMPLE_SHADING);
         glMinSampleShading(0.0f);
     }},
    {"clear values", always,
     [](const HostObjects&) {
         glClearColor(1.0f, 0.5f, 2.0f, 0.25f);
         glClearDepth(0.25);
         glClearStencil(0x55);
     },
     [](const HostObjects&) {
         glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
         glClearDepth(1.0);
         glClearStencil(0);
     }},
    {"seamless cube maps", always, [](const HostObjects&) { glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS); },
     [](const HostObjects&) { glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS); }},
};

// Set together for one direction of transfer. `first` is GL_PACK_… or GL_UNPACK_…; the two runs of enumerants
// are laid out alike: SWAP_BYTES, LSB_FIRST, ROW_LENGTH, SKIP_ROWS, SKIP_PIXELS, ALIGNMENT.
void setStorage(GLenum swapBytes, GLenum skipImages, GLenum imageHeight, GLenum blockWidth,
                const std::array<GLint, 12>& values)
{
    for (GLuint i = 0; i < 6; ++i)
        glPixelStorei(swapBytes + i, values[i]);
    glPixelStorei(skipImages, values[6]);
    glPixelStorei(imageHeight, values[7]);
    if (has(compressedStorage))
        for (GLuint i = 0; i < 4; ++i)
            glPixelStorei(blockWidth + i, values[8 + i]);
}

constexpr std::array<GLint, 12> hostileStorage{1, 1, 7, 3, 2, 8, 1, 5, 4, 4, 1, 16};
constexpr std::array<GLint, 12> defaultStorage{0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0};

void setPack(const std::array<GLint, 12>& values)
{
    setStorage(GL_PACK_SWAP_BYTES, GL_PACK_SKIP_IMAGES, GL_PACK_IMAGE_HEIGHT, GL_PACK_COMPRESSED_BLOCK_WIDTH,
               values);
}

void setUnpack(const std::array<GLint, 12>& values)
{
    setStorage(GL_UNPACK_SWAP_BYTES, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT,
               GL_UNPACK_COMPRESSED_BLOCK_WIDTH, values);
}

constexpr HostileEntry transfer[] = {
    {"pixel packing with gaps", always, [](const HostObjects&) { setPack(hostileStorage); },
     [](const HostObjects&) { setPack(defaultStorage); }},
    {"pixel unpacking with gaps", always, [](const HostObjects&) { setUnpack(hostileStorage); },
     [](const HostObjects&) { setUnpack(defaultStorage); }},
    {"pixel packing upside down", packInvert,
     [](const HostObjects&) { glPixelStorei(GL_PACK_INVERT_MESA, GL_TRUE); },
     [](const HostObjects&) { glPixelStorei(GL_PACK_INVERT_MESA, GL_FALSE); }},
    {"read colours clamped", always, [](const HostObjects&) { glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE); },
     [](const HostObjects&) { glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY); }},
    {"pixel pack buffer", always,
     [](const HostObjects& host) { glBindBuffer(GL_PIXEL_PACK_BUFFER, host.buffer); },
     [](const HostObjects&) { glBindBuffer(GL_PIXEL_PACK_BUFFER, 0); }},
    {"pixel unpack buffer", always,
     [](const HostObjects& host) { glBindBuffer(GL_PIXEL_UNPACK_BUFFER, host.buffer); },
     [](const HostObjects&) { glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0); }},
};

} // namespace

std::span<const HostileEntry> hostileFragments()
{
    return fragments;
}

std::span<const HostileEntry> hostileTransfer()
{
    return transfer;
}

} // namespace tests
