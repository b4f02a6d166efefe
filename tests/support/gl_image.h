// Small helpers of the tests that draw: programs, images to draw into, reading images back. What fails here
// ends the test with a message. Needs a current context, OpenGL 3.3 or later.
#pragma once

#include <mirrorball/maps/maps.h>

#include <epoxy/gl.h>

#include <string>
#include <string_view>
#include <vector>

namespace tests {

// A linked program. Where the driver refuses a stage or the link, its log is printed under the source with
// line numbers. Varyings named in `captured` go to transform feedback, interleaved.
GLuint makeProgram(std::string_view vertexSource, std::string_view fragmentSource,
                   const std::vector<const char*>& captured = {});

// A vertex shader for drawFullScreenTriangle, with output vec2 uv, (0, 0) at the lower left corner of the
// viewport.
extern const std::string_view fullScreenVertexSource;

// Draws three vertices without attributes that cover the viewport, with the current program, into the current
// framebuffer, and leaves the vertex array binding as it was.
void drawFullScreenTriangle();

// A framebuffer with one RGBA32F texture, width × height, cleared to zero, without depth. Creating it leaves
// the framebuffer and texture bindings as they were.
class ColourTarget
{
public:
    ColourTarget(int width, int height);
    ~ColourTarget();
    ColourTarget(const ColourTarget&) = delete;
    ColourTarget& operator=(const ColourTarget&) = delete;

    // Makes it the draw framebuffer and the whole of it the viewport.
    void bind() const;

    GLuint framebuffer() const { return framebuffer_; }
    GLuint texture() const { return texture_; }

    // The image as readTexture gives it.
    std::vector<float> read() const;

private:
    int width_;
    int height_;
    GLuint framebuffer_ = 0;
    GLuint texture_ = 0;
};

// One level of a colour texture that can be drawn to: width × height × RGBA, row 0 (v = 0) first. Components
// that the format lacks read as 0, alpha as 1. The size is that of the level. The state is left as it was,
// whatever it was.
std::vector<float> readTexture(GLuint texture2d, int width, int height, int level = 0);

// The same of one layer of an array texture.
std::vector<float> readTextureLayer(GLuint texture, int layer, int width, int height, int level = 0);

// The same of all layers of a map of that size, one after another.
std::vector<float> readMap(GLuint texture, mirrorball::MapKind map, int n);

// NaN equals itself, and -0 is not 0.
bool sameBits(const std::vector<float>& a, const std::vector<float>& b);

} // namespace tests
