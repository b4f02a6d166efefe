// The snippets of every look-up: glslangValidator accepts them in every version without a word, and two fit into one
// shader. Which reflectors need no more than Lookup::infinite.
#include "support/check.h"

#include <mirrorball/error.h>
#include <mirrorball/reflect/reflection_material.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

using namespace mirrorball;

namespace {

constexpr std::array lookups = {Lookup::infinite, Lookup::sphere, Lookup::box, Lookup::distance,
                                Lookup::layered};

constexpr std::array details = {LevelOfDetail::first, LevelOfDetail::isotropic, LevelOfDetail::anisotropic};

const char* const fragment = R"(
in vec3 position;
in vec3 normal;
uniform vec3 eye;
out vec4 colour;
void main()
{
    vec4 mirrored = first_reflection(position, normal, eye) + second_reflectionInView(position, normal);
    colour = first_material(mirrored, second_shownPosition(position, normal, eye));
}
)";

// What glslangValidator prints of the files, their names left out.
std::string complaints(const std::string& files)
{
    FILE* const validator = popen(("'" GLSLANG_VALIDATOR "' " + files + " 2>&1").c_str(), "r");
    CHECK(validator != nullptr);
    std::string output;
    std::array<char, 1024> line;
    while (std::fgets(line.data(), line.size(), validator) != nullptr) {
        const std::string text(line.data());
        if (text.rfind(SCRATCH_FOLDER, 0) != 0)
            output += text;
    }
    CHECK(pclose(validator) == 0);
    return output;
}

void testSnippets(MapKind map)
{
    std::string files;
    for (const GlslVersion version :
         {GlslVersion::glsl330, GlslVersion::glsl400, GlslVersion::glsl450, GlslVersion::es300})
        for (const Lookup lookup : lookups)
            for (const LevelOfDetail detail : details) {
                const std::string file = SCRATCH_FOLDER "/" + std::to_string(static_cast<int>(version)) +
                                         "_" + std::to_string(static_cast<int>(lookup)) + "_" +
                                         std::to_string(static_cast<int>(detail)) + ".frag";
                std::ofstream(file) << glslVersionLine(version)
                                    << reflectionGlsl({map, lookup, version, "first_", detail})
                                    << reflectionGlsl({MapKind::octahedral, lookup, version, "second_"})
                                    << fragment;
                files += "'" + file + "' ";
            }
    const std::string output = complaints(files);
    if (!output.empty())
        std::printf("%s", output.c_str());
    CHECK(output.empty());
}

void testNames()
{
    CHECK(lookupFromName("distance") == Lookup::distance);
    CHECK(lookupFromName("layered") == Lookup::layered);
    CHECK(!lookupFromName("telepathy"));
}

void testInfiniteSuffices()
{
    // The middle texels of a cube's face are the largest, 2 / 256 wide as seen from 1 away; those at its corners
    // have 1 / 3^(3/2) of the solid angle.
    const double texel = 2.0 / 256.0 / std::pow(3.0, 0.75);
    CHECK(infiniteSuffices(MapKind::cube, 256, 0.9 * texel, 1.0));
    CHECK(!infiniteSuffices(MapKind::cube, 256, 1.1 * texel, 1.0));
    CHECK(infiniteSuffices(MapKind::cube, 256, 0.9, 1.0 / texel));
    CHECK(!infiniteSuffices(MapKind::tennisBall, 256, 0.5, 4.0));
    CHECK_THROWS(infiniteSuffices(static_cast<MapKind>(-1), 256, 0.5, 4.0), ErrorKind::badArgument);
}

} // namespace

int main()
{
    testNames();
    testInfiniteSuffices();
    for (const MapInfo& map : maps())
        testSnippets(map.kind);
    return 0;
}
