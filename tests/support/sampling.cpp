#include "support/sampling.h"

#include <mirrorball/gl/objects.h>

#include <glm/common.hpp>

#include <cstring>

namespace tests {

namespace {

bool isOwned(mirrorball::MapKind map, int component, const glm::dvec2& centre, const glm::dvec2& size)
{
    const auto owner =
        mirrorball::coordinateFromDirection(map, mirrorball::directionFromSquare(map, component, centre));
    const glm::dvec2 offset = glm::abs(owner.uv - centre) * size;
    return owner.component == component && offset.x < 0.5 && offset.y < 0.5;
}

GLuint makeSamplingProgram(const mirrorball::ReflectionMaterial& material, const std::string& result,
                           const std::string& declarations)
{
    return makeProgram(fullScreenVertexSource,
                       glslVersionLine(material.version) + reflectionGlsl(material) +
                           "uniform sampler2D directions;\nuniform ivec2 shift;\nout vec4 colour;\n" +
                           declarations +
                           "void main()\n{\n"
                           "    vec4 direction = texelFetch(directions, ivec2(gl_FragCoord.xy) - shift, 0);\n"
                           "    colour = " +
                           result + ";\n}\n");
}

} // namespace

std::vector<float> layersOf(mirrorball::MapKind map, int n,
                            const std::function<glm::vec3(const glm::dvec3&)>& colour, PastSeams pastSeams)
{
    const mirrorball::MapInfo& info = mirrorball::mapInfo(map);
    const glm::dvec2 size(info.widthInN * n, info.heightInN * n);
    std::vector<float> layers;
    for (int component = 0; component < info.components; ++component)
        for (int row = 0; row < info.heightInN * n; ++row)
            for (int column = 0; column < info.widthInN * n; ++column) {
                const glm::dvec2 centre = (glm::dvec2(column, row) + 0.5) / size;
                const glm::vec3 texel = pastSeams == PastSeams::shown || isOwned(map, component, centre, size)
                                            ? colour(mirrorball::directionFromSquare(map, component, centre))
                                            : glm::vec3(1000.0f);
                layers.insert(layers.end(), {texel.r, texel.g, texel.b, 1.0f});
            }
    return layers;
}

SamplingProgram::SamplingProgram(const mirrorball::ReflectionMaterial& material, const std::string& result,
                                 const std::string& declarations)
    : program_(makeSamplingProgram(material, result, declarations)), binding_(program_)
{
}

SamplingProgram::~SamplingProgram()
{
    glDeleteProgram(program_);
}

std::vector<glm::vec4> SamplingProgram::draw(const mirrorball::ReflectionMap& map,
                                             const std::vector<glm::vec4>& directions, int width,
                                             const glm::ivec2& shift,
                                             const mirrorball::MaterialSettings& settings) const
{
    constexpr int unit = 8; // of the directions' texture
    const glm::ivec2 size(width, (static_cast<int>(directions.size()) + width - 1) / width);
    std::vector<glm::vec4> texels = directions;
    texels.resize(static_cast<std::size_t>(size.x * size.y), glm::vec4(1.0f));
    const auto texture = mirrorball::gl::Texture::create();
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, texels.data());

    const glm::ivec2 whole = size + shift;
    const ColourTarget target(whole.x, whole.y);
    target.bind();
    glUseProgram(program_);
    glUniform1i(glGetUniformLocation(program_, "directions"), unit);
    glUniform2i(glGetUniformLocation(program_, "shift"), shift.x, shift.y);
    const auto bound = binding_.bind(map, settings);
    drawFullScreenTriangle();
    const std::vector<float> image = target.read();
    std::vector<glm::vec4> pixels(directions.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int x = static_cast<int>(i) % size.x + shift.x, y = static_cast<int>(i) / size.x + shift.y;
        std::memcpy(&pixels[i], &image[4 * static_cast<std::size_t>(y * whole.x + x)], sizeof pixels[i]);
    }
    return pixels;
}

} // namespace tests
