// The printed GLSL: the text is the golden text, names follow the prefix, and glslangValidator accepts it
// without a word. maps_glsl_test --write brings tests/golden/ up to date: review the difference like code.
#include "support/check.h"

#include <mirrorball/error.h>
#include <mirrorball/maps/glsl.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace {

using mirrorball::GlslVersion;
using mirrorball::mapGlsl;
using mirrorball::MapInfo;

std::string goldenFile(const MapInfo& map)
{
    return "tests/golden/" + std::string(map.name) + ".glsl";
}

std::string goldenText(const MapInfo& map)
{
    return glslVersionLine(GlslVersion::glsl330) + "\n" + mapGlsl(map.kind, GlslVersion::glsl330) + "\n" +
           mapDerivativesGlsl(map.kind, GlslVersion::glsl330) + "\n" +
           mapRaysGlsl(map.kind, GlslVersion::glsl330);
}

void writeGolden()
{
    for (const MapInfo& map : mirrorball::maps()) {
        std::ofstream file(goldenFile(map));
        file << goldenText(map);
        CHECK(file.flush());
    }
}

void checkGolden(const MapInfo& map)
{
    std::ostringstream text;
    text << std::ifstream(goldenFile(map)).rdbuf();
    if (text.str() != goldenText(map))
        std::fprintf(stderr, "%s differs from what is printed; maps_glsl_test --write\n",
                     goldenFile(map).c_str());
    CHECK(text.str() == goldenText(map));
}

// What glslangValidator prints beside the file's name; it prints nothing else for a shader without fault.
std::string complaints(const std::string& shader)
{
    const std::string file = SCRATCH_FOLDER "/printed.frag";
    std::ofstream(file) << shader;
    FILE* const validator = popen(("'" GLSLANG_VALIDATOR "' '" + file + "' 2>&1").c_str(), "r");
    CHECK(validator != nullptr);
    std::string output;
    std::array<char, 256> buffer;
    while (std::fgets(buffer.data(), buffer.size(), validator) != nullptr)
        output += buffer.data();
    const int status = pclose(validator);
    if (output == file + "\n")
        output.clear();
    return status == 0 && output.empty() ? "" : "status " + std::to_string(status) + ": " + output;
}

// A fragment shader that calls every function of two maps, and where it is GLSL ES, asks for less than highp.
std::string fragmentShader(GlslVersion version, const MapInfo& first, const MapInfo& second)
{
    std::string shader = glslVersionLine(version);
    if (version == GlslVersion::es300)
        shader += "precision mediump float;\nprecision mediump int;\n";
    shader += mapGlsl(first.kind, version, "first_") + mapGlsl(second.kind, version, "second_") +
              mapDerivativesGlsl(first.kind, version, "first_") + mapRaysGlsl(first.kind, version, "first_");
    return shader + R"(
in vec3 direction;
out vec4 colour;
void main()
{
    vec3 a = first_coordinateFromDirection(direction);
    vec2 b = second_squareFromDirection(second_componentOf(direction), direction);
    vec3 ray = first_rayOfTexel(int(a.z), a.xy, b);
    colour = vec4(ray / first_rayLength(ray) + first_directionFromSquare(int(a.z), a.xy) + second_directionFromSquare(second_components - 1, b),
                  float(first_components)) + first_squareDerivatives(int(a.z), direction, a, a.zyx);
}
)";
}

void checkAccepted(const MapInfo& map, std::size_t index)
{
    const MapInfo& next = mirrorball::maps()[(index + 1) % mirrorball::maps().size()];
    for (const GlslVersion version :
         {GlslVersion::glsl330, GlslVersion::glsl400, GlslVersion::glsl450, GlslVersion::es300})
    {
        const std::string complaint = complaints(fragmentShader(version, map, next));
        if (!complaint.empty())
            std::fprintf(stderr, "%s, version %d: %s\n", map.name.data(), static_cast<int>(version),
                         complaint.c_str());
        CHECK(complaint.empty());
    }
}

// The check above can fail: a fault and a warning are both complaints.
void checkThatComplaintsAreSeen()
{
    CHECK(!complaints("#version 330 core\nvoid main() { undeclared(); }\n").empty());
    CHECK(!complaints("#version 330 core\n#extension GL_NOT_THERE : enable\nvoid main() {}\n").empty());
}

// No function of GLSL's whose precision the language leaves open.
void checkNoBuiltInTrigonometry(const std::string& text)
{
    for (const char* const name :
         {" sin(", " cos(", " tan(", " asin(", " acos(", " atan(", "(sin(", "(cos(", "(atan("})
        CHECK(text.find(name) == std::string::npos);
}

void checkPrefixes()
{
    using mirrorball::ErrorKind;
    const auto cube = [](const std::string& prefix) {
        return mapGlsl(mirrorball::MapKind::cube, GlslVersion::glsl330, prefix);
    };
    CHECK(cube("garden_").find("mirrorball_") == std::string::npos);
    CHECK(cube("garden_").find("vec3 garden_coordinateFromDirection(vec3 direction)") != std::string::npos);
    for (const char* const prefix : {"two words", "9lives", "a__b", "gl_", "semi;", "trailing__"})
        CHECK_THROWS(cube(prefix), ErrorKind::badArgument);
}

void checkNumbersWithoutName()
{
    using mirrorball::ErrorKind, mirrorball::MapKind;
    for (const int number : {-1, 8, 77}) {
        const auto map = static_cast<MapKind>(number);
        CHECK_THROWS(mirrorball::mapInfo(map), ErrorKind::badArgument);
        CHECK_THROWS(mapGlsl(map, GlslVersion::glsl330), ErrorKind::badArgument);
        CHECK_THROWS(mapGlsl(MapKind::cube, static_cast<GlslVersion>(number)), ErrorKind::badArgument);
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc > 1 && std::string(argv[1]) == "--write") {
        writeGolden();
        return 0;
    }
    checkThatComplaintsAreSeen();
    checkPrefixes();
    checkNumbersWithoutName();
    std::size_t index = 0;
    for (const MapInfo& map : mirrorball::maps()) {
        checkGolden(map);
        checkNoBuiltInTrigonometry(goldenText(map));
        checkAccepted(map, index++);
    }
}
