// Exact capture of one triangle at a time, on every map, against its edges' planes in double: what the polygon that
// covers it leaves out shows, since nothing else is there to show instead.
#include "examples/small_scenes.h"
#include "support/check.h"

#include "gl_scene.h"
#include "map_file.h"
#include "reference_direction.h"

#include <mirrorball/headless/context.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

using namespace mirrorball;

namespace {

using Triangle = std::array<glm::vec3, 3>;

class Random
{
public:
    explicit Random(unsigned int seed) : generator_(seed) {}

    float uniform(float low, float high)
    {
        return std::uniform_real_distribution<float>(low, high)(generator_);
    }
    float logarithmic(float low, float high) { return std::exp(uniform(std::log(low), std::log(high))); }
    bool oneIn(int count) { return std::uniform_int_distribution<int>(1, count)(generator_) == 1; }
    glm::vec3 direction()
    {
        const float z = uniform(-1.0f, 1.0f), turn = uniform(-3.1416f, 3.1416f);
        const float radius = std::sqrt(1.0f - z * z);
        return glm::vec3(radius * std::cos(turn), radius * std::sin(turn), z);
    }
    // As often as not near an axis: on it, or as far from it as a texel or less.
    glm::vec3 place()
    {
        if (oneIn(2))
            return direction();
        glm::vec3 axis(0.0f);
        axis[std::uniform_int_distribution<int>(0, 2)(generator_)] = oneIn(2) ? 1.0f : -1.0f;
        return oneIn(8) ? axis : glm::normalize(axis + logarithmic(1e-5f, 0.5f) * direction());
    }

private:
    std::mt19937 generator_;
};

// Spans of 1/1000 to nearly half a turn. Half of them are needles of any width, or nearly in a plane with the probe: then
// the third corner may lie anywhere around.
Triangle anyTriangle(Random& random)
{
    const auto second = [&](const glm::vec3& first) {
        const float span = random.logarithmic(1e-3f, 2.0f);
        return random.oneIn(2) ? random.place() : glm::normalize(first + span * random.direction());
    };
    const glm::vec3 a = random.place(), b = second(a);
    glm::vec3 c = second(a);
    if (random.oneIn(2)) {
        const float share = random.uniform(-0.2f, 1.2f);
        const glm::vec3 along = random.oneIn(2)
                                    ? glm::mix(a, b, share)
                                    : random.uniform(-1.0f, 1.0f) * a + random.uniform(-1.0f, 1.0f) * b;
        c = glm::normalize(along) + random.logarithmic(1e-5f, 0.1f) * random.direction();
    }
    return {random.uniform(1.0f, 5.0f) * a, random.uniform(1.0f, 5.0f) * b, random.uniform(1.0f, 5.0f) * c};
}

// The triangle's sides, as normals of planes through the probe; inside is where all products are positive. `slack`: what
// rounding to float may tilt a plane by.
struct Sides
{
    std::array<glm::dvec3, 3> normal;
    std::array<double, 3> slack;
    glm::dvec4 plane{0.0}; // the triangle's own: xyz . position = w
    bool edgeOn = false;   // it holds the probe, or nearly
};

Sides sidesOf(const Triangle& triangle)
{
    Sides sides;
    const glm::dvec3 a(triangle[0]), b(triangle[1]), c(triangle[2]);
    const double volume = glm::dot(a, glm::cross(b, c));
    sides.plane = glm::dvec4(glm::cross(b - a, c - a), volume);
    const double largest = std::max(glm::length(a), std::max(glm::length(b), glm::length(c)));
    sides.edgeOn = std::abs(volume) < 1e-6 * largest * largest * largest;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 from(triangle[(k + 1) % 3]), to(triangle[(k + 2) % 3]);
        const glm::dvec3 normal = glm::cross(from, to) * (volume < 0.0 ? -1.0 : 1.0);
        const double size = glm::length(normal);
        sides.normal[k] = normal / size;
        sides.slack[k] = 1e-5 + 3e-7 * (glm::dot(from, from) + glm::dot(to, to)) / size;
    }
    return sides;
}

struct Found
{
    std::size_t triangles = 0, inside = 0, missed = 0, beside = 0;
};

