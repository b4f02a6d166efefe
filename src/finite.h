// Numbers that a host hands over, where NaN or infinity would spread over a picture.
#pragma once

#include <mirrorball/error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace mirrorball {

// The components of a glm vector or matrix, from glm::value_ptr, or one number. Throws Error badArgument.
template <class Number>
void requireFinite(const Number* components, int count, const std::string& asked)
{
    if (!std::all_of(components, components + count, [](Number number) { return std::isfinite(number); }))
        throw Error(ErrorKind::badArgument, asked, "a component is not finite", "give finite numbers");
}

} // namespace mirrorball
