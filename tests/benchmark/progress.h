// How far the run is, on stderr: a bar with the time left on a terminal, otherwise a line for each tenth.
#pragma once

#include <chrono>
#include <string>

namespace tests::benchmark {

class Progress
{
public:
    explicit Progress(double steps);
    ~Progress(); // ends the line

    void label(const std::string& text) { label_ = text; }
    void advance(double steps);

private:
    void show();

    double steps_, done_ = 0.0;
    bool isTerminal_;
    int shownTenth_ = 0;
    std::string label_;
    std::chrono::steady_clock::time_point start_, shown_;
};

} // namespace tests::benchmark
