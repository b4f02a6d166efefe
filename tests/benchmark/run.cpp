#include "run.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <tuple>

namespace tests::benchmark {

namespace {

using mirrorball::MapKind;

constexpr int warmUpFrames = 4;
// Two contenders whose ratio must be sure, however few frames the others are given.
constexpr int rivalCheckFrames = 30;
// A contender's errors take about as long as so many of its frames.
constexpr int errorFrames = 20;

std::unique_ptr<Contender> make(const Entry& entry, const Stage& stage, bool cullBackFaces,
                                examples::View view)
{
    if (entry.rival)
        return makeRival(*entry.rival, stage, entry.n, cullBackFaces, view, entry.formats);
    return makeLibraryContender(*entry.method, entry.map, entry.n, stage, cullBackFaces, view);
}

// A scene, loaded once for all of its groups, and what was traced in it.
class LoadedScene
{
public:
    LoadedScene(const SceneChoice& choice, CapturePrograms& programs)
        : programs_(programs), scene_(examples::loadScene(std::string(choice.source))),
          stage_(choice, scene_, programs), tracer_(scene_, choice.at)
    {
    }

    const Stage& stage() const { return stage_; }
    Stage& stage(Vertices vertices)
    {
        if (vertices == Vertices::shared)
            return stage_;
        if (!ownVertices_) {
            ownVertices_ = std::make_unique<examples::Scene>(withOwnVertices(scene_));
            ownVerticesStage_ = std::make_unique<Stage>(stage_.choice(), *ownVertices_, programs_);
        }
        return *ownVerticesStage_;
    }

