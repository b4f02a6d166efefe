#include "support/driver.h"

#include <epoxy/gl.h>

#include <string_view>

namespace tests {

namespace {

bool says(GLenum name, std::string_view word)
{
    const std::string_view text = reinterpret_cast<const char*>(glGetString(name));
    return text.find(word) != std::string_view::npos;
}

} // namespace

bool isSoftpipe()
{
    return says(GL_RENDERER, "softpipe");
}

bool isSoftwareRasteriser()
{
    return isSoftpipe() || says(GL_RENDERER, "llvmpipe");
}

bool isNvidia()
{
    return says(GL_VENDOR, "NVIDIA");
}

} // namespace tests
