// All that docs/results/look_ups.md says: every look-up in every scene and reflector against the tracer.
//
//     parallax_table docs/results/look_ups.md
//
// Takes minutes. Fails when a look-up is worse than `infinite` anywhere.
#include "support/parallax.h"

#include <cstdio>
#include <fstream>
#include <string>
#include <utility>

using namespace mirrorball;

namespace {

using tests::ParallaxErrors;
using Words = std::vector<std::string>;

struct Case
{
    const char* scene;
    const char* reflector;
    Words words; // of render's command line
};

Words joined(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::vector<Case> cases()
{
    const std::string bunny = "/usr/share/glmark2/models/bunny.obj";
    std::vector<Case> all;
    for (const char* const name : {"room", "garden"}) {
        const Words scene = {std::string("builtin:") + name};
        all.push_back({name, "sphere 0.25", joined(scene, {"--reflector", "sphere:0.25"})});
        all.push_back({name, "sphere 0.5", joined(scene, {"--reflector", "sphere:0.5"})});
        all.push_back({name, "sphere 1", joined(scene, {"--reflector", "sphere:1"})});
        all.push_back({name, "teapot × 0.2", joined(scene, {"--scale", "0.2", "--reflector", "teapot"})});
        all.push_back({name, "bunny", joined(scene, {"--reflector", bunny})});
    }
    for (const tests::HouseRoom& room : tests::houseRooms)
        all.push_back({room.name, "sphere 0.5", joined(tests::wordsOf(room), {"--reflector", "sphere:0.5"})});
    const tests::HouseRoom& living = tests::houseRooms[0];
    const Words house = {tests::houseFile, "--at", living.at, "--light", living.light};
    const Words closer = joined(house, {"--eye", living.eye});
    const Words corner = joined(house, {"--eye", "11.4,1.75,-0.7", "--fov", "65"});
    all.push_back({living.name, "sphere 0.25", joined(closer, {"--reflector", "sphere:0.25"})});
    all.push_back({living.name, "sphere 1", joined(corner, {"--reflector", "sphere:1"})});
    all.push_back({living.name, "teapot × 0.2", joined(closer, {"--scale", "0.2", "--reflector", "teapot"})});
    all.push_back({living.name, "bunny × 0.4", joined(closer, {"--scale", "0.4", "--reflector", bunny})});
    for (Case& each : all)
        each.words = joined(each.words, {"--pixels", "1280x720"});
    return all;
}

std::string placesOfRooms()
{
    std::string text = "| room | render's options |\n|---|---|\n";
    for (const tests::HouseRoom& room : tests::houseRooms)
        text += std::string("| ") + room.name + " | `--at " + room.at + " --eye " + room.eye + " --light " +
                room.light + "` |\n";
    return text;
}

std::string row(const std::string& what, const char* lookup, const ParallaxErrors& errors)
{
    char text[160];
    std::snprintf(text, sizeof text, " | %s | %.3f° | %.3f° | %.1f° | %.2f %% | %.1f %% | %.1f dB | %.4f |\n",
                  lookup, errors.mean, errors.p95, errors.max, errors.wrongPercent,
                  errors.grazingWrongPercent, errors.psnr, errors.flip);
    return "| " + what + text;
}

constexpr MapKind otherMaps[] = {MapKind::dualParaboloid, MapKind::cube, MapKind::octahedral};

// The tables, and what was found to be worse than `infinite`.
struct Tables
{
    std::string tennisBall, others, equalTexels, worse;
};

void judge(const Case& each, Tables& tables)
{
    const tests::ParallaxJudge judge(tests::renderOptions(each.words));
    const bool isAimedAt = std::string(each.reflector) == "sphere 0.5" && std::string(each.scene) != "garden";
    const std::string name = std::string(each.scene) + ", " + each.reflector;
    ParallaxErrors infinite;
    for (const tests::NamedLookup& lookup : tests::lookups) {
        const ParallaxErrors errors = judge.judge(MapKind::tennisBall, lookup.lookup);
        const bool isFirst = lookup.lookup == Lookup::infinite;
        infinite = isFirst ? errors : infinite;
        tables.tennisBall += row(isFirst ? name : "", lookup.name, errors);
        if (!tests::neverWorse(errors, infinite))
            tables.worse += "- " + name + ", `" + lookup.name + "`\n";
        if (!isAimedAt || (lookup.lookup != Lookup::distance && lookup.lookup != Lookup::layered))
            continue;
        for (const MapKind map : otherMaps) {
            const std::string what = name + ", " + std::string(mapInfo(map).name);
            tables.others += row(what, lookup.name, judge.judge(map, lookup.lookup));
            if (const int n = tests::sizeOfEqualTexels(map); n != 256)
                tables.equalTexels +=
                    row(what + ", n = " + std::to_string(n), lookup.name, judge.judge(map, lookup.lookup, n));
        }
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: parallax_table OUT.md\n");
        return 2;
    }
    Tables tables;
    for (const Case& each : cases()) {
        std::fprintf(stderr, "%s, %s\n", each.scene, each.reflector);
        judge(each, tables);
    }
    const std::string head =
        "| scene, reflector | look-up | mean | p95 | max | wrong | grazing wrong | PSNR | FLIP |\n"
        "|---|---|---|---|---|---|---|---|---|\n";
    std::ofstream file(argv[1]);
    file
        << "# Look-ups against the tracer\n\nWritten by `parallax_table`; [reflection.md](../reflection.md) "
           "says what the columns mean. Pictures of 1280 × 720, maps of n = 256. In the room and the garden "
           "camera and reflector are where `render` puts them by default. The other rooms are those of a "
           "house "
           "(`AC14-FZK-Haus.ifc`), all that are 2.2 m wide; the mirror stands in the middle, 1.1 m above the "
           "floor, but in the living room, where a stair stands there, beside it:\n\n"
        << placesOfRooms()
        << "\nThe sphere of radius 1 is seen with `--eye 11.4,1.75,-0.7 --fov 65`.\n\n## Tennis-ball map\n\n"
        << head << tables.tennisBall << "\nWorse than `infinite`, by any column but the largest angle: "
        << (tables.worse.empty() ? "nowhere.\n" : "\n\n" + tables.worse) << "\n## Other maps\n\n"
        << head << tables.others
        << "\n## Other maps with as many texels\n\nAs the tennis-ball map, and the cube, of n = 256.\n\n"
        << head << tables.equalTexels;
    if (!file.flush()) {
        std::fprintf(stderr, "'%s' cannot be written\n", argv[1]);
        return 1;
    }
    return tables.worse.empty() ? 0 : 1;
}
