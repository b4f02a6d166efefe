// The entries of HostileState. Private to hostile_state*.cpp.
#pragma once

#include "support/gl_state_recorder.h" // Gate, has, limit

#include <epoxy/gl.h>

#include <array>
#include <span>
#include <vector>

namespace tests {

// A texture target and the texture of the host's that goes there.
struct HostTexture
{
    GLenum target;
    GLuint name;
};

// What the host owns: objects to bind, each in a state of its own.
struct HostObjects
{
    HostObjects();
    ~HostObjects();
    HostObjects(const HostObjects&) = delete;
    HostObjects& operator=(const HostObjects&) = delete;

    std::array<GLint, 4> viewport{}; // to go back to
    std::array<GLint, 4> scissor{};
    GLuint stencilMask = 0; // as many ones as the implementation cares for
    std::vector<std::array<GLfloat, 4>>
        attributeValues; // on NVIDIA some of them are the fixed function's, colour first

    std::vector<HostTexture> textures; // one for each target of the context
    GLuint sampler = 0;
    GLuint buffer = 0; // hostBufferSize bytes
    GLuint vertexArray = 0;
    GLuint program = 0;  // captures gl_Position with transform feedback
    GLuint pipeline = 0; // 0 where the context has none
    GLuint drawFramebuffer = 0;
    GLuint readFramebuffer = 0;
    GLuint renderbuffer = 0;
    GLuint transformFeedback = 0;     // 0 where the context has only the default one
    std::array<GLuint, 13> queries{}; // one for each target that can be active with the others
};

// Room for a 64-byte range at any binding point, each at its own multiple of 256, the largest alignment that
// OpenGL allows an implementation to ask for.
inline constexpr GLsizeiptr hostBufferSize = 64 * 1024;

struct HostileEntry
{
    const char* name;
    Gate gate;
    void (*apply)(const HostObjects& host);
    void (*undo)(const HostObjects& host);
};

std::span<const HostileEntry> hostileRasterisation(); // viewport to rasteriser
std::span<const HostileEntry> hostileFragments();     // depth, stencil, blending, samples, clear values
std::span<const HostileEntry> hostileBindings();      // objects bound where a guest would bind its own
std::span<const HostileEntry> hostileTransfer();      // pixel storage
std::span<const HostileEntry> hostileFixedFunction(); // compatibility profile

} // namespace tests
