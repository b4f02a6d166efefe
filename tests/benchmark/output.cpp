#include "output.h"

#include "csv.h"
#include "plot.h"

#include <mirrorball/error.h>

#include <fstream>

namespace tests::benchmark {

namespace {

void requireWritten(bool isWritten, const std::filesystem::path& path)
{
    if (!isWritten)
        throw mirrorball::Error(mirrorball::ErrorKind::unwritable, "the report in '" + path.string() + "'",
                                "it cannot be written", "name a folder that can");
}

} // namespace

void makeFolder(const std::filesystem::path& folder)
{
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    requireWritten(!problem && std::filesystem::is_directory(folder), folder);
}

void writeFiles(const std::filesystem::path& folder, const std::vector<Row>& rows,
                const Circumstances& circumstances)
{
    const std::filesystem::path table = folder / "benchmark.csv", summary = folder / "README.md";
    std::ofstream csv(table);
    writeCsv(csv, rows);
    requireWritten(static_cast<bool>(csv.flush()), table);
    const std::vector<std::string> plots = writePlots(folder, rows);
    std::ofstream report(summary);
    writeReport(report, rows, circumstances, plots);
    requireWritten(static_cast<bool>(report.flush()), summary);
}

} // namespace tests::benchmark
