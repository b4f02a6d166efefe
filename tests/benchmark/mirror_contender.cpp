#include "mirror_contender.h"

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <iterator>

namespace tests::benchmark {

namespace {

using examples::View;
using mirrorball::Lookup;

class LibraryMirror : public MirrorContender
{
public:
    LibraryMirror(const MirrorEntry& entry, const MirrorStage& stage, View view)
        : renderer_(stage.setup(), optionsOf(entry, stage), stage.canvas(view), stage.captureProgram())
    {
    }

    void capture() override { renderer_.capture(); }
    void drawMirror() const override { renderer_.drawMirrors(); }

private:
    static render::Options optionsOf(const MirrorEntry& entry, const MirrorStage& stage)
    {
        render::Options options = stage.options();
        options.map = entry.map;
        options.lookup = entry.lookup;
        options.size = entry.n;
        return options;
    }

    render::Renderer renderer_;
};

// What people put into their mirror's shader: the reflected ray, with the parallax-corrected one where it leaves a box
// that stands for the room (Lagarde and Zanuttini, "Local image-based lighting with parallax-corrected cubemaps",
// SIGGRAPH 2012 Talks). The probe's centre is the origin.
constexpr std::string_view handLookUps = R"(
uniform samplerCube colourMap, distanceMap;
uniform vec3 boxLow, boxHigh;
uniform vec3 tint;
uniform float blend;

vec3 lookUpDirection(vec3 position, vec3 normal, vec3 eye)
{
    vec3 ray = reflect(position - eye, normal);
#if BOX
    vec3 farther = max((boxLow - position) / ray, (boxHigh - position) / ray);
    return position + min(min(farther.x, farther.y), farther.z) * ray;
#else
    return ray;
#endif
}

vec4 mirrorball_reflection(vec3 position, vec3 normal, vec3 eye)
{
    return textureLod(colourMap, lookUpDirection(position, normal, eye), 0.0);
}

vec4 mirrorball_material(vec4 own, vec4 reflection)
{
    return vec4(mix(own.rgb, tint * reflection.rgb, blend), own.a);
}

vec4 mirrorball_shownPosition(vec3 position, vec3 normal, vec3 eye)
{
    vec3 direction = normalize(lookUpDirection(position, normal, eye));
    float shown = textureLod(distanceMap, direction, 0.0).r;
    return isinf(shown) ? vec4(0.0) : vec4(shown * direction, 1.0);
}
)";

std::string lookUpSource(Lookup lookup)
{
    return "#define BOX " + std::to_string(lookup == Lookup::box ? 1 : 0) + "\n" + std::string(handLookUps);
}

class HandMirror : public MirrorContender
{
public:
    HandMirror(const MirrorEntry& entry, const MirrorStage& stage, View view)
        : stage_(stage), canvas_(stage.canvas(view)),
          cube_(makeRival(Rival::culled, stage.handStage(), entry.n, false, View::colour)),
          mirror_(stage.setup().mirrors[0].reflector, stage.setup().origin, view, lookUpSource(entry.lookup))
    {
    }

    void capture() override { cube_->draw(); }
    void drawMirror() const override;

private:
    const MirrorStage& stage_;
    const render::Canvas& canvas_;
    std::unique_ptr<CubeMapContender> cube_;
    examples::GlMirror mirror_;
};

void HandMirror::drawMirror() const
{
    constexpr int colourUnit = 1, distanceUnit = 2; // unit 0 is the scene's image
    const unsigned int program = mirror_.program();
    const render::Setup& setup = stage_.setup();
    const glm::dvec3 centre = glm::dvec3(setup.worldFromProxy[3]) - setup.origin;
    const glm::dvec3 half(setup.worldFromProxy[0][0], setup.worldFromProxy[1][1], setup.worldFromProxy[2][2]);
    const auto location = [&](const char* name) { return glGetUniformLocation(program, name); };
    glUseProgram(program);
    glUniform1i(location("colourMap"), colourUnit);
    glUniform1i(location("distanceMap"), distanceUnit);
    glUniform3fv(location("boxLow"), 1, glm::value_ptr(glm::vec3(centre - half)));
    glUniform3fv(location("boxHigh"), 1, glm::value_ptr(glm::vec3(centre + half)));
    glUniform3fv(location("tint"), 1, glm::value_ptr(setup.mirrors[0].tint));
    glUniform1f(location("blend"), setup.mirrors[0].blend);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glActiveTexture(GL_TEXTURE0 + colourUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube_->colourTexture());
    glActiveTexture(GL_TEXTURE0 + distanceUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube_->distanceTexture());
    mirror_.draw(canvas_.pictureView(), 1);
}

// Where ball, eye and light are in a room of the house.
std::vector<std::string> placesOf(std::string_view name)
{
    const auto room = std::find_if(std::begin(houseRooms), std::end(houseRooms),
                                   [=](const HouseRoom& each) { return each.name == name; });
    return {"--at", room->at, "--eye", room->eye, "--light", room->light};
}

render::Options optionsOf(const MirrorScene& scene)
{
    std::vector<std::string> words = {std::string(scene.source), "--reflector", "sphere:0.5", "--pixels",
                                      "1280x720"};
    words.insert(words.end(), scene.words.begin(), scene.words.end());
    return renderOptions(words);
}

SceneChoice handChoiceOf(const MirrorScene& scene, const render::Setup& setup, const render::Options& options)
{
    SceneChoice choice{};
    choice.name = scene.name;
    choice.source = scene.source;
    choice.at = setup.origin;
    choice.near = static_cast<float>(setup.mirrors[0].near);
    choice.far = static_cast<float>(options.far);
    return choice;
}

examples::Scene litScene(const render::Setup& setup)
{
    examples::Scene scene = setup.scene;
    scene.light = glm::vec3(setup.light);
    return scene;
}

} // namespace

const std::vector<MirrorScene>& mirrorScenes()
{
    static const std::vector<MirrorScene> scenes = {{"room", "builtin:room", {}, true},
                                                    {"garden", "builtin:garden", {}, false},
                                                    {"house", houseFile, placesOf("living room"), false},
                                                    {"bathroom", houseFile, placesOf("bathroom"), false}};
    return scenes;
}

MirrorStage::MirrorStage(const MirrorScene& scene, CapturePrograms& programs)
    : scene_(scene), programs_(programs), options_(optionsOf(scene)), judge_(options_),
      colours_(judge_.setup(), View::colour, options_.pixels),
      positions_(judge_.setup(), View::position, options_.pixels), handScene_(litScene(judge_.setup())),
      handChoice_(handChoiceOf(scene, judge_.setup(), options_)),
      handStage_(handChoice_, handScene_, programs)
{
}

std::unique_ptr<MirrorContender> makeMirrorContender(const MirrorEntry& entry, const MirrorStage& stage,
                                                     View view)
{
    if (entry.isByHand)
        return std::make_unique<HandMirror>(entry, stage, view);
    return std::make_unique<LibraryMirror>(entry, stage, view);
}

} // namespace tests::benchmark
