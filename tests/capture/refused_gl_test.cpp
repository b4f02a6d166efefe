// What a probe and a capture program refuse, before anything is drawn, and what a mesh's numbers that are none count
// as.
#include "support/check.h"
#include "support/gl_state.h"
#include "support/six_walls.h"
#include "support/wall_patches.h"

#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <functional>
#include <limits>
#include <optional>

using namespace mirrorball;

namespace {

ReflectionProbe::Desc descOf(MapKind map)
{
    return {.map = map, .n = 12, .near = 0.1f, .far = 50.0f};
}

void checkLimits()
{
    ReflectionProbe::Desc desc = descOf(MapKind::cube);
    desc.supersample = 0;
    CHECK_THROWS(ReflectionProbe{desc}, ErrorKind::badArgument);
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    desc.n = largest / 4 + 1;
    desc.supersample = 4;
    CHECK_THROWS(ReflectionProbe{desc}, ErrorKind::badArgument);
    CHECK_THROWS(ReflectionProbe({.map = static_cast<MapKind>(99)}), ErrorKind::badArgument);
    CHECK_THROWS(ReflectionProbe({.method = static_cast<CaptureMethod>(-1)}), ErrorKind::badArgument);
    CHECK_THROWS(ReflectionProbe({.layers = static_cast<LayerOrder>(2)}), ErrorKind::badArgument);
    CHECK_THROWS(ReflectionProbe({.depthTerm = static_cast<DepthTerm>(2)}), ErrorKind::badArgument);
    CHECK_THROWS(ReflectionProbe({.colour = static_cast<ColourFormat>(77)}), ErrorKind::badArgument);
}

struct Drawn
{
    std::vector<unsigned int> programs; // in the order of the draws: another one for each way to draw
    int culled;

