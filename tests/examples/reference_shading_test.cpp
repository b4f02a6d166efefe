// What the reference tracer shows where a ray meets something, by values worked out by hand: images and
// alpha, light, mirrors.
#include "reference.h"
#include "small_scenes.h"

#include "support/check.h"

#include <cmath>
#include <limits>

using examples::Hit;
using examples::Image;
using examples::Mesh;
using examples::ReferenceTracer;
using examples::Reflector;
using examples::Scene;
using examples::Seen;
using examples::SeenKind;
using tests::isNear;
using tests::sceneOf;
using tests::triangle;
using tests::wall;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const float halfRoot = std::sqrt(0.5f);

// ---- Images and alpha ------------------------------------------------------------------------------

// 2 × 2: black, white (row v = 0), red, green with alpha 0.
Image fourTexels()
{
    return {2, 2, {0, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 255, 0, 255, 0, 0}};
}

void testSampling()
{
    const Image image = fourTexels();
    CHECK(examples::sampleImage(image, {0.25, 0.25}) == glm::dvec4(0, 0, 0, 1));
    CHECK(examples::sampleImage(image, {0.75, 0.25}) == glm::dvec4(1, 1, 1, 1));
    CHECK(examples::sampleImage(image, {0.25, 0.75}) == glm::dvec4(1, 0, 0, 1));
    CHECK(examples::sampleImage(image, {-1.25, 7.75}) == glm::dvec4(0, 1, 0, 0)); // repeats
    CHECK(examples::sampleImage(image, {0.5, 0.25}) == glm::dvec4(0.5, 0.5, 0.5, 1));
    CHECK(examples::sampleImage(image, {0.0, 0.25}) == glm::dvec4(0.5, 0.5, 0.5, 1)); // with its repetition
    CHECK(examples::sampleImage(image, {0.5, 0.5}) == glm::dvec4(0.5, 0.5, 0.25, 0.75));
    // sRGB byte 188 is linear 0.5029; filtering comes after decoding.
    const Image grey{1, 1, {188, 188, 188, 255}};
    CHECK_NEAR(examples::sampleImage(grey, {0.3, 0.9}).x, 0.50289, 1e-5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(examples::sampleImage(image, {nan, 0.0}) == glm::dvec4(0, 0, 0, 1));
}

void testAlpha()
{
    Mesh front =
        triangle({-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {0, 0, 1}, 1); // texture (0, 0) … (1, 1) over 4 × 4
    Scene scene =
        sceneOf({front, wall(-2), triangle({-9, -9, -1.5f}, {9, -9, -1.5f}, {0, 9, -1.5f}, {0, 0, 1}, 2)});
    scene.images = {fourTexels()};
    scene.materials.resize(3);
    scene.materials[1].diffuse = {0.5f, 1.0f, 1.0f, 1.0f};
    scene.materials[1].image = 0;
    scene.materials[2].diffuse.a = 0.49f; // not there at all
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    const auto look = [&](double u, double v) {
        return tracer.trace({4.0 * u - 1.0, 4.0 * v - 1.0, 0.0}, {0, 0, -1}, 0.0, infinity);
    };
    const Hit red = look(0.25, 0.7499);
    CHECK(red.found && red.triangle == 0 && red.material == 1);
    CHECK(isNear(glm::dvec3(red.colour), {0.5, 0, 0}, 1e-3)); // 0.0001 beside the texel's middle
    // Moved so that the clear texel's middle, (0.75, 0.75), lies at (0.25, 0.5): on the way there from (0.25,
    // 0) alpha is 1 − 2 v, and the hole begins at v = 1/4.
    scene.meshes[0].textureCoordinates = {{0.5, 0.25}, {1.5, 0.25}, {0.5, 1.25}};
    CHECK(look(0.25, 0.01).distance == 1.0);
    CHECK(look(0.25, 0.249).distance == 1.0);
    CHECK(look(0.25, 0.251).distance == 2.0); // through to the wall
    CHECK(look(0.25, 0.5).distance == 2.0);
}

// ---- Light -----------------------------------------------------------------------------------------

void testShade()
{
    Scene scene = sceneOf({wall(0)});
    scene.materials[0].diffuse = {0.5f, 0.25f, 1.0f, 1.0f};
    scene.materials[0].specular = {0.8f, 0.4f, 0.0f};
    scene.materials[0].shininess = 2.0f;
    const ReferenceTracer tracer(scene, glm::dvec3(0.0));
    const glm::dvec3 eye(0, 0, 2);
    const Hit hit = tracer.trace(eye, {0, 0, -1}, 0.0, infinity);
    const glm::dvec3 d(0.5, 0.25, 1.0);
    const glm::dvec3 s(0.8f, 0.4f, 0.0f);
    constexpr double a = static_cast<double>(examples::ambient);
    const double r = std::sqrt(0.5);
    // Light at 45°: N·L = √½, R·E = √½, to the power 2: ½.
    CHECK(isNear(tracer.shade(hit, eye, {0, 3, 3}), a * d + r * d + 0.5 * s, 1e-6));
    // Light straight above: N·L = R·E = 1.
    CHECK(isNear(tracer.shade(hit, eye, {0, 0, 9}), a * d + d + s, 1e-6));
    // Eye at 45°, light at 45° on the same side: R·E = 0, no highlight.
    CHECK(isNear(tracer.shade(hit, {0, 5, 5}, {0, 3, 3}), a * d + r * d, 1e-6));
    // Light behind the surface: ambient alone.
    CHECK(isNear(tracer.shade(hit, eye, {0, 0, -1}), a * d, 1e-6));
    // Seen and lit from behind, the normal is turned.
    CHECK(isNear(tracer.shade(hit, {0, 0, -2}, {0, 0, -9}), a * d + d + s, 1e-6));
    CHECK(tracer.shade(Hit{}, eye, {0, 0, 9}) == scene.background);
}

// ---- Mirrors ---------------------------------------------------------------------------------------

Reflector ball(const glm::dvec3& at, double radius)
{
    Reflector reflector;
    reflector.at = at;
    reflector.radius = radius;
    reflector.material.diffuse = {0.9f, 0.8f, 0.7f, 1.0f};
    return reflector;
}

void testSphere()
{
    const Scene scene = sceneOf({wall(-4), wall(6)});
    ReferenceTracer tracer(scene, glm::dvec3(0.0));
    tracer.add(ball({0, 0, 0}, 1.0));
    // Head on: back to where it came from, and on to the wall behind the eye.
    const Seen head = tracer.look({0, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(head.kind == SeenKind::reflector && head.hit.reflector == 0);
    CHECK_NEAR(head.hit.distance, 4.0, 1e-15);
    CHECK(isNear(head.hit.normal, {0, 0, 1}, 1e-15) && isNear(head.mirrorDirection, {0, 0, 1}, 1e-15));
    CHECK(head.mirrored.found && head.mirrored.triangle >= 2);
    CHECK_NEAR(head.mirrored.distance, 5.0, 1e-12);
    // Where the normal stands at 45°, straight down becomes sideways: past both walls.
    const double r = std::sqrt(0.5);
    const Seen side = tracer.look({r, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(isNear(side.hit.position, {r, 0, r}, 1e-14) && isNear(side.mirrorDirection, {1, 0, 0}, 1e-14));
    CHECK(!side.mirrored.found);
    CHECK(tracer.shade(side.mirrored, side.hit.position, {0, 0, 9}) == scene.background);
    // Beside it, and in front of it.
    CHECK(tracer.look({1.001, 0, 5}, {0, 0, -1}, 0.1, 100.0).kind == SeenKind::scene);
    CHECK(tracer.look({1.001, 0, 5}, {1, 0, 0}, 0.1, 100.0).kind == SeenKind::background);
    CHECK(tracer.look({0, 0, 5}, {0, 0, -1}, 0.1, 3.9).kind == SeenKind::background);
    const Seen inside =
        tracer.look({0, 0, 5}, {0, 0, -1}, 4.5, 100.0); // past the front: the back from within
    CHECK(inside.kind == SeenKind::reflector && std::abs(inside.hit.distance - 6.0) < 1e-15);
    // The outline of a unit ball from 5 away lies asin(1/5) from its middle.
    CHECK_NEAR(head.hit.edgeAngle, std::asin(0.2), 1e-15);
}

// A square at 45° sends a ray along −z to +x; with scale and place as given.
void testMirrorMesh()
{
    Scene scene = sceneOf({wall(-4)});
    Mesh right = triangle({9, -50, -50}, {9, 50, -50}, {9, 0, 50}, {-1, 0, 0});
    scene.meshes.push_back(right);
    Reflector mirror;
    mirror.at = {2, 0, 0};
    mirror.scale = 0.5;
    mirror.mesh = triangle({-2, -4, 2}, {2, -4, -2}, {0, 4, 0}, {halfRoot, 0, halfRoot});
    ReferenceTracer tracer(scene, glm::dvec3(0.0));
    tracer.add(mirror);
    const Seen seen = tracer.look({2, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(seen.kind == SeenKind::reflector);
    CHECK(isNear(seen.hit.position, {2, 0, 0}, 1e-12));
    CHECK(isNear(seen.mirrorDirection, {1, 0, 0}, 1e-7)); // the normal is a float
    CHECK(seen.mirrored.found && seen.mirrored.triangle == 2 && seen.mirrored.reflector == -1);
    CHECK_NEAR(seen.mirrored.distance, 7.0, 1e-6);
    // At y = 0 the triangle is 2 wide, scaled 1: from x = 1.5 to 2.5.
    CHECK(tracer.look({2.45, 0, 5}, {0, 0, -1}, 0.1, 100.0).kind == SeenKind::reflector);
    CHECK(tracer.look({2.55, 0, 5}, {0, 0, -1}, 0.1, 100.0).kind == SeenKind::scene);
}

// Two balls: each shows the other as a plain object, and itself not at all.
void testTwoReflectors()
{
    const Scene scene = sceneOf({wall(-4)});
    ReferenceTracer tracer(scene, glm::dvec3(0.0));
    tracer.add(ball({0, 0, 0}, 1.0));
    tracer.add(ball({0, 0, 10}, 2.0));
    const Seen seen = tracer.look({0, 0, 5}, {0, 0, -1}, 0.1, 100.0);
    CHECK(seen.hit.reflector == 0 && seen.mirrored.reflector == 1);
    CHECK_NEAR(seen.mirrored.distance, 7.0, 1e-12);
    // Its plain colour, lit head on: (ambient + 1) of the diffuse colour.
    const glm::vec3 colour = tracer.shade(seen.mirrored, {0, 0, 1}, {0, 0, 1});
    CHECK(isNear(glm::dvec3(colour), 1.3 * glm::dvec3(0.9, 0.8, 0.7), 1e-6));
    const Seen other = tracer.look({0, 0, 5}, {0, 0, 1}, 0.1, 100.0);
    CHECK(other.hit.reflector == 1 && other.mirrored.reflector == 0);
}

} // namespace

int main()
{
    testSampling();
    testAlpha();
    testShade();
    testSphere();
    testMirrorMesh();
    testTwoReflectors();
}
