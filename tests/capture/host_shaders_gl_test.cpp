// The host's shaders stay the host's: varyings of every kind, qualifiers, conditions, macros and names arrive
// as written on every path of a capture, textures get the right mipmap level, errors keep the host's line
// numbers, and the limit of varyings is where it is said to be.
//
// The scene is six walls around the probe, cut finely enough for mapped vertices; every varying is a linear
// function of position, so that what a texel must show follows from its distance and direction alone.
#include "support/check.h"
#include "support/gl_image.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <cstring>
#include <string>

using namespace mirrorball;

namespace {

constexpr int n = 16;
constexpr int cuts = 12; // squares along a wall's side, drawn in patches of 4 × 4
constexpr int patchesPerWall = 9;
constexpr int trianglesPerPatch = 32;

// Walls of a cube of half side 2. The third coordinate of each vertex's extra attribute numbers its triangle.
class Walls
{
public:
    Walls()
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
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)),
                     vertices.data(), GL_STATIC_DRAW);
        for (GLuint attribute = 0; attribute < 2; ++attribute) {
            glEnableVertexAttribArray(attribute);
            glVertexAttribPointer(attribute, attribute == 0 ? 3 : 1, GL_FLOAT, GL_FALSE, 4 * sizeof(float),
                                  reinterpret_cast<const void*>(attribute * 3 * sizeof(float)));
        }
    }

    static std::vector<CaptureMesh> meshes(CaptureProgram& program)
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

    void draw(std::uint64_t patch) const
    {
        glBindVertexArray(vertexArray_);
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(patch) * 3 * trianglesPerPatch, 3 * trianglesPerPatch);
    }

private:
    // Counter-clockwise as seen from the middle on the walls of positive sides, clockwise on the others.
    static void addSquare(std::vector<float>& vertices, int wall, int i, int j)
    {
        const int axis = wall / 2;
        const float at[2] = {4.0f * static_cast<float>(i) / cuts - 2.0f,
                             4.0f * static_cast<float>(j) / cuts - 2.0f};
        const float step = 4.0f / cuts;
        for (const int corner : {0, 3, 1, 0, 2, 3}) {
            glm::vec3 p;
            p[axis] = wall % 2 == 0 ? 2.0f : -2.0f;
            p[(axis + 1) % 3] = at[0] + ((corner & 1) != 0 ? step : 0.0f);
            p[(axis + 2) % 3] = at[1] + ((corner & 2) != 0 ? step : 0.0f);
            vertices.insert(vertices.end(), {p.x, p.y, p.z, static_cast<float>(vertices.size() / 4)});
        }
    }

    GLuint vertexArray_ = 0;
};

struct Path
{
    MapKind map;
    CaptureMethod method;
    LayerOrder layers;
};

// Every way that a program is put together.
std::vector<Path> paths()
{
    std::vector<Path> all;
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
    return all;
}

// One of each kind: varyings carried at three vertices, copied, and straight on.
std::vector<Path> fewPaths()
{
    return {{MapKind::tennisBall, CaptureMethod::exact, LayerOrder::oneAtATime},
            {MapKind::octahedral, CaptureMethod::automatic, LayerOrder::allAtOnce},
            {MapKind::cube, CaptureMethod::automatic, LayerOrder::oneAtATime}};
}

ReflectionProbe::Desc descOf(const Path& path, int size = n)
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

struct Texel
{
    glm::vec4 colour;
    glm::dvec3 direction;
    float distance;
};

