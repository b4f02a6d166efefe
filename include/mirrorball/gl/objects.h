// Move-only owners of OpenGL objects. What the library creates is owned by one of these; a name that a host
// puts into a Desc is borrowed and never deleted. No GL header is needed to use them: names are unsigned int.
//
// An owner deletes its object in whatever context is current. That is to be the one it was made in; for what OpenGL
// shares, all but framebuffers and vertex arrays, one that shares with it will do. With none current the name is
// dropped without a GL call: the context is gone, or the object lives on until it is.
#pragma once

#include <mirrorball/export.h>

#include <utility>

namespace mirrorball::gl {

enum class ObjectKind { texture, framebuffer, buffer, vertexArray, program, shader, sampler };

template <ObjectKind kind>
class Object
{
public:
    Object() noexcept = default;
    explicit Object(unsigned int name) noexcept : name_(name) {}
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0u)) {}
    Object& operator=(Object&& other) noexcept
    {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object() { destroy(name_); }

    unsigned int name() const noexcept { return name_; }
    explicit operator bool() const noexcept { return name_ != 0; }

    // A new object of this kind; a shader is made by compileShader instead.
    MIRRORBALL_EXPORT static Object create();

private:
    MIRRORBALL_EXPORT static void destroy(unsigned int name) noexcept;

    unsigned int name_ = 0;
};

using Texture = Object<ObjectKind::texture>;
using Framebuffer = Object<ObjectKind::framebuffer>;
using Buffer = Object<ObjectKind::buffer>;
using VertexArray = Object<ObjectKind::vertexArray>;
using Program = Object<ObjectKind::program>;
using Shader = Object<ObjectKind::shader>;
using Sampler = Object<ObjectKind::sampler>;

} // namespace mirrorball::gl
