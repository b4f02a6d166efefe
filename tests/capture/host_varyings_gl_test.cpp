// The host's shaders stay the host's: varyings of every kind, qualifiers, blocks, arrays, conditions, macros
// and names arrive as written on every path of a capture.
#include "support/check.h"
#include "support/wall_patches.h"

#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

using namespace mirrorball;
using namespace tests;

namespace {

// The shaders write positionInWorld + 0, …: whatever way it went, the colour is the position that is shown,
// in w 1. Within tolerance of the position by direction for exact capture; by distance and place on a wall
// for mapped vertices.
void checkShowsPosition(const CapturePath& path, const std::string& vertex, const std::string& fragment,
                        const WallPatches& walls, const std::string& name,
                        const std::string& position = "positionInWorld")
{
    ReflectionProbe probe(descOf(path));
    CaptureProgram program(
        {.name = name, .vertexSource = vertex, .fragmentSource = fragment, .position = position});
    const bool isStraight =
        path.method == CaptureMethod::exact || path.map == MapKind::cube || path.map == MapKind::octahedral;
    for (const Texel& texel : captured(probe, program, walls)) {
        if (std::isinf(texel.distance) && path.method == CaptureMethod::perVertex)
            continue; // the textbook way leaves out what lies far beyond the hemisphere
        CHECK(std::isfinite(texel.distance));
        const glm::dvec3 shown(texel.colour);
        const double biggest = std::max({std::abs(shown.x), std::abs(shown.y), std::abs(shown.z)});
        if (!(std::abs(biggest - 2.0) < 1e-4 && std::abs(texel.colour.w - 1.0f) < 1e-5f))
            std::printf("%s on %s, method %d, layers %d: %g %g %g %g\n", name.c_str(),
                        std::string(mapInfo(path.map).name).c_str(), static_cast<int>(path.method),
                        static_cast<int>(path.layers), shown.x, shown.y, shown.z,
                        static_cast<double>(texel.colour.w));
        CHECK_NEAR(biggest, 2.0, 1e-4); // on a wall
        CHECK_NEAR(texel.colour.w, 1.0, 1e-5);
        // Rasterised by hardware the texel's place is off by its snapping, 1/16 texel at the coarsest.
        const double tolerance = isStraight ? 0.02 : 0.5;
        CHECK(glm::length(glm::normalize(shown) - texel.direction) < tolerance);
        CHECK_NEAR(glm::length(shown), texel.distance, 1e-4);
    }
}

void checkEverywhere(const std::vector<CapturePath>& paths, const std::string& vertex,
                     const std::string& fragment, const WallPatches& walls, const std::string& name,
                     const std::string& position = "positionInWorld")
{
    for (const CapturePath& path : paths)
        checkShowsPosition(path, vertex, fragment, walls, name, position);
}

// Each type carries parts of the position or a known number; the sum is the position.
const std::string typesVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in float number;
out vec3 positionInWorld;
out float x, y; out vec2 xy; out vec4 xyz1;
out mat2 m2; out mat3 m3; out mat4x3 m43; out mat2x3 m23;
flat out int i; flat out uint u; flat out ivec2 i2; flat out ivec3 i3; flat out ivec4 i4;
flat out uvec2 u2; flat out uvec3 u3; flat out uvec4 u4;
flat out vec3 seven;
void main()
{
    positionInWorld = position;
    x = position.x; y = position.y; xy = position.xy; xyz1 = vec4(position, 1.0);
    m2 = mat2(position.x, position.y, position.z, 1.0);
    m3 = mat3(position, 2.0 * position, 3.0 * position);
    m43 = mat4x3(position, position.yzx, position.zxy, vec3(1.0));
    m23 = mat2x3(position, -position);
    i = -3; u = 5u; i2 = ivec2(1, -2); i3 = ivec3(1, 2, -3); i4 = ivec4(1, 2, 3, -4);
    u2 = uvec2(1u, 2u); u3 = uvec3(1u, 2u, 4000000000u); u4 = uvec4(1u, 2u, 3u, 4u);
    seven = vec3(7.0, 8.0, 9.0);
    gl_Position = vec4(0.0);
}
)";
// Two halves, since all of them at once are more than the exact path has room for.
const std::string floatsFragment = R"(#version 330 core
in vec3 positionInWorld;
in float x, y; in vec2 xy; in vec4 xyz1;
in mat2 m2;
out vec4 colour;
void main()
{
    bool right = abs(x - positionInWorld.x) + abs(y - positionInWorld.y) < 1e-5 && distance(xy, positionInWorld.xy) < 1e-5 &&
                 distance(m2[0], positionInWorld.xy) < 1e-5 && abs(m2[1].x - positionInWorld.z) < 1e-5;
    colour = right ? xyz1 : vec4(-5.0);
}
)";
const std::string matricesFragment = R"(#version 330 core
in mat3 m3;
in mat4x3 m43;
out vec4 colour;
void main()
{
    bool right = distance(m3[1], 2.0 * m3[0]) + distance(m3[2], 3.0 * m3[0]) < 1e-4 &&
                 distance(m43[0], m3[0]) + distance(m43[1], m3[0].yzx) + distance(m43[2], m3[0].zxy) < 1e-4;
    colour = right ? vec4(m3[0], m43[3].z) : vec4(-5.0);
}
)";
const std::string integersFragment = R"(#version 330 core
in vec3 positionInWorld;
in mat2x3 m23;
flat in int i; flat in uint u; flat in ivec2 i2; flat in ivec3 i3; flat in ivec4 i4;
flat in uvec2 u2; flat in uvec3 u3; flat in uvec4 u4;
flat in vec3 seven;
out vec4 colour;
void main()
{
    bool right = i == -3 && u == 5u && i2 == ivec2(1, -2) && i3 == ivec3(1, 2, -3) && i4 == ivec4(1, 2, 3, -4) &&
                 u2 == uvec2(1u, 2u) && u3 == uvec3(1u, 2u, 4000000000u) && u4 == uvec4(1u, 2u, 3u, 4u) &&
                 seven == vec3(7.0, 8.0, 9.0) && distance(m23[0], -m23[1]) + distance(m23[0], positionInWorld) < 1e-4;
    colour = right ? vec4(positionInWorld, 1.0) : vec4(-5.0);
}
)";

