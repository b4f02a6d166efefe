// What two pictures differ by where both show the first reflector.
#pragma once

#include "picture.h"

namespace tests {

// sRGB, of [0, 1].
double encoded(double linear);

// Decibels, of the encoded colours.
double psnrOf(const render::Picture& drawn, const render::Picture& traced);

// The mean of FLIP; around the reflector the pictures are seen as they are.
double flipOf(const render::Picture& drawn, const render::Picture& traced);

} // namespace tests
