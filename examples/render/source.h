// The images of --source, as the layers of a map.
#pragma once

#include <mirrorball/maps/maps.h>

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace render {

struct Source
{
    mirrorball::MapKind map; // cube, equirectangular or sphereMap
    int n;
    std::vector<float> layers; // as mirrorball::ImageMap wants them: linear RGBA
};

// Six files are a cube, +X −X +Y −Y +Z −Z; one is a panorama (twice as wide as high) or a sphere-map image
// (square). Throws mirrorball::Error: badArgument for another number of files, else what readImage throws,
// and badFile for sizes that do not fit.
Source readSource(const std::vector<std::string>& files);

// Linear RGB in a direction of the map, bilinear within a layer, by double formulas that share nothing with
// the library's maps: for the reference.
glm::vec3 sourceColour(const Source& source, const glm::dvec3& direction);

} // namespace render
