// The maps once more, as the table in docs/maps.md states them, in 1280 bits and without a thought for
// rounding. Shares nothing with the library but the list of names.
#pragma once

#include "maps/exact.h"

#include <mirrorball/maps/maps.h>

#include <array>

namespace tests {

// Of a map, the component that owns (x, y, z), not all zero.
int exactComponent(mirrorball::MapKind map, const std::array<Exact, 3>& d);

// How far (x, y, z) / |(x, y, z)| is from changing its component: the smallest of the quantities compared.
double distanceFromBorder(mirrorball::MapKind map, const std::array<Exact, 3>& d);

// (u, v) in a component.
std::array<Exact, 2> exactSquare(mirrorball::MapKind map, int component, const std::array<Exact, 3>& d);

} // namespace tests
