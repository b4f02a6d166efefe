// The printed GLSL, run by the driver, against C++ float: 2^20 directions a map, forward and back.
#include "maps/directions.h"
#include "maps/reference.h"
#include "support/check.h"
#include "support/gl_image.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/maps/glsl.h>

#include <algorithm>
#include <cstdio>

namespace {

using mirrorball::GlslVersion;
using mirrorball::MapKind;

constexpr int side = 1024;
constexpr int count = side * side;
constexpr double squareBound = 0x1p-20;
// GLSL divides and takes roots to 2.5 ulp instead of half: four times the 1e-6 / 4 that C++ stays below.
constexpr double directionBound = 1e-6;

// Zero, subnormal, tiny, huge, infinite and NaN, in all combinations.
std::vector<glm::vec3> specialDirections()
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float largest = std::numeric_limits<float>::max();
    const float smallest = std::numeric_limits<float>::min();
    const std::array values{0.0f,      -0.0f,     1e-40f, -1e-45f, smallest,
                            -smallest, 1.0f,      -0.5f,  largest, -largest,
                            infinity,  -infinity, 3e19f,  -1e-20f, std::numeric_limits<float>::quiet_NaN()};
    std::vector<glm::vec3> directions;
    for (const float x : values)
        for (const float y : values)
            for (const float z : values)
                directions.emplace_back(x, y, z);
    return directions;
}

std::vector<glm::vec3> allDirections()
{
    std::vector<glm::vec3> directions = specialDirections();
    const auto hard = tests::hardDirections<float>(count);
    directions.insert(directions.end(), hard.begin(), hard.end());
    directions.resize(count);
    return directions;
}

// A texture of side x side texels, bound to unit 0.
class Texture
{
public:
    template <class Vector>
    Texture(const std::vector<Vector>& texels, GLint internalFormat, GLenum format)
    {
        glGenTextures(1, &name_);
        glBindTexture(GL_TEXTURE_2D, name_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, side, side, 0, format, GL_FLOAT, texels.data());
    }
    ~Texture() { glDeleteTextures(1, &name_); }
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

private:
    GLuint name_ = 0;
};

// What `expression` gives for each texel `d` of the bound texture.
std::vector<float> evaluated(MapKind map, const std::string& expression)
{
    const std::string fragmentShader =
        glslVersionLine(GlslVersion::glsl330) + mapGlsl(map, GlslVersion::glsl330, "") +
        "uniform sampler2D inputs;\nout vec4 result;\nvoid main()\n{\n"
        "    vec3 d = texelFetch(inputs, ivec2(gl_FragCoord.xy), 0).xyz;\n    result = " +
        expression + ";\n}\n";
    const GLuint program = tests::makeProgram(tests::fullScreenVertexSource, fragmentShader);
    const tests::ColourTarget target(side, side);
    target.bind();
    glUseProgram(program);
    tests::drawFullScreenTriangle();
    glUseProgram(0);
    glDeleteProgram(program);
    return target.read();
}

// A component that differs is one where the direction lies within 4 ulp of the border.
void checkComponent(MapKind map, const glm::vec3& d, int inGlsl)
{
    if (inGlsl == mirrorball::componentOf(map, d))
        return;
    const std::array<tests::Exact, 3> exact{double(d.x), double(d.y), double(d.z)};
    CHECK(inGlsl >= 0 && inGlsl < mirrorball::mapInfo(map).components);
    CHECK_NEAR(tests::distanceFromBorder(map, exact), 0, 4 * 0x1p-23);
}

double checkForward(MapKind map, const std::vector<glm::vec3>& directions,
                    std::vector<glm::vec3>& coordinates)
{
    const Texture inputs(directions, GL_RGB32F, GL_RGB);
    const std::vector<float> glsl = evaluated(map, "vec4(coordinateFromDirection(d), 0.0)");
    double worst = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        coordinates[i] = {glsl[4 * i], glsl[4 * i + 1], glsl[4 * i + 2]};
        const int component = static_cast<int>(coordinates[i].z);
        checkComponent(map, directions[i], component);
        const glm::vec2 expected = mirrorball::squareFromDirection(map, component, directions[i]);
        for (int k = 0; k < 2; ++k) {
            CHECK_NEAR(coordinates[i][k], std::clamp(expected[k], 0.0f, 1.0f), squareBound);
            worst = std::max(
                worst, std::abs(double(coordinates[i][k]) - double(std::clamp(expected[k], 0.0f, 1.0f))));
        }
    }
    return worst;
}

double checkInverse(MapKind map, const std::vector<glm::vec3>& coordinates)
{
    const Texture inputs(coordinates, GL_RGB32F, GL_RGB);
    const std::vector<float> glsl = evaluated(map, "vec4(directionFromSquare(int(d.z), d.xy), 0.0)");
    double worst = 0;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const glm::vec3 expected = mirrorball::directionFromSquare(map, static_cast<int>(coordinates[i].z),
                                                                   glm::vec2(coordinates[i]));
        // A hair's breadth from the sphere map's rim, 1 - r² loses its last digits and takes the root with
        // it.
        const glm::vec2 ab = 2.0f * glm::vec2(coordinates[i]) - 1.0f;
        if (map == MapKind::sphereMap && ab.x * ab.x + ab.y * ab.y > 0.9f)
            continue;
        for (int k = 0; k < 3; ++k) {
            CHECK_NEAR(glsl[4 * i + static_cast<std::size_t>(k)], expected[k], directionBound);
            worst = std::max(
                worst, std::abs(double(glsl[4 * i + static_cast<std::size_t>(k)]) - double(expected[k])));
        }
    }
    return worst;
}

} // namespace

int main()
{
    const mirrorball::headless::Context context;
    std::printf("%s\n", context.description().c_str());
    const std::vector<glm::vec3> directions = allDirections();
    std::vector<glm::vec3> coordinates(directions.size());
    for (const mirrorball::MapInfo& map : mirrorball::maps()) {
        const double forward = checkForward(map.kind, directions, coordinates);
        const double inverse = checkInverse(map.kind, coordinates);
        std::printf("%-18s largest difference: (u, v) %.3g, direction %.3g\n", map.name.data(), forward,
                    inverse);
    }
    CHECK(glGetError() == GL_NO_ERROR);
}
