// Six walls around the probe, in patches of triangles small enough for mapped vertices, and every way that the
// library draws them: for tests of what becomes of the host's shaders. Every varying is made a linear function
// of position, so that what a texel must show follows from its distance and direction alone.
#pragma once

#include <mirrorball/capture/reflection_probe.h>

#include <string>
#include <vector>

namespace tests {

constexpr int patchesPerWall = 9;
constexpr int trianglesPerPatch = 32;

// Walls of a cube of half side 2: positions at attribute 0; the number of each vertex, as a float, at 1.
class WallPatches
{
public:
    WallPatches();
    static std::vector<mirrorball::CaptureMesh> meshes(mirrorball::CaptureProgram& program);
    void draw(std::uint64_t patch, unsigned int primitive) const;

private:
    unsigned int vertexArray_ = 0;
};

struct CapturePath
{
    mirrorball::MapKind map;
    mirrorball::CaptureMethod method;
    mirrorball::LayerOrder layers;
};

// Every way that a program is put together. Softpipe's own interpolation is off by far more than these tests
// allow on slivers, such as clipping leaves; there only what the library interpolates is judged.
std::vector<CapturePath> capturePaths();

// One of each kind: varyings carried at three vertices, copied, and straight on.
std::vector<CapturePath> fewCapturePaths();

mirrorball::ReflectionProbe::Desc descOf(const CapturePath& path, int size = 16);

struct Texel
{
    glm::vec4 colour;
    glm::dvec3 direction;
    float distance;
};

std::vector<Texel> captured(mirrorball::ReflectionProbe& probe, mirrorball::CaptureProgram& program,
                            const WallPatches& walls);

// Hands positionInWorld over and nothing else.
extern const std::string plainVertex;

// Comments, conditions, extensions, macros and CRLF around declarations; names that the library's own text
// also uses; qualifiers; outputs that nobody reads; built-ins that capture takes over. They show the position.
extern const std::string awkwardVertex, awkwardFragment;

std::string withCarriageReturns(const std::string& text);

} // namespace tests
