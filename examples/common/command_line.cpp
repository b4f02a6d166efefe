#include "command_line.h"

#include <mirrorball/error.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace examples {

namespace {

constexpr int failed = 1;
constexpr int misused = 2;

// One line, whatever the message holds.
int report(const CLI::App& app, std::string message, int status)
{
    for (char& c : message)
        if (c == '\n' || c == '\r')
            c = ' ';
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), message.c_str());
    return status;
}

std::string spelled(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

// What strtod and strtol would pass over.
bool startsBlank(const std::string& text)
{
    return text.empty() || std::isspace(static_cast<unsigned char>(text[0])) != 0;
}

glm::dvec3 parseVector(const std::string& text, const std::string& option)
{
    glm::dvec3 vector;
    std::istringstream parts(text + ",");
    std::string part;
    int count = 0;
    for (; std::getline(parts, part, ','); ++count)
        if (count < 3)
            vector[count] = parseNumber(part, option);
    if (count != 3)
        throw CLI::ConversionError(option + ": '" + text + "' is not a vector x,y,z");
    return vector;
}

int parseInteger(const std::string& text, const std::string& option)
{
    char* end = nullptr;
    const long number = std::strtol(text.c_str(), &end, 10);
    if (startsBlank(text) || *end != '\0' || number != static_cast<int>(number))
        throw CLI::ConversionError(option + ": '" + text + "' is not an integer of 32 bits");
    return static_cast<int>(number);
}

// Which of the known names the word is.
std::size_t indexOf(const std::string& word, const std::vector<std::string>& known, const std::string& option)
{
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end())
        throw CLI::ConversionError(option + ": '" + word + "' is unknown; it is one of " + joined(known));
    return static_cast<std::size_t>(found - known.begin());
}

// An option with one value.
CLI::Option* add(CLI::App& app, const std::string& name, const std::function<void(const std::string&)>& parse,
                 const std::string& type, const std::string& description)
{
    return app.add_option_function<std::string>(name, parse, description)->type_name(type);
}

std::string withDefault(const std::string& description, const std::string& otherwise)
{
    return description + " (default: " + otherwise + ")";
}

} // namespace

int runProgram(const std::string& name, const std::string& description, int argc, char** argv,
               const AddOptions& addOptions, const std::function<void()>& body)
{
    CLI::App app(description, name);
    try {
        addOptions(app);
        app.parse(argc, argv);
        body();
        return 0;
    } catch (const CLI::Success& success) {
        return app.exit(success); // --help
    } catch (const CLI::ParseError& error) {
        return report(app, error.what(), misused);
    } catch (const mirrorball::Error& error) {
        return report(app, error.what(),
                      error.kind() == mirrorball::ErrorKind::unknownName ? misused : failed);
    } catch (const std::bad_alloc&) {
        return report(app, "out of memory", failed);
    } catch (const std::exception& error) {
        return report(app, error.what(), failed);
    }
}

void parseWords(const std::vector<std::string>& words, const AddOptions& addOptions)
{
    CLI::App app;
    addOptions(app);
    std::vector<std::string> reversed(words.rbegin(), words.rend()); // as CLI11 takes them
    app.parse(reversed);
}

CLI::Option* addVector(CLI::App& app, const std::string& name, glm::dvec3& value,
                       const std::string& description)
{
    const auto parse = [&value, name](const std::string& text) { value = parseVector(text, name); };
    return add(app, name, parse, "x,y,z", description)
        ->default_str(spelled(value.x) + "," + spelled(value.y) + "," + spelled(value.z));
}

CLI::Option* addSize(CLI::App& app, const std::string& name, glm::ivec2& value,
                     const std::string& description)
{
    const auto parse = [&value, name](const std::string& text) {
        int width = 0, height = 0;
        char after = 0;
        if (startsBlank(text) || std::sscanf(text.c_str(), "%9dx%9d%c", &width, &height, &after) != 2)
            throw CLI::ConversionError(name + ": '" + text + "' is not a size WxH");
        value = {width, height};
    };
    return add(app, name, parse, "WxH", description)
        ->default_str(std::to_string(value.x) + "x" + std::to_string(value.y));
}

CLI::Option* addNumber(CLI::App& app, const std::string& name, double& value, const std::string& description)
{
    const auto parse = [&value, name](const std::string& text) { value = parseNumber(text, name); };
    return add(app, name, parse, "NUMBER", description)->default_str(spelled(value));
}

