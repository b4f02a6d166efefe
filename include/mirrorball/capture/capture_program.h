// The host's own vertex and fragment shader, turned into programs that draw into a map.
//
// The host hands over the two shaders it draws its scene with. They stay as they are: the vertex shader
// transforms and hands varyings over, the fragment shader writes its colour. The library replaces what
// happens between the two: where the position goes on the map, and how varyings reach a texel. Line numbers
// in compile errors are the host's own.
//
// What is asked of them: #version 330 core or later; after the vertex shader's main, `position` is an
// expression of type vec3 that holds the position in world space (relative to Desc::captureOrigin of the
// probe); the colour is the fragment shader's output with location 0, or else its first. gl_Position as the host
// computes it is ignored, clip distances too.
#pragma once

#include <mirrorball/export.h>

#include <memory>
#include <string>

namespace mirrorball {

class MIRRORBALL_EXPORT CaptureProgram
{
public:
    struct Desc
    {
        std::string name = "capture program"; // for messages
        std::string vertexSource;
        std::string fragmentSource;
        std::string position = "positionInWorld"; // usually the name of a varying, as here
    };

    // Reads both sources; throws Error badShader for what capture cannot use. Programs are compiled when a
    // probe first needs them, one for every combination of map and method, and kept.
    explicit CaptureProgram(Desc desc);
    ~CaptureProgram();
    CaptureProgram(CaptureProgram&&) noexcept;
    CaptureProgram& operator=(CaptureProgram&&) noexcept;

    const Desc& desc() const;

    struct Implementation;
    Implementation& implementation() { return *implementation_; } // for the library's own use

private:
    std::unique_ptr<Implementation> implementation_;
};

} // namespace mirrorball
