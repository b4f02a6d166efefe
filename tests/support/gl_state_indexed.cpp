// State with one value for each viewport, draw buffer, binding point, image unit and so on.
#include "support/gl_state_recorder.h"

#include <array>

namespace tests {

namespace {

void recordViewports(StateRecorder& recorder)
{
    if (!has(viewportArray))
        return; // one viewport: recordFixedState has it
    const int count = limit(GL_MAX_VIEWPORTS);
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<GLuint>(i);
        std::array<double, 4> values{};
        glGetDoublei_v(GL_VIEWPORT, index, values.data());
        recorder.addNumbers(indexed("GL_VIEWPORT", i), values);
        glGetDoublei_v(GL_SCISSOR_BOX, index, values.data());
        recorder.addNumbers(indexed("GL_SCISSOR_BOX", i), values);
        glGetDoublei_v(GL_DEPTH_RANGE, index, values.data());
        recorder.addNumbers(indexed("GL_DEPTH_RANGE", i), std::span(values).first(2));
        recorder.addSwitch(indexed("GL_SCISSOR_TEST", i), glIsEnabledi(GL_SCISSOR_TEST, index) == GL_TRUE);
    }
}

void recordDrawBuffers(StateRecorder& recorder)
{
    constexpr Enum blend[] = {GL_ENUM(GL_BLEND_SRC_RGB),      GL_ENUM(GL_BLEND_DST_RGB),
                              GL_ENUM(GL_BLEND_SRC_ALPHA),    GL_ENUM(GL_BLEND_DST_ALPHA),
                              GL_ENUM(GL_BLEND_EQUATION_RGB), GL_ENUM(GL_BLEND_EQUATION_ALPHA)};
    const bool blendsEachBuffer = has(drawBuffersBlend);
    if (!blendsEachBuffer)
        for (const Enum& name : blend)
            recorder.addSymbol(name.text, limit(name.value));

    const int count = limit(GL_MAX_DRAW_BUFFERS);
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<GLuint>(i);
        recorder.addSymbol(indexed("GL_DRAW_BUFFER", i), limit(GL_DRAW_BUFFER0 + index));
        recorder.addSwitch(indexed("GL_BLEND", i), glIsEnabledi(GL_BLEND, index) == GL_TRUE);
        std::array<GLboolean, 4> mask{};
        glGetBooleani_v(GL_COLOR_WRITEMASK, index, mask.data());
        const std::array<GLint64, 4> values{mask[0], mask[1], mask[2], mask[3]};
        recorder.addSymbols(indexed("GL_COLOR_WRITEMASK", i), values);
        if (blendsEachBuffer)
            for (const Enum& name : blend) {
                GLint value = 0;
                glGetIntegeri_v(name.value, index, &value);
                recorder.addSymbol(indexed(name.text, i), value);
            }
    }
}

void recordClipDistances(StateRecorder& recorder)
{
    const int count = limit(GL_MAX_CLIP_DISTANCES);
    for (int i = 0; i < count; ++i)
        recorder.addSwitch(indexed("GL_CLIP_DISTANCE", i),
                           glIsEnabled(GL_CLIP_DISTANCE0 + static_cast<GLuint>(i)) == GL_TRUE);
}

void recordSampleMasks(StateRecorder& recorder)
{
    const int count = limit(GL_MAX_SAMPLE_MASK_WORDS);
    for (int i = 0; i < count; ++i) {
        GLint64 word = 0;
        glGetInteger64i_v(GL_SAMPLE_MASK_VALUE, static_cast<GLuint>(i), &word);
        recorder.addSymbol(indexed("GL_SAMPLE_MASK_VALUE", i), word);
    }
}

struct BindingPoints
{
    Enum binding;
    Enum start;
    Enum size;
    GLenum count;
    Gate gate;
};

