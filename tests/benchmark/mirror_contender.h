// What competes when both passes count: a map, and a mirror that is drawn with it.
#pragma once

#include "contender.h"
#include "rivals.h"

#include "renderer.h"
#include "support/parallax.h"

#include <mirrorball/reflect/reflection_material.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tests::benchmark {

// A ball of radius 0.5 in a scene, and the picture of it, 1280 × 720.
struct MirrorScene
{
    std::string_view name;
    std::string source;
    std::vector<std::string> words; // of render's command line: where ball, eye and light are
    bool quick;                     // part of --quick
};
const std::vector<MirrorScene>& mirrorScenes();

struct MirrorEntry
{
    bool isByHand; // a culled six-pass cube: infinite, or box
    mirrorball::MapKind map;
    mirrorball::Lookup lookup;
    int n;
};

// What all contenders in a scene share: the traced truth, the scene on the GPU, the shaders. Needs a context.
class MirrorStage
{
public:
    explicit MirrorStage(const MirrorScene& scene, CapturePrograms& programs);
    MirrorStage(const MirrorStage&) = delete;
    MirrorStage& operator=(const MirrorStage&) = delete;

    const MirrorScene& scene() const { return scene_; }
    const render::Options& options() const { return options_; }
    const render::Setup& setup() const { return judge_.setup(); }
    const ParallaxJudge& judge() const { return judge_; }
    const render::Canvas& canvas(examples::View view) const
    {
        return view == examples::View::colour ? colours_ : positions_;
    }
    mirrorball::CaptureProgram& captureProgram() const { return programs_.of(examples::View::colour); }
    const Stage& handStage() const { return handStage_; }

private:
    const MirrorScene& scene_;
    CapturePrograms& programs_;
    render::Options options_;
    ParallaxJudge judge_;
    render::Canvas colours_, positions_;
    examples::Scene handScene_;
    SceneChoice handChoice_;
    Stage handStage_;
};

class MirrorContender
{
public:
    virtual ~MirrorContender() = default;

    virtual void capture() = 0;          // pass 1
    virtual void drawMirror() const = 0; // after Canvas::drawScene
};

std::unique_ptr<MirrorContender> makeMirrorContender(const MirrorEntry& entry, const MirrorStage& stage,
                                                     examples::View view);

} // namespace tests::benchmark
