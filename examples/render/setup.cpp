#include "setup.h"

#include "command_line.h"

#include <mirrorball/error.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace render {

namespace {

using namespace examples;
using mirrorball::Error;
using mirrorball::ErrorKind;

struct Box
{
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-low};

    void add(const glm::dvec3& point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    glm::dvec3 halfExtent() const { return 0.5 * (high - low); }
};

Box boxOf(const Mesh& mesh)
{
    Box box;
    for (const glm::vec3& position : mesh.positions)
        box.add(glm::dvec3(position));
    return box;
}

// Polished metal: a light grey with a highlight.
Material ownMaterial()
{
    Material material;
    material.name = "reflector";
    material.diffuse = glm::vec4(0.7f, 0.7f, 0.7f, 1.0f);
    material.specular = glm::vec3(0.6f);
    material.shininess = 60.0f;
    return material;
}

// The probe lies within the reflector, so nothing nearer than its surface can be seen. A tenth is left for
// what stands close; a flat reflector has a smallest extent of nothing, and gets a thousandth of its largest.
double derivedNear(const Mesh& mesh, double scale)
{
    const glm::dvec3 half = boxOf(mesh).halfExtent() * scale;
    const double smallest = std::min({half.x, half.y, half.z}), largest = std::max({half.x, half.y, half.z});
    return std::max(0.9 * smallest, 1e-3 * largest);
}

Mirror mirrorOf(const ReflectorOptions& given, const Options& options)
{
    const std::string sphere = "sphere:";
    Mirror mirror{};
    mirror.reflector.at = given.at + options.offset;
    mirror.reflector.mesh = loadReflector(given.shape);
    mirror.reflector.scale = given.scale;
    mirror.reflector.material = ownMaterial();
    if (given.shape.starts_with(sphere))
        mirror.reflector.radius = given.scale * parseNumber(given.shape.substr(sphere.size()), "--reflector");
    mirror.worldFromProbe = poseOf(mirror.reflector.at, given.turn);
    mirror.near = options.near.value_or(derivedNear(mirror.reflector.mesh, given.scale));
    requireRange(mirror.near, options.far);
    mirror.blend = static_cast<float>(given.blend);
    mirror.tint = glm::vec3(given.tint);
    if (!given.source.empty())
        mirror.source = readSource(given.source);
    return mirror;
}

Camera cameraOf(const Options& options, const Reflector& first)
{
    // By default the first reflector fills most of the picture's height, seen a little from above.
    const double size = glm::length(boxOf(first.mesh).halfExtent()) * first.scale;
    const double distance = 1.2 * size / std::tan(0.5 * glm::radians(options.fov));
    const glm::dvec3 look = options.look ? *options.look + options.offset : first.at;
    const glm::dvec3 eye = options.eye ? *options.eye + options.offset
                                       : first.at + distance * glm::normalize(glm::dvec3(1.0, 0.6, 2.0));
    const glm::dvec3 across = glm::cross(look - eye, options.up);
    // Parallel within rounding: there is no direction to call right.
    if (!(glm::length(across) > 1e-9 * glm::length(look - eye) * glm::length(options.up)))
        throw Error(ErrorKind::badArgument, "--eye, --look and --up",
                    "eye and look are one point, or up points along the view", "move the eye or turn up");
    return {eye, look, options.up, glm::radians(options.fov), options.pixels * options.supersample};
}

double farthestFrom(const glm::dvec3& eye, const Setup& setup)
{
    double farthest = 0.0;
    for (const Mesh& mesh : setup.scene.meshes)
        for (const glm::vec3& position : mesh.positions) {
            const double distance = glm::distance(glm::dvec3(position) + setup.scene.offset, eye);
            farthest = std::isfinite(distance) ? std::max(farthest, distance) : farthest;
        }
    for (const Mirror& mirror : setup.mirrors) {
        const Reflector& reflector = mirror.reflector;
        const double radius = glm::length(boxOf(reflector.mesh).halfExtent()) * reflector.scale;
        farthest = std::max(farthest, glm::distance(reflector.at, eye) + 2.0 * radius);
    }
    return farthest;
}

// A box given by its corners, by default the one around the scene: what becomes of the cube [-1, 1]³.
glm::dmat4 proxyOf(const Options& options, const Scene& scene)
{
    Box box;
    for (const Mesh& mesh : scene.meshes)
        for (const glm::vec3& position : mesh.positions)
            box.add(glm::dvec3(position));
    box.low = options.proxyLow.value_or(box.low);
    box.high = options.proxyHigh.value_or(box.high);
    const glm::dvec3 half = box.halfExtent();
    glm::dmat4 worldFromProxy(1.0);
    for (int axis = 0; axis < 3; ++axis)
        worldFromProxy[axis][axis] = half[axis];
    worldFromProxy[3] = glm::dvec4(box.low + half + scene.offset, 1.0);
    return worldFromProxy;
}

} // namespace

Setup setupOf(const Options& options)
{
    Setup setup;
    setup.scene = sceneOf(options);
    for (const ReflectorOptions& reflector : options.reflectors)
        setup.mirrors.push_back(mirrorOf(reflector, options));
    setup.origin = setup.mirrors[0].reflector.at;
    setup.camera = cameraOf(options, setup.mirrors[0].reflector);
    setup.light = lightOf(options, setup.scene);
    setup.worldFromProxy = proxyOf(options, setup.scene);
    setup.farthest = farthestFrom(setup.camera.eye, setup);
    return setup;
}

} // namespace render
