// Scenes from files, through Assimp.
#pragma once

#include "scene.h"

namespace examples {

// Coordinates as Assimp gives them, with the nodes' transforms applied; polygons triangulated; points and
// lines left out; every triangle kept, degenerate ones too. Throws mirrorball::Error: notFound, badFile.
Scene readSceneFile(const std::string& file);

} // namespace examples