    Errors errors(const Entry& entry, bool cullBackFaces)
    {
        const bool isTurned = entry.method != nullptr && entry.method->isTurned;
        const auto [truth, isNew] = truths_.try_emplace({entry.map, entry.n, isTurned});
        if (isNew)
            truth->second = traceMap(tracer_, stage_.choice(), entry.map, entry.n,
                                     isTurned ? glm::dmat3(stage_.cheapestPose(entry.map)) : glm::dmat3(1.0));
        return errorsOf([&](examples::View view) { return make(entry, stage_, cullBackFaces, view); },
                        truth->second, scene_, stage_.choice().at);
    }

private:
    CapturePrograms& programs_;
    examples::Scene scene_;
    Stage stage_;
    std::unique_ptr<examples::Scene> ownVertices_;
    std::unique_ptr<Stage> ownVerticesStage_;
    examples::ReferenceTracer tracer_;
    std::map<std::tuple<MapKind, int, bool>, std::vector<TrueTexel>> truths_;
};

// Ratios to the culled six passes, and to the best of the hand-written cubes.
void setRatios(std::span<Row> rows)
{
    const auto culled = std::find_if(rows.begin(), rows.end(),
                                     [](const Row& row) { return row.entry.rival == Rival::culled; });
    const Timing base = culled->timing;
    double best = std::numeric_limits<double>::infinity();
    for (const Row& row : rows)
        if (row.entry.rival)
            best = std::min(best, row.cost());
    for (Row& row : rows) {
        row.cpuRatio = row.timing.cpu.median / base.cpu.median;
        row.wallRatio = row.timing.wall.median / base.wall.median;
        row.costRatioToBest = row.cost() / best;
        if (row.timing.gpu && base.gpu)
            row.gpuRatio = row.timing.gpu->median / base.gpu->median;
    }
}

int framesOf(const Group& group, int frames)
{
    return group.isRivalCheck ? std::max(frames, rivalCheckFrames) : frames;
}

int partFramesOf(const Group& group, int frames)
{
    return std::max(2, framesOf(group, frames) / 3);
}

// Roughly what a frame costs next to others, so that the time left comes out right.
double weightOf(const Group& group)
{
    const double texels = static_cast<double>(group.cubeN) * group.cubeN / (256.0 * 256.0);
    return group.scene->weight * 0.5 * (1.0 + texels);
}

void runGroup(const Group& group, int frames, LoadedScene& loaded, Progress& progress, std::vector<Row>& rows)
{
    Stage& stage = loaded.stage(group.vertices);
    std::vector<std::unique_ptr<Contender>> contenders;
    for (const Entry& entry : group.entries)
        contenders.push_back(make(entry, stage, group.cullBackFaces, examples::View::colour));
    const std::vector<Timing> timings = measure(contenders, warmUpFrames, framesOf(group, frames),
                                                [&] { progress.advance(weightOf(group)); });
    // After them all programs are compiled, and a third of the frames tells enough of a part.
    stage.endBeforeRasteriser(true);
    const std::vector<Timing> partTimings =
        measure(contenders, 1, partFramesOf(group, frames), [&] { progress.advance(weightOf(group)); });
    stage.endBeforeRasteriser(false);

    const std::size_t firstRow = rows.size();
    for (std::size_t index = 0; index < group.entries.size(); ++index) {
        Row row;
        row.group = {group.scene, group.cubeN, group.cullBackFaces, group.isRivalCheck, group.vertices, {}};
        row.entry = group.entries[index];
        row.sceneTriangles = stage.triangleCount();
        row.sceneVertices = stage.vertexCount();
        row.measures = measuresOf(row.entry.map, row.entry.n);
        row.timing = timings[index];
        row.costBeforeRasteriser = partTimings[index].cost();
        row.work = countWork(*contenders[index]);
        contenders[index].reset();
        if (!group.isRivalCheck)
            row.errors = loaded.errors(row.entry, group.cullBackFaces);
        progress.advance(errorFrames * weightOf(group));
        rows.push_back(std::move(row));
    }
    setRatios(std::span(rows).subspan(firstRow));
}

bool isJudged(const Row& row, const Options& options)
{
    const auto isAskedFor = [](const auto& list, const auto& value) {
        return list.empty() || std::ranges::count(list, value) > 0;
    };
    const bool isDrawable = !row.entry.rival || isSupported(*row.entry.rival);
    return row.errors && isDrawable && isThere(*row.group.scene) &&
           isAskedFor(options.scenes, row.group.scene->name) && isAskedFor(options.maps, row.entry.map) &&
           isAskedFor(options.methods, row.entry.methodName()) && isAskedFor(options.sizes, row.group.cubeN);
}

} // namespace

double stepsOf(const std::vector<Group>& plan, int frames)
{
    double steps = 0.0;
    for (const Group& group : plan)
        steps += weightOf(group) * static_cast<double>(group.entries.size()) *
                 (warmUpFrames + framesOf(group, frames) + 1 + partFramesOf(group, frames) + errorFrames);
    return steps;
}

std::vector<Row> run(const std::vector<Group>& plan, int frames, const std::string& name, Progress& progress,
                     const std::function<void(const std::vector<Row>&)>& afterGroup)
{
    CapturePrograms programs;
    std::unique_ptr<LoadedScene> loaded;
    std::vector<Row> rows;
    for (const Group& group : plan) {
        progress.label(std::string(group.scene->name) + ", n = " + std::to_string(group.cubeN));
        if (!loaded || &loaded->stage().choice() != group.scene) {
            loaded.reset(); // before the next takes memory
            loaded = std::make_unique<LoadedScene>(*group.scene, programs);
        }
        runGroup(group, frames, *loaded, progress, rows);
        for (Row& row : rows)
            row.run = row.errorsRun = name;
        afterGroup(rows);
    }
    return rows;
}

double judgeSteps(const std::vector<Row>& rows, const Options& options)
{
    double steps = 0.0;
    for (const Row& row : rows)
        if (isJudged(row, options))
            steps += weightOf(row.group);
    return steps;
}

void judge(std::vector<Row>& rows, const Options& options, const std::string& name, Progress& progress,
           const std::function<void(std::string_view)>& afterGroup)
{
    CapturePrograms programs;
    std::unique_ptr<LoadedScene> loaded; // for one size, as rays of all would take gigabytes
    int cubeN = 0;
    for (Row& row : rows) {
        if (!isJudged(row, options))
            continue;
        if (!loaded || &loaded->stage().choice() != row.group.scene || cubeN != row.group.cubeN) {
            if (loaded)
                afterGroup(loaded->stage().choice().name);
            progress.label(std::string(row.group.scene->name) +
                           ", errors, n = " + std::to_string(row.group.cubeN));
            loaded.reset();
            loaded = std::make_unique<LoadedScene>(*row.group.scene, programs);
            cubeN = row.group.cubeN;
        }
        row.errors = loaded->errors(row.entry, row.group.cullBackFaces);
        row.errorsRun = name;
        progress.advance(weightOf(row.group));
    }
    if (loaded)
        afterGroup(loaded->stage().choice().name);
}

} // namespace tests::benchmark
