#include "support/wall_patches.h"

#include "support/check.h"
#include "support/driver.h"
#include "support/gl_image.h"

#include <epoxy/gl.h>

using namespace mirrorball;

namespace tests {

namespace {

constexpr int cuts = 12; // squares along a wall's side, drawn in patches of 4 × 4

// Counter-clockwise as seen from the middle on the walls of positive sides, clockwise on the others.
void addSquare(std::vector<float>& vertices, int wall, int i, int j)
{
    const int axis = wall / 2;
    // From the number alone, so that neighbours have the same bits.
    const auto place = [](int number) { return 4.0f * static_cast<float>(number) / cuts - 2.0f; };
    for (const int corner : {0, 3, 1, 0, 2, 3}) {
        glm::vec3 p;
        p[axis] = wall % 2 == 0 ? 2.0f : -2.0f;
        p[(axis + 1) % 3] = place(i + ((corner & 1) != 0 ? 1 : 0));
        p[(axis + 2) % 3] = place(j + ((corner & 2) != 0 ? 1 : 0));
        vertices.insert(vertices.end(), {p.x, p.y, p.z, static_cast<float>(vertices.size() / 4)});
    }
}

} // namespace

WallPatches::WallPatches()
{
    std::vector<float> vertices;
    for (int wall = 0; wall < 6; ++wall)
        for (int patch = 0; patch < patchesPerWall; ++patch)
            for (int square = 0; square < 16; ++square)
                addSquare(vertices, wall, 4 * (patch % 3) + square % 4, 4 * (patch / 3) + square / 4);
    glGenVertexArrays(1, &vertexArray_);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)), vertices.data(),
                 GL_STATIC_DRAW);
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, attribute == 0 ? 3 : 1, GL_FLOAT, GL_FALSE, 4 * sizeof(float),
                              reinterpret_cast<const void*>(attribute * 3 * sizeof(float)));
    }
}

std::vector<CaptureMesh> WallPatches::meshes(CaptureProgram& program)
{
    std::vector<CaptureMesh> all;
    for (int wall = 0; wall < 6; ++wall)
        for (int patch = 0; patch < patchesPerWall; ++patch) {
            glm::vec3 centre;
            centre[wall / 2] = wall % 2 == 0 ? 2.0f : -2.0f;
            centre[(wall / 2 + 1) % 3] = 4.0f / 3.0f * static_cast<float>(patch % 3 - 1);
            centre[(wall / 2 + 2) % 3] = 4.0f / 3.0f * static_cast<float>(patch / 3 - 1);
            all.push_back({.program = &program,
                           .id = static_cast<std::uint64_t>(wall * patchesPerWall + patch),
                           .bounds = Sphere{centre, 0.95f},
                           .longestEdge = 0.48f});
        }
    return all;
}

void WallPatches::draw(std::uint64_t patch, unsigned int primitive) const
{
    glBindVertexArray(vertexArray_);
    glDrawArrays(primitive, static_cast<GLint>(patch) * 3 * trianglesPerPatch, 3 * trianglesPerPatch);
}

static std::vector<CapturePath> judged(std::vector<CapturePath> paths)
{
    if (isSoftpipe())
        std::erase_if(paths, [](const CapturePath& path) { return path.method != CaptureMethod::exact; });
    return paths;
}

std::vector<CapturePath> capturePaths()
{
    std::vector<CapturePath> all;
    for (const LayerOrder layers : {LayerOrder::oneAtATime, LayerOrder::allAtOnce}) {
        all.push_back({MapKind::tennisBall, CaptureMethod::exact, layers});
        all.push_back({MapKind::tennisBall, CaptureMethod::automatic, layers});
        all.push_back({MapKind::dualParaboloid, CaptureMethod::exact, layers});
        all.push_back({MapKind::dualParaboloid, CaptureMethod::perVertex, layers});
        all.push_back({MapKind::cube, CaptureMethod::exact, layers});
        all.push_back({MapKind::cube, CaptureMethod::automatic, layers});
        all.push_back({MapKind::octahedral, CaptureMethod::automatic, layers});
        all.push_back({MapKind::equirectangular, CaptureMethod::exact, layers});
    }
    if (epoxy_gl_version() >= 40)
        all.push_back({MapKind::tennisBall, CaptureMethod::tessellated, LayerOrder::oneAtATime});
    return judged(std::move(all));
}

std::vector<CapturePath> fewCapturePaths()
{
    return judged({{MapKind::tennisBall, CaptureMethod::exact, LayerOrder::oneAtATime},
                   {MapKind::octahedral, CaptureMethod::automatic, LayerOrder::allAtOnce},
                   {MapKind::cube, CaptureMethod::automatic, LayerOrder::oneAtATime}});
}

