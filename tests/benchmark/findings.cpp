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

const Row* cheapest(const Rows& rows, const std::function<bool(const Row&)>& counts)
{
    const Row* best = nullptr;
    for (const Row* row : rows)
        if (counts(*row) && (best == nullptr || row->timing.cpu.median < best->timing.cpu.median))
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

class Aims
{
public:
    explicit Aims(const Rows& group) : group_(group)
    {
        const Row& row = *group.front();
        scene_ = std::string(row.group.scene->name) + (row.group.cullBackFaces ? ", back faces culled" : "");
        const auto automatic = [](Sizing sizing) {
            return [=](const Row& each) {
                return isMethod(each, "automatic") && isTennisBall(each) && each.entry.sizing == sizing;
            };
        };
        addRatio("automatic tennis-ball / best cube, equal angle",
                 cheapest(group, automatic(Sizing::equalAngle)), 0.9);
        addRatio("automatic tennis-ball / best cube, equal texels",
                 cheapest(group, automatic(Sizing::equalTexels)), 1.1);
        const Row* exact = tennisBall("exact");
        addQuotient("exact / tessellated", exact, tennisBall("tessellated"), 1.0);
        if (row.group.scene->name == "crowd-200k")
            addQuotient("exact / perVertex", exact, tennisBall("perVertex"), 2.0);
        addFewerWrong(exact, tennisBall("tessellated"));
        addVertexRuns(tennisBall("automatic"));
    }

    const std::vector<Aim>& all() const { return aims_; }

private:
    const Row* tennisBall(std::string_view method) const
    {
        return cheapest(group_, [&](const Row& row) {
            return isMethod(row, method) && row.entry.map == MapKind::tennisBall &&
                   row.entry.sizing == Sizing::equalTexels;
        });
    }

    void addRatio(const char* what, const Row* row, double limit)
    {
        if (row != nullptr)
            aims_.push_back({scene_, what, row->cpuRatioToBest, limit});
    }

    void addQuotient(const char* what, const Row* row, const Row* to, double limit)
    {
        if (row != nullptr && to != nullptr)
            aims_.push_back({scene_, what, row->timing.cpu.median / to->timing.cpu.median, limit});
    }

    void addFewerWrong(const Row* exact, const Row* tessellated)
    {
        if (exact == nullptr || tessellated == nullptr || !(tessellated->errors->wrongPercent > 0.0))
            return;
        // None wrong counts as half a texel.
        const double least = 50.0 / static_cast<double>(exact->errors->texels);
        aims_.push_back({scene_, "wrong texels, tessellated / exact",
                         tessellated->errors->wrongPercent / std::max(exact->errors->wrongPercent, least),
                         100.0, true});
    }

    void addVertexRuns(const Row* automatic)
    {
        if (automatic != nullptr && automatic->work.vertexShaderRuns)
            aims_.push_back({scene_, "vertex-shader runs a vertex, automatic",
                             static_cast<double>(*automatic->work.vertexShaderRuns) /
                                 static_cast<double>(automatic->sceneVertices),
                             1.15});
    }

    const Rows& group_;
    std::string scene_;
    std::vector<Aim> aims_;
};

} // namespace

std::vector<RivalCheck> rivalChecksOf(const std::vector<Row>& rows)
{
    std::vector<RivalCheck> checks;
    for (const Rows& group : groupsOf(rows))
        for (const Row* row : group)
            if (row->group.isRivalCheck && row->entry.rival == Rival::plain)
                checks.push_back({std::string(row->group.scene->name), 1.0 / row->cpuRatio,
                                  *row->group.scene->culledOverPlain});
    return checks;
}

std::vector<Aim> aimsOf(const std::vector<Row>& rows)
{
    std::vector<Aim> aims;
    for (const Rows& group : groupsOf(rows)) {
        if (group.front()->group.cubeN != rows.front().group.cubeN)
            continue;
        const Aims ofGroup(group);
        aims.insert(aims.end(), ofGroup.all().begin(), ofGroup.all().end());
    }
    return aims;
}

std::vector<Finding> findingsOf(const std::vector<Row>& rows)
{
    std::vector<Finding> findings;
    for (const Rows& group : groupsOf(rows)) {
        const double widest = group.front()->measures.worstDiagonal; // a rival's
        const Row* const best = cheapest(group, [&](const Row& row) {
            return !row.entry.rival && row.errors->wrongPercent <= rightPercent &&
                   row.measures.worstDiagonal <= widest;
        });
        if (best != nullptr)
            findings.push_back({best});
    }
    return findings;
}

} // namespace tests::benchmark
