// Numbers as the tables show them.
#pragma once

#include "timing.h"

#include <cstdio>
#include <string>

namespace tests::benchmark {

inline std::string format(const char* pattern, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

inline std::string milliseconds(double value)
{
    return format(value < 10.0 ? "%.2f" : "%.1f", value);
}

inline std::string timesOf(const Quartiles& quartiles)
{
    return milliseconds(quartiles.median) + " (" + milliseconds(quartiles.lower) + "-" +
           milliseconds(quartiles.upper) + ")";
}

} // namespace tests::benchmark
