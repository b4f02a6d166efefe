// Numbers in messages.
#pragma once

#include <charconv>
#include <string>

namespace mirrorball {

// The shortest text that says which number it is, whatever the locale: "0.05", "1e-09", "nan".
template <class Number>
std::string numberText(Number number)
{
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

} // namespace mirrorball
