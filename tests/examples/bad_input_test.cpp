// What the programs say to bad input: the exit status that docs/programs.md promises, one line on stderr,
// nothing on stdout, and no file.
#include "examples/program.h"

#include <mirrorball/error.h>
#include <mirrorball/io/image.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

using tests::Environment;
using tests::Scratch;
using Words = std::vector<std::string>;

namespace {

constexpr int failed = 1;
constexpr int misused = 2;

Words operator+(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// A program that writes its output into a folder, which must stay empty.
class Subject
{
public:
    Subject(std::string program, std::string outputName)
        : program_(std::move(program)), outputName_(std::move(outputName))
    {
    }

    void refuses(int status, const Words& arguments, const Environment& environment = {}) const
    {
        const Scratch folder;
        refusesExactly(status, arguments + Words{"-o", folder / outputName_}, environment);
        CHECK(folder.fileCount() == 0);
    }

    void refusesExactly(int status, const Words& arguments, const Environment& environment = {}) const
    {
        const tests::Outcome outcome = tests::run(program_, arguments, environment);
        const bool isOneLine = std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1 &&
                               outcome.errors.back() == '\n' && outcome.errors.size() > 10;
        if (outcome.status != status || !isOneLine || !outcome.output.empty()) {
            for (const std::string& word : arguments)
                std::fprintf(stderr, "%s ", word.c_str());
            std::fprintf(stderr, "\nstatus %d, not %d: %s", outcome.status, status, outcome.errors.c_str());
        }
        CHECK(outcome.status == status);
        CHECK(isOneLine);
        CHECK(outcome.output.empty());
        ++count_;
    }

    void refusesEach(int status, const std::vector<Words>& cases,
                     const Words& before = {"builtin:cards"}) const
    {
        for (const Words& words : cases)
            refuses(status, before + words);
    }

    int count() const { return count_; }

private:
    std::string program_, outputName_;
    mutable int count_ = 0;
};

// What both programs have in common.
void testNamesAndNumbers(const Subject& subject)
{
    subject.refusesEach(misused, {{"--wobble"},
                                  {"--wobble", "3"},
                                  {"second.obj"},
                                  {"--map", "mercator"},
                                  {"--map", ""},
                                  {"--map"},
                                  {"--method", "magic"},
                                  {"--view", "smell"},
                                  {"--at", "1,2"},
                                  {"--at", "1,2,3,4"},
                                  {"--at", "one,2,3"},
                                  {"--at", ""},
                                  {"--size", "many"},
                                  {"--size", "1.5"},
                                  {"--size", " 16"},
                                  {"--size", "99999999999"},
                                  {"--far", "1e"},
                                  {"--far", "10m"}});
    subject.refuses(misused, {"builtin:castle"});
    subject.refuses(misused, {"builtin:crowd:many"});
    subject.refusesExactly(misused, {"builtin:cards"}); // no -o
    subject.refuses(misused, {});                       // no scene
    subject.refusesEach(failed, {{"--size", "0"},
                                 {"--size", "-1"},
                                 {"--size", "16384"}, // a tennis-ball layer is three times as high
                                 {"--size", "100000"},
                                 {"--near", "5", "--far", "5"},
                                 {"--near", "5", "--far", "4"},
                                 {"--near", "0"},
                                 {"--near", "-1"},
                                 {"--near", "nan"},
                                 {"--far", "nan"},
                                 {"--at", "nan,0,0"},
                                 {"--at", "0,inf,0"},
                                 {"--offset", "0,0,nan"},
                                 {"--light", "nan,0,0"},
                                 {"--probe-turn", "inf,0,0"},
                                 {"--frames", "0"}});
    // The same without OpenGL.
    subject.refusesEach(failed, {{"--size", "0"}, {"--near", "5", "--far", "4"}, {"--at", "nan,0,0"}},
                        {"builtin:cards", "--reference"});
}

// A folder with files that are no scene.
class BadScenes
{
public:
    BadScenes()
    {
        tests::store(folder_ / "empty.obj", "");
        tests::store(folder_ / "points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n");
        tests::store(folder_ / "noise.glb", std::string(1000, '\x5a'));
        tests::store(folder_ / "noise.png", std::string(1000, '\x5a'));
        tests::store(folder_ / "text.txt", "not a model");
    }
    Words all() const
    {
        Words files = {folder_ / "missing.obj", folder_ / "", ""};
        for (const char* const name : {"empty.obj", "points.obj", "noise.glb", "noise.png", "text.txt"})
            files.push_back(folder_ / name);
        return files;
    }
    std::string operator/(const char* name) const { return folder_ / name; }

private:
    Scratch folder_;
};

void testScenes(const Subject& subject, const BadScenes& scenes)
{
    for (const std::string& file : scenes.all())
        subject.refuses(failed, {file});
}

void testOutputs(const Subject& subject, const BadScenes& scenes, const std::string& name)
{
    const Scratch folder;
    const std::string inFile = scenes / "text.txt";
    subject.refusesExactly(failed, {"builtin:cards", "-o", folder / ("missing/" + name)});
    subject.refusesExactly(failed, {"builtin:cards", "-o", inFile + "/" + name});
    CHECK(folder.fileCount() == 0);
    // Statistics that cannot be written leave no picture behind, and the other way round.
    subject.refuses(failed, {"builtin:cards", "--stats", folder / "missing/stats.json"});
    subject.refusesExactly(
        failed, {"builtin:cards", "--stats", folder / "stats.json", "-o", folder / ("missing/" + name)});
    CHECK(folder.fileCount() == 0);
}

void testContexts(const Subject& subject)
{
    subject.refuses(failed, {"builtin:cards"}, {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}});
    subject.refuses(failed, {"builtin:cards"}, {{"MESA_GL_VERSION_OVERRIDE", "3.2"}});
}

void testRender(const Subject& render, const BadScenes& scenes)
{
    render.refusesEach(misused, {{"--ior", "1.5"},
                                 {"--roughness", "0.5"},
                                 {"--blur", "3,1"},
                                 {"--lookup", "telepathy"},
                                 {"--material", "glass"},
                                 {"--material", "cheese"},
                                 {"--view", "normal"},
                                 {"--reflector", "sphere:"},
                                 {"--reflector", "sphere:wide"},
                                 {"--pixels", "100"},
                                 {"--pixels", "100x"},
                                 {"--pixels", "axb"},
                                 {"--pixels", " 100x100"},
                                 {"--source"},
                                 {"--reflector", "sphere:1", "--scale", "big"}});
    render.refusesEach(failed, {{"--reflector", "toaster"},
                                {"--reflector", scenes / "empty.obj"},
                                {"--reflector", scenes / "noise.glb"},
                                {"--reflector", "sphere:0"},
                                {"--reflector", "sphere:-1"},
                                {"--reflector", "sphere:nan"},
                                {"--scale", "0"},
                                {"--scale", "nan"},
                                {"--blend", "1.5"},
                                {"--blend", "nan"},
                                {"--tint", "0,0,nan"},
                                {"--tint", "1,-0.5,1"},
                                {"--proxy-low", "1,1,1", "--proxy-high", "1,2,2"},
                                {"--pixels", "0x10"},
                                {"--pixels", "-5x10"},
                                {"--pixels", "100000x100000"},
                                {"--pixels", "20000x10"},
                                {"--supersample", "0"},
                                {"--supersample", "99"},
                                {"--fov", "0"},
                                {"--fov", "180"},
                                {"--fov", "nan"},
                                {"--eye", "1,2,3", "--look", "1,2,3"},
                                {"--eye", "0,5,0", "--look", "0,0,0"},
                                {"--eye", "nan,0,0"},
                                {"--up", "0,0,0"},
                                {"--reflector", "sphere:1", "--reflector", "sphere:1", "--at", "nan,0,0"}});
    const Scratch folder;
    for (const char* const name : {"picture", "picture.jpg", "picture.png.txt"})
        render.refusesExactly(failed, {"builtin:cards", "-o", folder / name});
    render.refusesExactly(failed, {"builtin:cards", "--view", "position", "-o", folder / "picture.png"});
    render.refusesExactly(
        failed, {"builtin:cards", "-o", folder / "picture.png", "--stats", folder / "./picture.png"});
    CHECK(folder.fileCount() == 0);
}

void testSources(const Subject& render, const BadScenes& scenes)
{
    const Scratch folder;
    const auto image = [&](const std::string& name, int width, int height) {
        const std::size_t count = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        mirrorball::io::writePng(folder / name, {width, height, 3, std::vector<float>(count, 0.5f)});
        return std::string(folder / name);
    };
    const std::string square = image("square.png", 4, 4), small = image("small.png", 2, 2),
                      wide = image("wide.png", 6, 4);
    const std::string noise = scenes / "noise.png", missing = scenes / "missing.png";
    const Words five(5, square);
    render.refusesEach(failed,
                       {Words{"--source", missing}, Words{"--source", noise},
                        Words{"--source", wide}, // neither 2:1 nor 1:1
                        Words{"--source", square, square}, Words{"--source"} + five,
                        Words{"--source"} + five + Words{small}, Words{"--source"} + five + Words{wide},
                        Words{"--source"} + five + Words{noise}, Words{"--source"} + five + Words{missing}});
}

// The option that lacks it is named, not the one that would be its value.
void testForgottenValues()
{
    const auto saysOf = [](const char* program, const Words& words, const std::string& option) {
        const std::string said = tests::run(program, words, {}).errors;
        CHECK(said.find(option + ": it needs a value, and '-o' looks like an option") != std::string::npos);
    };
    saysOf(RENDER_PROGRAM, {"builtin:cards", "--source", "-o", "x.png"}, "--source");
    saysOf(CAPTURE_PROGRAM, {"builtin:cards", "--stats", "-o", "x"}, "--stats");
}

void testHello(const Subject& hello)
{
    const Scratch folder;
    hello.refusesExactly(misused, {"--wobble"});
    hello.refusesExactly(misused, {"--frames", "few"});
    for (const char* const frames : {"0", "-3"})
        hello.refusesExactly(failed, {"--frames", frames});
    hello.refusesExactly(misused, {"--headless"});
    hello.refusesExactly(failed, {"--headless", folder / "missing/hello.png"});
    hello.refusesExactly(failed, {"--headless", folder / "hello.txt"});
    hello.refusesExactly(failed, {"--headless", folder / "hello.png"},
                         {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}});
    hello.refusesExactly(failed, {}, {{"DISPLAY", ":987654"}, {"WAYLAND_DISPLAY", "none"}});
    CHECK(folder.fileCount() == 0);
}

