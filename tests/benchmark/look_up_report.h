// The part of the summary that is about look-ups.
#pragma once

#include "results.h"

#include <iosfwd>
#include <span>
#include <vector>

namespace tests::benchmark {

void writeLookUps(std::ostream& out, const std::vector<LookUpRow>& rows);

// Of one scene, by cost: no other is both cheaper and no worse in mean angle.
std::vector<const LookUpRow*> paretoFront(std::span<const LookUpRow> scene);

} // namespace tests::benchmark
