// What the command lines of the programs have in common: exit statuses, vectors, sizes, names from lists.
//
// Exit status 2: an unknown option or name, or a value that does not parse. 1: parsed, but not allowed or
// failed. Either way one line on stderr. Numbers are decimal or C hex floats.
#pragma once

#include <mirrorball/maps/maps.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// CLI11's header takes long to compile: only what needs more of it than the functions below includes it.
namespace CLI {
class App;
class Option;
} // namespace CLI

namespace examples {

using AddOptions = std::function<void(CLI::App&)>;

// Parses, then runs the body, and turns what is thrown into the exit status and the line on stderr.
int runProgram(const std::string& name, const std::string& description, int argc, char** argv,
               const AddOptions& addOptions, const std::function<void()>& body);

// Parses the words that follow a program's name, or throws.
void parseWords(const std::vector<std::string>& words, const AddOptions& addOptions);

// Options with a value "x,y,z", "WxH", a number, or a map's name; each shows its default in --help.
CLI::Option* addVector(CLI::App& app, const std::string& name, glm::dvec3& value,
                       const std::string& description);
CLI::Option* addSize(CLI::App& app, const std::string& name, glm::ivec2& value,
                     const std::string& description);
CLI::Option* addNumber(CLI::App& app, const std::string& name, double& value, const std::string& description);
CLI::Option* addInteger(CLI::App& app, const std::string& name, int& value, const std::string& description);
CLI::Option* addMap(CLI::App& app, mirrorball::MapKind& value);

// Values that need not be given; `otherwise` says in --help what holds then.
CLI::Option* addOptionalVector(CLI::App& app, const std::string& name, std::optional<glm::dvec3>& value,
                               const std::string& description, const std::string& otherwise);
CLI::Option* addOptionalNumber(CLI::App& app, const std::string& name, std::optional<double>& value,
                               const std::string& description, const std::string& otherwise);
CLI::Option* addOptionalInteger(CLI::App& app, const std::string& name, std::optional<int>& value,
                                const std::string& description, const std::string& otherwise);

// Integers, the option once for each.
CLI::Option* addIntegers(CLI::App& app, const std::string& name, std::vector<int>& values,
                         const std::string& description, const std::string& otherwise);

CLI::Option* addFlag(CLI::App& app, const std::string& name, bool& value, const std::string& description);

// For CLI::Option::check of texts: else an option without its value would take the next option for it.
std::string notAnOption(const std::string& text);

// Any text; `type` stands for it in --help. A name without dashes is told by its place.
CLI::Option* addText(CLI::App& app, const std::string& name, std::string& value, const std::string& type,
                     const std::string& description);
CLI::Option* addRequiredText(CLI::App& app, const std::string& name, std::string& value,
                             const std::string& type, const std::string& description);
// Any texts, the option once for each.
CLI::Option* addTexts(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                      const std::string& type, const std::string& description);

// An option whose value must be one of the names; known[i].second is stored.
template <class Value>
CLI::Option* addChoice(CLI::App& app, const std::string& name, Value& value,
                       const std::vector<std::pair<std::string, Value>>& known,
                       const std::string& description);

// The same, once for each: values are appended. None given stands for all.
template <class Value>
CLI::Option* addChoices(CLI::App& app, const std::string& name, std::vector<Value>& values,
                        const std::vector<std::pair<std::string, Value>>& known,
                        const std::string& description);

// Options of later versions: each is refused by name, whatever its value.
void refuseOptions(CLI::App& app, const std::vector<std::string>& names);

// The number that all of the text spells, decimal or hex float; throws CLI::ConversionError.
double parseNumber(const std::string& text, const std::string& option);

// "a, b and c", for messages that list names.
std::string joined(const std::vector<std::string>& words);

// What the templates come down to: `chosen` is told the name's index.
using Chosen = std::function<void(std::size_t)>;
CLI::Option* addName(CLI::App& app, const std::string& name, const std::vector<std::string>& known,
                     const std::string& current, const Chosen& chosen, const std::string& description);
CLI::Option* addNames(CLI::App& app, const std::string& name, const std::vector<std::string>& known,
                      const Chosen& chosen, const std::string& description);

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
    const auto chosen = [&value, known](std::size_t index) { value = known[index].second; };
    return addName(app, name, names, current, chosen, description);
}

template <class Value>
CLI::Option* addChoices(CLI::App& app, const std::string& name, std::vector<Value>& values,
                        const std::vector<std::pair<std::string, Value>>& known,
                        const std::string& description)
{
    std::vector<std::string> names;
    for (const auto& [word, meaning] : known)
        names.push_back(word);
    const auto chosen = [&values, known](std::size_t index) { values.push_back(known[index].second); };
    return addNames(app, name, names, chosen, description);
}

} // namespace examples
