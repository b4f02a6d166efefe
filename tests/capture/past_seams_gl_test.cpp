// What only texels past a seam would show is not drawn, and no look-up can tell: all texels that a component owns, and
// those that linear filtering at a seam reads, are the same bit for bit.
#include "support/check.h"
#include "support/gl_image.h"

#include "gl_scene.h"

#include <mirrorball/headless/context.h>

#include <cstdio>
#include <cstring>

using namespace mirrorball;

namespace {

struct Captured
{
    std::vector<std::vector<float>> colour, distance; // one a layer, four floats a texel
    CaptureReport report;
};

Captured captured(const examples::Scene& scene, ReflectionProbe::Desc desc, bool pastSeams)
{
    desc.pastSeams = pastSeams;
    ReflectionProbe probe(desc);
    const examples::GlScene drawable(scene, desc.captureOrigin);
    CaptureProgram program = examples::phongCaptureProgram();
    Captured result;
    result.report =
        probe.capture(drawable.captureMeshes(program), [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
            drawable.drawMesh(mesh.id, draw.program, {});
        });
    const MapInfo& info = mapInfo(desc.map);
    for (int layer = 0; layer < info.components; ++layer)
        for (const auto& [to, texture] : {std::pair(&result.colour, probe.map().colourTexture),
                                          std::pair(&result.distance, probe.map().distanceTexture)})
            to->push_back(
                tests::readTextureLayer(texture, layer, info.widthInN * desc.n, info.heightInN * desc.n));
    return result;
}

// Whether linear filtering reads a texel for any direction of its own component: where that owns a place less than a
// texel away. Places of a fine grid stand for all.
bool isRead(MapKind map, int layer, int column, int row, int width, int height)
{
    constexpr int steps = 8;
    for (int y = -steps; y <= steps; ++y)
        for (int x = -steps; x <= steps; ++x) {
            const glm::dvec2 uv((column + 0.5 + x * 0.999 / steps) / width,
                                (row + 0.5 + y * 0.999 / steps) / height);
            if (uv.x >= 0.0 && uv.x <= 1.0 && uv.y >= 0.0 && uv.y <= 1.0 &&
                componentOf(map, directionFromSquare(map, layer, uv)) == layer)
                return true;
        }
    return false;
}

void check(const examples::Scene& scene, MapKind map, CaptureMethod method)
{
    const ReflectionProbe::Desc desc{.map = map, .n = 48, .near = 0.1f, .mipLevels = false, .method = method};
    const Captured all = captured(scene, desc, true), needed = captured(scene, desc, false);
    const MapInfo& info = mapInfo(map);
    const int width = info.widthInN * desc.n, height = info.heightInN * desc.n;
    std::size_t differing = 0;
    for (int layer = 0; layer < info.components; ++layer)
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const std::size_t at = 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                            static_cast<std::size_t>(column));
                const auto of = static_cast<std::size_t>(layer);
                const bool isSame =
                    std::memcmp(&all.colour[of][at], &needed.colour[of][at], 4 * sizeof(float)) == 0 &&
                    std::memcmp(&all.distance[of][at], &needed.distance[of][at], sizeof(float)) == 0;
                differing += isSame ? 0 : 1;
                if (!isSame)
                    CHECK(!isRead(map, layer, column, row, width, height));
            }
    std::printf("%s: %d draws instead of %d, %zu texels past seams differ\n", std::string(info.name).c_str(),
                needed.report.draws, all.report.draws, differing);
    CHECK(needed.report.draws < all.report.draws && needed.report.triangles < all.report.triangles);
    CHECK(needed.report.draws + needed.report.drawsCulled == all.report.draws + all.report.drawsCulled);
    CHECK(differing > 0);
}

} // namespace

int main()
{
    const headless::Context context;
    const examples::Scene scene = examples::loadScene("builtin:crowd:12000");
    for (const MapKind map : {MapKind::tennisBall, MapKind::tennisBallEven, MapKind::dualParaboloid})
        for (const CaptureMethod method : {CaptureMethod::automatic, CaptureMethod::exact})
            check(scene, map, method);
}
