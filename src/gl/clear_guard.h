// What would keep a clear from reaching all of a framebuffer with two colours is off while this lives: for clears amid the
// host's own draws, between which its state must stay.
#pragma once

#include <array>

namespace mirrorball::gl {

class ClearGuard
{
public:
    ClearGuard();
    ~ClearGuard();
    ClearGuard(const ClearGuard&) = delete;
    ClearGuard& operator=(const ClearGuard&) = delete;

private:
    std::array<std::array<unsigned char, 4>, 2> colourMasks_{};
    unsigned char depthMask_ = 1;
    bool scissorTest_ = false, rasterizerDiscard_ = false;
};

} // namespace mirrorball::gl
