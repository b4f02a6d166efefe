// What the host's vertex shader hands to its fragment shader, and what that one writes.
#pragma once

#include "capture/host_shader.h"

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

// What stands before its type: "flat ", "noperspective centroid ".
std::string qualifiers(const Varying& varying);

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

} // namespace mirrorball::capture
