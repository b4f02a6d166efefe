#include "look_up_plan.h"

#include <mirrorball/maps/measures.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace tests::benchmark {

namespace {

using mirrorball::Lookup;
using mirrorball::MapKind;

constexpr int otherN[] = {64, 128, 512, 1024};
// At other sizes than the main one: what a host chooses between first.
constexpr MapKind mainMaps[] = {MapKind::tennisBall, MapKind::cube};
constexpr Lookup mainLookups[] = {Lookup::infinite, Lookup::distance, Lookup::layered};

template <class List, class Value>
bool contains(const List& list, const Value& value)
{
    return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

bool isMeasured(MapKind map, Lookup lookup, int cubeN, const Options& options)
{
    const bool isMainLookup = contains(mainLookups, lookup);
    if (!options.maps.empty())
        return contains(options.maps, map) && (cubeN == mainN || isMainLookup);
    if (options.quick)
        return map == MapKind::tennisBall && isMainLookup;
    return cubeN == mainN || (contains(mainMaps, map) && isMainLookup);
}

LookUpGroup groupOf(const MirrorScene& scene, int cubeN, const Options& options)
{
    LookUpGroup group{&scene, cubeN, {{true, MapKind::cube, Lookup::infinite, mainN}}};
    if (cubeN != mainN)
        group.entries.push_back({true, MapKind::cube, Lookup::infinite, cubeN});
    group.entries.push_back({true, MapKind::cube, Lookup::box, cubeN});
    for (const mirrorball::MapInfo& info : mirrorball::maps())
        for (const NamedLookup& lookup : lookups)
            if (isMeasured(info.kind, lookup.lookup, cubeN, options))
                group.entries.push_back({false, info.kind, lookup.lookup,
                                         mirrorball::shortSideFromTexels(info.kind, 6.0 * cubeN * cubeN)});
    return group;
}

} // namespace

std::string_view nameOf(Lookup lookup)
{
    return std::find_if(std::begin(lookups), std::end(lookups),
                        [=](const NamedLookup& each) { return each.lookup == lookup; })
        ->name;
}

std::vector<LookUpGroup> makeLookUpPlan(const Options& options, std::vector<std::string>& missing)
{
    std::vector<int> sizes = options.sizes;
    if (sizes.empty()) {
        sizes = {mainN};
        if (!options.quick)
            sizes.insert(sizes.end(), std::begin(otherN), std::end(otherN));
    }
    std::vector<LookUpGroup> groups;
    for (const MirrorScene& scene : mirrorScenes()) {
        const bool isWanted =
            options.scenes.empty() ? scene.quick || !options.quick : contains(options.scenes, scene.name);
        if (!isWanted)
            continue;
        if (!scene.source.starts_with("builtin:") && !std::filesystem::exists(scene.source)) {
            missing.push_back(std::string(scene.name) + " with a mirror");
            continue;
        }
        for (const int cubeN : sizes)
            groups.push_back(groupOf(scene, cubeN, options));
    }
    return groups;
}

} // namespace tests::benchmark
