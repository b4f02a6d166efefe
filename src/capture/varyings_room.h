// Whether a driver has room for the host's varyings.
#pragma once

#include "capture/varyings.h"

#include <span>
#include <string>
#include <vector>

namespace mirrorball::capture {

// What the library's own varyings take beside the host's, in scalars, gl_Position, gl_Layer and gl_PrimitiveID
// included.
int ownScalars(Carriage carriage);

// Scalars that the geometry stage writes a vertex (that the vertex stage writes, for direct carriage).
int scalarsOf(std::span<const Varying> varyings, Carriage carriage);

// Throws Error badShader, which names the varying, where the driver has no room for one or it is of a type
// that cannot be carried. vertices: how many the geometry stage writes at least for one triangle.
void requireRoom(const std::vector<Varying>& varyings, Carriage carriage, int vertices,
                 const std::string& programName);

// Drivers may waste room: NVIDIA's lays a vec3 where a vec4 would go. Throws Error badShader with the host's name for
// the varying that a linker says it has no resource for, of packed ones for the last.
void requireNoneWithoutResource(const std::vector<Varying>& varyings, Carriage carriage,
                                const std::string& linkError, const std::string& programName);

// Whether the driver has room.
bool hasRoom(const std::vector<Varying>& varyings, Carriage carriage, int vertices);

} // namespace mirrorball::capture
