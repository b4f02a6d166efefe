// Comma-separated values: a list of columns, each of which spells a cell of a row and reads it again.
#pragma once

#include <mirrorball/error.h>

#include <algorithm>
#include <functional>
#include <istream>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tests::benchmark {

template <class RowType>
struct Column
{
    const char* name;
    std::function<std::string(const RowType&)> text;
    std::function<void(RowType&, const std::string&)> set; // what `text` gave
};

// What is wrong with a cell; its file and row are added where they are known.
struct BadCell
{
    std::string what;
};

// A cell's text, and back. Numbers have six digits and must be finite, counts are whole; texts are quoted, since some
// hold commas.
std::string inQuotes(std::string_view text);
std::string spelled(double value);
std::string spelled(int value);
std::string spelled(std::size_t value);
std::string spelled(bool value);
std::string spelled(const std::string& text);
void parse(const std::string& text, double& value);
void parse(const std::string& text, int& value);
void parse(const std::string& text, std::size_t& value);
void parse(const std::string& text, bool& value);
void parse(const std::string& text, std::string& value);

// Of the two that a text may be, whether it is the first.
bool isFirst(const std::string& text, std::string_view first, std::string_view second);

// Of a line, without the quotation marks.
std::vector<std::string> cellsOf(const std::string& line);

template <class Value>
std::string spelled(const std::optional<Value>& value)
{
    return value ? spelled(*value) : "";
}

template <class Value>
void parse(const std::string& text, std::optional<Value>& value)
{
    value.reset();
    if (!text.empty())
        parse(text, value.emplace());
}

// Which of a list has this name.
template <class List, class NameOf>
const auto& named(const List& list, const std::string& text, const char* what, NameOf nameOf)
{
    const auto found = std::ranges::find_if(list, [&](const auto& each) { return nameOf(each) == text; });
    if (found == std::end(list))
        throw BadCell{"'" + text + "' is no " + what + " of the benchmark's"};
    return *found;
}

// A cell that `reach`, given a row, refers to.
template <class RowType, class Reach>
Column<RowType> cell(const char* name, Reach reach)
{
    return {name, [=](const RowType& row) { return spelled(reach(row)); },
            [=](RowType& row, const std::string& text) { parse(text, reach(row)); }};
}

// One that follows from others.
template <class RowType>
Column<RowType> derived(const char* name, std::function<std::string(const RowType&)> text)
{
    return {name, std::move(text), [](RowType&, const std::string&) {}};
}

template <class RowType>
void writeTable(std::ostream& out, const std::vector<Column<RowType>>& columns,
                const std::vector<RowType>& rows)
{
    for (std::size_t index = 0; index < columns.size(); ++index)
        out << (index > 0 ? "," : "") << columns[index].name;
    out << '\n';
    for (const RowType& row : rows) {
        for (std::size_t index = 0; index < columns.size(); ++index)
            out << (index > 0 ? "," : "") << columns[index].text(row);
        out << '\n';
    }
}

template <class RowType>
RowType rowOf(const std::vector<std::string>& names, const std::vector<std::string>& cells,
              const std::vector<Column<RowType>>& columns)
{
    if (cells.size() != names.size())
        throw BadCell{"it has " + std::to_string(cells.size()) + " cells, and " +
                      std::to_string(names.size()) + " columns have names"};
    RowType row{};
    for (const Column<RowType>& column : columns) {
        const auto place = std::ranges::find(names, column.name) - names.begin();
        try {
            column.set(row, cells[static_cast<std::size_t>(place)]);
        } catch (const BadCell& bad) {
            throw BadCell{std::string(column.name) + ": " + bad.what};
        }
    }
    return row;
}

// `require` throws BadCell where no report can be made of a row's numbers. Throws mirrorball::Error, badFile.
template <class RowType>
std::vector<RowType> readTable(std::istream& in, const std::string& name,
                               const std::vector<Column<RowType>>& columns, void (*require)(const RowType&))
{
    std::vector<RowType> rows;
    std::size_t number = 1;
    try {
        std::string line;
        std::getline(in, line);
        const std::vector<std::string> names = cellsOf(line);
        for (const Column<RowType>& column : columns)
            if (std::ranges::count(names, column.name) != 1)
                throw BadCell{"'" + std::string(column.name) + "' does not name one column"};
        for (++number; std::getline(in, line); ++number) {
            rows.push_back(rowOf(names, cellsOf(line), columns));
            require(rows.back());
        }
    } catch (const BadCell& bad) {
        throw mirrorball::Error(mirrorball::ErrorKind::badFile, name + ", line " + std::to_string(number),
                                bad.what, "name a report that this version wrote");
    }
    return rows;
}

} // namespace tests::benchmark
