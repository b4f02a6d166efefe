// The picture as the library draws it: pass 1 for every reflector that mirrors the scene, then pass 2.
#pragma once

#include "picture.h"
#include "setup.h"
#include "stats.h"

#include <functional>
#include <vector>

namespace render {

// Makes a context of its own and adds times and counts to the statistics. Throws mirrorball::Error.
Picture drawPicture(const Setup& setup, const Options& options, examples::Stats& stats);

// One picture for each camera, all from one pass 1: neither scene nor reflectors move. The setup's own camera does
// not matter.
void drawPath(const Setup& setup, const Options& options, const std::vector<Camera>& path,
              const std::function<void(const Picture&)>& use);

} // namespace render
