#include "stats.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>

namespace examples {

namespace {

double seconds(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        if (static_cast<unsigned char>(c) >= 0x20)
            result += c;
    }
    return result + "\"";
}

} // namespace

void Stats::add(const std::string& name, double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    entries_.emplace_back(name, std::isfinite(value) ? text : "null"); // JSON has no infinity
}

void Stats::add(const std::string& name, const std::string& value)
{
    entries_.emplace_back(name, quoted(value));
}

void Stats::write(const std::filesystem::path& path) const
{
    std::ofstream file(path);
    file << "{\n";
    for (std::size_t index = 0; index < entries_.size(); ++index)
        file << "  " << quoted(entries_[index].first) << ": " << entries_[index].second
             << (index + 1 < entries_.size() ? ",\n" : "\n");
    file << "}\n";
    if (!file.flush())
        throw mirrorball::Error(mirrorball::ErrorKind::unwritable, "statistics in '" + path.string() + "'",
                                "the file cannot be written", "name a place that can");
}

void requireApart(const std::filesystem::path& stats, const std::vector<std::filesystem::path>& others)
{
    std::error_code ignored;
    const std::filesystem::path asked = std::filesystem::weakly_canonical(stats, ignored);
    for (const std::filesystem::path& other : others)
        if (!stats.empty() && asked == std::filesystem::weakly_canonical(other, ignored))
            throw mirrorball::Error(mirrorball::ErrorKind::badArgument, "--stats " + stats.string(),
                                    "'" + other.string() + "' is written there", "name another file");
}

void writeWithStats(const Stats& stats, const std::filesystem::path& path,
                    const std::function<void()>& writeFiles)
{
    if (path.empty())
        return writeFiles();
    stats.write(path);
    try {
        writeFiles();
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        throw;
    }
}

Stopwatch::Stopwatch()
{
    glFinish();
    wallStart_ = seconds(CLOCK_MONOTONIC);
    cpuStart_ = seconds(CLOCK_PROCESS_CPUTIME_ID);
}

double Stopwatch::wallMilliseconds()
{
    glFinish();
    cpu_ = 1e3 * (seconds(CLOCK_PROCESS_CPUTIME_ID) - cpuStart_);
    return 1e3 * (seconds(CLOCK_MONOTONIC) - wallStart_);
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace examples
