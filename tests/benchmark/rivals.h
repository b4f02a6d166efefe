// The six-pass cube map as people write it by hand, in raw OpenGL: what the library is measured against. The
// same shading, formats (RGBA16F, R32F, reversed 32-bit depth) and draw calls as the library's captures.
#pragma once

#include "contender.h"

#include <span>
#include <string_view>

namespace tests::benchmark {

enum class Rival {
    plain,           // every mesh to all six faces
    culled,          // the same, but for meshes whose bounding sphere lies outside a face's frustum
    layeredGeometry, // one draw a mesh, to the faces it touches; a geometry shader copies and culls triangles
    layeredInstanced, // one draw a mesh, an instance for each face it touches; the vertex shader sets
                      // gl_Layer
};

// What is drawn into: the library's formats, or 8-bit colour and 24-bit depth without a distance, as
// SceneChoice::culledOverPlain was measured with.
enum class RivalFormats { asTheLibrary, eightBit };

struct RivalInfo
{
    Rival rival;
    std::string_view name;
};
std::span<const RivalInfo> rivals();

// Whether the current context can do it: gl_Layer from a vertex shader is an extension.
bool isSupported(Rival rival);

class CubeMapContender : public Contender
{
public:
    virtual unsigned int colourTexture() const = 0;
    virtual unsigned int distanceTexture() const = 0; // infinite where nothing was drawn
};

std::unique_ptr<CubeMapContender> makeRival(Rival rival, const Stage& stage, int n, bool cullBackFaces,
                                            examples::View view,
                                            RivalFormats formats = RivalFormats::asTheLibrary);

} // namespace tests::benchmark
