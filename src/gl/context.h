// What the current context is, asked before anything is done with it.
#pragma once

#include <vector>

namespace mirrorball::gl {

// Whether a context is current on this thread, found out without a call that would crash if none is.
bool contextIsCurrent() noexcept;

// Throws Error unless a desktop context of at least 3.3 is current and it can be drawn with now (no transform
// feedback active).
void requireContext();

// A shortcut for glGetIntegerv: the value, or the first of several.
int integer(unsigned int name);

// What a context has. Asked once and kept: to look for one extension costs a call for each that the driver has.
struct Abilities
{
    bool viewportArrays, clipControl, pipelines, indexedBlend, patches, compatibility;
    int drawBuffers, viewports, sampleMaskWords;
    std::vector<unsigned int>
        switches; // capabilities that could mask, clip, blend or discard: our passes turn them off

    static Abilities ofCurrentContext();
};

} // namespace mirrorball::gl
