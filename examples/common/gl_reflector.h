// A mirror on the GPU: a true sphere, computed in the pixel, or a mesh with interpolated normals. It shows
// its own Phong colour mixed with what the library's snippet reads from a map.
#pragma once

#include "gl_scene.h"
#include "reference.h"

#include <mirrorball/reflect/probe_binding.h>
#include <mirrorball/reflect/reflection_material.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <optional>
#include <string>

namespace examples {

// A view of the scene, everything relative to the origin that the GlScene was made with.
struct PictureView
{
    glm::mat4 clipFromWorld{1.0f};
    glm::mat3 rayFromPixel{1.0f};        // the direction through window coordinates (x, y, 1)
    glm::vec2 depthFromClip{1.0f, 0.0f}; // depth = x * z / w + y, by the clip control in force
    glm::dvec3 eye{0.0};
    PhongView phong;
};

// The reflector's surface, with any fragment shader that has the functions which shaders/mirror.glsl calls.
class GlMirror
{
public:
    // `lookUps` defines those functions.
    GlMirror(const Reflector& reflector, const glm::dvec3& origin, View view, const std::string& lookUps);

    unsigned int program() const { return program_.name(); }

    // Into a picture; `number`, from 1, goes to output 1. Precondition: what the functions read is bound.
    void draw(const PictureView& view, int number) const;

    // As a plain object, a sphere finely tessellated: how the other reflectors see it.
    const GlScene& plain() const { return plain_; }

private:
    glm::dvec3 centre_; // relative to the origin
    double radius_;
    GlScene plain_;
    std::optional<GlScene> box_; // around a sphere
    mirrorball::gl::Program program_;
};

// With the library's functions.
class GlReflector
{
public:
    // `material` says which map the reflector will be drawn with, and how it is looked up.
    GlReflector(const Reflector& reflector, const glm::dvec3& origin, View view,
                const mirrorball::ReflectionMaterial& material);

    void draw(const PictureView& view, int number, const mirrorball::ReflectionMap& map,
              const mirrorball::MaterialSettings& settings) const;
    const GlScene& plain() const { return mirror_.plain(); }

private:
    GlMirror mirror_;
    mirrorball::ProbeBinding binding_;
};

} // namespace examples
