#include "csv_table.h"

#include <charconv>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace tests::benchmark {

namespace {

template <class Number>
void parseNumber(const std::string& text, Number& value)
{
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem != std::errc() || stop != end)
        throw BadCell{"'" + text + "' is not a number of its kind"};
}

} // namespace

std::string spelled(double value)
{
    std::ostringstream out;
    out << std::setprecision(6) << value;
    return out.str();
}

std::string spelled(int value)
{
    return std::to_string(value);
}

std::string spelled(std::size_t value)
{
    return std::to_string(value);
}

std::string spelled(bool value)
{
    return value ? "1" : "0";
}

std::string inQuotes(std::string_view text)
{
    return "\"" + std::string(text) + "\"";
}

std::string spelled(const std::string& text)
{
    return inQuotes(text);
}

void parse(const std::string& text, double& value)
{
    parseNumber(text, value);
    if (!std::isfinite(value))
        throw BadCell{"'" + text + "' is not finite"};
}

void parse(const std::string& text, int& value)
{
    parseNumber(text, value);
}

void parse(const std::string& text, std::size_t& value)
{
    parseNumber(text, value);
}

bool isFirst(const std::string& text, std::string_view first, std::string_view second)
{
    if (text != first && text != second)
        throw BadCell{"'" + text + "' is neither '" + std::string(first) + "' nor '" + std::string(second) +
                      "'"};
    return text == first;
}

void parse(const std::string& text, bool& value)
{
    value = isFirst(text, "1", "0");
}

void parse(const std::string& text, std::string& value)
{
    value = text;
}

std::vector<std::string> cellsOf(const std::string& line)
{
    std::vector<std::string> cells(1);
    bool isQuoted = false; // where a comma does not end a cell
    for (const char letter : line)
        if (letter == '"')
            isQuoted = !isQuoted;
        else if (letter == ',' && !isQuoted)
            cells.emplace_back();
        else
            cells.back() += letter;
    if (isQuoted)
        throw BadCell{"a quotation mark is not closed"};
    return cells;
}

} // namespace tests::benchmark
