// The names of uniforms that tell what a host's program was made for.
#pragma once

#include <mirrorball/maps/maps.h>

#include <algorithm>
#include <string>

namespace mirrorball::reflect {

// The turn into a map's axes, after the prefix. Every look-up uses it, and it names the map, so that a binding sees
// which one the snippet is of.
inline std::string mapFromWorld(MapKind map)
{
    std::string name(mapInfo(map).name);
    std::replace(name.begin(), name.end(), '-', '_');
    return "mapFromWorld_" + name;
}

} // namespace mirrorball::reflect
