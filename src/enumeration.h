// A host may hand over numbers that an enumeration has no name for, read from a file or cast.
#pragma once

#include <mirrorball/error.h>

#include <string>

namespace mirrorball {

// Throws Error badArgument for a value that is none from the first, 0, to `last`.
template <class Enumeration>
void requireOneOf(Enumeration value, Enumeration last, const char* asked, const char* type)
{
    if (static_cast<int>(value) < 0 || value > last)
        throw Error(ErrorKind::badArgument, asked,
                    "there is none of the number " + std::to_string(static_cast<int>(value)),
                    std::string("take one of ") + type + "'s");
}

} // namespace mirrorball