constexpr double nearest = 1e-3;

// One triangle's map, texel by texel; what lies within the slack of a side is undecided.
void compare(Found& found, const Sides& sides, const std::vector<std::vector<examples::Sample>>& layers,
             const MapInfo& info, int n)
{
    const int width = info.widthInN * n, height = info.heightInN * n;
    for (int layer = 0; layer < info.components; ++layer)
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const glm::dvec3 direction =
                    glm::normalize(examples::referenceRay(info.name, layer, column, row, width, height));
                const double along = glm::dot(glm::dvec3(sides.plane), direction);
                // Of what is nearly in a plane with the probe, parts lie before `near`.
                bool inside = std::abs(sides.plane.w) > 1.01 * nearest * std::abs(along);
                bool outside = false;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double beyond = glm::dot(sides.normal[k], direction);
                    inside = inside && beyond > sides.slack[k];
                    outside = outside || beyond < -sides.slack[k];
                }
                const std::size_t texel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(column);
                const bool shown = !std::isinf(layers[static_cast<std::size_t>(layer)][texel].distance);
                found.inside += inside ? 1 : 0;
                found.missed += inside && !shown ? 1 : 0;
                found.beside += outside && shown ? 1 : 0;
            }
}

void check(const MapInfo& info, int n, int count, unsigned int seed)
{
    Random random(seed);
    std::vector<Triangle> triangles;
    std::vector<examples::Mesh> meshes;
    while (static_cast<int>(triangles.size()) < count) {
        const Triangle triangle = anyTriangle(random);
        if (sidesOf(triangle).edgeOn)
            continue;
        triangles.push_back(triangle);
        meshes.push_back(tests::triangle(triangle[0], triangle[1], triangle[2], glm::vec3(0, 1, 0)));
    }
    const examples::Scene scene = tests::sceneOf(std::move(meshes));
    const examples::GlScene drawable(scene, glm::dvec3(0.0));
    CaptureProgram program = examples::phongCaptureProgram();
    ReflectionProbe probe({.map = info.kind,
                           .n = n,
                           .near = static_cast<float>(nearest),
                           .mipLevels = false,
                           .pastSeams = true,
                           .method = CaptureMethod::exact});
    Found found;
    for (const CaptureMesh& mesh : drawable.captureMeshes(program)) {
        probe.capture(std::span(&mesh, 1), [&](const CaptureMesh& one, const CaptureDraw& draw) {
            drawable.drawMesh(one.id, draw.program, {}, 1, draw.primitive);
        });
        const std::size_t before = found.missed + found.beside;
        const Triangle& triangle = triangles[static_cast<std::size_t>(mesh.id)];
        compare(found, sidesOf(triangle),
                examples::readMap(probe.map(), examples::View::triangle, glm::dvec3(0.0), scene.background),
                info, n);
        found.triangles += 1;
        if (found.missed + found.beside > before)
            for (const glm::vec3& corner : triangle)
                std::printf("    (%.9gf, %.9gf, %.9gf)\n", static_cast<double>(corner.x),
                            static_cast<double>(corner.y), static_cast<double>(corner.z));
    }
    std::printf("%-18s n = %-3d %zu triangles, %zu texels inside: %zu missed, %zu beside\n",
                std::string(info.name).c_str(), n, found.triangles, found.inside, found.missed, found.beside);
    CHECK(found.inside > 0);
    CHECK(found.missed == 0);
    CHECK(found.beside == 0);
}

} // namespace

int main(int argc, char** argv)
{
    // [COUNT [SEED [MAP]]]: so many triangles a map and size, from this seed on.
    const int count = argc > 1 ? std::atoi(argv[1]) : 100;
    const auto seed = static_cast<unsigned int>(argc > 2 ? std::atoi(argv[2]) : 1);
    if (argc > 3)
        CHECK(mapFromName(argv[3]).has_value()); // an unknown map would be no test
    const headless::Context context;
    for (const MapInfo& info : maps()) {
        if (argc > 3 && info.name != argv[3])
            continue;
        check(info, 7, count, seed);
        check(info, 48, count, seed + 1);
        check(info, 157, count / 4, seed + 2);
    }
}
