// The picture as the library draws it: pass 1 for every reflector that mirrors the scene, then pass 2.
#pragma once

#include "picture.h"
#include "setup.h"
#include "stats.h"

namespace render {

// Makes a context of its own and adds times and counts to the statistics. Throws mirrorball::Error.
Picture drawPicture(const Setup& setup, const Options& options, examples::Stats& stats);

} // namespace render
