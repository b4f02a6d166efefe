#include "look_up_run.h"

#include <epoxy/gl.h>

namespace tests::benchmark {

namespace {

using examples::View;

constexpr int warmUpFrames = 2;
// The two pictures of a contender and their comparison take about as long as so many of its frames.
constexpr int judgeFrames = 60;

struct Samples
{
    std::vector<double> capture, mirror, both, frameWall;
};

void drawFrame(MirrorContender& contender, const render::Canvas& canvas, Samples& samples)
{
    const Sample capture = timed([&] { contender.capture(); });
    const Sample scene = timed([&] {
        glDisable(GL_CULL_FACE); // a capture by hand may leave it on
        canvas.drawScene();
    });
    const Sample mirror = timed([&] { contender.drawMirror(); });
    samples.capture.push_back(capture.cost());
    samples.mirror.push_back(mirror.cost());
    samples.both.push_back(capture.cost() + mirror.cost());
    samples.frameWall.push_back(capture.wall + scene.wall + mirror.wall);
}

render::Picture pictureOf(const MirrorEntry& entry, const MirrorStage& stage, View view)
{
    const std::unique_ptr<MirrorContender> contender = makeMirrorContender(entry, stage, view);
    contender->capture();
    stage.canvas(view).drawScene();
    contender->drawMirror();
    return stage.canvas(view).picture();
}

double weightOf(const LookUpGroup& group)
{
    return 0.5 + 0.5 * group.cubeN * group.cubeN / (256.0 * 256.0);
}

void runGroup(const LookUpGroup& group, int frames, const MirrorStage& stage, Progress& progress,
              std::vector<LookUpRow>& rows)
{
    std::vector<std::unique_ptr<MirrorContender>> contenders;
    for (const MirrorEntry& entry : group.entries)
        contenders.push_back(makeMirrorContender(entry, stage, View::colour));
    std::vector<Samples> samples(contenders.size());
    for (int frame = 0; frame < warmUpFrames + frames; ++frame)
        for (std::size_t index = 0; index < contenders.size(); ++index) {
            Samples discarded;
            drawFrame(*contenders[index], stage.canvas(View::colour),
                      frame < warmUpFrames ? discarded : samples[index]);
            progress.advance(weightOf(group));
        }
    const double base = quartilesOf(samples.front().both).median;
    for (std::size_t index = 0; index < contenders.size(); ++index) {
        contenders[index].reset();
        const Samples& of = samples[index];
        LookUpRow row{.scene = group.scene,
                      .cubeN = group.cubeN,
                      .entry = group.entries[index],
                      .capture = quartilesOf(of.capture),
                      .mirror = quartilesOf(of.mirror),
                      .both = quartilesOf(of.both),
                      .frameWall = quartilesOf(of.frameWall),
                      .frames = of.both.size()};
        row.ratio = row.both.median / base;
        row.errors = stage.judge().judge(pictureOf(row.entry, stage, View::position),
                                         pictureOf(row.entry, stage, View::colour));
        progress.advance(judgeFrames * weightOf(group));
        rows.push_back(std::move(row));
    }
}

} // namespace

double stepsOf(const std::vector<LookUpGroup>& plan, int frames)
{
    double steps = 0.0;
    for (const LookUpGroup& group : plan)
        steps += weightOf(group) * static_cast<double>(group.entries.size()) *
                 (warmUpFrames + frames + judgeFrames);
    return steps;
}

std::vector<LookUpRow> runLookUps(const std::vector<LookUpGroup>& plan, int frames, const std::string& name,
                                  Progress& progress,
                                  const std::function<void(const std::vector<LookUpRow>&)>& afterGroup)
{
    CapturePrograms programs;
    std::unique_ptr<MirrorStage> stage;
    std::vector<LookUpRow> rows;
    for (const LookUpGroup& group : plan) {
        progress.label(std::string(group.scene->name) + ", look-ups, n = " + std::to_string(group.cubeN));
        if (!stage || &stage->scene() != group.scene) {
            stage.reset(); // before the next takes memory
            stage = std::make_unique<MirrorStage>(*group.scene, programs);
        }
        runGroup(group, frames, *stage, progress, rows);
        for (LookUpRow& row : rows) {
            row.costsOf = costName();
            row.run = name;
        }
        afterGroup(rows);
    }
    return rows;
}

} // namespace tests::benchmark
