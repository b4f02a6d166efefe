#include "trace.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace render {

namespace {

using namespace examples;

// The ray through the middle of a sample; x to the right and y downwards from the top left corner.
class Rays
{
public:
    explicit Rays(const Camera& camera)
        : forward_(glm::normalize(camera.look - camera.eye)),
          right_(glm::normalize(glm::cross(forward_, camera.up))), down_(glm::cross(forward_, right_)),
          // One sample's side on the plane at distance 1.
          side_(2.0 * std::tan(0.5 * camera.fovInRadians) / camera.samples.y), size_(camera.samples)
    {
    }

    glm::dvec3 through(int x, int y) const
    {
        return forward_ + (x + 0.5 - 0.5 * size_.x) * side_ * right_ +
               (y + 0.5 - 0.5 * size_.y) * side_ * down_;
    }

private:
    glm::dvec3 forward_, right_, down_;
    double side_;
    glm::ivec2 size_;
};

glm::vec3 mirroredColour(const Setup& setup, const ReferenceTracer& tracer, const Mirror& mirror,
                         const Seen& seen)
{
    if (!mirror.source)
        return tracer.shade(seen.mirrored, seen.hit.position, setup.light);
    const glm::dmat3 mapFromWorld = glm::transpose(glm::dmat3(mirror.worldFromProbe));
    return sourceColour(*mirror.source, mapFromWorld * seen.mirrorDirection);
}

Sample traced(const Setup& setup, const ReferenceTracer& tracer, const Seen& seen, View view)
{
    Sample sample = nothingSeen(view, setup.scene.background);
    if (seen.kind == SeenKind::background)
        return sample;
    sample.distance = static_cast<float>(seen.hit.distance);
    const bool isMirror = seen.kind == SeenKind::reflector;
    const Mirror* const mirror =
        isMirror ? &setup.mirrors[static_cast<std::size_t>(seen.hit.reflector)] : nullptr;
    if (view == View::position) {
        if (!isMirror)
            sample.colour = seen.hit.position;
        else if (!mirror->source)
            sample.colour = seen.mirrored.position; // NaN where nothing is mirrored
        return sample;
    }
    const glm::vec3 own = tracer.shade(seen.hit, setup.camera.eye, setup.light);
    sample.colour = glm::dvec3(own);
    if (isMirror)
        sample.colour = glm::dvec3(
            glm::mix(own, mirror->tint * mirroredColour(setup, tracer, *mirror, seen), mirror->blend));
    return sample;
}

} // namespace

Picture tracePicture(const Setup& setup, const Options& options)
{
    ReferenceTracer tracer(setup.scene, setup.camera.eye);
    for (const Mirror& mirror : setup.mirrors)
        tracer.add(mirror.reflector);
    const Rays rays(setup.camera);
    const glm::ivec2 size = setup.camera.samples;
    const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    Picture picture{size, std::vector<Sample>(count), std::vector<int>(count)};
    forEachRow(size.y, [&](int row) {
        for (int column = 0; column < size.x; ++column) {
            const Seen seen = tracer.look(setup.camera.eye, rays.through(column, row), 0.0,
                                          std::numeric_limits<double>::infinity());
            const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                                      static_cast<std::size_t>(column);
            picture.samples[index] = traced(setup, tracer, seen, options.view);
            picture.reflectors[index] = seen.kind == SeenKind::reflector ? seen.hit.reflector + 1 : 0;
        }
    });
    return picture;
}

} // namespace render
