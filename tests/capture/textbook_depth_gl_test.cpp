// The textbook depth terms come out as they are written: tennis-ball |R|/100 + b² - 0.75, dual-paraboloid -+ z|R|/100 -
// 0.9 (minus for component 0), read back from the framebuffer while the callback has it bound.
#include "support/check.h"
#include "support/six_walls.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <cstdio>
#include <vector>

using namespace mirrorball;

namespace {

constexpr int n = 64;

// What the textbook writes to z for a point in direction d (unit) at a distance, before the viewport transform.
double textbook(MapKind map, int component, const glm::dvec3& d, const glm::dvec2& uv, double distance)
{
    const double b = 2.0 * uv.y - 1.0;
    if (map == MapKind::tennisBall)
        return distance / 100.0 + b * b - 0.75;
    return (component == 0 ? -d.z : d.z) * distance / 100.0 - 0.9;
}

void check(MapKind map)
{
    const tests::SixWalls walls{glm::vec3(0.0f)};
    ReflectionProbe probe({.map = map,
                           .n = n,
                           .near = 0.1f,
                           .far = 50.0f,
                           .method = CaptureMethod::perVertex,
                           .depthTerm = DepthTerm::textbook});
    const MapInfo& info = mapInfo(map);
    const int width = info.widthInN * n, height = info.heightInN * n;
    int compared = 0;
    const CaptureMesh mesh = walls.mesh();
    probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw& draw) {
        walls.draw();
        std::vector<float> depth(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        GLint framebuffer = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::dvec2 uv((x + 0.5) / width, (y + 0.5) / height);
                const glm::dvec3 d = directionFromSquare(map, draw.view, uv);
                const glm::dvec3 a = glm::abs(d);
                const double expected = textbook(map, draw.view, d, uv, 2.0 / std::max({a.x, a.y, a.z}));
                const float found = depth[static_cast<std::size_t>(y * width + x)];
                if (componentOf(map, d) != draw.view ||
                    found == 1.0f) // another component's, or nothing drawn there
                    continue;
                ++compared;
                // Walls are cut into squares of 2/64: z bends by less than 2e-4 within one.
                CHECK_NEAR(2.0 * static_cast<double>(found) - 1.0, expected, 1e-3);
            }
    });
    std::printf("%s: %d texels compared\n", std::string(info.name).c_str(), compared);
    CHECK(compared > width * height / 2);
}

} // namespace

int main()
{
    const headless::Context context;
    check(MapKind::tennisBall);
    check(MapKind::dualParaboloid);
    return 0;
}