void recordBufferRanges(StateRecorder& recorder)
{
    const BindingPoints all[] = {
        {GL_ENUM(GL_UNIFORM_BUFFER_BINDING), GL_ENUM(GL_UNIFORM_BUFFER_START),
         GL_ENUM(GL_UNIFORM_BUFFER_SIZE), GL_MAX_UNIFORM_BUFFER_BINDINGS, always},
        {GL_ENUM(GL_SHADER_STORAGE_BUFFER_BINDING), GL_ENUM(GL_SHADER_STORAGE_BUFFER_START),
         GL_ENUM(GL_SHADER_STORAGE_BUFFER_SIZE), GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, storageBuffer},
        {GL_ENUM(GL_ATOMIC_COUNTER_BUFFER_BINDING), GL_ENUM(GL_ATOMIC_COUNTER_BUFFER_START),
         GL_ENUM(GL_ATOMIC_COUNTER_BUFFER_SIZE), GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS, atomicCounters},
        {GL_ENUM(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING), GL_ENUM(GL_TRANSFORM_FEEDBACK_BUFFER_START),
         GL_ENUM(GL_TRANSFORM_FEEDBACK_BUFFER_SIZE),
         has(transformFeedback3) ? GLenum{GL_MAX_TRANSFORM_FEEDBACK_BUFFERS}
                                 : GLenum{GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS},
         always},
    };
    for (const BindingPoints& points : all) {
        const int count = has(points.gate) ? limit(points.count) : 0;
        for (int i = 0; i < count; ++i) {
            const auto index = static_cast<GLuint>(i);
            GLint buffer = 0;
            glGetIntegeri_v(points.binding.value, index, &buffer);
            recorder.addSymbol(indexed(points.binding.text, i), buffer);
            for (const Enum& name : {points.start, points.size}) {
                GLint64 value = 0;
                glGetInteger64i_v(name.value, index, &value);
                recorder.addNumber(indexed(name.text, i), static_cast<double>(value));
            }
        }
    }
}

void recordImageUnits(StateRecorder& recorder)
{
    constexpr Enum names[] = {GL_ENUM(GL_IMAGE_BINDING_NAME),    GL_ENUM(GL_IMAGE_BINDING_LEVEL),
                              GL_ENUM(GL_IMAGE_BINDING_LAYERED), GL_ENUM(GL_IMAGE_BINDING_LAYER),
                              GL_ENUM(GL_IMAGE_BINDING_ACCESS),  GL_ENUM(GL_IMAGE_BINDING_FORMAT)};
    const int count = has(imageLoadStore) ? limit(GL_MAX_IMAGE_UNITS) : 0;
    for (int i = 0; i < count; ++i)
        for (const Enum& name : names) {
            GLint value = 0;
            glGetIntegeri_v(name.value, static_cast<GLuint>(i), &value);
            recorder.addSymbol(indexed(name.text, i), value);
        }
}

void recordWindowRectangles(StateRecorder& recorder)
{
    const int count = has(windowRectangles) ? limit(GL_NUM_WINDOW_RECTANGLES_EXT) : 0;
    for (int i = 0; i < count; ++i) {
        std::array<GLint64, 4> box{};
        glGetInteger64i_v(GL_WINDOW_RECTANGLE_EXT, static_cast<GLuint>(i), box.data());
        recorder.addSymbols(indexed("GL_WINDOW_RECTANGLE_EXT", i), box);
    }
}

// The values of attributes that no array feeds. Attribute 0 of a compatibility context is the current vertex,
// which cannot be asked for.
void recordAttributeValues(StateRecorder& recorder)
{
    const int count = limit(GL_MAX_VERTEX_ATTRIBS);
    for (int i = has(compatibility) ? 1 : 0; i < count; ++i) {
        std::array<GLfloat, 4> value{};
        glGetVertexAttribfv(static_cast<GLuint>(i), GL_CURRENT_VERTEX_ATTRIB, value.data());
        recorder.addFloats(indexed("GL_CURRENT_VERTEX_ATTRIB", i), value);
    }
}

} // namespace

void recordIndexedState(StateRecorder& recorder)
{
    recordViewports(recorder);
    recordDrawBuffers(recorder);
    recordClipDistances(recorder);
    recordSampleMasks(recorder);
    recordBufferRanges(recorder);
    recordImageUnits(recorder);
    recordWindowRectangles(recorder);
    recordAttributeValues(recorder);
}

} // namespace tests
