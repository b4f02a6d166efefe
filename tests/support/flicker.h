// How much a mirror's picture changes from frame to frame while the eye moves, drawn and traced: what a look-up adds to
// the change is flicker.
#pragma once

#include "draw.h"

#include <vector>

namespace tests {

// A step's change is the sum of |after - before| over the sRGB encoded channels of the pixels that show the reflector
// before and after, drawn and traced.
struct PathChanges
{
    std::vector<double> drawn, traced; // one a step
};

// `steps` steps out of a full turn of `stepsATurn` around the first reflector, from the eye on and at its height.
// Options are as on render's command line.
PathChanges changesAround(const render::Options& options, int steps, int stepsATurn);

// How many times as much the drawn picture changes as the traced one, in the worst window of so many steps in a row.
double worstRatio(const PathChanges& changes, std::size_t window);

} // namespace tests
