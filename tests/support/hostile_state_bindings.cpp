// The host's own objects, bound wherever a guest would bind its own.
#include "support/hostile_state_entries.h"

#include <iterator>
#include <tuple>

namespace tests {

namespace {

template <class Change>
void forEachUnit(Change change)
{
    const int activeUnit = limit(GL_ACTIVE_TEXTURE);
    for (GLuint unit = 0; unit < static_cast<GLuint>(limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS)); ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        change(unit);
    }
    glActiveTexture(static_cast<GLenum>(activeUnit));
}

// Binding points that take a buffer each.
struct IndexedTarget
{
    GLenum target;
    GLenum count;
    Gate gate;
};

constexpr IndexedTarget indexedTargets[] = {
    {GL_UNIFORM_BUFFER, GL_MAX_UNIFORM_BUFFER_BINDINGS, always},
    {GL_TRANSFORM_FEEDBACK_BUFFER, GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS, always},
    {GL_ATOMIC_COUNTER_BUFFER, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS, atomicCounters},
    {GL_SHADER_STORAGE_BUFFER, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, storageBuffer},
};

// Calls bind(target, index) for every such binding point of the context.
template <class Bind>
void forEachBindingPoint(Bind bind)
{
    for (const IndexedTarget& points : indexedTargets)
        if (has(points.gate))
            for (GLuint i = 0; i < static_cast<GLuint>(limit(points.count)); ++i)
                bind(points.target, i);
}

void bindBufferEverywhere(GLuint buffer)
{
    struct Target
    {
        GLenum target;
        Gate gate;
    };
    constexpr Target targets[] = {
        {GL_ARRAY_BUFFER, always},
        {GL_COPY_READ_BUFFER, always},
        {GL_COPY_WRITE_BUFFER, always},
        {GL_TEXTURE_BUFFER, always},
        {GL_DRAW_INDIRECT_BUFFER, drawIndirect},
        {GL_DISPATCH_INDIRECT_BUFFER, computeShader},
        {GL_QUERY_BUFFER, queryBuffer},
        {GL_PARAMETER_BUFFER_ARB, indirectParameters},
    };
    for (const Target& target : targets)
        if (has(target.gate))
            glBindBuffer(target.target, buffer);
}

struct QueryTarget
{
    GLenum target;
    Gate gate;
};

// All that can be active together; of the three that count samples only one can.
constexpr QueryTarget queryTargets[] = {
    {GL_SAMPLES_PASSED, always},
    {GL_TIME_ELAPSED, always},
    {GL_PRIMITIVES_GENERATED, always},
    {GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, always},
    {GL_TRANSFORM_FEEDBACK_OVERFLOW, overflowQuery},
    {GL_VERTICES_SUBMITTED, pipelineStatistics},
    {GL_PRIMITIVES_SUBMITTED, pipelineStatistics},
    {GL_VERTEX_SHADER_INVOCATIONS, pipelineStatistics},
    {GL_GEOMETRY_SHADER_INVOCATIONS, pipelineStatistics},
    {GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED, pipelineStatistics},
    {GL_FRAGMENT_SHADER_INVOCATIONS, pipelineStatistics},
    {GL_CLIPPING_INPUT_PRIMITIVES, pipelineStatistics},
    {GL_CLIPPING_OUTPUT_PRIMITIVES, pipelineStatistics},
};
static_assert(std::size(queryTargets) == std::tuple_size_v<decltype(HostObjects::queries)>);

// Attribute 0 of a compatibility context is the current vertex and has no value.
template <class Change>
void forEachAttributeValue(Change change)
{
    for (GLuint i = has(compatibility) ? 1 : 0; i < static_cast<GLuint>(limit(GL_MAX_VERTEX_ATTRIBS)); ++i)
        change(i);
}

constexpr HostileEntry entries[] = {
    {"host's framebuffers bound", always,
     [](const HostObjects& host) {
         glBindFramebuffer(GL_DRAW_FRAMEBUFFER, host.drawFramebuffer);
         glBindFramebuffer(GL_READ_FRAMEBUFFER, host.readFramebuffer);
     },
     [](const HostObjects&) { glBindFramebuffer(GL_FRAMEBUFFER, 0); }},
    {"host's renderbuffer bound", always,
     [](const HostObjects& host) { glBindRenderbuffer(GL_RENDERBUFFER, host.renderbuffer); },
     [](const HostObjects&) { glBindRenderbuffer(GL_RENDERBUFFER, 0); }},
    {"host's vertex array bound", always,
     [](const HostObjects& host) { glBindVertexArray(host.vertexArray); },
     [](const HostObjects&) { glBindVertexArray(0); }},
    {"attribute values", always,
     [](const HostObjects&) {
         forEachAttributeValue(
             [](GLuint i) { glVertexAttrib4f(i, static_cast<GLfloat>(i), 0.1f, 0.2f, 0.3f); });
     },
     [](const HostObjects& host) {
         forEachAttributeValue([&](GLuint i) { glVertexAttrib4fv(i, host.attributeValues[i].data()); });
     }},
    {"host's buffer on every binding point", always,
     [](const HostObjects& host) {
         forEachBindingPoint([&](GLenum target, GLuint i) {
             glBindBufferRange(target, i, host.buffer, GLintptr{256} * (i + 1), 64);
         });
     },
     [](const HostObjects&) {
         forEachBindingPoint([](GLenum target, GLuint i) { glBindBufferBase(target, i, 0); });
     }},
    {"host's buffer on every target", always,
     [](const HostObjects& host) { bindBufferEverywhere(host.buffer); },
     [](const HostObjects&) { bindBufferEverywhere(0); }},
    {"transform feedback paused", transformFeedback2,
     [](const HostObjects& host) {
         glUseProgram(host.program);
         glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, host.transformFeedback);
         glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, host.buffer);
         glBeginTransformFeedback(GL_TRIANGLES);
         glPauseTransformFeedback();
         glUseProgram(0);
     },
     [](const HostObjects&) {
         glEndTransformFeedback();
         glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
         glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
     }},
    // before the program: while one is in use, Mesa ignores that pipeline 0 is bound
    {"host's pipeline bound", separateShaders,
     [](const HostObjects& host) { glBindProgramPipeline(host.pipeline); },
     [](const HostObjects&) { glBindProgramPipeline(0); }},
    {"host's program in use", always, [](const HostObjects& host) { glUseProgram(host.program); },
     [](const HostObjects&) { glUseProgram(0); }},
    {"textures on every unit", always,
     [](const HostObjects& host) {
         forEachUnit([&](GLuint) {
             for (const HostTexture& texture : host.textures)
                 glBindTexture(texture.target, texture.name);
         });
     },
     [](const HostObjects& host) {
         forEachUnit([&](GLuint) {
             for (const HostTexture& texture : host.textures)
                 glBindTexture(texture.target, 0);
         });
     }},
    {"samplers on every unit", always,
     [](const HostObjects& host) { forEachUnit([&](GLuint unit) { glBindSampler(unit, host.sampler); }); },
     [](const HostObjects&) { forEachUnit([](GLuint unit) { glBindSampler(unit, 0); }); }},
    {"image on every image unit", imageLoadStore,
     [](const HostObjects& host) {
         for (const HostTexture& texture : host.textures)
             if (texture.target == GL_TEXTURE_2D_ARRAY)
                 for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_IMAGE_UNITS)); ++i)
                     glBindImageTexture(i, texture.name, 1, GL_TRUE, 1, GL_WRITE_ONLY, GL_RGBA8);
     },
     [](const HostObjects&) { // the defaults of the table of image-unit state
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_IMAGE_UNITS)); ++i)
             glBindImageTexture(i, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
     }},
    {"last texture unit active", always,
     [](const HostObjects&) {
         const int last = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1;
         glActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(last));
     },
     [](const HostObjects&) { glActiveTexture(GL_TEXTURE0); }},
    {"queries active", always,
     [](const HostObjects& host) {
         for (std::size_t i = 0; i < std::size(queryTargets); ++i)
             if (has(queryTargets[i].gate))
                 glBeginQuery(queryTargets[i].target, host.queries[i]);
     },
     [](const HostObjects&) {
         for (const QueryTarget& query : queryTargets)
             if (has(query.gate))
                 glEndQuery(query.target);
     }},
    {"no threads for shader compilers", parallelCompile,
     [](const HostObjects&) { glMaxShaderCompilerThreadsKHR(0); },
     [](const HostObjects&) { glMaxShaderCompilerThreadsKHR(~0u); }},
    {"debug group open", debugOutput,
     [](const HostObjects&) { glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, "the host's"); },
     [](const HostObjects&) { glPopDebugGroup(); }},
};

} // namespace

std::span<const HostileEntry> hostileBindings()
{
    return entries;
}

} // namespace tests
