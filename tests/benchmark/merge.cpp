#include "merge.h"

#include "csv.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <tuple>

namespace tests::benchmark {

namespace {

// A contender, in the order of a plan: the size that aims are of before the others, what is made by hand before the
// library's.
auto contender(const Row& row)
{
    const Group& group = row.group;
    const Entry& entry = row.entry;
    return std::tuple(group.scene, group.isRivalCheck, group.cubeN != mainN, group.cubeN, group.cullBackFaces,
                      group.vertices, !entry.rival, entry.rival, entry.map, entry.method, entry.sizing);
}

auto contender(const LookUpRow& row)
{
    const MirrorEntry& entry = row.entry;
    return std::tuple(row.scene, row.cubeN != mainN, row.cubeN, !entry.isByHand, entry.map, entry.lookup,
                      entry.n != mainN, entry.n);
}

template <class RowType>
std::vector<RowType> mergedRows(std::vector<RowType> earlier, const std::vector<RowType>& later)
{
    // Of equal ones the later stands first, and is kept.
    earlier.insert(earlier.begin(), later.begin(), later.end());
    std::ranges::stable_sort(earlier, {}, [](const RowType& row) { return contender(row); });
    const auto isSame = [](const RowType& a, const RowType& b) { return contender(a) == contender(b); };
    earlier.erase(std::unique(earlier.begin(), earlier.end(), isSame), earlier.end());
    return earlier;
}

template <class Rows>
void read(const std::filesystem::path& path, Rows (*readRows)(std::istream&, const std::string&), Rows& rows)
{
    if (!std::filesystem::exists(path))
        return;
    std::ifstream file(path);
    if (!file)
        throw mirrorball::Error(mirrorball::ErrorKind::notFound, "'" + path.string() + "'",
                                "it cannot be read", "name the folder of an earlier report");
    rows = readRows(file, path.string());
}

} // namespace

Results merged(Results earlier, const Results& later)
{
    return {mergedRows(std::move(earlier.captures), later.captures),
            mergedRows(std::move(earlier.lookUps), later.lookUps)};
}

Results readReports(const std::vector<std::string>& folders)
{
    Results results;
    for (const std::filesystem::path folder : folders) {
        Results each;
        read(folder / "benchmark.csv", readCaptures, each.captures);
        read(folder / "look_ups.csv", readLookUps, each.lookUps);
        if (each.captures.empty() && each.lookUps.empty())
            throw mirrorball::Error(mirrorball::ErrorKind::notFound, "a report in '" + folder.string() + "'",
                                    "it has neither a benchmark.csv nor a look_ups.csv with rows",
                                    "name the folder of an earlier report");
        results = merged(std::move(results), each);
    }
    return results;
}

} // namespace tests::benchmark
