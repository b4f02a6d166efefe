// Layers are cleared between the host's draws. Whatever its callback leaves masked, clipped or discarded after one view
// keeps nothing of the next view's layer from being cleared, and the callback finds it again.
#include "support/check.h"
#include "support/gl_image.h"
#include "support/six_walls.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <functional>

using namespace mirrorball;

namespace {

constexpr int n = 16;

// A state that would spoil a clear: how the host sets it, how it takes it back, and whether it is set.
struct Obstacle
{
    const char* name;
    std::function<void()> set, unset;
    std::function<bool()> isSet;
};

std::vector<Obstacle> obstacles()
{
    const auto toggle = [](const char* name, GLenum capability) {
        return Obstacle{name, [=] { glEnable(capability); }, [=] { glDisable(capability); },
                        [=] { return glIsEnabled(capability) == GL_TRUE; }};
    };
    const auto colourMask = [] {
        GLboolean mask[4];
        glGetBooleani_v(GL_COLOR_WRITEMASK, 1, mask);
        return mask[0] == GL_FALSE && mask[3] == GL_FALSE;
    };
    const auto depthMask = [] {
        GLboolean mask = GL_TRUE;
        glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
        return mask == GL_FALSE;
    };
    return {toggle("scissor test", GL_SCISSOR_TEST),
            toggle("rasterizer discard", GL_RASTERIZER_DISCARD),
            {"colour mask", [] { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); },
             [] { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }, colourMask},
            {"depth mask", [] { glDepthMask(GL_FALSE); }, [] { glDepthMask(GL_TRUE); }, depthMask}};
}

// The second capture into a texture draws nothing in its second half of views, where the first has left walls: they
// must be gone.
void check(const Obstacle& obstacle, MapKind map, int layersOfDepth)
{
    const tests::SixWalls walls(glm::vec3(0.0f), 4);
    ReflectionProbe probe({.map = map, .n = n, .near = 0.1f, .layersOfDepth = layersOfDepth});
    const CaptureMesh mesh = walls.mesh();
    for (int time = 0; time < 2; ++time) // both of the textures that take turns
        probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw&) { walls.draw(); });
    glScissor(0, 0, 1, 1);
    int calls = 0;
    probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw& draw) {
        CHECK(calls == 0 || obstacle.isSet());
        obstacle.unset();
        if (draw.view == 0)
            walls.draw();
        obstacle.set();
        ++calls;
    });
    CHECK(calls > 1 && !obstacle.isSet()); // the guard of the whole capture has put it back
    const std::vector<float> found = tests::readMap(probe.map().distanceTexture, map, n);
    const std::size_t perLayer = found.size() / static_cast<std::size_t>(mapInfo(map).components);
    for (std::size_t texel = 0; texel < found.size(); texel += 4)
        CHECK(std::isinf(found[texel]) == (texel >= perLayer));
}

} // namespace

int main()
{
    const headless::Context context;
    for (const Obstacle& obstacle : obstacles())
        for (const MapKind map : {MapKind::tennisBall, MapKind::cube})
            for (const int layersOfDepth : {1, 2})
                check(obstacle, map, layersOfDepth);
}
