// The report in Markdown: a summary that says what is won and lost, and a page for each scene.
#pragma once

#include "results.h"

#include <iosfwd>
#include <span>
#include <string>

namespace tests::benchmark {

// README.md
void writeReport(std::ostream& out, const Results& results, const Circumstances& circumstances);

// Of one scene: the plots and every table of pass 1.
void writeScene(std::ostream& out, std::span<const Row> scene);
std::string pageOf(std::span<const Row> scene); // that file's name

} // namespace tests::benchmark
