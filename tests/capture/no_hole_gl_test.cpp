// Closed meshes have no holes: seen from inside, no texel of any map shows the background. From many random
// points, and with the probe on a vertex, an edge or a face of something else, at places where floats are
// coarse; and two-sided and back-face-culled draws, in strips, indexed, instanced and displaced, show the same.
#include "support/check.h"
#include "support/gl_image.h"

#include "scene.h"

#include <mirrorball/capture/reflection_probe.h>
#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cstring>
#include <random>

using namespace mirrorball;

namespace {

struct Shape
{
    std::vector<glm::vec3> positions;
    std::vector<GLuint> indices; // counter-clockwise as seen from inside
};

// A sphere around the origin of radius 0.8 … 1.2, its triangles small on one side and large on the other.
Shape bumpySphere(int rings, int segments)
{
    Shape shape;
    const auto bumpy = [](const glm::vec3& d) {
        return d * (1.0f + 0.2f * std::sin(7.0f * d.x) * std::cos(5.0f * d.y + 3.0f * d.z));
    };
    shape.positions.push_back(bumpy({0, 1, 0}));
    for (int ring = 1; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            // Squared, so that rings crowd together at the top and segments at longitude 0.
            const float down =
                glm::pi<float>() * std::pow(static_cast<float>(ring) / static_cast<float>(rings), 2.0f);
            const float around = 2.0f * glm::pi<float>() *
                                 std::pow(static_cast<float>(segment) / static_cast<float>(segments), 2.0f);
            shape.positions.push_back(bumpy(
                {std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around)}));
        }
    shape.positions.push_back(bumpy({0, -1, 0}));
    const auto at = [&](int ring, int segment) {
        if (ring == 0 || ring == rings)
            return static_cast<GLuint>(ring == 0 ? 0 : shape.positions.size() - 1);
        return static_cast<GLuint>(1 + (ring - 1) * segments + segment % segments);
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            if (ring > 0)
                shape.indices.insert(shape.indices.end(),
                                     {at(ring, segment), at(ring, segment + 1), at(ring + 1, segment)});
            if (ring < rings - 1)
                shape.indices.insert(shape.indices.end(), {at(ring, segment + 1), at(ring + 1, segment + 1),
                                                           at(ring + 1, segment)});
        }
    return shape;
}

// 12 triangles, half sides 1, 2, 3.
Shape box()
{
    Shape shape;
    for (int corner = 0; corner < 8; ++corner)
        shape.positions.push_back(
            {(corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 2 : -2, (corner & 4) != 0 ? 3 : -3});
    shape.indices = {0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5,
                     2, 3, 6, 3, 7, 6, 0, 2, 4, 2, 6, 4, 1, 5, 3, 3, 5, 7};
    return shape;
}

// A model's triangles, all its meshes in one.
Shape shapeOf(const examples::Scene& scene)
{
    Shape shape;
    for (const examples::Mesh& mesh : scene.meshes) {
        const auto first = static_cast<GLuint>(shape.positions.size());
        shape.positions.insert(shape.positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle)
                shape.indices.push_back(first + corner);
    }
    return shape;
}

// Whether a ray from there crosses the surface an odd number of times. Its direction is no edge's.
bool isInside(const Shape& shape, const glm::dvec3& place)
{
    const glm::dvec3 direction(0.5377, -0.3161, 0.7816);
    bool inside = false;
    for (std::size_t index = 0; index < shape.indices.size(); index += 3) {
        const glm::dvec3 a = glm::dvec3(shape.positions[shape.indices[index]]) - place,
                         b = glm::dvec3(shape.positions[shape.indices[index + 1]]) - place,
                         c = glm::dvec3(shape.positions[shape.indices[index + 2]]) - place;
        const double u = glm::dot(direction, glm::cross(b, c)), v = glm::dot(direction, glm::cross(c, a)),
                     w = glm::dot(direction, glm::cross(a, b));
        const bool isMet = (u > 0.0) == (v > 0.0) && (v > 0.0) == (w > 0.0);
        const bool isAhead = (glm::dot(a, glm::cross(b - a, c - a)) > 0.0) == (u + v + w > 0.0);
        inside = inside != (isMet && isAhead);
    }
    return inside;
}

const char* const vertexSource = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 worldFromObject; // set to another one for each instance by the host
uniform float displacement;
uniform vec3 placeOfInstance[2];
out vec3 positionInWorld;
void main()
{
    vec3 displaced = position * (1.0 + displacement * sin(9.0 * position.x));
    positionInWorld = (worldFromObject * vec4(displaced, 1.0)).xyz + placeOfInstance[gl_InstanceID];
    gl_Position = vec4(0.0);
}
)";
const char* const fragmentSource = R"(#version 330 core
in vec3 positionInWorld;
out vec4 colour;
void main() { colour = vec4(positionInWorld, gl_FrontFacing ? 1.0 : 2.0); }
)";

