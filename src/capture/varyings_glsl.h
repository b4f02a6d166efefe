// The GLSL that carries the host's varyings past the stages between its vertex and its fragment shader.
#pragma once

#include "capture/varyings.h"

#include <string>
#include <vector>

namespace mirrorball::capture {

// Of a varying between the geometry and the fragment stage. Numbered, since a host's name with the library's prefix
// could be a name of the library's.
std::string carriedName(const Varying& varying);

// Declarations of the geometry stage and the function copyVaryings that hands on those of a corner (copied)
// or of all three (exact).
std::string geometryVaryings(const std::vector<Varying>& varyings, Carriage carriage);

// Declarations of the tessellation stages and their functions copyVaryings and mixVaryings.
std::string controlVaryings(const std::vector<Varying>& varyings);
std::string evaluationVaryings(const std::vector<Varying>& varyings);

// Declarations of the fragment stage behind a geometry stage and the function readVaryings, which sets the
// host's globals.
std::string fragmentVaryings(const std::vector<Varying>& varyings, Carriage carriage);

// The function fromCentre, which tells where a fragment of a mapped mesh lies from the probe's centre, in some frame:
// from a varying of the host's with the position relative to captureOrigin, or from the library's own (null).
std::string fragmentPosition(const Varying* position);

} // namespace mirrorball::capture
