// Which driver the current context is of, for what drivers do differently within OpenGL's rules.
#pragma once

namespace tests {

bool isSoftpipe();
bool isSoftwareRasteriser(); // llvmpipe or softpipe
bool isNvidia();

} // namespace tests
