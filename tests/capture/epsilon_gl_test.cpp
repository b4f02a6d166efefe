// automatic stays within its epsilon: what a texel shows lies at most epsilon texels from the texel's own
// direction, and its distance is right to epsilon texel angles, relative. What is drawn exactly is judged by exact_gl;
// along needles the varyings that say the place are rounded to more than the smallest epsilon there, with exact as
// well.
#include "support/check.h"

#include "gl_scene.h"
#include "map_file.h"
#include "reference.h"

#include <mirrorball/headless/context.h>
#include <mirrorball/maps/measures.h>

#include <cstdio>
#include <cstdlib>

using namespace mirrorball;

namespace {

struct Worst
{
    double direction = 0.0; // texels
    double distance = 0.0;  // texel angles
    int drawsMapped = 0;
    int texels = 0; // that are not drawn exactly
};

struct Captured
{
    std::vector<std::vector<examples::Sample>> layers;
    int drawsMapped;
};

// Colours are the positions relative to the probe that the varyings carried there.
Captured captured(const examples::Scene& scene, const glm::dvec3& at, MapKind map, int n,
                  CaptureMethod method, float epsilon)
{
    ReflectionProbe::Desc desc;
    desc.map = map;
    desc.n = n;
    desc.worldFromProbe[3] = glm::dvec4(at, 1.0);
    desc.captureOrigin = at;
    desc.near = 0.02f;
    desc.far = 1e5f;
    desc.colour = ColourFormat::rgba32f;
    desc.method = method;
    desc.epsilon = epsilon;
    ReflectionProbe probe(desc);
    const examples::GlScene drawable(scene, at);
    CaptureProgram program = examples::phongCaptureProgram(examples::View::position);
    const CaptureReport report =
        probe.capture(drawable.captureMeshes(program), [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
            drawable.drawMesh(mesh.id, draw.program, {});
        });
    return {examples::readMap(probe.map(), examples::View::position, glm::dvec3(0.0), scene.background),
            report.drawsMapped};
}

Worst worstOf(const examples::Scene& scene, const glm::dvec3& at, MapKind map, int n, float epsilon)
{
    const Captured automatic = captured(scene, at, map, n, CaptureMethod::automatic, epsilon);
    const Captured exact = captured(scene, at, map, n, CaptureMethod::exact, epsilon);
    const MapInfo& info = mapInfo(map);
    const int width = info.widthInN * n, height = info.heightInN * n;
    Worst worst{.drawsMapped = automatic.drawsMapped};
    for (int layer = 0; layer < info.components; ++layer)
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const glm::dvec2 uv((column + 0.5) / width, (row + 0.5) / height);
                const glm::dvec3 direction = directionFromSquare(map, layer, uv);
                // Beyond the part of its layer that a component owns nobody looks.
                const Stretch texel = texelStretch(jacobian(map, layer, uv), width, height);
                // Nor outside the sphere map's disc, where texels have no extent.
                if (componentOf(map, direction) != layer || !(texel.shortest > 0.0))
                    continue;
                const auto in = static_cast<std::size_t>(layer);
                const std::size_t texelIndex =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column);
                const examples::Sample& sample = automatic.layers[in][texelIndex];
                const bool isExact = sample.colour == exact.layers[in][texelIndex].colour;
                if (std::isinf(sample.distance) || isExact)
                    continue;
                ++worst.texels;
                // In texels of the map: the difference of the coordinates that it shows and that it should.
                const glm::dvec2 shown = squareFromDirection(map, layer, glm::dvec3(sample.colour));
                const glm::dvec2 off = (shown - uv) * glm::dvec2(width, height);
                worst.direction = std::max(worst.direction, glm::length(off));
                const double relative =
                    std::abs(static_cast<double>(sample.distance) / glm::length(sample.colour) - 1.0);
                worst.distance = std::max(worst.distance, relative / texel.longest);
            }
    return worst;
}

} // namespace

int main(int argc, char** argv)
{
    const headless::Context context;
    const int n = 64;
    bool anyMapped = false;
    // [SCENE [X Y Z]]
    const std::vector<std::string> names =
        argc > 1 ? std::vector<std::string>{argv[1]}
                 : std::vector<std::string>{"builtin:room", "builtin:crowd:20000", "builtin:garden"};
    const glm::dvec3 at = argc > 4 ? glm::dvec3(std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4]))
                                   : glm::dvec3(0.01, 0.02, 0.03);
    for (const std::string& name : names) {
        const examples::Scene scene = examples::loadScene(name);
        for (const MapInfo& info : maps())
            for (const float epsilon : {1.0f / 2.0f, 1.0f / 16.0f, 1.0f / 256.0f}) {
                const Worst worst = worstOf(scene, at, info.kind, n, epsilon);
                std::printf("%-20s %-18s epsilon %.4f: direction %.5f texels, distance %.5f texel angles, %d "
                            "draws mapped, %d texels\n",
                            name.c_str(), std::string(info.name).c_str(), static_cast<double>(epsilon),
                            worst.direction, worst.distance, worst.drawsMapped, worst.texels);
                anyMapped = anyMapped || (worst.drawsMapped > 0 && worst.texels > 0);
                // The rasteriser of an ordinary draw snaps to 1/256 texel (1/16 at the coarsest allowed).
                const double snapping = std::sqrt(0.5) / 256.0;
                CHECK(worst.direction <= static_cast<double>(epsilon) + snapping);
                CHECK(worst.distance <= static_cast<double>(epsilon));
            }
    }
    CHECK(anyMapped);
    return 0;
}
