// Component headless: an OpenGL context without a window, a display server or a surface, through EGL, for
// programs and tests that draw into framebuffer objects only. Hosts with a context of their own need nothing
// of this.
#pragma once

#include <mirrorball/export.h>

#include <memory>
#include <string>

namespace mirrorball::headless {

// A context with no default framebuffer. Destroying it releases it; every object in it goes with it.
//
// Displays are tried in this order: Mesa's surfaceless platform, then each EGL device. With libglvnd,
// __EGL_VENDOR_LIBRARY_FILENAMES chooses the vendor where several are installed.
class MIRRORBALL_EXPORT Context
{
public:
    struct Desc
    {
        int major = 3; // at least this version; the newest that the driver has is made
        int minor = 3;
        bool debug = false;
        bool compatibility = false; // compatibility instead of core profile
        bool es = false;            // OpenGL ES, 2.0 to 3.2, instead of desktop OpenGL
    };

    // Makes the context and makes it current on the calling thread. Throws Error with nothing changed:
    // badArgument for a version that does not exist, noContext where there is no EGL driver, unsupported
    // where there is one but all that it offers is older than asked.
    Context();
    explicit Context(const Desc& desc);

    Context(Context&& other) noexcept;
    Context& operator=(Context&& other) noexcept;
    ~Context();

    // Makes it current on the calling thread. Throws Error, noContext, if it is current on another thread.
    // Precondition: not moved from; so for description().
    void makeCurrent() const;

    // Version, renderer and vendor as the driver spells them: "OpenGL 4.5 (Core Profile) Mesa 22.3.6,
    // llvmpipe, Mesa".
    const std::string& description() const;

private:
    struct State;
    std::unique_ptr<State> state;
};

} // namespace mirrorball::headless
