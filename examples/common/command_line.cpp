#include "command_line.h"

#include <mirrorball/error.h>

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

} // namespace

int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& body)
{
    try {
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

double parseNumber(const std::string& text, const std::string& option)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool blank = text.empty() || std::isspace(static_cast<unsigned char>(text[0])) != 0;
    if (blank || end != text.c_str() + text.size())
        throw CLI::ConversionError(option + ": '" + text + "' is not a number");
    return value;
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

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t index = 0; index < words.size(); ++index)
        text += (index == 0 ? "" : index + 1 == words.size() ? " and " : ", ") + words[index];
    return text;
}

CLI::Option* addVector(CLI::App& app, const std::string& name, glm::dvec3& value,
                       const std::string& description)
{
    return app
        .add_option_function<std::string>(
            name, [&value, name](const std::string& text) { value = parseVector(text, name); }, description)
        ->type_name("x,y,z")
        ->default_str(spelled(value.x) + "," + spelled(value.y) + "," + spelled(value.z));
}

CLI::Option* addSize(CLI::App& app, const std::string& name, glm::ivec2& value,
                     const std::string& description)
{
    const auto parse = [&value, name](const std::string& text) {
        int width = 0, height = 0;
        char after = 0;
        if (std::sscanf(text.c_str(), "%9dx%9d%c", &width, &height, &after) != 2)
            throw CLI::ConversionError(name + ": '" + text + "' is not a size WxH");
        value = {width, height};
    };
    return app.add_option_function<std::string>(name, parse, description)
        ->type_name("WxH")
        ->default_str(std::to_string(value.x) + "x" + std::to_string(value.y));
}

CLI::Option* addNumber(CLI::App& app, const std::string& name, double& value, const std::string& description)
{
    return app
        .add_option_function<std::string>(
            name, [&value, name](const std::string& text) { value = parseNumber(text, name); }, description)
        ->type_name("NUMBER")
        ->default_str(spelled(value));
}

CLI::Option* addInteger(CLI::App& app, const std::string& name, int& value, const std::string& description)
{
    const auto parse = [&value, name](const std::string& text) {
        char* end = nullptr;
        const long number = std::strtol(text.c_str(), &end, 10);
        if (text.empty() || *end != '\0' || number != static_cast<int>(number))
            throw CLI::ConversionError(name + ": '" + text + "' is not an integer of 32 bits");
        value = static_cast<int>(number);
    };
    return app.add_option_function<std::string>(name, parse, description)
        ->type_name("INTEGER")
        ->default_str(std::to_string(value));
}

CLI::Option* addMap(CLI::App& app, mirrorball::MapKind& value)
{
    std::vector<std::pair<std::string, mirrorball::MapKind>> known;
    for (const mirrorball::MapInfo& info : mirrorball::maps())
        known.emplace_back(info.name, info.kind);
    return addChoice(app, "--map", value, known, "the map");
}

} // namespace examples
