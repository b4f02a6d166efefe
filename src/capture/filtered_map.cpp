#include "capture/filtered_map.h"

#include "capture_shaders.h"
#include "gl/context.h"
#include "gl/program.h"

#include <mirrorball/error.h>
#include <mirrorball/maps/glsl.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string>

namespace mirrorball::capture {

namespace {

// The coarsest level's texels, of all components: 512 share the sphere at 9° across. Between larger ones
// linear interpolation errs by more than 1/255 of a smooth environment, differently on each side of a border.
constexpr int fewestTexels = 512;

gl::Program link(MapKind map, std::string_view fragment, const std::string& name,
                 PastSeams pastSeams = PastSeams::unknown)
{
    const std::string version = glslVersionLine(GlslVersion::glsl330) + "#define MIRRORBALL_WHOLE_SQUARE " +
                                (pastSeams == PastSeams::captured ? "1\n" : "0\n");
    return gl::linkProgram(
        {{GL_VERTEX_SHADER, version + std::string(shaders::copyVertex), "the vertex shader of " + name},
         {GL_FRAGMENT_SHADER,
          version + mapGlsl(map, GlslVersion::glsl330, "map_") + std::string(shaders::filteredCommon) +
              std::string(fragment),
          "the fragment shader of " + name}},
        name);
}

int roundedUp(int number, int multiple)
{
    return (number + multiple - 1) / multiple * multiple;
}

float largestNumber(unsigned int internalFormat)
{
    constexpr float largestHalf = 65504.0f;
    constexpr float roomForSums = 1e36f; // in floats, whose largest is 3.4e38
    return internalFormat == GL_RGBA32F ? roomForSums : largestHalf;
}

} // namespace

FilteredLayout filteredLayout(MapKind map, int n)
{
    const MapSize size = mapSize(map, n);
    int coarsest = 0;
    const auto texels = [&](int level) {
        return size.layers * (size.width >> level) * (size.height >> level);
    };
    while (texels(coarsest + 1) >= fewestTexels)
        ++coarsest;
    // Half a texel of the coarsest level, which is what linear interpolation at the border reads.
    const int guard = std::max(1, (1 << coarsest) / 2);
    return {roundedUp(size.width + 2 * guard, 1 << coarsest),
            roundedUp(size.height + 2 * guard, 1 << coarsest), guard, coarsest + 1};
}

FilteredMap::FilteredMap(MapKind map, int n, unsigned int internalFormat, PastSeams pastSeams)
    : map_(map), n_(n), layout_(filteredLayout(map, n)), largest_(largestNumber(internalFormat)),
      copies_(pastSeams == PastSeams::captured)
{
    const int limit = gl::integer(GL_MAX_TEXTURE_SIZE);
    if (std::max(layout_.width, layout_.height) > limit)
        throw Error(ErrorKind::badArgument,
                    "a " + std::string(mapInfo(map).name) + " map of size " + std::to_string(n) +
                        " with guard texels",
                    "it is " + std::to_string(layout_.width) + " x " + std::to_string(layout_.height) +
                        " texels and this driver's limit is " + std::to_string(limit),
                    "ask for fewer or for no mip levels");
    if (copies_)
        copy_ = link(map, shaders::filteredCopy, "the copy of a map");
    fill_ = link(map, shaders::filteredFill, "the guard texels of a map", pastSeams);
    if (map == MapKind::sphereMap)
        rim_ = link(map, shaders::filteredRim, "the rim of a sphere map");
    texture_ = gl::Texture::create();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    for (int level = 0; level < layout_.levels; ++level)
        glTexImage3D(GL_TEXTURE_2D_ARRAY, level, static_cast<GLint>(internalFormat), layout_.width >> level,
                     layout_.height >> level, mapInfo(map).components, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, layout_.levels - 1);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    framebuffer_ = gl::Framebuffer::create();
}

void FilteredMap::update(unsigned int colourTexture)
{
    pass_.prepare();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0); // only single texels are read
    glBindTexture(GL_TEXTURE_2D_ARRAY, colourTexture);
    fillFirstLevel();
    if (rim_)
        fillRim(0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glBindTexture(GL_TEXTURE_2D_ARRAY, colourTexture);
    for (int level = 1; rim_ && level < layout_.levels; ++level)
        fillRim(level);
}

void FilteredMap::fillFirstLevel()
{
    const MapSize size = mapSize(map_, n_);
    for (int layer = 0; layer < size.layers; ++layer) {
        attach(0, layer);
        if (copies_) {
            useProgram(copy_);
            glUniform1i(glGetUniformLocation(copy_.name(), "layer"), layer);
            glViewport(layout_.guard, layout_.guard, size.width, size.height);
            pass_.draw();
        }
        useProgram(fill_);
        glUniform1i(glGetUniformLocation(fill_.name(), "layer"), layer);
        glViewport(0, 0, layout_.width, layout_.height);
        if (copies_)
            drawGuards();
        else
            pass_.draw();
    }
}

// Everything but the map's own texels: below, above, left and right of them.
void FilteredMap::drawGuards()
{
    const MapSize size = mapSize(map_, n_);
    const int right = layout_.guard + size.width, top = layout_.guard + size.height;
    glEnable(GL_SCISSOR_TEST);
    for (const std::array<int, 4>& box :
         {std::array{0, 0, layout_.width, layout_.guard},
          std::array{0, top, layout_.width, layout_.height - top},
          std::array{0, layout_.guard, layout_.guard, size.height},
          std::array{right, layout_.guard, layout_.width - right, size.height}})
    {
        glScissor(box[0], box[1], box[2], box[3]);
        pass_.draw();
    }
    glDisable(GL_SCISSOR_TEST);
}

void FilteredMap::fillRim(int level)
{
    useProgram(rim_);
    ReflectionMap described;
    describeIn(described);
    glUniform4fv(glGetUniformLocation(rim_.name(), "textureFromSquare"), 1, &described.filteredFromSquare.x);
    glUniform2f(glGetUniformLocation(rim_.name(), "levelSize"), static_cast<float>(layout_.width >> level),
                static_cast<float>(layout_.height >> level));
    attach(level, 0);
    glViewport(0, 0, layout_.width >> level, layout_.height >> level);
    pass_.draw();
}

void FilteredMap::useProgram(const gl::Program& program) const
{
    glUseProgram(program.name());
    glUniform1i(glGetUniformLocation(program.name(), "colours"), 0);
    glUniform1f(glGetUniformLocation(program.name(), "largest"), largest_);
    glUniform1i(glGetUniformLocation(program.name(), "guard"), layout_.guard);
}

void FilteredMap::attach(int level, int layer) const
{
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture_.name(), level, layer);
}

void FilteredMap::describeIn(ReflectionMap& map) const
{
    const MapSize size = mapSize(map_, n_);
    const glm::vec2 whole(layout_.width, layout_.height);
    map.filteredColourTexture = texture_.name();
    map.filteredFromSquare = {
        static_cast<float>(size.width) / whole.x, static_cast<float>(size.height) / whole.y,
        static_cast<float>(layout_.guard) / whole.x, static_cast<float>(layout_.guard) / whole.y};
}

} // namespace mirrorball::capture
