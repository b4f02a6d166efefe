#include "gl_reflector.h"

#include "phong_shaders.h"
#include "shapes.h"

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>

namespace examples {

namespace {

constexpr int probeUnit = 1; // unit 0 is the scene's image

Scene sceneOf(const Reflector& reflector, Mesh mesh)
{
    Scene scene;
    scene.offset = reflector.at;
    scene.materials = {reflector.material};
    scene.materials[0].image = -1;
    mesh.material = 0;
    scene.meshes.push_back(std::move(mesh));
    return scene;
}

Mesh scaled(Mesh mesh, double scale)
{
    for (glm::vec3& position : mesh.positions)
        position = glm::vec3(scale * glm::dvec3(position));
    return mesh;
}

Mesh boxAround(double radius)
{
    Mesh box = meshOf("box", 0);
    // A little larger than the sphere, so that rounding cuts nothing off it.
    const glm::vec3 corner(static_cast<float>(1.001 * radius));
    appendBox(box, -corner, corner);
    return box;
}

std::string fragmentSource(const Reflector& reflector, View view, const std::string& lookUps)
{
    const bool isSphere = reflector.radius > 0.0;
    return fragmentPrelude(view) + lookUps + std::string(shaders::mirror) +
           std::string(isSphere ? shaders::sphereMirrorFrag : shaders::meshMirrorFrag);
}

} // namespace

GlMirror::GlMirror(const Reflector& reflector, const glm::dvec3& origin, View view,
                   const std::string& lookUps)
    : centre_(reflector.at - origin), radius_(reflector.radius),
      plain_(sceneOf(reflector, scaled(reflector.mesh, reflector.scale)), origin),
      program_(linkProgram(phongVertexSource(), fragmentSource(reflector, view, lookUps)))
{
    if (radius_ > 0.0)
        box_.emplace(sceneOf(reflector, boxAround(radius_)), origin);
}

void GlMirror::draw(const PictureView& view, int number) const
{
    const auto location = [&](const char* name) { return glGetUniformLocation(program(), name); };
    glUseProgram(program());
    glUniformMatrix4fv(location("clipFromWorld"), 1, GL_FALSE, glm::value_ptr(view.clipFromWorld));
    glUniformMatrix3fv(location("rayFromPixel"), 1, GL_FALSE, glm::value_ptr(view.rayFromPixel));
    glUniform2fv(location("depthFromClip"), 1, glm::value_ptr(view.depthFromClip));
    glUniform3fv(location("centreInWorld"), 1, glm::value_ptr(glm::vec3(centre_)));
    glUniform3fv(location("eyeFromCentre"), 1, glm::value_ptr(glm::vec3(view.eye - centre_)));
    glUniform1f(location("radius"), static_cast<float>(radius_));
    glUniform1f(location("reflector"), static_cast<float>(number));
    // Of the box around a sphere only the far side is drawn: once a pixel, and also from within the box.
    (box_ ? glEnable : glDisable)(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    (box_ ? *box_ : plain_).drawAll(program(), view.phong);
    glDisable(GL_CULL_FACE);
    glCullFace(GL_BACK);
}

GlReflector::GlReflector(const Reflector& reflector, const glm::dvec3& origin, View view,
                         const mirrorball::ReflectionMaterial& material)
    : mirror_(reflector, origin, view, mirrorball::reflectionGlsl(material)),
      binding_(mirror_.program(), probeUnit)
{
}

void GlReflector::draw(const PictureView& view, int number, const mirrorball::ReflectionMap& map,
                       const mirrorball::MaterialSettings& settings) const
{
    glUseProgram(mirror_.program());
    const auto bound = binding_.bind(map, settings);
    mirror_.draw(view, number);
}

} // namespace examples
