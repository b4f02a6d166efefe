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

inline std::string timesOf(const Quartiles& quartiles)
{
    return format("%.1f", quartiles.median) + " (" + format("%.1f", quartiles.lower) + "-" +
           format("%.1f", quartiles.upper) + ")";
}

} // namespace tests::benchmark