std::vector<Texel> captured(ReflectionProbe& probe, CaptureProgram& program, const Walls& walls)
{
    const std::vector<CaptureMesh> meshes = Walls::meshes(program);
    const CaptureReport report =
        probe.capture(meshes, [&](const CaptureMesh& mesh, const CaptureDraw&) { walls.draw(mesh.id); });
    const bool mayMap = probe.desc().method == CaptureMethod::automatic &&
                        probe.desc().layers == LayerOrder::oneAtATime && probe.desc().map != MapKind::cube &&
                        probe.desc().map != MapKind::octahedral;
    CHECK((report.drawsMapped > 0) == mayMap);
    std::vector<Texel> texels;
    const MapInfo& info = mapInfo(probe.desc().map);
    const int size = probe.desc().n, width = info.widthInN * size, height = info.heightInN * size;
    for (int layer = 0; layer < info.components; ++layer) {
        const auto colour = tests::readTextureLayer(probe.map().colourTexture, layer, width, height);
        const auto distance = tests::readTextureLayer(probe.map().distanceTexture, layer, width, height);
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

// The shaders write positionInWorld + 0, …: whatever way it went, the colour is the position that is shown,
// in w 1. Within tolerance of the position by direction for exact capture; by distance and place on a wall
// for mapped vertices.
void checkShowsPosition(const Path& path, const std::string& vertex, const std::string& fragment,
                        const Walls& walls, const std::string& name)
{
    ReflectionProbe probe(descOf(path));
    CaptureProgram program({.name = name, .vertexSource = vertex, .fragmentSource = fragment});
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

void checkEverywhere(const std::string& vertex, const std::string& fragment, const Walls& walls,
                     const std::string& name)
{
    for (const Path& path : paths())
        checkShowsPosition(path, vertex, fragment, walls, name);
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

const std::string plainVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
out vec3 positionInWorld;
void main() { positionInWorld = position; gl_Position = vec4(position, 1.0); }
)";

// Comments, conditions, extensions, macros and CRLF around declarations; names that the library's own text
// also uses; qualifiers; outputs that nobody reads; built-ins that capture takes over.
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

// A flat varying has the value of the triangle's last vertex.
void checkProvokingVertex(const Walls& walls)
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
    for (const Path& path : paths()) {
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

// A texture whose level k holds the number k: what the host's texture() finds is the level that its footprint
// asks for. Expected from the map's Jacobian: level = log2 of the longer of the two changes of the coordinate
// (times the texture's size) over one texel. llvmpipe chooses levels from differences within 2 × 2 texels,
// which is the derivative at the middle of the quad: over so short a way it changes by little.
void checkLevels(const Walls& walls, MapKind map, CaptureMethod method)
{
    constexpr int levels = 11, side = 1 << (levels - 1);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    for (int level = 0; level < levels; ++level) {
        const std::vector<float> texels(static_cast<std::size_t>(side >> level) *
                                            static_cast<std::size_t>(side >> level),
                                        static_cast<float>(level));
        glTexImage2D(GL_TEXTURE_2D, level, GL_R32F, side >> level, side >> level, 0, GL_RED, GL_FLOAT,
                     texels.data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    const std::string fragment = R"(#version 330 core
in vec3 positionInWorld;
uniform sampler2D levels;
out vec4 colour;
void main() { colour = vec4(texture(levels, positionInWorld.xy).x, 0.0, 0.0, 1.0); }
)";
    constexpr int size = 48;
    ReflectionProbe probe(descOf({map, method, LayerOrder::oneAtATime}, size));
    CaptureProgram program({.name = "levels", .vertexSource = plainVertex, .fragmentSource = fragment});
    const std::vector<Texel> texels = captured(probe, program, walls);
    glDeleteTextures(1, &texture);
    const MapInfo& info = mapInfo(map);
    const int width = info.widthInN * size, height = info.heightInN * size;
    std::size_t judged = 0;
    for (std::size_t index = 0; index < texels.size(); ++index) {
        const Texel& texel = texels[index];
        const glm::dvec3 size3 = glm::abs(texel.direction);
        // The walls z = ±2, away from their borders, where a quad lies on two walls.
        if (!(size3.z > 1.15 * size3.x && size3.z > 1.15 * size3.y))
            continue;
        const auto perLayer = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        const int layer = static_cast<int>(index / perLayer),
                  row = static_cast<int>(index % perLayer) / width,
                  column = static_cast<int>(index % perLayer) % width;
        // The differences within the quad.
        const auto shownAt = [&](double x, double y) {
            const glm::dvec3 d = directionFromSquare(map, layer, glm::dvec2(x / width, y / height));
            return glm::dvec2(d) * (2.0 / std::abs(d.z)) * static_cast<double>(side);
        };
        const double x = column / 2 * 2 + 0.5, y = row / 2 * 2 + 0.5;
        // Outside its disc, and in quads on the rim, the sphere map shows one direction over and over.
        if (map == MapKind::sphereMap &&
            std::hypot(x + 0.5 - 0.5 * width, y + 0.5 - 0.5 * height) > 0.47 * width)
            continue;
        double low = 1e9, high = -1e9;
        for (const double other : {0.0, 1.0}) {
            const double alongX = glm::length(shownAt(x + 1.0, y + other) - shownAt(x, y + other));
            const double alongY = glm::length(shownAt(x + other, y + 1.0) - shownAt(x + other, y));
            low = std::min(low, std::log2(std::max(alongX, alongY)));
            high = std::max(high, std::log2(std::max(alongX, alongY)));
        }
        // The two rows and columns of a quad differ by less than 1/8 of a level; llvmpipe's own log2 is good
        // to 1/16.
        CHECK(static_cast<double>(texel.colour.x) > low - 0.125 &&
              static_cast<double>(texel.colour.x) < high + 0.125);
        ++judged;
    }
    CHECK(judged > texels.size() / 32);
}

// Leaves of which every other stripe is cut away by discard show what is behind: here nothing.
void checkDiscard(const Walls& walls)
{
    const std::string fragment = R"(#version 330 core
in vec3 positionInWorld;
out vec4 colour;
void main()
{
    if (fract(positionInWorld.x) < 0.5)
        discard;
    colour = vec4(positionInWorld, 1.0);
}
)";
    for (const Path& path : paths()) {
        ReflectionProbe probe(descOf(path));
        CaptureProgram program({.name = "leaves", .vertexSource = plainVertex, .fragmentSource = fragment});
        for (const Texel& texel : captured(probe, program, walls)) {
            const glm::dvec3 size3 = glm::abs(texel.direction);
            const double x = texel.direction.x * 2.0 / std::max({size3.x, size3.y, size3.z});
            const double part = x - std::floor(x);
            const double margin = path.method == CaptureMethod::exact ? 1e-4 : 0.05; // bend and snapping
            if (path.method == CaptureMethod::perVertex ||
                std::min({part, std::abs(part - 0.5), 1.0 - part}) < margin)
                continue;
            CHECK(std::isinf(texel.distance) == (part < 0.5));
        }
    }
}

// Both sides of the limit of varyings: what the library accepts links, and one more is refused by name.
void checkLimit(const Walls& walls, const Path& path, const std::string& type, const std::string& qualifier)
{
    const auto sources = [&](int count) {
        std::string vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvec3 place;\n",
                    fragment = "#version 330 core\nout vec4 colour;\n", set, sum;
        for (int index = 0; index < count; ++index) {
            const std::string name = "varying" + std::to_string(index);
            vertex += qualifier + "out " + type + " " + name + ";\n";
            fragment += qualifier + "in " + type + " " + name + ";\n";
            set += name + " = " + type + "(place.x);\n";
            sum += " + vec4(" + name +
                   (type == "mat4"   ? "[0]"
                    : type == "vec4" ? ""
                    : type == "vec3" ? ", 0.0"
                                     : "") +
                   ")";
        }
        return CaptureProgram::Desc{
            .name = "limit",
            .vertexSource = vertex + "void main() { place = position;\n" + set + "}\n",
            .fragmentSource = fragment + "void main() { colour = vec4(0.0)" + sum + "; }\n",
            .position = "place"};
    };
    ReflectionProbe probe(descOf(path, 4));
    std::string message;
    int fits = 0;
    for (int fails = 200; fails - fits > 1;) {
        const int count = (fits + fails) / 2;
        try {
            CaptureProgram program(sources(count));
            captured(probe, program, walls);
            fits = count;
        } catch (const Error& error) {
            fails = count;
            CHECK(error.kind() == ErrorKind::badShader);
            message = error.what();
        }
    }
    // The first that has no room is named, by the library and not by a driver that could not link.
    const std::string named = "'" + type + " varying" + std::to_string(fits) + "'";
    if (message.find(named) == std::string::npos)
        std::printf("%s\n", message.c_str());
    CHECK(message.find(named) != std::string::npos);
    std::printf("%-18s method %d, layers %d: %3d varyings of type %s%s\n",
                std::string(mapInfo(path.map).name).c_str(), static_cast<int>(path.method),
                static_cast<int>(path.layers), fits, qualifier.c_str(), type.c_str());
    CHECK(fits >= (type == "mat4" ? 2 : 8));
}

std::string messageOf(const CaptureProgram::Desc& desc, const Walls& walls, const Path& path)
{
    try {
        CaptureProgram program(desc);
        ReflectionProbe probe(descOf(path, 4));
        captured(probe, program, walls);
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::badShader);
        return error.what();
    }
    std::printf("'%s' compiled\n", desc.name.c_str());
    CHECK(false);
    return {};
}

// A driver's log names source string 0 and the line: "0:12(5): error".
bool namesLine(const std::string& message, const std::string& text, const std::string& line)
{
    const auto at = text.find(line);
    CHECK(at != std::string::npos);
    const auto number = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const bool named = message.find("0:" + std::to_string(number) + "(") != std::string::npos ||
                       message.find("0(" + std::to_string(number) + ")") != std::string::npos;
    if (!named)
        std::printf("line %td: %s\n", number, message.c_str());
    return named;
}

void replaceOnce(std::string& text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    CHECK(at != std::string::npos);
    text.replace(at, from.size(), to);
}

void checkMessages(const Walls& walls)
{
    for (const Path& path : fewPaths()) {
        std::string broken = awkwardVertex;
        replaceOnce(broken, "byLocation = position;", "byLocation = nothing;");
        std::string message = messageOf(
            {.name = "first", .vertexSource = broken, .fragmentSource = awkwardFragment}, walls, path);
        CHECK(namesLine(message, broken, "byLocation = nothing;"));
        CHECK(message.find("the vertex shader of 'first'") != std::string::npos);
        for (const bool isWindows : {false, true}) {
            broken = awkwardFragment;
            replaceOnce(broken, "bright = vec4(9.0);", "bright = nothing;");
            if (isWindows)
                broken = withCarriageReturns(broken);
            message = messageOf({.name = "second", .vertexSource = awkwardVertex, .fragmentSource = broken},
                                walls, path);
            CHECK(namesLine(message, broken, "bright = nothing;"));
            CHECK(message.find("the fragment shader of 'second'") != std::string::npos);
        }
        // Of another type than the vertex shader's: the driver's link error, with the program's name.
        broken = awkwardFragment;
        replaceOnce(broken, "in vec3 weight;", "in vec4 weight;");
        replaceOnce(broken, "addTo(sum, weight);", "addTo(sum, weight.xyz);");
        message = messageOf({.name = "third", .vertexSource = awkwardVertex, .fragmentSource = broken}, walls,
                            path);
        CHECK(message.find("weight") != std::string::npos && message.find("'third'") != std::string::npos);
    }
    const Path any{MapKind::tennisBall, CaptureMethod::exact, LayerOrder::oneAtATime};
    const auto refused = [&](const std::string& vertex, const std::string& fragment,
                             const std::string& named) {
        const std::string message =
            messageOf({.name = "bad", .vertexSource = vertex, .fragmentSource = fragment}, walls, any);
        if (message.find(named) == std::string::npos)
            std::printf("%s\n", message.c_str());
        CHECK(message.find(named) != std::string::npos);
    };
    const std::string head = "#version 330 core\n",
                      end = "out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n";
    refused("void main() {}", head + end, "#version");
    refused(plainVertex, "#version 300 es\n" + end, "300 es");
    refused(plainVertex, head + "out vec4 colour;\n", "no main");
    refused(plainVertex, head + "void main() {}\n", "no output");
    refused(plainVertex, head + "in Block { vec3 a; } block;\n" + end, "'Block'");
    refused(plainVertex, head + "float mirrorballCapture_weight;\n" + end, "mirrorballCapture_weight");
    refused(plainVertex, head + "out vec4 colours[2];\nvoid main() { colours[0] = vec4(1.0); }\n", "colours");
    refused(head +
                "layout(location = 0) in vec3 position;\nout vec3 positionInWorld;\nout float several[3];\n"
                "void main() { positionInWorld = position; several = float[3](1.0, 2.0, 3.0); }\n",
            head + "in float several[3];\nout vec4 colour;\nvoid main() { colour = vec4(several[1]); }\n",
            "'float several[3]'");
}

} // namespace

int main()
{
    const headless::Context context;
    const Walls walls;
    checkEverywhere(typesVertex, floatsFragment, walls, "floats");
    checkEverywhere(typesVertex, matricesFragment, walls, "matrices");
    checkEverywhere(typesVertex, integersFragment, walls, "integers");
    checkEverywhere(awkwardVertex, awkwardFragment, walls, "awkward");
    for (const Path& path : fewPaths())
        checkShowsPosition(path, withCarriageReturns(awkwardVertex), withCarriageReturns(awkwardFragment),
                           walls, "CRLF");
    checkProvokingVertex(walls);
    for (const MapInfo& info : maps())
        checkLevels(walls, info.kind, CaptureMethod::exact);
    checkDiscard(walls);
    checkMessages(walls);
    std::printf("%s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    for (const Path& path : fewPaths())
        for (const char* const type : {"float", "vec3", "mat4"})
            checkLimit(walls, path, type, "");
    checkLimit(walls, fewPaths()[0], "float", "flat ");
    // Too many for all layers in one draw: each view has its own, with as much room as ever.
    checkLimit(walls, {MapKind::cube, CaptureMethod::exact, LayerOrder::allAtOnce}, "vec4", "");
    return 0;
}
