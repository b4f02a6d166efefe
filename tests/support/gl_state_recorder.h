// How the parts of GlState::capture() write down what they find. Private to gl_state*.cpp.
#pragma once

#include "support/gl_state.h"

#include <epoxy/gl.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tests {

// Where a piece of state exists: from a version of OpenGL, or with an extension before it. Asking for what a
// context lacks would be an error of ours.
struct Gate
{
    int version = 33;                // 10 * major + minor, as epoxy_gl_version()
    const char* extension = nullptr; // or nullptr
    bool compatibility = false;      // in a compatibility profile only
};

inline constexpr int extensionOnly = 1000; // as Gate::version: no version of OpenGL has it

inline constexpr Gate always{};
inline constexpr Gate compatibility{33, nullptr, true};
inline constexpr Gate sampleShading{40, "GL_ARB_sample_shading"};
inline constexpr Gate tessellation{40, "GL_ARB_tessellation_shader"};
inline constexpr Gate drawBuffersBlend{40, "GL_ARB_draw_buffers_blend"};
inline constexpr Gate drawIndirect{40, "GL_ARB_draw_indirect"};
inline constexpr Gate cubeMapArray{40, "GL_ARB_texture_cube_map_array"};
inline constexpr Gate transformFeedback2{40, "GL_ARB_transform_feedback2"};
inline constexpr Gate transformFeedback3{40, "GL_ARB_transform_feedback3"};
inline constexpr Gate viewportArray{41, "GL_ARB_viewport_array"};
inline constexpr Gate separateShaders{41, "GL_ARB_separate_shader_objects"};
inline constexpr Gate vertexAttrib64{41, "GL_ARB_vertex_attrib_64bit"};
inline constexpr Gate atomicCounters{42, "GL_ARB_shader_atomic_counters"};
inline constexpr Gate imageLoadStore{42, "GL_ARB_shader_image_load_store"};
inline constexpr Gate textureStorage{42, "GL_ARB_texture_storage"};
inline constexpr Gate compressedStorage{42, "GL_ARB_compressed_texture_pixel_storage"};
inline constexpr Gate es3Compatibility{43, "GL_ARB_ES3_compatibility"};
inline constexpr Gate computeShader{43, "GL_ARB_compute_shader"};
inline constexpr Gate storageBuffer{43, "GL_ARB_shader_storage_buffer_object"};
inline constexpr Gate noAttachments{43, "GL_ARB_framebuffer_no_attachments"};
inline constexpr Gate vertexAttribBinding{43, "GL_ARB_vertex_attrib_binding"};
inline constexpr Gate stencilTexturing{43, "GL_ARB_stencil_texturing"};
inline constexpr Gate debugOutput{43, "GL_KHR_debug"};
inline constexpr Gate queryBuffer{44, "GL_ARB_query_buffer_object"};
inline constexpr Gate clipControl{45, "GL_ARB_clip_control"};
inline constexpr Gate indirectParameters{46, "GL_ARB_indirect_parameters"};
inline constexpr Gate pipelineStatistics{46, "GL_ARB_pipeline_statistics_query"};
inline constexpr Gate overflowQuery{46, "GL_ARB_transform_feedback_overflow_query"};
inline constexpr Gate polygonOffsetClamp{46, "GL_ARB_polygon_offset_clamp"};
inline constexpr Gate anisotropy{46, "GL_ARB_texture_filter_anisotropic"};
inline constexpr Gate depthBounds{extensionOnly, "GL_EXT_depth_bounds_test"};
inline constexpr Gate windowRectangles{extensionOnly, "GL_EXT_window_rectangles"};
inline constexpr Gate primitiveBounds{extensionOnly, "GL_ARB_ES3_2_compatibility"};
inline constexpr Gate advancedBlend{extensionOnly, "GL_KHR_blend_equation_advanced_coherent"};
inline constexpr Gate parallelCompile{extensionOnly, "GL_KHR_parallel_shader_compile"};
inline constexpr Gate packInvert{extensionOnly, "GL_MESA_pack_invert"};
inline constexpr Gate seamlessPerTexture{extensionOnly, "GL_ARB_seamless_cubemap_per_texture"};
inline constexpr Gate srgbDecode{extensionOnly, "GL_EXT_texture_sRGB_decode"};
inline constexpr Gate rasterMultisample{extensionOnly, "GL_EXT_raster_multisample"};
inline constexpr Gate conservativeNvidia{extensionOnly, "GL_NV_conservative_raster"};
inline constexpr Gate conservativeIntel{extensionOnly, "GL_INTEL_conservative_rasterization"};
inline constexpr Gate shadingRateImage{extensionOnly, "GL_NV_shading_rate_image"};

// A name of OpenGL as it is written and as it is passed: GL_ENUM(GL_BLEND).
struct Enum
{
    const char* text;
    GLenum value;
};
#define GL_ENUM(name)                                                                                        \
    tests::Enum                                                                                              \
    {                                                                                                        \
#name, name                                                                                          \
    }

// Whether the current context has what the gate names.
bool has(const Gate& gate);

// A limit of the current context: GL_MAX_DRAW_BUFFERS.
int limit(GLenum name);

class StateRecorder
{
public:
    explicit StateRecorder(std::vector<GlState::Item>& items) : items_(items) {}

    void add(std::string name, std::string value) { items_.push_back({std::move(name), std::move(value)}); }

    // Enumerants, names and bit masks are written in hexadecimal, quantities in decimal; several as "(1, 0)".
    void addSymbols(std::string name, std::span<const GLint64> values);
    void addNumbers(std::string name, std::span<const double> values);
    void addFloats(std::string name, std::span<const GLfloat> values);
    void addSymbol(std::string name, GLint64 value) { addSymbols(std::move(name), {&value, 1}); }
    void addNumber(std::string name, double value) { addNumbers(std::move(name), {&value, 1}); }
    void addSwitch(std::string name, bool on) { add(std::move(name), on ? "on" : "off"); }

private:
    std::vector<GlState::Item>& items_;
};

// "GL_BLEND[2]"
std::string indexed(std::string_view name, int index);

// The parts of the capture.
void recordFixedState(StateRecorder& recorder);    // gl_state_fixed.cpp: what has no index
void recordFixedFunction(StateRecorder& recorder); // gl_state_fixed_function.cpp: compatibility profile
void recordIndexedState(StateRecorder& recorder); // gl_state_indexed.cpp: per viewport, draw buffer, unit, …
void recordTextureUnits(StateRecorder& recorder);      // gl_state_textures.cpp: bindings, and what is bound
void recordBoundFramebuffers(StateRecorder& recorder); // gl_state_objects.cpp: attachments
void recordBoundVertexArray(StateRecorder& recorder);  // gl_state_objects.cpp: attributes
void recordBoundBuffers(StateRecorder& recorder);      // gl_state_objects.cpp: sizes

} // namespace tests
