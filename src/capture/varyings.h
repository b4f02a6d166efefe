// What the host's vertex shader hands to its fragment shader, and how capture programs carry it past the
// geometry stage.
#pragma once

#include "capture/host_shader.h"

#include <mirrorball/maps/maps.h>

#include <span>
#include <string>
#include <vector>

namespace mirrorball::capture {

// Names of the library's in capture programs; another prefix than pass 2's, so that a reflective object can
// be drawn into another object's map with the snippet of pass 2 in its shader.
inline const std::string prefix = "mirrorballCapture_";
inline const std::string declarationMark = prefix + "declared"; // see HostShader::Changes::mark

// A varying that the fragment shader declares and the vertex shader writes: a variable, or a member of an
// interface block.
struct Varying
{
    std::size_t declaration; // which of the fragment shader's; its mark says whether it is compiled in
    std::string type;
    std::string name; // as the fragment shader calls it: "normal", or "surface.normal"
    std::string arraySuffix, interpolation, auxiliary;
    std::string vertexName;     // another one only where a layout location joins the two, or a block
    int elements = 1;           // of an array; 0 where the number is not known
    std::string block = {};     // of which it is a member; "" for none
    std::string blockBody = {}; // the vertex shader's members, for the first of a block only
    int member = 0;             // its number in the block
    std::string trouble = {};   // why it cannot be carried past another stage; "" where it can

    std::string statement() const { return block.empty() ? name : block; } // what declares it
};

std::vector<Varying> varyingsOf(const HostShader& vertex, const HostShader& fragment);

// The output that receives the colour, and all others: those are written to nowhere.
struct Outputs
{
    std::string colour;
    std::vector<std::string> others;
};

Outputs outputsOf(const HostShader& fragment);

// How varyings travel.
enum class Carriage {
    direct, // from the vertex stage to the fragment stage
    copied, // through a geometry shader, vertex by vertex
    exact   // all three vertices' at once, flat; interpolated in the fragment stage
};

// What the library's own varyings take beside the host's, in scalars, gl_Position, gl_Layer and gl_PrimitiveID included.
int ownScalars(Carriage carriage);

// Scalars that the geometry stage writes a vertex (that the vertex stage writes, for direct carriage).
int scalarsOf(std::span<const Varying> varyings, Carriage carriage);

// Throws Error badShader, which names the varying, where the driver has no room for one or it is of a type
// that cannot be carried. vertices: how many the geometry stage writes at least for one triangle.
void requireRoom(const std::vector<Varying>& varyings, Carriage carriage, int vertices,
                 const std::string& programName);

// Drivers may waste room: NVIDIA's lays a vec3 where a vec4 would go. Throws Error badShader with the host's name for the
// varying that a linker says it has no resource for, of packed ones for the last.
void requireNoneWithoutResource(const std::vector<Varying>& varyings, Carriage carriage,
                                const std::string& linkError, const std::string& programName);

// Whether the driver has room.
bool hasRoom(const std::vector<Varying>& varyings, Carriage carriage, int vertices);

// Declarations of the geometry stage and the function copyVaryings that hands on those of a corner (copied)
// or of all three (exact).
std::string geometryVaryings(const std::vector<Varying>& varyings, Carriage carriage);

// Declarations of the tessellation stages and their functions copyVaryings and mixVaryings.
std::string controlVaryings(const std::vector<Varying>& varyings);
std::string evaluationVaryings(const std::vector<Varying>& varyings);

// Declarations of the fragment stage behind a geometry stage and the function readVaryings, which sets the
// host's globals.
std::string fragmentVaryings(const std::vector<Varying>& varyings, Carriage carriage);

// The function fromCentre, which tells where a fragment of a mapped mesh lies from the probe's centre, in some frame:
// from a varying of the host's with the position relative to captureOrigin, or from the library's own (null).
std::string fragmentPosition(const Varying* position);

} // namespace mirrorball::capture
