// The polygons of exact capture that cover a curved triangle on the map: what their shaders are told of each map.
#pragma once

#include <mirrorball/maps/maps.h>

#include <string>
#include <string_view>

namespace mirrorball::capture {

// The text that lays covers for a family of maps, for after shaders::coverCommon.
std::string_view coverShader(MapKind map);

// What the #if lines of both ask, for the current context's rasteriser.
std::string coverDefines(MapKind map);

} // namespace mirrorball::capture
