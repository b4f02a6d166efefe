// A host whose loader is GLEW, included before every public header; glew_last.cpp includes it after.
#include <GL/glew.h>

#include "all_headers.h"

#include <cstdio>
#include <exception>

bool probeAndGlewShareAContext();

int main()
try {
    const mirrorball::headless::Context context;
    // GLEW as Debian builds it asks for GLX in the end, when it has found all functions of OpenGL.
    const GLenum status = glewInit();
    if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY) {
        std::fprintf(stderr, "%s\n", reinterpret_cast<const char*>(glewGetErrorString(status)));
        return 1;
    }
    return probeAndGlewShareAContext() ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
