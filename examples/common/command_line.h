// What the command lines of the programs have in common: exit statuses, vectors, sizes, names from lists.
//
// Exit status 2: an unknown option or name, or a value that does not parse. 1: parsed, but not allowed or
// failed. Either way one line on stderr. Numbers are decimal or C hex floats.
#pragma once

#include <mirrorball/maps/maps.h>

#include <CLI/CLI.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>

namespace examples {

// Parses, then runs the body, and turns what is thrown into the exit status and the line on stderr.
int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& body);

// Options with a value "x,y,z", "WxH", a number, or a map's name; each shows its default in --help.
CLI::Option* addVector(CLI::App& app, const std::string& name, glm::dvec3& value,
                       const std::string& description);
CLI::Option* addSize(CLI::App& app, const std::string& name, glm::ivec2& value,
                     const std::string& description);
CLI::Option* addNumber(CLI::App& app, const std::string& name, double& value, const std::string& description);
CLI::Option* addInteger(CLI::App& app, const std::string& name, int& value, const std::string& description);
CLI::Option* addMap(CLI::App& app, mirrorball::MapKind& value);

// An option whose value must be one of the names; known[i].second is stored.
template <class Value>
CLI::Option* addChoice(CLI::App& app, const std::string& name, Value& value,
                       const std::vector<std::pair<std::string, Value>>& known,
                       const std::string& description);

// The number that all of the text spells, decimal or hex float; throws CLI::ConversionError.
double parseNumber(const std::string& text, const std::string& option);
glm::dvec3 parseVector(const std::string& text, const std::string& option);

// "a, b and c", for messages that list names.
std::string joined(const std::vector<std::string>& words);

template <class Value>
CLI::Option* addChoice(CLI::App& app, const std::string& name, Value& value,
                       const std::vector<std::pair<std::string, Value>>& known,
                       const std::string& description)
{
    std::vector<std::string> names;
    std::string current;
    for (const auto& [word, meaning] : known) {
        names.push_back(word);
        if (meaning == value)
            current = word;
    }
    const auto parse = [&value, known, names, name](const std::string& text) {
        for (const auto& [word, meaning] : known)
            if (word == text) {
                value = meaning;
                return;
            }
        throw CLI::ConversionError(name + ": '" + text + "' is unknown; it is one of " + joined(names));
    };
    return app.add_option_function<std::string>(name, parse, description + ": " + joined(names))
        ->default_str(current);
}

} // namespace examples
