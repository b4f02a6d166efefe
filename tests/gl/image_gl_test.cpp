// The helpers that draw and read back; and with them, that hostile states are hostile: a drawing that does
// not protect itself comes out wrong.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/gl_state.h"
#include "support/hostile_state.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

constexpr int width = 8;
constexpr int height = 4;

using Image = std::vector<float>;

std::size_t texel(int x, int y)
{
    return 4 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
}

GLuint makeConstantProgram()
{
    return tests::makeProgram(tests::fullScreenVertexSource, R"(#version 330 core
out vec4 colour;
void main() { colour = vec4(2.5, -1.0, 65536.0, 0.25); }
)");
}

void readsWhatWasDrawn()
{
    const tests::ColourTarget target(width, height);
    CHECK(target.read() == Image(4 * width * height, 0.0f));

    const GLuint program = tests::makeProgram(tests::fullScreenVertexSource, R"(#version 330 core
in vec2 uv;
out vec4 colour;
void main() { colour = vec4(uv, gl_FragCoord.xy); }
)");
    glUseProgram(program);
    target.bind();
    tests::drawFullScreenTriangle();
    const Image image = target.read();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* rgba = &image[texel(x, y)];
            // A driver's interpolation takes a handful of operations on numbers up to 2: 8 ulp of 2.
            constexpr double tolerance = 8 * 2.4e-7;
            CHECK_NEAR(rgba[0], (x + 0.5) / width, tolerance);
            CHECK_NEAR(rgba[1], (y + 0.5) / height, tolerance);
            CHECK_NEAR(rgba[2], x + 0.5, 0.0);
            CHECK_NEAR(rgba[3], y + 0.5, 0.0);
        }
    glUseProgram(0);
    glDeleteProgram(program);
}

void readsOneLayerOnly()
{
    Image texels(3 * 4 * width * height);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = static_cast<float>(i) - 100.5f;
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, width, height, 3, 0, GL_RGBA, GL_FLOAT, texels.data());
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    for (int layer = 0; layer < 3; ++layer) {
        const auto begin = texels.begin() + layer * 4 * width * height;
        CHECK(tests::readTextureLayer(texture, layer, width, height) ==
              Image(begin, begin + 4 * width * height));
    }
    glDeleteTextures(1, &texture);
}

void helpersLeaveTheStateAlone(tests::HostileState& hostile)
{
    const tests::ColourTarget target(width, height);
    const GLuint program = makeConstantProgram();
    glUseProgram(program);
    target.bind();
    tests::drawFullScreenTriangle();
    const Image image = target.read();
    CHECK(tests::changesBy([] { tests::drawFullScreenTriangle(); }).empty());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    CHECK(image[0] == 2.5f && image[1] == -1.0f && image[2] == 65536.0f && image[3] == 0.25f);

    for (const std::string& name : hostile.names()) {
        hostile.apply({name});
        CHECK(tests::changesBy([&] { CHECK(target.read() == image); }).empty());
        hostile.undo();
    }
    CHECK(tests::changesBy([] { const tests::ColourTarget another(1, 1); }).empty());
    glUseProgram(0);
    glDeleteProgram(program);
}

// A picture that reads a texture and is tested against depth and stencil.
class Picture
{
public:
    Picture()
    {
        constexpr GLfloat green[] = {0.25f, 0.5f, 0.125f, 0.5f};
        glGenRenderbuffers(1, &depth_);
        glBindRenderbuffer(GL_RENDERBUFFER, depth_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
        glBindRenderbuffer(GL_RENDERBUFFER, 0);
        glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, green);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    ~Picture()
    {
        glDeleteTextures(1, &texture_);
        glDeleteRenderbuffers(1, &depth_);
        glDeleteProgram(program_);
    }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    // Draws once, in these hostile states that apply to an otherwise proper set-up.
    Image draw(tests::HostileState& hostile, const std::vector<std::string>& names) const
    {
        target_.bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glUseProgram(program_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        hostile.apply(names);
        tests::drawFullScreenTriangle();
        hostile.undo();
        glBindTexture(GL_TEXTURE_2D, 0);
        glUseProgram(0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return target_.read();
    }

private:
    const tests::ColourTarget target_{width, height};
    const GLuint program_ = tests::makeProgram(tests::fullScreenVertexSource, R"(#version 330 core
in vec2 uv;
uniform sampler2D image;
out vec4 colour;
void main() { colour = texture(image, uv + 2.0) + vec4(uv, 0.0, 0.0); }
)");
    GLuint depth_ = 0;
    GLuint texture_ = 0;
};

void hostileStatesSpoilADrawing(tests::HostileState& hostile)
{
    const Picture picture;
    const Image calm = picture.draw(hostile, {});
    CHECK(picture.draw(hostile, {}) == calm);
    // The others need more than this drawing to show: several samples, clip distances, indices, lines, a
    // read-back, …
    for (const std::string name :
         {"viewport of one pixel", "viewports all different", "scissor of one pixel",
          "scissors all different", "clip control upper left, zero to one", "rasteriser discard",
          "front and back culled", "polygons as lines", "depth test never passes",
          "stencil test never passes", "colour writes off", "colour masks all different",
          "blending to nothing", "host's framebuffers bound", "host's program in use",
          "textures on every unit", "samplers on every unit"})
    {
        const bool present =
            std::find(hostile.names().begin(), hostile.names().end(), name) != hostile.names().end();
        CHECK(!present || picture.draw(hostile, {name}) != calm);
    }
}

} // namespace

int main()
{
    const mirrorball::headless::Context context;
    std::printf("%s\n", context.description().c_str());
    readsWhatWasDrawn();
    readsOneLayerOnly();
    tests::HostileState hostile;
    helpersLeaveTheStateAlone(hostile);
    hostileStatesSpoilADrawing(hostile);
    CHECK(tests::takeErrors().empty());
}
