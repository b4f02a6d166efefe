// The part of the summary that is about look-ups.
#pragma once

#include "look_up_run.h"

#include <iosfwd>
#include <vector>

namespace tests::benchmark {

void writeLookUps(std::ostream& out, const std::vector<LookUpRow>& rows);

// Of one scene, by cost: no other is both cheaper and no worse in mean angle.
std::vector<const LookUpRow*> paretoFront(const std::vector<const LookUpRow*>& rows);

} // namespace tests::benchmark
