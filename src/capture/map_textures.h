// The textures and framebuffers that one capture draws into.
#pragma once

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/gl/objects.h>

#include <vector>

namespace mirrorball::capture {

struct MapSize
{
    int width, height, layers;
};

MapSize mapSize(MapKind map, int n);

// n of the second layer of depth of a map of size n. It is seen through the gaps between what is near and its own place
// only, so that a quarter of the texels shows nearly as much; docs/reflection.md has both sides of that.
int hiddenN(int n);

// Throws Error badArgument when the driver's limits are exceeded, before anything is allocated.
void requireMapSize(MapKind map, int n, int supersample = 1);

// Colour and distance: what a capture leaves behind.
struct MapTextures
{
    gl::Texture colour;
    gl::Texture distance;
    std::vector<gl::Framebuffer> layers; // one a layer
    gl::Framebuffer allLayers;           // layered
};

unsigned int internalFormat(ColourFormat format);

// A depth texture with all layers, and textures that share it (none for nullptr). Bind nothing of the host's:
// call inside a StateGuard.
gl::Texture makeDepth(const MapSize& size);
gl::Texture makeDistances(const MapSize& size, int lastLevel = 0);
MapTextures makeMapTextures(const MapSize& size, ColourFormat format, const gl::Texture* depth,
                            int lastDistanceLevel = 0);

// Framebuffers around the host's textures; colour and distance stay empty.
MapTextures borrowMapTextures(const MapSize& size, unsigned int colour, unsigned int distance);

} // namespace mirrorball::capture
