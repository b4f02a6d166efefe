#include "reference.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace examples {
namespace {

std::vector<PlacedMesh> placedMeshes(const Scene& scene)
{
    std::vector<PlacedMesh> placed;
    for (const Mesh& mesh : scene.meshes) {
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        const Image* image =
            material.image >= 0 ? &scene.images[static_cast<std::size_t>(material.image)] : nullptr;
        placed.push_back({&mesh, &material, image, 1.0, scene.offset});
    }
    return placed;
}

// The true sphere: the smaller root of |start + t · direction − centre| = radius that is in [near, far].
Hit traceSphere(const Reflector& sphere, const glm::dvec3& start, const glm::dvec3& unitDirection,
                double near, double far)
{
    const glm::dvec3 fromCentre = start - sphere.at;
    const double middle = -glm::dot(fromCentre, unitDirection);
    // Distance of the line from the centre by the perpendicular, which does not cancel as b² − c does.
    const glm::dvec3 perpendicular = fromCentre + middle * unitDirection;
    const double halfChordSquared = sphere.radius * sphere.radius - glm::dot(perpendicular, perpendicular);
    if (!(halfChordSquared >= 0.0)) {
        return {};
    }
    const double halfChord = std::sqrt(halfChordSquared);
    for (const double distance : {middle - halfChord, middle + halfChord}) {
        if (distance >= near && distance <= far) {
            Hit hit;
            hit.found = true;
            hit.distance = distance;
            hit.position = start + distance * unitDirection;
            hit.normal = (perpendicular + (distance - middle) * unitDirection) / sphere.radius;
            hit.colour = glm::vec3(sphere.material.diffuse);
            // To the outline: the cone around the sphere, seen from the start.
            hit.edgeAngle =
                std::abs(std::atan2(sphere.radius, std::sqrt(std::fmax(glm::dot(fromCentre, fromCentre) -
                                                                           sphere.radius * sphere.radius,
                                                                       0.0))) -
                         std::atan2(glm::length(perpendicular), middle));
            return hit;
        }
    }
    return {};
}

} // namespace

ReferenceTracer::ReferenceTracer(const Scene& scene, const glm::dvec3& origin)
    : scene_(&scene), origin_(origin), geometry_(placedMeshes(scene), origin)
{
}

void ReferenceTracer::add(Reflector reflector)
{
    Placed placed{std::make_unique<Reflector>(std::move(reflector)), nullptr};
    const Reflector& kept = *placed.reflector;
    if (!(kept.radius > 0.0)) {
        const PlacedMesh mesh{&kept.mesh, &kept.material, nullptr, kept.scale, kept.at};
        placed.geometry = std::make_unique<ReferenceGeometry>(std::span(&mesh, 1), origin_);
    }
    reflectors_.push_back(std::move(placed));
}

Hit ReferenceTracer::trace(const glm::dvec3& originInWorld, const glm::dvec3& direction, double near,
                           double far) const
{
    return geometry_.trace(originInWorld, direction, near, far);
}

Hit ReferenceTracer::traceReflectors(const glm::dvec3& start, const glm::dvec3& direction, double near,
                                     double far, int leftOut) const
{
    const glm::dvec3 unitDirection = glm::normalize(direction);
    Hit nearest;
    for (int number = 0; number < static_cast<int>(reflectors_.size()); ++number) {
        if (number == leftOut) {
            continue;
        }
        const Placed& placed = reflectors_[static_cast<std::size_t>(number)];
        const double limit = std::min(far, nearest.distance);
        Hit hit = placed.geometry ? placed.geometry->trace(start, unitDirection, near, limit)
                                  : traceSphere(*placed.reflector, start, unitDirection, near, limit);
        if (hit.found) {
            hit.reflector = number;
            nearest = hit;
        }
    }
    return nearest;
}

Seen ReferenceTracer::look(const glm::dvec3& eye, const glm::dvec3& direction, double near, double far) const
{
    constexpr int none = -1;
    const auto nearest = [&](const glm::dvec3& start, const glm::dvec3& along, double from, int leftOut) {
        const Hit inScene = trace(start, along, from, far);
        const Hit onReflector = traceReflectors(start, along, from, std::min(far, inScene.distance), leftOut);
        return onReflector.found ? onReflector : inScene;
    };

    Seen seen;
    seen.hit = nearest(eye, direction, near, none);
    if (!seen.hit.found) {
        return seen;
    }
    if (seen.hit.reflector == none) {
        seen.kind = SeenKind::scene;
        return seen;
    }
    seen.kind = SeenKind::reflector;
    const glm::dvec3 toEye = -glm::normalize(direction);
    const glm::dvec3& normal = seen.hit.normal;
    seen.mirrorDirection = 2.0 * glm::dot(normal, toEye) * normal - toEye;
    seen.mirrored = nearest(seen.hit.position, seen.mirrorDirection, 0.0, seen.hit.reflector);
    return seen;
}

glm::vec3 ReferenceTracer::shade(const Hit& hit, const glm::dvec3& eye, const glm::dvec3& lightInWorld) const
{
    if (!hit.found) {
        return scene_->background;
    }
    const Material& material = hit.reflector >= 0
                                   ? reflectors_[static_cast<std::size_t>(hit.reflector)].reflector->material
                                   : scene_->materials[static_cast<std::size_t>(hit.material)];
    const glm::dvec3 diffuse(hit.colour);
    const glm::dvec3 toEye = glm::normalize(eye - hit.position);
    const glm::dvec3 toLight = glm::normalize(lightInWorld - hit.position);
    const glm::dvec3 normal = glm::dot(hit.normal, toEye) < 0.0 ? -hit.normal : hit.normal;
    const double lambert = glm::dot(normal, toLight);
    glm::dvec3 colour = static_cast<double>(ambient) * diffuse;
    if (lambert > 0.0) {
        const glm::dvec3 mirroredLight = 2.0 * lambert * normal - toLight;
        const double highlight = std::fmax(glm::dot(mirroredLight, toEye), 0.0);
        colour += lambert * diffuse + std::pow(highlight, static_cast<double>(material.shininess)) *
                                          glm::dvec3(material.specular);
    }
    return glm::vec3(colour);
}

void forEachRow(int rows, const std::function<void(int)>& work)
{
    std::atomic<int> next = 0;
    std::mutex mutex;
    std::exception_ptr problem;
    const auto run = [&] {
        try {
            for (int row = next++; row < rows; row = next++) {
                work(row);
            }
        } catch (...) {
            next = rows;
            const std::lock_guard lock(mutex);
            problem = problem ? problem : std::current_exception();
        }
    };
    std::vector<std::jthread> helpers(std::max(std::thread::hardware_concurrency(), 1u) - 1);
    for (std::jthread& helper : helpers) {
        helper = std::jthread(run);
    }
    run();
    helpers.clear();
    if (problem) {
        std::rethrow_exception(problem);
    }
}

} // namespace examples