CLI::Option* addInteger(CLI::App& app, const std::string& name, int& value, const std::string& description)
{
    const auto parse = [&value, name](const std::string& text) { value = parseInteger(text, name); };
    return add(app, name, parse, "INTEGER", description)->default_str(std::to_string(value));
}

CLI::Option* addMap(CLI::App& app, mirrorball::MapKind& value)
{
    std::vector<std::pair<std::string, mirrorball::MapKind>> known;
    for (const mirrorball::MapInfo& info : mirrorball::maps())
        known.emplace_back(info.name, info.kind);
    return addChoice(app, "--map", value, known, "the map");
}

CLI::Option* addOptionalVector(CLI::App& app, const std::string& name, std::optional<glm::dvec3>& value,
                               const std::string& description, const std::string& otherwise)
{
    const auto parse = [&value, name](const std::string& text) { value = parseVector(text, name); };
    return add(app, name, parse, "x,y,z", withDefault(description, otherwise));
}

CLI::Option* addOptionalNumber(CLI::App& app, const std::string& name, std::optional<double>& value,
                               const std::string& description, const std::string& otherwise)
{
    const auto parse = [&value, name](const std::string& text) { value = parseNumber(text, name); };
    return add(app, name, parse, "NUMBER", withDefault(description, otherwise));
}

CLI::Option* addOptionalInteger(CLI::App& app, const std::string& name, std::optional<int>& value,
                                const std::string& description, const std::string& otherwise)
{
    const auto parse = [&value, name](const std::string& text) { value = parseInteger(text, name); };
    return add(app, name, parse, "INTEGER", withDefault(description, otherwise));
}

CLI::Option* addIntegers(CLI::App& app, const std::string& name, std::vector<int>& values,
                         const std::string& description, const std::string& otherwise)
{
    const auto parse = [&values, name](const std::vector<std::string>& words) {
        for (const std::string& word : words)
            values.push_back(parseInteger(word, name));
    };
    const std::string whole = withDefault(description + ", once for each", otherwise);
    return app.add_option_function<std::vector<std::string>>(name, parse, whole)
        ->type_name("INTEGER")
        ->allow_extra_args(false);
}

CLI::Option* addFlag(CLI::App& app, const std::string& name, bool& value, const std::string& description)
{
    return app.add_flag(name, value, description);
}

std::string notAnOption(const std::string& text)
{
    return text.starts_with('-') ? "it needs a value, and '" + text + "' looks like an option" : "";
}

CLI::Option* addText(CLI::App& app, const std::string& name, std::string& value, const std::string& type,
                     const std::string& description)
{
    return app.add_option(name, value, description)->type_name(type)->check(notAnOption);
}

CLI::Option* addRequiredText(CLI::App& app, const std::string& name, std::string& value,
                             const std::string& type, const std::string& description)
{
    return addText(app, name, value, type, description)->required();
}

CLI::Option* addTexts(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                      const std::string& type, const std::string& description)
{
    return app.add_option(name, values, description + ", once for each")
        ->type_name(type)
        ->check(notAnOption)
        ->allow_extra_args(false);
}

CLI::Option* addName(CLI::App& app, const std::string& name, const std::vector<std::string>& known,
                     const std::string& current, const Chosen& chosen, const std::string& description)
{
    const auto parse = [known, chosen, name](const std::string& word) { chosen(indexOf(word, known, name)); };
    return add(app, name, parse, "TEXT", description + ": " + joined(known))->default_str(current);
}

CLI::Option* addNames(CLI::App& app, const std::string& name, const std::vector<std::string>& known,
                      const Chosen& chosen, const std::string& description)
{
    const auto parse = [known, chosen, name](const std::vector<std::string>& words) {
        for (const std::string& word : words)
            chosen(indexOf(word, known, name));
    };
    const std::string whole = description + ", once for each: " + joined(known);
    return app.add_option_function<std::vector<std::string>>(name, parse, whole)
        ->default_str("all")
        ->allow_extra_args(false);
}

void refuseOptions(CLI::App& app, const std::vector<std::string>& names)
{
    for (const std::string& name : names) {
        const auto refuse = [name](const std::string&) {
            throw CLI::ConversionError(name + " is not in this version");
        };
        app.add_option_function<std::string>(name, refuse)->group("")->trigger_on_parse();
    }
}

double parseNumber(const std::string& text, const std::string& option)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (startsBlank(text) || end != text.c_str() + text.size())
        throw CLI::ConversionError(option + ": '" + text + "' is not a number");
    return value;
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t index = 0; index < words.size(); ++index)
        text += (index == 0 ? "" : index + 1 == words.size() ? " and " : ", ") + words[index];
    return text;
}

} // namespace examples
