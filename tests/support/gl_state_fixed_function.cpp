// What only a compatibility profile has. Core shaders ignore most of it, but not all: pixel transfer changes
// uploads, and a host notices any of it.
#include "support/gl_state_recorder.h"

#include <array>

namespace tests {

namespace {

struct Query
{
    Enum name;
    int count = 1; // of values that one query returns
};

constexpr Enum switches[] = {
    GL_ENUM(GL_ALPHA_TEST),
    GL_ENUM(GL_AUTO_NORMAL),
    GL_ENUM(GL_COLOR_MATERIAL),
    GL_ENUM(GL_COLOR_SUM),
    GL_ENUM(GL_FOG),
    GL_ENUM(GL_INDEX_LOGIC_OP),
    GL_ENUM(GL_LIGHTING),
    GL_ENUM(GL_LINE_STIPPLE),
    GL_ENUM(GL_NORMALIZE),
    GL_ENUM(GL_POINT_SMOOTH),
    GL_ENUM(GL_POINT_SPRITE),
    GL_ENUM(GL_POLYGON_STIPPLE),
    GL_ENUM(GL_RESCALE_NORMAL),
    GL_ENUM(GL_VERTEX_PROGRAM_TWO_SIDE),
    GL_ENUM(GL_COLOR_ARRAY),
    GL_ENUM(GL_FOG_COORD_ARRAY),
    GL_ENUM(GL_NORMAL_ARRAY),
    GL_ENUM(GL_SECONDARY_COLOR_ARRAY),
    GL_ENUM(GL_VERTEX_ARRAY),
};

constexpr Enum symbols[] = {
    GL_ENUM(GL_ALPHA_TEST_FUNC),
    GL_ENUM(GL_ATTRIB_STACK_DEPTH),
    GL_ENUM(GL_CLAMP_FRAGMENT_COLOR),
    GL_ENUM(GL_CLAMP_VERTEX_COLOR),
    GL_ENUM(GL_CLIENT_ACTIVE_TEXTURE),
    GL_ENUM(GL_CLIENT_ATTRIB_STACK_DEPTH),
    GL_ENUM(GL_COLOR_MATERIAL_FACE),
    GL_ENUM(GL_COLOR_MATERIAL_PARAMETER),
    GL_ENUM(GL_FOG_COORD_SRC),
    GL_ENUM(GL_FOG_HINT),
    GL_ENUM(GL_FOG_MODE),
    GL_ENUM(GL_GENERATE_MIPMAP_HINT),
    GL_ENUM(GL_LIGHT_MODEL_COLOR_CONTROL),
    GL_ENUM(GL_LIGHT_MODEL_LOCAL_VIEWER),
    GL_ENUM(GL_LIGHT_MODEL_TWO_SIDE),
    GL_ENUM(GL_LIST_BASE),
    GL_ENUM(GL_LIST_INDEX),
    GL_ENUM(GL_LIST_MODE),
    GL_ENUM(GL_MAP_COLOR),
    GL_ENUM(GL_MAP_STENCIL),
    GL_ENUM(GL_MATRIX_MODE),
    GL_ENUM(GL_MODELVIEW_STACK_DEPTH),
    GL_ENUM(GL_NAME_STACK_DEPTH),
    GL_ENUM(GL_PERSPECTIVE_CORRECTION_HINT),
    GL_ENUM(GL_POINT_SMOOTH_HINT),
    GL_ENUM(GL_PROJECTION_STACK_DEPTH),
    GL_ENUM(GL_RENDER_MODE),
    GL_ENUM(GL_SHADE_MODEL),
};

constexpr Query numbers[] = {
    {GL_ENUM(GL_ACCUM_CLEAR_VALUE), 4},
    {GL_ENUM(GL_ALPHA_BIAS)},
    {GL_ENUM(GL_ALPHA_SCALE)},
    {GL_ENUM(GL_ALPHA_TEST_REF)},
    {GL_ENUM(GL_BLUE_BIAS)},
    {GL_ENUM(GL_BLUE_SCALE)},
    {GL_ENUM(GL_CURRENT_COLOR), 4},
    {GL_ENUM(GL_CURRENT_FOG_COORD)},
    {GL_ENUM(GL_CURRENT_NORMAL), 3},
    {GL_ENUM(GL_CURRENT_RASTER_POSITION), 4},
    {GL_ENUM(GL_CURRENT_SECONDARY_COLOR), 4},
    {GL_ENUM(GL_DEPTH_BIAS)},
    {GL_ENUM(GL_DEPTH_SCALE)},
    {GL_ENUM(GL_FOG_COLOR), 4},
    {GL_ENUM(GL_FOG_DENSITY)},
    {GL_ENUM(GL_FOG_END)},
    {GL_ENUM(GL_FOG_START)},
    {GL_ENUM(GL_GREEN_BIAS)},
    {GL_ENUM(GL_GREEN_SCALE)},
    {GL_ENUM(GL_INDEX_OFFSET)},
    {GL_ENUM(GL_INDEX_SHIFT)},
    {GL_ENUM(GL_LIGHT_MODEL_AMBIENT), 4},
    {GL_ENUM(GL_LINE_STIPPLE_PATTERN)},
    {GL_ENUM(GL_LINE_STIPPLE_REPEAT)},
    {GL_ENUM(GL_MODELVIEW_MATRIX), 16},
    {GL_ENUM(GL_POINT_DISTANCE_ATTENUATION), 3},
    {GL_ENUM(GL_POINT_SIZE_MAX)},
    {GL_ENUM(GL_POINT_SIZE_MIN)},
    {GL_ENUM(GL_PROJECTION_MATRIX), 16},
    {GL_ENUM(GL_RED_BIAS)},
    {GL_ENUM(GL_RED_SCALE)},
    {GL_ENUM(GL_ZOOM_X)},
    {GL_ENUM(GL_ZOOM_Y)},
};

void recordTextureStages(StateRecorder& recorder)
{
    constexpr Enum enables[] = {
        GL_ENUM(GL_TEXTURE_1D),       GL_ENUM(GL_TEXTURE_2D),        GL_ENUM(GL_TEXTURE_3D),
        GL_ENUM(GL_TEXTURE_CUBE_MAP), GL_ENUM(GL_TEXTURE_RECTANGLE), GL_ENUM(GL_TEXTURE_GEN_S),
        GL_ENUM(GL_TEXTURE_GEN_T),    GL_ENUM(GL_TEXTURE_GEN_R),     GL_ENUM(GL_TEXTURE_GEN_Q)};
    const int activeUnit = limit(GL_ACTIVE_TEXTURE);
    const int count = limit(GL_MAX_TEXTURE_COORDS);
    for (int i = 0; i < count; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(i));
        const std::string stage = indexed("GL_TEXTURE", i) + " ";
        if (i < limit(GL_MAX_TEXTURE_UNITS)) {
            for (const Enum& name : enables)
                recorder.addSwitch(stage + name.text, glIsEnabled(name.value) == GL_TRUE);
            GLint mode = 0;
            glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mode);
            recorder.addSymbol(stage + "GL_TEXTURE_ENV_MODE", mode);
        }
        recorder.addSymbol(stage + "GL_TEXTURE_STACK_DEPTH", limit(GL_TEXTURE_STACK_DEPTH));
        std::array<double, 16> values{};
        glGetDoublev(GL_TEXTURE_MATRIX, values.data());
        recorder.addNumbers(stage + "GL_TEXTURE_MATRIX", values);
        glGetDoublev(GL_CURRENT_TEXTURE_COORDS, values.data());
        recorder.addNumbers(stage + "GL_CURRENT_TEXTURE_COORDS", std::span(values).first(4));
    }
    glActiveTexture(static_cast<GLenum>(activeUnit));
}

} // namespace

void recordFixedFunction(StateRecorder& recorder)
{
    if (!has(compatibility))
        return;
    for (const Enum& name : switches)
        recorder.addSwitch(name.text, glIsEnabled(name.value) == GL_TRUE);
    for (int i = 0; i < limit(GL_MAX_LIGHTS); ++i)
        recorder.addSwitch(indexed("GL_LIGHT", i),
                           glIsEnabled(GL_LIGHT0 + static_cast<GLuint>(i)) == GL_TRUE);
    for (const Enum& name : symbols)
        recorder.addSymbol(name.text, limit(name.value));
    for (const Query& query : numbers) {
        std::array<double, 16> values{};
        glGetDoublev(query.name.value, values.data());
        recorder.addNumbers(query.name.text, std::span(values).first(static_cast<std::size_t>(query.count)));
    }
    recordTextureStages(recorder);
}

} // namespace tests