// How the same triangles are sent.
enum class Sending { indexed, arrays, strips, instanced };

class Drawable
{
public:
    explicit Drawable(const Shape& shape) : shape_(shape)
    {
        std::vector<glm::vec3> unrolled;
        for (const GLuint index : shape.indices)
            unrolled.push_back(shape.positions[index]);
        indexed_ = upload(shape.positions, shape.indices);
        arrays_ = upload(unrolled, {});
        // Each triangle as a strip of its own between restarts.
        std::vector<GLuint> strips;
        for (std::size_t index = 0; index < shape.indices.size(); ++index) {
            strips.push_back(shape.indices[index]);
            if (index % 3 == 2)
                strips.push_back(~0u);
        }
        strips_ = upload(shape.positions, strips);
        stripLength_ = static_cast<GLsizei>(strips.size());
        for (const glm::vec3& p : shape.positions)
            radius_ = std::max(radius_, glm::length(p));
    }

    float radius() const { return radius_; }
    const Shape& shape() const { return shape_; }

    void draw(Sending sending) const
    {
        const auto count = static_cast<GLsizei>(shape_.indices.size());
        switch (sending) {
        case Sending::indexed:
            glBindVertexArray(indexed_);
            glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
            break;
        case Sending::arrays:
            glBindVertexArray(arrays_);
            glDrawArrays(GL_TRIANGLES, 0, count);
            break;
        case Sending::strips:
            glEnable(GL_PRIMITIVE_RESTART);
            glPrimitiveRestartIndex(~0u);
            glBindVertexArray(strips_);
            glDrawElements(GL_TRIANGLE_STRIP, stripLength_, GL_UNSIGNED_INT, nullptr);
            glDisable(GL_PRIMITIVE_RESTART);
            break;
        case Sending::instanced:
            glBindVertexArray(indexed_);
            glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr, 2);
            break;
        }
    }

private:
    static GLuint upload(const std::vector<glm::vec3>& positions, const std::vector<GLuint>& indices)
    {
        GLuint vertexArray = 0, buffers[2] = {};
        glGenVertexArrays(1, &vertexArray);
        glGenBuffers(2, buffers);
        glBindVertexArray(vertexArray);
        glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(glm::vec3)),
                     positions.data(), GL_STATIC_DRAW);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        if (!indices.empty()) {
            glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
            glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                         indices.data(), GL_STATIC_DRAW);
        }
        return vertexArray;
    }

    Shape shape_;
    GLuint indexed_ = 0, arrays_ = 0, strips_ = 0;
    GLsizei stripLength_ = 0;
    float radius_ = 0.0f;
};

class Program
{
public:
    Program() : program_({.name = "shape", .vertexSource = vertexSource, .fragmentSource = fragmentSource}) {}