// None of a map's files is written where one of them cannot be.
void testHalfAMap(const Subject& capture)
{
    const Scratch folder;
    std::filesystem::create_directory(folder / "map_1.exr");
    capture.refusesExactly(failed, {"builtin:cards", "--size", "16", "-o", folder / "map"});
    CHECK(folder.fileCount() == 1);
    std::filesystem::create_directory(folder / "maps");
    capture.refusesExactly(failed, {"builtin:cards", "--size", "16", "-o", folder / "maps/"});
    CHECK(std::filesystem::is_empty(folder / "maps"));
    capture.refusesExactly(failed, {"builtin:cards", "--size", "16", "-o", folder / "maps/a", "--stats",
                                    folder / "maps/a_1.exr"});
    CHECK(std::filesystem::is_empty(folder / "maps"));
}

} // namespace

int main()
{
    const BadScenes scenes;
    const Subject capture(CAPTURE_PROGRAM, "map"), render(RENDER_PROGRAM, "picture.png"),
        hello(HELLO_PROGRAM, "hello.png");
    for (const auto& [subject, name] : {std::pair(&capture, "map"), std::pair(&render, "picture.exr")}) {
        testNamesAndNumbers(*subject);
        testScenes(*subject, scenes);
        testOutputs(*subject, scenes, name);
        testContexts(*subject);
    }
    testHalfAMap(capture);
    testRender(render, scenes);
    testSources(render, scenes);
    testForgottenValues();
    testHello(hello);
    std::printf("refused: capture %d, render %d, hello_probe %d\n", capture.count(), render.count(),
                hello.count());
}