// Blocks with and without an instance name, arrays with numbers, constants and macros for sizes, flat ones.
const std::string blocksVertex = R"(#version 330 core
#define LAYERS 2
layout(location = 0) in vec3 position;
out Surface {
    vec3 place; // on the wall
    flat ivec2 numbers[2];
    float parts[3], weights[LAYERS];
    mat3 turned;
} handedOver;
out Loose
{
    smooth vec3 again;
};
out float alone[2];
flat out uint counts[3];
void main()
{
    handedOver.place = position;
    handedOver.numbers = ivec2[2](ivec2(1, -2), ivec2(3, 4));
    handedOver.parts = float[3](position.x, position.y, position.z);
    handedOver.weights = float[LAYERS](0.25, 0.75);
    handedOver.turned = mat3(position, position.yzx, position.zxy);
    again = position;
    alone = float[2](position.x, 2.0 * position.y);
    counts = uint[3](7u, 8u, 9u);
    gl_Position = vec4(0.0);
}
)";
const std::string blocksFragment = R"(#version 330 core
#define LAYERS 2
const int several = 3;
in Surface {
    vec3 place;
    flat ivec2 numbers[2];
    float parts[several], weights[LAYERS];
    mat3 turned;
} surface;
in Loose
{
    smooth vec3 again;
};
in float alone[LAYERS];
flat in uint counts[several];
out vec4 colour;
void main()
{
    int wrong = 0;
    if (distance(vec3(surface.parts[0], surface.parts[1], surface.parts[2]), surface.place) > 1e-4)
        wrong += 1;
    if (surface.numbers[0] != ivec2(1, -2) || surface.numbers[1] != ivec2(3, 4))
        wrong += 2;
    if (abs(surface.weights[0] - 0.25) + abs(surface.weights[1] - 0.75) > 1e-5)
        wrong += 4;
    if (distance(surface.turned[2], surface.place.zxy) > 1e-4)
        wrong += 8;
    if (distance(again, surface.place) > 1e-4)
        wrong += 16;
    if (distance(vec2(alone[0], 0.5 * alone[1]), surface.place.xy) > 1e-4)
        wrong += 32;
    if (counts[0] != 7u || counts[1] != 8u || counts[2] != 9u)
        wrong += 64;
    colour = wrong == 0 ? vec4(surface.place, 1.0) : vec4(-5.0 - float(wrong)); // which is beyond the walls
}
)";

// A flat varying has the value of the triangle's last vertex.
void checkProvokingVertex(const std::vector<CapturePath>& paths, const WallPatches& walls)
{
    const std::string vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in float number;
out vec3 positionInWorld;
flat out int vertexNumber;
void main() { positionInWorld = position; vertexNumber = int(number); gl_Position = vec4(0.0); }
)";
    const std::string fragment = R"(#version 330 core
in vec3 positionInWorld;
flat in int vertexNumber;
out vec4 colour;
void main() { colour = vec4(float(vertexNumber), float(gl_PrimitiveID), gl_FrontFacing ? 1.0 : 0.0, 1.0); }
)";
    for (const CapturePath& path : paths) {
        ReflectionProbe probe(descOf(path));
        CaptureProgram program({.name = "flat", .vertexSource = vertex, .fragmentSource = fragment});
        for (const Texel& texel : captured(probe, program, walls)) {
            if (std::isinf(texel.distance))
                continue;
            CHECK(std::fmod(texel.colour.x, 3.0f) == 2.0f);
            const int triangle = static_cast<int>(texel.colour.x) / 3;
            CHECK(static_cast<int>(texel.colour.y) == triangle % trianglesPerPatch);
            const int wall =
                triangle / trianglesPerPatch / patchesPerWall; // those of even number face the probe
            CHECK(texel.colour.z == (wall % 2 == 0 ? 1.0f : 0.0f));
        }
    }
}

} // namespace

// few: one path of each kind.
int main(int argc, char**)
{
    const headless::Context context;
    const WallPatches walls;
    const std::vector<CapturePath> paths = argc > 1 ? fewCapturePaths() : capturePaths();
    checkEverywhere(paths, typesVertex, floatsFragment, walls, "floats");
    checkEverywhere(paths, typesVertex, matricesFragment, walls, "matrices");
    checkEverywhere(paths, typesVertex, integersFragment, walls, "integers");
    checkEverywhere(paths, blocksVertex, blocksFragment, walls, "blocks and arrays", "handedOver.place");
    checkEverywhere(paths, awkwardVertex, awkwardFragment, walls, "awkward");
    for (const CapturePath& path : fewCapturePaths())
        checkShowsPosition(path, withCarriageReturns(awkwardVertex), withCarriageReturns(awkwardFragment),
                           walls, "CRLF");
    checkProvokingVertex(paths, walls);
    return 0;
}