    // Everything to where the probe stands, in double and then rounded: as a host does it.
    std::vector<float> capture(ReflectionProbe& probe, const Drawable& drawable,
                               const glm::mat4& worldFromObject, bool cull, Sending sending,
                               float displacement = 0.0f, bool hasBounds = true)
    {
        CaptureMesh mesh{.program = &program_, .cullBackFaces = cull};
        if (hasBounds)
            mesh.bounds = Sphere{glm::vec3(worldFromObject[3]), drawable.radius() * 1.1f};
        probe.capture({&mesh, 1}, [&](const CaptureMesh&, const CaptureDraw& draw) {
            const auto location = [&](const char* name) { return glGetUniformLocation(draw.program, name); };
            glUniformMatrix4fv(location("worldFromObject"), 1, GL_FALSE, &worldFromObject[0][0]);
            glUniform1f(location("displacement"), displacement);
            const float places[6] = {0.0f, 0.0f, 0.0f, 0.0f, 1000.0f, 0.0f};
            glUniform3fv(location("placeOfInstance"), 2, places);
            drawable.draw(sending);
        });
        std::vector<float> all;
        for (const unsigned int texture : {probe.map().colourTexture, probe.map().distanceTexture}) {
            const auto texels = tests::readMap(texture, probe.desc().map, probe.desc().n);
            all.insert(all.end(), texels.begin(), texels.end());
        }
        return all;
    }

private:
    CaptureProgram program_;
};

ReflectionProbe::Desc descOf(MapKind map, CaptureMethod method, int n)
{
    return {.map = map,
            .n = n,
            .near = 1e-6f,
            .far = 1e4f,
            .colour = ColourFormat::rgba32f,
            .background = glm::vec4(0.0f),
            .method = method};
}

std::size_t holes(const std::vector<float>& image)
{
    std::size_t count = 0;
    for (std::size_t texel = 0; texel < image.size() / 8; ++texel)
        count += image[4 * texel + 3] == 0.0f ? 1 : 0;
    return count;
}

// From random points, the shape moved and turned so that its vertices are unfriendly numbers.
void checkClosed(Program& program, const Drawable& drawable, MapKind map, int points, std::mt19937& generator)
{
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    ReflectionProbe exact(descOf(map, CaptureMethod::exact, 6));
    for (int point = 0; point < points; ++point) {
        glm::vec3 place;
        do
            place = 0.75f * glm::vec3(uniform(generator), uniform(generator), uniform(generator));
        while (glm::length(place) > 0.75f);
        if (point % 16 == 0) // as near to a face, an edge or a vertex as floats allow
            place = drawable.shape()
                        .positions[static_cast<std::size_t>(point) % drawable.shape().positions.size()] *
                    0.999f;
        glm::mat4 worldFromObject = glm::translate(glm::mat4(1.0f), -place);
        if (point % 3 == 0)
            worldFromObject =
                glm::rotate(worldFromObject, 3.0f * uniform(generator), glm::vec3(0.6f, 0.8f, 0.0f));
        if (point % 16 == 0)
            worldFromObject = glm::translate(glm::mat4(1.0f), -place);
        const std::size_t found =
            holes(program.capture(exact, drawable, worldFromObject, false, Sending::indexed));
        if (found != 0)
            std::printf("%s: %zu holes at point %d\n", std::string(mapInfo(map).name).c_str(), found, point);
        CHECK(found == 0);
    }
}

