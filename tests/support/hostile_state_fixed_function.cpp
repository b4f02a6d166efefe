// What a host of the compatibility profile may have set besides. Some of it reaches core shaders: the alpha
// test, polygon stipple, clamped fragment colours, pixel transfer.
#include "support/hostile_state_entries.h"

namespace tests {

namespace {

constexpr GLenum switches[] = {GL_LIGHTING,
                               GL_LIGHT0,
                               GL_FOG,
                               GL_COLOR_MATERIAL,
                               GL_COLOR_SUM,
                               GL_NORMALIZE,
                               GL_RESCALE_NORMAL,
                               GL_AUTO_NORMAL,
                               GL_LINE_STIPPLE,
                               GL_POINT_SMOOTH,
                               GL_POINT_SPRITE,
                               GL_INDEX_LOGIC_OP,
                               GL_TEXTURE_1D,
                               GL_TEXTURE_2D,
                               GL_TEXTURE_3D,
                               GL_TEXTURE_CUBE_MAP,
                               GL_TEXTURE_RECTANGLE,
                               GL_TEXTURE_GEN_S,
                               GL_TEXTURE_GEN_T,
                               GL_TEXTURE_GEN_R,
                               GL_TEXTURE_GEN_Q,
                               GL_VERTEX_PROGRAM_TWO_SIDE};

constexpr GLenum clientArrays[] = {GL_COLOR_ARRAY, GL_FOG_COORD_ARRAY, GL_NORMAL_ARRAY,
                                   GL_SECONDARY_COLOR_ARRAY, GL_VERTEX_ARRAY};

constexpr HostileEntry entries[] = {
    {"alpha test never passes", compatibility,
     [](const HostObjects&) {
         glEnable(GL_ALPHA_TEST);
         glAlphaFunc(GL_NEVER, 0.5f);
     },
     [](const HostObjects&) {
         glDisable(GL_ALPHA_TEST);
         glAlphaFunc(GL_ALWAYS, 0.0f);
     }},
    {"polygons stippled away", compatibility,
     [](const HostObjects&) {
         constexpr GLubyte nothing[32 * 4] = {};
         glEnable(GL_POLYGON_STIPPLE);
         glPolygonStipple(nothing);
     },
     [](const HostObjects&) {
         std::array<GLubyte, 32 * 4> everything;
         everything.fill(0xff);
         glDisable(GL_POLYGON_STIPPLE);
         glPolygonStipple(everything.data());
     }},
    {"shaded colours clamped", compatibility,
     [](const HostObjects&) {
         glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
         glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
     },
     [](const HostObjects&) {
         glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FIXED_ONLY);
         glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
     }},
    {"pixel transfer scaled to nothing", compatibility,
     [](const HostObjects&) {
         for (GLenum scale : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
             glPixelTransferf(scale, 0.0f);
         for (GLenum bias : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS})
             glPixelTransferf(bias, 0.5f);
         glPixelTransferi(GL_INDEX_SHIFT, 1);
         glPixelTransferi(GL_INDEX_OFFSET, 1);
         glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
         glPixelTransferi(GL_MAP_STENCIL, GL_TRUE);
         glPixelZoom(2.0f, 3.0f);
     },
     [](const HostObjects&) {
         for (GLenum scale : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
             glPixelTransferf(scale, 1.0f);
         for (GLenum bias : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS})
             glPixelTransferf(bias, 0.0f);
         glPixelTransferi(GL_INDEX_SHIFT, 0);
         glPixelTransferi(GL_INDEX_OFFSET, 0);
         glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
         glPixelTransferi(GL_MAP_STENCIL, GL_FALSE);
         glPixelZoom(1.0f, 1.0f);
     }},
    {"matrices", compatibility,
     [](const HostObjects&) {
         for (GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
             glMatrixMode(mode);
             glPushMatrix();
             glScalef(0.0f, 2.0f, 3.0f);
         }
     },
     [](const HostObjects&) {
         for (GLenum mode : {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW}) {
             glMatrixMode(mode);
             glPopMatrix();
         }
     }},
    {"fixed-function switches", compatibility,
     [](const HostObjects&) {
         for (GLenum capability : switches)
             glEnable(capability);
         for (GLenum array : clientArrays)
             glEnableClientState(array);
         glShadeModel(GL_FLAT);
     },
     [](const HostObjects&) {
         for (GLenum capability : switches)
             glDisable(capability);
         for (GLenum array : clientArrays)
             glDisableClientState(array);
         glShadeModel(GL_SMOOTH);
     }},
    {"attributes pushed and changed", compatibility,
     [](const HostObjects& host) {
         constexpr GLfloat values[] = {0.25f, 0.5f, 0.75f, 0.125f};
         glPushAttrib(GL_ALL_ATTRIB_BITS); // what follows goes with the pop
         glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
         glClientActiveTexture(GL_TEXTURE1);
         glColor4fv(values);
         glSecondaryColor3fv(values);
         glNormal3fv(values);
         glFogCoordf(0.5f);
         glTexCoord4fv(values);
         glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
         const GLint bound = limit(GL_DRAW_FRAMEBUFFER_BINDING);
         glBindFramebuffer(GL_DRAW_FRAMEBUFFER, host.drawFramebuffer); // a window position needs one
         glWindowPos2f(3.0f, 4.0f);
         glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
         glClearAccum(0.25f, 0.5f, 0.75f, 1.0f);
         glLineStipple(3, 0x5555);
         glListBase(7);
         glColorMaterial(GL_BACK, GL_EMISSION);
         glLightModelfv(GL_LIGHT_MODEL_AMBIENT, values);
         glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
         glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
         glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
         glFogi(GL_FOG_MODE, GL_LINEAR);
         glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
         glFogf(GL_FOG_DENSITY, 0.5f);
         glFogf(GL_FOG_START, 2.0f);
         glFogf(GL_FOG_END, 3.0f);
         glFogfv(GL_FOG_COLOR, values);
         glPointParameterf(GL_POINT_SIZE_MIN, 2.0f);
         glPointParameterf(GL_POINT_SIZE_MAX, 3.0f);
         glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, values);
         for (GLenum hint :
              {GL_FOG_HINT, GL_GENERATE_MIPMAP_HINT, GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT})
             glHint(hint, GL_FASTEST);
     },
     [](const HostObjects&) {
         glPopClientAttrib();
         glPopAttrib();
         glFogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH); // Mesa 22.3 leaves these two out of the stack
         glHint(GL_GENERATE_MIPMAP_HINT, GL_DONT_CARE);
     }},
};

} // namespace

std::span<const HostileEntry> hostileFixedFunction()
{
    return entries;
}

} // namespace tests
