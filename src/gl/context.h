// What the current context is, asked before anything is done with it.
#pragma once

namespace mirrorball::gl {

// Whether a context is current on this thread, found out without a call that would crash if none is.
bool contextIsCurrent() noexcept;

// Throws Error unless a desktop context of at least 3.3 is current and it can be drawn with now (no transform
// feedback active).
void requireContext();

// A shortcut for glGetIntegerv of one value.
int integer(unsigned int name);

} // namespace mirrorball::gl