// However the triangles are sent, the map is the same; culled, the inside of a closed mesh is the same and its
// outside is gone.
void checkSendings(Program& program, const Drawable& drawable, MapKind map, CaptureMethod method,
                   LayerOrder layers)
{
    ReflectionProbe::Desc desc = descOf(map, method, 12);
    desc.layers = layers;
    ReflectionProbe probe(desc);
    const glm::mat4 around = glm::translate(glm::mat4(1.0f), glm::vec3(0.1f, -0.2f, 0.15f));
    const std::vector<float> expected = program.capture(probe, drawable, around, false, Sending::indexed);
    const bool isStraight =
        method == CaptureMethod::exact || map == MapKind::cube || map == MapKind::octahedral;
    if (isStraight) {
        if (holes(expected) != 0)
            std::printf("%s, method %d, layers %d: %zu holes\n", std::string(mapInfo(map).name).c_str(),
                        static_cast<int>(method), static_cast<int>(layers), holes(expected));
        CHECK(holes(expected) == 0);
        for (std::size_t texel = 0; texel < expected.size() / 8; ++texel)
            CHECK(expected[4 * texel + 3] == 1.0f); // front faces only
        CHECK(tests::sameBits(program.capture(probe, drawable, around, true, Sending::indexed), expected));
    }
    for (const Sending sending : {Sending::arrays, Sending::strips, Sending::instanced})
        CHECK(tests::sameBits(program.capture(probe, drawable, around, false, sending), expected));
    CHECK(tests::sameBits(program.capture(probe, drawable, around, false, Sending::indexed, 0.0f, false),
                          expected));

    // Its vertices displaced, within bounds that hold for that.
    if (isStraight)
        CHECK(holes(program.capture(probe, drawable, around, false, Sending::indexed, 0.05f)) == 0);

    // From outside its back is seen through a culled front: drawn inside out, nothing at all.
    const glm::mat4 beside = glm::translate(glm::mat4(1.0f), glm::vec3(1.2f, 1.5f, -1.7f));
    const std::vector<float> both = program.capture(probe, drawable, beside, false, Sending::indexed);
    const std::vector<float> culled = program.capture(probe, drawable, beside, true, Sending::indexed);
    std::size_t seen = 0;
    for (std::size_t texel = 0; texel < both.size() / 8; ++texel) {
        seen += both[4 * texel + 3] != 0.0f ? 1 : 0;
        if (isStraight) {
            // Nearest is the outside, which is a back face here; culled, the far wall's inside.
            CHECK(both[4 * texel + 3] != 1.0f);
            CHECK((both[4 * texel + 3] == 2.0f) == (culled[4 * texel + 3] == 1.0f));
        }
        CHECK(culled[4 * texel + 3] != 2.0f);
    }
    CHECK(seen > 0);
}

// A model from random points inside it.
void checkModel(Program& program, const Drawable& drawable, MapKind map, int points)
{
    std::mt19937 generator(23);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    ReflectionProbe exact(descOf(map, CaptureMethod::exact, 12));
    for (int point = 0; point < points; ++point) {
        glm::vec3 place;
        do
            place = drawable.radius() * glm::vec3(uniform(generator), uniform(generator), uniform(generator));
        while (!isInside(drawable.shape(), place));
        const glm::mat4 worldFromObject = glm::translate(glm::mat4(1.0f), -place);
        const std::size_t found =
            holes(program.capture(exact, drawable, worldFromObject, false, Sending::indexed));
        if (found != 0)
            std::printf("%s: %zu holes at %.9g, %.9g, %.9g\n", std::string(mapInfo(map).name).c_str(), found,
                        static_cast<double>(place.x), static_cast<double>(place.y),
                        static_cast<double>(place.z));
        CHECK(found == 0);
    }
}

} // namespace

int main(int argc, char** argv)
{
    const headless::Context context;
    // [POINTS [MAP|all [MODEL]]]: for each shape and map, 10,000 in all; of a closed model alone.
    const int points = argc > 1 ? std::atoi(argv[1]) : 625;
    const std::string only = argc > 2 && std::strcmp(argv[2], "all") != 0 ? argv[2] : "";
    Program program;
    if (argc > 3) {
        const Drawable model(shapeOf(examples::loadScene(argv[3])));
        for (const MapInfo& info : maps())
            if (only.empty() || info.name == only)
                checkModel(program, model, info.kind, points);
        return 0;
    }
    const Drawable sphere(bumpySphere(9, 14)), twelve(box());
    for (const MapInfo& info : maps()) {
        if (!only.empty() && info.name != only)
            continue;
        std::mt19937 generator(11);
        checkClosed(program, sphere, info.kind, points, generator);
        checkClosed(program, twelve, info.kind, points, generator);
        for (const CaptureMethod method : {CaptureMethod::exact, CaptureMethod::perVertex})
            for (const LayerOrder layers : {LayerOrder::oneAtATime, LayerOrder::allAtOnce})
                checkSendings(program, sphere, info.kind, method, layers);
    }
    return 0;
}
