#include "findings.h"

#include <algorithm>
#include <functional>

namespace tests::benchmark {

namespace {

using mirrorball::MapKind;
using Rows = std::vector<const Row*>;

// Rows stand group after group.
std::vector<Rows> groupsOf(const std::vector<Row>& rows)
{
    std::vector<Rows> groups;
    for (const Row& row : rows) {
        if (groups.empty() || !isSameGroup(groups.back().front()->group, row.group))
            groups.emplace_back();
        groups.back().push_back(&row);
    }
    return groups;
}

// By the ratio, which rows of other runs have to their own cubes.
const Row* cheapest(const Rows& rows, const std::function<bool(const Row&)>& counts)
{
    const Row* best = nullptr;
    for (const Row* row : rows)
        if (counts(*row) && (best == nullptr || row->costRatioToBest < best->costRatioToBest))
            best = row;
    return best;
}

bool isTennisBall(const Row& row)
{
    return row.entry.map == MapKind::tennisBall || row.entry.map == MapKind::tennisBallEven;
}

bool isMethod(const Row& row, std::string_view name)
{
    return !row.entry.rival && row.entry.methodName() == name;
}

std::string nameOf(const Group& group)
{
    return std::string(group.scene->name) +
           (group.cubeN == mainN ? "" : ", cube n = " + std::to_string(group.cubeN)) +
           (group.cullBackFaces ? ", back faces culled" : "");
}

const Row* automatic(const Rows& group, Sizing sizing, std::string_view method = "automatic")
{
    return cheapest(group, [=](const Row& row) {
        return isMethod(row, method) && isTennisBall(row) && row.entry.sizing == sizing;
    });
}

// At equal texels.
const Row* find(const Rows& group, std::string_view method, MapKind map = MapKind::tennisBall)
{
    return cheapest(group, [=](const Row& row) {
        return isMethod(row, method) && row.entry.map == map && row.entry.sizing == Sizing::equalTexels;
    });
}

std::optional<double> ratioToBest(const Row* row)
{
    return row != nullptr ? std::optional(row->costRatioToBest) : std::nullopt;
}

std::optional<double> quotient(const Row* row, const Row* to)
{
    if (row == nullptr || to == nullptr || row->run != to->run)
        return std::nullopt;
    return row->cost() / to->cost();
}

std::optional<double> fewerWrong(const Row* exact, const Row* tessellated)
{
    if (exact == nullptr || tessellated == nullptr || !(tessellated->errors->wrongPercent > 0.0))
        return std::nullopt;
    const double least =
        50.0 / static_cast<double>(exact->errors->texels); // none wrong counts as half a texel
    return tessellated->errors->wrongPercent / std::max(exact->errors->wrongPercent, least);
}

std::optional<double> vertexRuns(const Row* row)
{
    if (row == nullptr || !row->work.vertexShaderRuns)
        return std::nullopt;
    return static_cast<double>(*row->work.vertexShaderRuns) / static_cast<double>(row->sceneVertices);
}

constexpr AimInfo infos[aimCount] = {
    {"automatic tennis-ball / best cube, equal angle", 0.9, false},
    {"automatic tennis-ball / best cube, equal texels", 1.1, false},
    {"exact / tessellated", 1.0, false},
    {"wrong texels, tessellated / exact", 100.0, true},
    {"exact / perVertex", 2.0, false},
    {"vertex-shader runs a vertex, automatic", 1.15, false},
    {"the same, turned by cheapestPose", 1.15, false},
};

Aims aimsOfGroup(const Rows& group)
{
    const Row* const exact = find(group, "exact");
    const Row* const tessellated = find(group, "tessellated");
    // The aim is for this scene alone.
    const bool isCrowd = group.front()->group.scene->name == "crowd-200k";
    return {nameOf(group.front()->group),
            {ratioToBest(automatic(group, Sizing::equalAngle)),
             ratioToBest(automatic(group, Sizing::equalTexels)), quotient(exact, tessellated),
             fewerWrong(exact, tessellated),
             isCrowd ? quotient(exact, find(group, "perVertex")) : std::nullopt,
             vertexRuns(find(group, "automatic")), vertexRuns(find(group, "automatic-turned"))}};
}

// The groups that the aims are for: the first size of each scene.
std::vector<Rows> aimedAt(const std::vector<Row>& rows)
{
    std::vector<Rows> groups = groupsOf(rows);
    std::erase_if(groups, [&](const Rows& group) {
        const Group& of = group.front()->group;
        const auto first =
            std::ranges::find_if(rows, [&](const Row& row) { return row.group.scene == of.scene; });
        return of.cubeN != first->group.cubeN || of.isRivalCheck;
    });
    return groups;
}

} // namespace

std::vector<RivalCheck> rivalChecksOf(const std::vector<Row>& rows)
{
    std::vector<RivalCheck> checks;
    for (const Rows& group : groupsOf(rows)) {
        const Group& of = group.front()->group;
        if (!of.isRivalCheck)
            continue;
        const auto find = [&](Rival rival) {
            return cheapest(group, [=](const Row& row) { return row.entry.rival == rival; });
        };
        const Row *const plain = find(Rival::plain), *const culled = find(Rival::culled);
        if (plain == nullptr || culled == nullptr || plain->run != culled->run || !of.scene->culledOverPlain)
            continue; // of a report that something was taken out of
        const double longer = 1e6 * (plain->cost() - culled->cost());
        checks.push_back({std::string(of.scene->name), of.vertices, 1.0 / plain->costRatio(),
                          *of.scene->culledOverPlain,
                          longer / (static_cast<double>(plain->work.sent.triangles) -
                                    static_cast<double>(culled->work.sent.triangles))});
    }
    return checks;
}

std::span<const AimInfo, aimCount> aimInfos()
{
    return infos;
}

std::vector<Aims> aimsOf(const std::vector<Row>& rows)
{
    std::vector<Aims> aims;
    for (const Rows& group : aimedAt(rows)) {
        const Aims each = aimsOfGroup(group);
        if (std::ranges::any_of(each.measured, [](const auto& figure) { return figure.has_value(); }))
            aims.push_back(each);
    }
    return aims;
}

std::vector<Profile> profilesOf(const std::vector<Row>& rows)
{
    std::vector<Profile> profiles;
    for (const Rows& group : aimedAt(rows)) {
        const Aims aims = aimsOfGroup(group);
        const auto misses = [&](std::size_t aim) {
            return aims.measured[aim] && !infos[aim].isReached(*aims.measured[aim]);
        };
        if (!misses(0) && !misses(1))
            continue;
        Profile profile{aims.scene, {}};
        const auto add = [&](const char* what, const Row* row) {
            if (row != nullptr)
                profile.lines.push_back({what, row});
        };
        add("best cube by hand", cheapest(group, [](const Row& row) { return row.entry.rival.has_value(); }));
        add("the library's cube, automatic", find(group, "automatic", MapKind::cube));
        add("tennis-ball, perVertex, equal texels", find(group, "perVertex"));
        add("tennis-ball, automatic, equal texels", find(group, "automatic"));
        add("tennis-ball, exact, equal texels", find(group, "exact"));
        add("cheaper of both tennis-balls, automatic, equal angle", automatic(group, Sizing::equalAngle));
        add("the same, near first", automatic(group, Sizing::equalAngle, "automatic-near-first"));
        profiles.push_back(std::move(profile));
    }
    return profiles;
}

std::vector<Finding> findingsOf(const std::vector<Row>& rows)
{
    std::vector<Finding> findings;
    for (const Rows& group : groupsOf(rows)) {
        const double widest = group.front()->measures.worstDiagonal; // a rival's
        const Row* const best = cheapest(group, [&](const Row& row) {
            return !row.entry.rival && row.errors && row.errors->wrongPercent <= rightPercent &&
                   row.measures.worstDiagonal <= widest;
        });
        if (best != nullptr)
            findings.push_back({best});
    }
    return findings;
}

} // namespace tests::benchmark
