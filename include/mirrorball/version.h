// The version of the library; CMakeLists.txt reads it from here.
#pragma once

#define MIRRORBALL_VERSION_MAJOR 0
#define MIRRORBALL_VERSION_MINOR 1
#define MIRRORBALL_VERSION_PATCH 0
