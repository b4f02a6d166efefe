// Viewports, scissors, clipping, primitives and the rasteriser.
#include "support/hostile_state_entries.h"

namespace tests {

namespace {

// Calls change(i) for every viewport of the context.
template <class Change>
void forEachViewport(Change change)
{
    for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_VIEWPORTS)); ++i)
        change(i);
}

void undoViewport(const HostObjects& host)
{
    glViewport(host.viewport[0], host.viewport[1], host.viewport[2], host.viewport[3]);
}

void undoScissor(const HostObjects& host)
{
    glDisable(GL_SCISSOR_TEST);
    glScissor(host.scissor[0], host.scissor[1], host.scissor[2], host.scissor[3]);
}

template <GLenum capability>
constexpr HostileEntry switchedOn(const char* name, Gate gate)
{
    return {name, gate, [](const HostObjects&) { glEnable(capability); },
            [](const HostObjects&) { glDisable(capability); }};
}

constexpr HostileEntry entries[] = {
    {"viewport of one pixel", always, [](const HostObjects&) { glViewport(3, 2, 1, 1); }, undoViewport},
    {"viewports all different", viewportArray,
     [](const HostObjects&) {
         forEachViewport([](GLuint i) {
             const auto offset = static_cast<GLfloat>(i);
             glViewportIndexedf(i, 0.25f + offset, 1.5f, 2.0f, 0.5f + offset);
         });
     },
     undoViewport},
    {"scissor of one pixel", always,
     [](const HostObjects&) {
         glEnable(GL_SCISSOR_TEST);
         glScissor(2, 1, 1, 1);
     },
     undoScissor},
    {"scissors all different", viewportArray,
     [](const HostObjects&) {
         forEachViewport([](GLuint i) {
             glScissorIndexed(i, static_cast<GLint>(i), 1, 1, 2);
             if (i % 2 == 0)
                 glEnablei(GL_SCISSOR_TEST, i);
             else
                 glDisablei(GL_SCISSOR_TEST, i);
         });
     },
     undoScissor},
    {"depth range reversed", always, [](const HostObjects&) { glDepthRange(1.0, 0.0); },
     [](const HostObjects&) { glDepthRange(0.0, 1.0); }},
    {"depth ranges all different", viewportArray,
     [](const HostObjects&) {
         forEachViewport([](GLuint i) { glDepthRangeIndexed(i, 0.5, 1.0 / (i + 3)); });
     },
     [](const HostObjects&) { glDepthRange(0.0, 1.0); }},
    {"clip control upper left, zero to one", clipControl,
     [](const HostObjects&) { glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE); },
     [](const HostObjects&) { glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE); }},
    {"clip distances on", always,
     [](const HostObjects&) {
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_CLIP_DISTANCES)); ++i)
             glEnable(GL_CLIP_DISTANCE0 + i);
     },
     [](const HostObjects&) {
         for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_CLIP_DISTANCES)); ++i)
             glDisable(GL_CLIP_DISTANCE0 + i);
     }},
    switchedOn<GL_RASTERIZER_DISCARD>("rasteriser discard", always),
    {"front and back culled", always,
     [](const HostObjects&) {
         glEnable(GL_CULL_FACE);
         glCullFace(GL_FRONT_AND_BACK);
     },
     [](const HostObjects&) {
         glDisable(GL_CULL_FACE);
         glCullFace(GL_BACK);
     }},
    {"front face clockwise", always, [](const HostObjects&) { glFrontFace(GL_CW); },
     [](const HostObjects&) { glFrontFace(GL_CCW); }},
    {"polygons as lines", always, [](const HostObjects&) { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); },
     [](const HostObjects&) { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
    {"polygons as points, front only", compatibility,
     [](const HostObjects&) { glPolygonMode(GL_FRONT, GL_POINT); },
     [](const HostObjects&) { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
    {"polygon offset", always,
     [](const HostObjects&) {
         for (GLenum capability : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
             glEnable(capability);
         glPolygonOffset(100.0f, 1e6f);
         if (has(polygonOffsetClamp))
             glPolygonOffsetClamp(100.0f, 1e6f, 0.5f);
     },
     [](const HostObjects&) {
         for (GLenum capability : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
             glDisable(capability);
         glPolygonOffset(0.0f, 0.0f);
     }},
    {"provoking vertex first", always,
     [](const HostObjects&) { glProvokingVertex(GL_FIRST_VERTEX_CONVENTION); },
     [](const HostObjects&) { glProvokingVertex(GL_LAST_VERTEX_CONVENTION); }},
    {"primitive restart at index 1", always,
     [](const HostObjects&) {
         glEnable(GL_PRIMITIVE_RESTART);
         glPrimitiveRestartIndex(1);
     },
     [](const HostObjects&) {
         glDisable(GL_PRIMITIVE_RESTART);
         glPrimitiveRestartIndex(0);
     }},
    switchedOn<GL_PRIMITIVE_RESTART_FIXED_INDEX>("primitive restart at the fixed index", es3Compatibility),
    {"patch parameters", tessellation,
     [](const HostObjects&) {
         constexpr GLfloat outer[] = {5.0f, 6.0f, 7.0f, 8.0f};
         glPatchParameteri(GL_PATCH_VERTICES, 32);
         glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, outer);
         glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, outer);
     },
     [](const HostObjects&) {
         constexpr GLfloat ones[] = {1.0f, 1.0f, 1.0f, 1.0f};
         glPatchParameteri(GL_PATCH_VERTICES, 3);
         glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, ones);
         glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, ones);
     }},
    {"lines and points", always,
     [](const HostObjects&) {
         glLineWidth(0.5f); // a forward-compatible context refuses more than 1
         glPointSize(7.0f);
         glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 3.0f);
         glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
         for (GLenum capability : {GL_PROGRAM_POINT_SIZE, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH})
             glEnable(capability);
     },
     [](const HostObjects&) {
         glLineWidth(1.0f);
         glPointSize(1.0f);
         glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1.0f);
         glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_UPPER_LEFT);
         for (GLenum capability : {GL_PROGRAM_POINT_SIZE, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH})
             glDisable(capability);
     }},
    {"hints", always,
     [](const HostObjects&) {
         for (GLenum hint : {GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT,
                             GL_FRAGMENT_SHADER_DERIVATIVE_HINT})
             glHint(hint, GL_FASTEST);
     },
     [](const HostObjects&) {
         for (GLenum hint : {GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT,
                             GL_FRAGMENT_SHADER_DERIVATIVE_HINT})
             glHint(hint, GL_DONT_CARE);
     }},
    {"window rectangles", windowRectangles,
     [](const HostObjects&) {
         constexpr GLint box[] = {1, 1, 1, 1};
         glWindowRectanglesEXT(GL_INCLUSIVE_EXT, 1, box);
     },
     [](const HostObjects&) { glWindowRectanglesEXT(GL_EXCLUSIVE_EXT, 0, nullptr); }},
    switchedOn<GL_RASTER_MULTISAMPLE_EXT>("rasterised as if multisampled", rasterMultisample),
    switchedOn<GL_CONSERVATIVE_RASTERIZATION_NV>("conservative rasterisation (NVIDIA)", conservativeNvidia),
    switchedOn<GL_CONSERVATIVE_RASTERIZATION_INTEL>("conservative rasterisation (Intel)", conservativeIntel),
    switchedOn<GL_SHADING_RATE_IMAGE_NV>("shading rate from an image", shadingRateImage),
    {"primitive bounding box", primitiveBounds,
     [](const HostObjects&) { glPrimitiveBoundingBoxARB(0.0f, 0.0f, 0.0f, 1.0f, 0.1f, 0.1f, 0.1f, 1.0f); },
     [](const HostObjects&) {
         glPrimitiveBoundingBoxARB(-1.0f, -1.0f, -1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f);
     }},
};

} // namespace

std::span<const HostileEntry> hostileRasterisation()
{
    return entries;
}

} // namespace tests
