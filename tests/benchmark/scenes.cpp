#include "scenes.h"

namespace tests::benchmark {

namespace {

// Debian's glmark2-data and assimp-testmodels.
#define MODELS "/usr/share/assimp/models/"

constexpr SceneChoice choices[] = {
    {"cards", "builtin:cards", {0, 0, 0}, 0.1f, 3000.0f, false, true, {}},
    {"room", "builtin:room", {0, 0, 0}, 0.1f, 100.0f, true, false, {}},
    // 128 objects on a shell of radius 4 to 13 in a room.
    {"crowd-12k", "builtin:crowd:12000", {0, 0, 0}, 0.1f, 100.0f, true, true, 0.86},
    {"crowd-100k", "builtin:crowd:100000", {0, 0, 0}, 0.1f, 100.0f, true, true, 0.65},
    {"crowd-200k", "builtin:crowd:200000", {0, 0, 0}, 0.1f, 100.0f, true, false, {}},
    {"crowd-503k", "builtin:crowd:503000", {0, 0, 0}, 0.1f, 100.0f, true, false, 0.56},
    // In a room of the ground floor, which is y from 0 to 2.5; outside lie 20 units of ground.
    {"house", MODELS "IFC/AC14-FZK-Haus.ifc", {4, 1.5, -3}, 0.1f, 100.0f, false, true, {}},
    // From inside the bunny: its back faces are all that is seen.
    {"bunny", "/usr/share/glmark2/models/bunny.obj", {0, 0, 0}, 0.01f, 10.0f, false, false, {}},
    // In millimetres, between the cylinders; the nearest surface is 8 away.
    {"engine",
     MODELS "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
     {0, 0, 0},
     1.0f,
     2000.0f,
     false,
     false,
     {}},
};

} // namespace

std::span<const SceneChoice> sceneChoices()
{
    return choices;
}

} // namespace tests::benchmark