ReflectionProbe::Desc descOf(const CapturePath& path, int size)
{
    return {.map = path.map,
            .n = size,
            .near = 0.1f,
            .far = 50.0f,
            .colour = ColourFormat::rgba32f,
            .background = glm::vec4(-1.0f),
            .method = path.method,
            .epsilon = 4.0f, // so that automatic maps vertices
            .layers = path.layers};
}

std::vector<Texel> captured(ReflectionProbe& probe, CaptureProgram& program, const WallPatches& walls)
{
    const std::vector<CaptureMesh> meshes = WallPatches::meshes(program);
    const CaptureReport report = probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw& draw) {
        walls.draw(mesh.id, draw.primitive);
    });
    const bool mayMap = probe.desc().method == CaptureMethod::automatic &&
                        probe.desc().layers == LayerOrder::oneAtATime && probe.desc().map != MapKind::cube &&
                        probe.desc().map != MapKind::octahedral;
    CHECK((report.drawsMapped > 0) == mayMap);
    std::vector<Texel> texels;
    const MapInfo& info = mapInfo(probe.desc().map);
    const int size = probe.desc().n, width = info.widthInN * size, height = info.heightInN * size;
    for (int layer = 0; layer < info.components; ++layer) {
        const auto colour = readTextureLayer(probe.map().colourTexture, layer, width, height);
        const auto distance = readTextureLayer(probe.map().distanceTexture, layer, width, height);
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const std::size_t at = 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                            static_cast<std::size_t>(column));
                const glm::dvec2 uv((column + 0.5) / width, (row + 0.5) / height);
                texels.push_back({{colour[at], colour[at + 1], colour[at + 2], colour[at + 3]},
                                  directionFromSquare(info.kind, layer, uv),
                                  distance[at]});
            }
    }
    return texels;
}

const std::string plainVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
out vec3 positionInWorld;
void main() { positionInWorld = position; gl_Position = vec4(position, 1.0); }
)";

const std::string awkwardVertex = R"(// the host's own words first
#version 330 core /* and after */
#extension GL_ARB_separate_shader_objects : enable
#extension GL_ARB_shading_language_420pack : enable
#define SMOOTH_NORMALS 1
#define radius 3.0
#define view(a) broken
layout(location = 0) in vec3 position; // in vec3 notThisOne;
/* in vec3 norThis; */
out vec3 positionInWorld;
#if SMOOTH_NORMALS
smooth out vec3 direction;
#else
flat out vec3 direction;
#endif
#ifdef NEVER
out vec3 neverThere;
#endif
layout(location = 3) out vec3 byLocation;
centroid out vec3 weight;
noperspective out float constantOne, constantTwo;
out float distance; // hides the built-in function
out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[2]; };
struct Corner { vec3 inside; };
Corner hit(const in vec3 p) { Corner c; c.inside = p; return c; }
void main()
{
    positionInWorld = hit(position).inside;
    direction = position;
    byLocation = position;
    weight = position;
    constantOne = 1.0; constantTwo = radius - 1.0;
    distance = sqrt(dot(position, position)) * 0.0 + 4.0;
    gl_ClipDistance[0] = -1.0; gl_ClipDistance[1] = -1.0;
    gl_Position = vec4(0.0);
}
)";
const std::string awkwardFragment = R"(#version 330 core
#extension GL_ARB_separate_shader_objects : enable
#extension GL_ARB_conservative_depth : enable
#define SMOOTH_NORMALS 1
#define MANY \
    1
#define radius 7.0
#define corner 1 +
#if SMOOTH_NORMALS
smooth in vec3 direction;
#else
flat in vec3 direction;
#endif
#ifdef NEVER
in vec3 neverThere;
#endif
in vec3 positionInWorld;
layout(location = 3)
in vec3 otherName;
centroid in vec3 weight;
noperspective in float constantOne, constantTwo;
in float distance;
in vec3 nobodyWrites;
layout(location = 1) out vec4 bright;
layout(location = 0) out vec4 colour;
#ifdef GL_ARB_conservative_depth
layout(depth_any) out float gl_FragDepth;
#endif
void addTo(inout vec3 sum, in vec3 term) { sum += term; }
float hit = 0.25;
void main()
{
    vec3 sum = vec3(0.0);
    addTo(sum, direction);
    addTo(sum, otherName);
    addTo(sum, weight);
    addTo(sum, positionInWorld);
    bright = vec4(9.0);
    colour = vec4(sum * hit, constantOne * constantTwo * 0.5 * (distance - 3.0) * float(MANY));
    gl_FragDepth = 0.5;
    if (gl_FragCoord.x < 0.0)
        return;
}
)";

std::string withCarriageReturns(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return result;
}

} // namespace tests