    bool operator==(const Drawn&) const = default;
};

// What is no number tells nothing: the draws are those of meshes that it is not known of.
void checkNotANumber(MapKind map)
{
    const tests::WallPatches walls;
    CaptureProgram program(
        {.vertexSource = tests::plainVertex,
         .fragmentSource = "#version 330 core\nout vec4 colour;\nvoid main() { colour = vec4(1.0); }\n"});
    const auto drawn = [&](bool nearFirst, const std::function<void(CaptureMesh&)>& change) {
        std::vector<CaptureMesh> meshes = tests::WallPatches::meshes(program);
        for (CaptureMesh& mesh : meshes)
            change(mesh);
        ReflectionProbe::Desc desc = descOf(map);
        desc.nearFirst = nearFirst;
        ReflectionProbe probe(desc);
        Drawn result{};
        result.culled = probe
                            .capture(meshes,
                                     [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
                                         result.programs.push_back(draw.program);
                                         walls.draw(mesh.id, draw.primitive);
                                     })
                            .drawsCulled;
        return result;
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const bool isLinear = map == MapKind::cube || map == MapKind::octahedral;
    for (const bool nearFirst : {false, true}) {
        const Drawn known = drawn(nearFirst, [](CaptureMesh&) {});
        const Drawn withoutBounds = drawn(nearFirst, [](CaptureMesh& mesh) { mesh.bounds.reset(); });
        if (map != MapKind::sphereMap) // one component, and small triangles are not mapped well enough
            CHECK(known != withoutBounds);
        CHECK(drawn(nearFirst, [](CaptureMesh& mesh) { mesh.bounds->radius = nan; }) == withoutBounds);
        CHECK(drawn(nearFirst, [](CaptureMesh& mesh) { mesh.bounds->centre.y = nan; }) == withoutBounds);

        const Drawn anyEdge = drawn(nearFirst, [](CaptureMesh& mesh) { mesh.longestEdge = infinite; });
        if (map == MapKind::tennisBall ||
            map == MapKind::dualParaboloid) // others are drawn exactly either way
            CHECK(known != anyEdge);
        CHECK(drawn(nearFirst, [](CaptureMesh& mesh) { mesh.longestEdge = nan; }) == anyEdge);

        // Of bounds that hold the probe.
        const auto around = [&](std::optional<float> nearest) {
            return drawn(nearFirst, [=](CaptureMesh& mesh) {
                mesh.bounds = Sphere{glm::vec3(0.0f), 4.0f};
                mesh.nearestDistance = nearest;
            });
        };
        CHECK((around(1.9f) != around(std::nullopt)) == isLinear);
        for (const float nothing : {nan, 0.0f, -1.0f})
            CHECK(around(nothing) == around(std::nullopt));
    }
}

// What a capture refuses, before it draws anything.
void checkRefused(const tests::SixWalls& walls)
{
    ReflectionProbe probe(descOf(MapKind::tennisBall));
    CaptureMesh mesh = walls.mesh();
    CHECK_THROWS(probe.capture({&mesh, 1}, ReflectionProbe::DrawMesh{}), ErrorKind::badArgument);
    CHECK_THROWS(probe.capture(ReflectionProbe::DrawScene{}), ErrorKind::badArgument);
    const auto draw = [](const CaptureMesh&, const CaptureDraw&) { CHECK(!"drawn"); };
    CaptureMesh negative[] = {mesh, mesh, mesh};
    negative[0].bounds = Sphere{glm::vec3(0.0f), -1.0f};
    negative[1].longestEdge = -1.0f;
    negative[2].widestAngle = -1.0f;
    for (const CaptureMesh& one : negative)
        CHECK_THROWS(probe.capture({&one, 1}, draw), ErrorKind::badArgument);
    // Known before anything is compiled.
    const auto refused = [](const std::string& fragmentSource, const std::string& position) {
        CHECK_THROWS(CaptureProgram({.vertexSource = tests::plainVertex,
                                     .fragmentSource = "#version 330 core\n" + fragmentSource,
                                     .position = position}),
                     ErrorKind::badShader);
    };
    refused("out ivec4 c;\nvoid main() { c = ivec4(1); }\n", "positionInWorld");
    refused("out uint c;\nvoid main() { c = 1u; }\n", "positionInWorld");
    const std::string white = "out vec4 c;\nvoid main() { c = vec4(1.0); }\n";
    for (const char* const position : {"", "nothing", "gl_Position"})
        refused(white, position);
    const std::string vertex = "#version 330 core\nout vec4 place;\nvoid main() { place = vec4(1.0); }\n";
    CHECK_THROWS(
        CaptureProgram(
            {.vertexSource = vertex, .fragmentSource = "#version 330 core\n" + white, .position = "place"}),
        ErrorKind::badShader);
    // An output of integers that is not the colour, or not compiled.
    CaptureProgram({.vertexSource = tests::plainVertex,
                    .fragmentSource = "#version 330 core\nlayout(location = 1) out uint id;\n"
                                      "#if 0\nlayout(location = 0) out ivec4 c;\n#else\n"
                                      "layout(location = 0) out vec4 c;\n#endif\n"
                                      "void main() { c = vec4(1.0); id = 1u; }\n"});
    // Out of sight, and yet compiled.
    CaptureProgram broken(
        {.vertexSource = tests::plainVertex,
         .fragmentSource = "#version 330 core\nout vec4 c;\nvoid main() { c = nothing; }\n"});
    mesh.bounds = Sphere{glm::vec3(1000.0f, 0.0f, 0.0f), 1.0f};
    mesh.program = &broken;
    CHECK_THROWS(probe.capture({&mesh, 1}, draw), ErrorKind::badShader);
    mesh.program = nullptr;
    CHECK_THROWS(probe.capture({&mesh, 1}, draw), ErrorKind::badArgument);
}

} // namespace

int main()
{
    const headless::Context context;
    checkLimits();
    checkRefused(tests::SixWalls(glm::vec3(0.0f), 8));
    for (const MapInfo& info : maps())
        checkNotANumber(info.kind);
    CHECK(tests::takeErrors().empty());
}
