// State that has one value in the context: switches, enumerants and names, numbers.
#include "support/gl_state_recorder.h"

#include <array>

namespace tests {

namespace {

struct Query
{
    Enum name;
    int count = 1; // of values that one query returns
    Gate gate = always;
};

// Asked with glIsEnabled.
constexpr Query switches[] = {
    {GL_ENUM(GL_BLEND)},
    {GL_ENUM(GL_COLOR_LOGIC_OP)},
    {GL_ENUM(GL_CULL_FACE)},
    {GL_ENUM(GL_DEPTH_CLAMP)},
    {GL_ENUM(GL_DEPTH_TEST)},
    {GL_ENUM(GL_DITHER)},
    {GL_ENUM(GL_FRAMEBUFFER_SRGB)},
    {GL_ENUM(GL_LINE_SMOOTH)},
    {GL_ENUM(GL_MULTISAMPLE)},
    {GL_ENUM(GL_POLYGON_OFFSET_FILL)},
    {GL_ENUM(GL_POLYGON_OFFSET_LINE)},
    {GL_ENUM(GL_POLYGON_OFFSET_POINT)},
    {GL_ENUM(GL_POLYGON_SMOOTH)},
    {GL_ENUM(GL_PRIMITIVE_RESTART)},
    {GL_ENUM(GL_PROGRAM_POINT_SIZE)},
    {GL_ENUM(GL_RASTERIZER_DISCARD)},
    {GL_ENUM(GL_SAMPLE_ALPHA_TO_COVERAGE)},
    {GL_ENUM(GL_SAMPLE_ALPHA_TO_ONE)},
    {GL_ENUM(GL_SAMPLE_COVERAGE)},
    {GL_ENUM(GL_SAMPLE_MASK)},
    {GL_ENUM(GL_SCISSOR_TEST)},
    {GL_ENUM(GL_STENCIL_TEST)},
    {GL_ENUM(GL_TEXTURE_CUBE_MAP_SEAMLESS)},
    {GL_ENUM(GL_SAMPLE_SHADING), 1, sampleShading},
    {GL_ENUM(GL_PRIMITIVE_RESTART_FIXED_INDEX), 1, es3Compatibility},
    {GL_ENUM(GL_DEBUG_OUTPUT), 1, debugOutput},
    {GL_ENUM(GL_DEBUG_OUTPUT_SYNCHRONOUS), 1, debugOutput},
    {GL_ENUM(GL_DEPTH_BOUNDS_TEST_EXT), 1, depthBounds},
    {GL_ENUM(GL_BLEND_ADVANCED_COHERENT_KHR), 1, advancedBlend},
    {GL_ENUM(GL_RASTER_MULTISAMPLE_EXT), 1, rasterMultisample},
    {GL_ENUM(GL_CONSERVATIVE_RASTERIZATION_NV), 1, conservativeNvidia},
    {GL_ENUM(GL_CONSERVATIVE_RASTERIZATION_INTEL), 1, conservativeIntel},
    {GL_ENUM(GL_SHADING_RATE_IMAGE_NV), 1, shadingRateImage},
};

// Asked with glGetInteger64v, since glGetIntegerv may clamp a mask of 32 ones: enumerants, names of objects,
// bit masks.
constexpr Query symbols[] = {
    {GL_ENUM(GL_DRAW_FRAMEBUFFER_BINDING)},
    {GL_ENUM(GL_READ_FRAMEBUFFER_BINDING)},
    {GL_ENUM(GL_RENDERBUFFER_BINDING)},
    {GL_ENUM(GL_READ_BUFFER)},
    {GL_ENUM(GL_CURRENT_PROGRAM)},
    {GL_ENUM(GL_PROGRAM_PIPELINE_BINDING), 1, separateShaders},
    {GL_ENUM(GL_VERTEX_ARRAY_BINDING)},
    {GL_ENUM(GL_ARRAY_BUFFER_BINDING)},
    {GL_ENUM(GL_ELEMENT_ARRAY_BUFFER_BINDING)},
    {GL_ENUM(GL_COPY_READ_BUFFER_BINDING)},
    {GL_ENUM(GL_COPY_WRITE_BUFFER_BINDING)},
    {GL_ENUM(GL_PIXEL_PACK_BUFFER_BINDING)},
    {GL_ENUM(GL_PIXEL_UNPACK_BUFFER_BINDING)},
    {GL_ENUM(GL_TEXTURE_BUFFER_BINDING)},
    {GL_ENUM(GL_UNIFORM_BUFFER_BINDING)},
    {GL_ENUM(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING)},
    {GL_ENUM(GL_DRAW_INDIRECT_BUFFER_BINDING), 1, drawIndirect},
    {GL_ENUM(GL_ATOMIC_COUNTER_BUFFER_BINDING), 1, atomicCounters},
    {GL_ENUM(GL_DISPATCH_INDIRECT_BUFFER_BINDING), 1, computeShader},
    {GL_ENUM(GL_SHADER_STORAGE_BUFFER_BINDING), 1, storageBuffer},
    {GL_ENUM(GL_QUERY_BUFFER_BINDING), 1, queryBuffer},
    {GL_ENUM(GL_PARAMETER_BUFFER_BINDING_ARB), 1, indirectParameters},
    {GL_ENUM(GL_TRANSFORM_FEEDBACK_BINDING), 1, transformFeedback2},
    {GL_ENUM(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE), 1, transformFeedback2},
    {GL_ENUM(GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED), 1, transformFeedback2},
    {GL_ENUM(GL_ACTIVE_TEXTURE)},
    {GL_ENUM(GL_CLIP_ORIGIN), 1, clipControl},
    {GL_ENUM(GL_CLIP_DEPTH_MODE), 1, clipControl},
    {GL_ENUM(GL_DEPTH_FUNC)},
    {GL_ENUM(GL_DEPTH_WRITEMASK)},
    {GL_ENUM(GL_STENCIL_FUNC)},
    {GL_ENUM(GL_STENCIL_REF)},
    {GL_ENUM(GL_STENCIL_VALUE_MASK)},
    {GL_ENUM(GL_STENCIL_FAIL)},
    {GL_ENUM(GL_STENCIL_PASS_DEPTH_FAIL)},
    {GL_ENUM(GL_STENCIL_PASS_DEPTH_PASS)},
    {GL_ENUM(GL_STENCIL_WRITEMASK)},
    {GL_ENUM(GL_STENCIL_BACK_FUNC)},
    {GL_ENUM(GL_STENCIL_BACK_REF)},
    {GL_ENUM(GL_STENCIL_BACK_VALUE_MASK)},
    {GL_ENUM(GL_STENCIL_BACK_FAIL)},
    {GL_ENUM(GL_STENCIL_BACK_PASS_DEPTH_FAIL)},
    {GL_ENUM(GL_STENCIL_BACK_PASS_DEPTH_PASS)},
    {GL_ENUM(GL_STENCIL_BACK_WRITEMASK)},
    {GL_ENUM(GL_LOGIC_OP_MODE)},
    {GL_ENUM(GL_CULL_FACE_MODE)},
    {GL_ENUM(GL_FRONT_FACE)},
    {GL_ENUM(GL_POLYGON_MODE), 2},
    {GL_ENUM(GL_PROVOKING_VERTEX)},
    {GL_ENUM(GL_PRIMITIVE_RESTART_INDEX)},
    {GL_ENUM(GL_LINE_SMOOTH_HINT)},
    {GL_ENUM(GL_POLYGON_SMOOTH_HINT)},
    {GL_ENUM(GL_TEXTURE_COMPRESSION_HINT)},
    {GL_ENUM(GL_FRAGMENT_SHADER_DERIVATIVE_HINT)},
    {GL_ENUM(GL_CLAMP_READ_COLOR)},
    {GL_ENUM(GL_STENCIL_CLEAR_VALUE)},
    {GL_ENUM(GL_DEBUG_GROUP_STACK_DEPTH), 1, debugOutput},
    {GL_ENUM(GL_WINDOW_RECTANGLE_MODE_EXT), 1, windowRectangles},
    {GL_ENUM(GL_NUM_WINDOW_RECTANGLES_EXT), 1, windowRectangles},
    {GL_ENUM(GL_MAX_SHADER_COMPILER_THREADS_KHR), 1, parallelCompile},
};

// Asked with glGetDoublev, which every 32-bit integer and float passes unchanged.
constexpr Query numbers[] = {
    {GL_ENUM(GL_VIEWPORT), 4},
    {GL_ENUM(GL_SCISSOR_BOX), 4},
    {GL_ENUM(GL_DEPTH_RANGE), 2},
    {GL_ENUM(GL_DEPTH_CLEAR_VALUE)},
    {GL_ENUM(GL_COLOR_CLEAR_VALUE), 4},
    {GL_ENUM(GL_BLEND_COLOR), 4},
    {GL_ENUM(GL_POLYGON_OFFSET_FACTOR)},
    {GL_ENUM(GL_POLYGON_OFFSET_UNITS)},
    {GL_ENUM(GL_POLYGON_OFFSET_CLAMP), 1, polygonOffsetClamp},
    {GL_ENUM(GL_LINE_WIDTH)},
    {GL_ENUM(GL_POINT_SIZE)},
    {GL_ENUM(GL_POINT_FADE_THRESHOLD_SIZE)},
    {GL_ENUM(GL_POINT_SPRITE_COORD_ORIGIN)},
    {GL_ENUM(GL_SAMPLE_COVERAGE_VALUE)},
    {GL_ENUM(GL_SAMPLE_COVERAGE_INVERT)},
    {GL_ENUM(GL_MIN_SAMPLE_SHADING_VALUE), 1, sampleShading},
    {GL_ENUM(GL_PATCH_VERTICES), 1, tessellation},
    {GL_ENUM(GL_PATCH_DEFAULT_INNER_LEVEL), 2, tessellation},
    {GL_ENUM(GL_PATCH_DEFAULT_OUTER_LEVEL), 4, tessellation},
    {GL_ENUM(GL_PACK_ALIGNMENT)},
    {GL_ENUM(GL_PACK_IMAGE_HEIGHT)},
    {GL_ENUM(GL_PACK_LSB_FIRST)},
    {GL_ENUM(GL_PACK_ROW_LENGTH)},
    {GL_ENUM(GL_PACK_SKIP_IMAGES)},
    {GL_ENUM(GL_PACK_SKIP_PIXELS)},
    {GL_ENUM(GL_PACK_SKIP_ROWS)},
    {GL_ENUM(GL_PACK_SWAP_BYTES)},
    {GL_ENUM(GL_PACK_COMPRESSED_BLOCK_WIDTH), 1, compressedStorage},
    {GL_ENUM(GL_PACK_COMPRESSED_BLOCK_HEIGHT), 1, compressedStorage},
    {GL_ENUM(GL_PACK_COMPRESSED_BLOCK_DEPTH), 1, compressedStorage},
    {GL_ENUM(GL_PACK_COMPRESSED_BLOCK_SIZE), 1, compressedStorage},
    {GL_ENUM(GL_PACK_INVERT_MESA), 1, packInvert},
    {GL_ENUM(GL_UNPACK_ALIGNMENT)},
    {GL_ENUM(GL_UNPACK_IMAGE_HEIGHT)},
    {GL_ENUM(GL_UNPACK_LSB_FIRST)},
    {GL_ENUM(GL_UNPACK_ROW_LENGTH)},
    {GL_ENUM(GL_UNPACK_SKIP_IMAGES)},
    {GL_ENUM(GL_UNPACK_SKIP_PIXELS)},
    {GL_ENUM(GL_UNPACK_SKIP_ROWS)},
    {GL_ENUM(GL_UNPACK_SWAP_BYTES)},
    {GL_ENUM(GL_UNPACK_COMPRESSED_BLOCK_WIDTH), 1, compressedStorage},
    {GL_ENUM(GL_UNPACK_COMPRESSED_BLOCK_HEIGHT), 1, compressedStorage},
    {GL_ENUM(GL_UNPACK_COMPRESSED_BLOCK_DEPTH), 1, compressedStorage},
    {GL_ENUM(GL_UNPACK_COMPRESSED_BLOCK_SIZE), 1, compressedStorage},
    {GL_ENUM(GL_DEPTH_BOUNDS_EXT), 2, depthBounds},
    {GL_ENUM(GL_PRIMITIVE_BOUNDING_BOX_ARB), 8, primitiveBounds},
};

// The query objects that are active.
constexpr Query activeQueries[] = {
    {GL_ENUM(GL_SAMPLES_PASSED)},
    {GL_ENUM(GL_ANY_SAMPLES_PASSED)},
    {GL_ENUM(GL_TIME_ELAPSED)},
    {GL_ENUM(GL_PRIMITIVES_GENERATED)},
    {GL_ENUM(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN)},
    {GL_ENUM(GL_ANY_SAMPLES_PASSED_CONSERVATIVE), 1, es3Compatibility},
    {GL_ENUM(GL_TRANSFORM_FEEDBACK_OVERFLOW), 1, overflowQuery},
    {GL_ENUM(GL_VERTICES_SUBMITTED), 1, pipelineStatistics},
    {GL_ENUM(GL_PRIMITIVES_SUBMITTED), 1, pipelineStatistics},
    {GL_ENUM(GL_VERTEX_SHADER_INVOCATIONS), 1, pipelineStatistics},
    {GL_ENUM(GL_GEOMETRY_SHADER_INVOCATIONS), 1, pipelineStatistics},
    {GL_ENUM(GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED), 1, pipelineStatistics},
    {GL_ENUM(GL_FRAGMENT_SHADER_INVOCATIONS), 1, pipelineStatistics},
    {GL_ENUM(GL_CLIPPING_INPUT_PRIMITIVES), 1, pipelineStatistics},
    {GL_ENUM(GL_CLIPPING_OUTPUT_PRIMITIVES), 1, pipelineStatistics},
};

} // namespace

void recordFixedState(StateRecorder& recorder)
{
    for (const Query& query : switches)
        if (has(query.gate))
            recorder.addSwitch(query.name.text, glIsEnabled(query.name.value) == GL_TRUE);
    for (const Query& query : symbols)
        if (has(query.gate)) {
            std::array<GLint64, 8> values{};
            glGetInteger64v(query.name.value, values.data());
            recorder.addSymbols(query.name.text,
                                std::span(values).first(static_cast<std::size_t>(query.count)));
        }
    for (const Query& query : numbers)
        if (has(query.gate)) {
            std::array<double, 8> values{};
            glGetDoublev(query.name.value, values.data());
            recorder.addNumbers(query.name.text,
                                std::span(values).first(static_cast<std::size_t>(query.count)));
        }
    for (const Query& query : activeQueries)
        if (has(query.gate)) {
            GLint name = 0;
            glGetQueryiv(query.name.value, GL_CURRENT_QUERY, &name);
            recorder.addSymbol(std::string("GL_CURRENT_QUERY ") + query.name.text, name);
        }
}

} // namespace tests
