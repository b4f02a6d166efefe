// What would keep a clear from reaching all of a framebuffer with two colours is off while this lives: for clears amid
// the host's own draws, between which its state must stay.
#pragma once

#include "gl/context.h"

#include <array>

namespace mirrorball::gl {

class ClearGuard
{
public:
    explicit ClearGuard(const Abilities& abilities); // of the current context; they outlive the guard
    ~ClearGuard();
    ClearGuard(const ClearGuard&) = delete;
    ClearGuard& operator=(const ClearGuard&) = delete;

private:
    void setScissorTest(bool enabled) const;

    const Abilities& abilities_;
    std::array<std::array<unsigned char, 4>, 2> colourMasks_{};
    unsigned char depthMask_ = 1;
    bool scissorTest_ = false, rasterizerDiscard_ = false;
};

} // namespace mirrorball::gl
