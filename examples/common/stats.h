// The numbers of --stats: a flat JSON object, names with units, in the order they were added.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace examples {

class Stats
{
public:
    void add(const std::string& name, double value);
    void add(const std::string& name, const std::string& value);

    // Throws mirrorball::Error, unwritable.
    void write(const std::filesystem::path& path) const;

private:
    std::vector<std::pair<std::string, std::string>> entries_; // values as JSON spells them
};

// Throws Error badArgument where statistics would be written over another file of a program's.
void requireApart(const std::filesystem::path& stats, const std::vector<std::filesystem::path>& others);

// Writes the statistics (nowhere for an empty path) and then the other files: all of it or nothing.
void writeWithStats(const Stats& stats, const std::filesystem::path& path,
                    const std::function<void()>& writeFiles);

// Wall time and process CPU time (all threads) of a stretch of drawing, in milliseconds; glFinish bounds it
// on both sides, since GL timer queries are wrong on software rasterisers.
class Stopwatch
{
public:
    Stopwatch();
    double wallMilliseconds();
    double cpuMilliseconds() const { return cpu_; } // of the last wallMilliseconds call

private:
    double wallStart_, cpuStart_, cpu_ = 0.0;
};

double median(std::vector<double> values);

} // namespace examples
