#include "capture_options.h"

#include <mirrorball/error.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace examples {

using mirrorball::Error;
using mirrorball::ErrorKind;

std::vector<std::pair<std::string, mirrorball::CaptureMethod>> captureMethods()
{
    return {{"automatic", mirrorball::CaptureMethod::automatic},
            {"exact", mirrorball::CaptureMethod::exact},
            {"perVertex", mirrorball::CaptureMethod::perVertex},
            {"tessellated", mirrorball::CaptureMethod::tessellated}};
}

void addCaptureOptions(CLI::App& app, CaptureOptions& options)
{
    addRequiredText(app, "SCENE", options.scene, "TEXT",
                    "a model file, builtin:garden, builtin:room, builtin:cards or builtin:crowd:N");
    addVector(app, "--offset", options.offset, "moves everything, in double");
    addOptionalVector(app, "--light", options.light, "the point light", "the scene's own");
    addMap(app, options.map);
    addInteger(app, "--size", options.size, "texels across the short side of a component");
    addChoice(app, "--method", options.method, captureMethods(), "how triangles are drawn into the map");
    addNumber(app, "--epsilon", options.epsilon, "texels that automatic and tessellated may be off by");
    addFlag(app, "--near-first", options.nearFirst, "draw from near to far and leave out what is hidden");
    addNumber(app, "--far", options.far, "farthest radial distance from the probe");
    addInteger(app, "--frames", options.frames, "how often it is drawn; times are medians");
    addFlag(app, "--reference", options.reference, "trace with Embree instead of drawing");
    addText(app, "--stats", options.stats, "FILE", "writes counts and times as JSON");
}

void requireAllowed(const CaptureOptions& options)
{
    if (options.size < 1 || options.size > 16384)
        throw Error(ErrorKind::badArgument, "--size " + std::to_string(options.size),
                    "a map has 1 to 16384 texels across", "ask for a size in that range");
    if (options.frames < 1)
        throw Error(ErrorKind::badArgument, "--frames " + std::to_string(options.frames), "it is less than 1",
                    "give 1 or more");
    if (!(options.epsilon > 0.0) || !std::isfinite(options.epsilon))
        throw Error(ErrorKind::badArgument, "--epsilon", "it is not above 0", "give a number of texels");
    requireFinite(options.offset, "--offset");
    if (options.light)
        requireFinite(*options.light, "--light");
}

void requireRange(double near, double far)
{
    if (!(near > 0.0) || !std::isfinite(near) || !(far > near))
        throw Error(ErrorKind::badArgument, "--near and --far", "they are not 0 < near < far",
                    "give such numbers");
}

void requireFinite(const glm::dvec3& vector, const std::string& option)
{
    if (!std::isfinite(vector.x) || !std::isfinite(vector.y) || !std::isfinite(vector.z))
        throw Error(ErrorKind::badArgument, option, "a coordinate is not finite", "give finite numbers");
}

Scene sceneOf(const CaptureOptions& options)
{
    Scene scene = loadScene(options.scene);
    scene.offset = options.offset;
    return scene;
}

glm::dvec3 lightOf(const CaptureOptions& options, const Scene& scene)
{
    return options.light.value_or(glm::dvec3(scene.light)) + options.offset;
}

glm::dmat4 poseOf(const glm::dvec3& centreInWorld, const glm::dvec3& degrees)
{
    glm::dmat4 pose = glm::translate(glm::dmat4(1.0), centreInWorld);
    pose = glm::rotate(pose, glm::radians(degrees.z), {0, 0, 1});
    pose = glm::rotate(pose, glm::radians(degrees.y), {0, 1, 0});
    return glm::rotate(pose, glm::radians(degrees.x), {1, 0, 0});
}

} // namespace examples
