// What the library throws. Every run-time failure (context, shader, framebuffer, file, argument) is an
// Error that says in one sentence what was asked, what was found and what to do; it is thrown before
// anything of the host's has changed. Broken preconditions assert instead.
#pragma once

#include <mirrorball/export.h>

#include <stdexcept>
#include <string>

namespace mirrorball {

enum class ErrorKind {
    unknownName, // a map, method or option that does not exist
    badArgument, // a value that is not allowed: size 0, NaN, near >= far, beyond the driver's limit
    notFound,    // a file that is not there, or not a regular file
    badFile,     // a file that is empty, broken or of an unsupported kind
    unwritable,  // an output that cannot be written
    noContext,   // no current OpenGL context, or none can be made
    unsupported, // the context is too old or lacks something
    badShader,   // a shader of the host's does not compile or link, or uses what capture cannot carry
    hostBusy,    // the host's state forbids the call now: active transform feedback, a call inside a call
};

class MIRRORBALL_EXPORT Error : public std::runtime_error
{
public:
    // One sentence, "asked: found; advice", each part without a full stop; advice may be empty.
    Error(ErrorKind kind, const std::string& asked, const std::string& found, const std::string& advice = {});

    ErrorKind kind() const noexcept { return kind_; }

private:
    ErrorKind kind_;
};

} // namespace mirrorball
