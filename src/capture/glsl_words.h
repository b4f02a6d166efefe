// The words of GLSL that the host's shaders are read and rewritten by, and the library's macros.
#pragma once

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <string_view>

namespace mirrorball::capture {

inline constexpr std::string_view interpolations[] = {"flat", "noperspective", "smooth"};
inline constexpr std::string_view auxiliaries[] = {"centroid", "sample"};
inline constexpr std::string_view otherQualifiers[] = {"invariant", "precise", "highp", "mediump",
                                                       "lowp",      "const",   "patch"};

template <class List>
bool contains(const List& list, std::string_view word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

inline bool isQualifier(std::string_view word)
{
    return word == "in" || word == "out" || contains(interpolations, word) || contains(auxiliaries, word) ||
           contains(otherQualifiers, word);
}

inline bool continuesIdentifier(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The word after the # of a preprocessor line.
inline std::string_view directiveName(std::string_view line)
{
    const std::size_t begin = line.find_first_not_of(" \t", 1);
    if (begin == std::string_view::npos)
        return {};
    std::size_t end = begin;
    while (end < line.size() && continuesIdentifier(line[end]))
        ++end;
    return line.substr(begin, end - begin);
}

// A line that defines one of the library's own macros.
inline std::string define(const std::string& name, const std::string& value)
{
    return "#define MIRRORBALL_" + name + " " + value + "\n";
}

inline std::string define(const std::string& name, bool value)
{
    return define(name, std::string(value ? "1" : "0"));
}

} // namespace mirrorball::capture
