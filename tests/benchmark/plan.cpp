#include "plan.h"

#include <mirrorball/maps/measures.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

namespace tests::benchmark {

namespace {

using mirrorball::MapKind;

constexpr int mainN = 256;
// All maps are measured at mainN, the two tennis-ball maps at these as well.
constexpr int otherN[] = {64, 128, 512, 1024};
constexpr MapKind mainMaps[] = {MapKind::tennisBall, MapKind::tennisBallEven};
constexpr MapKind quickMaps[] = {MapKind::tennisBall, MapKind::tennisBallEven, MapKind::dualParaboloid,
                                 MapKind::cube};

template <class List, class Value>
bool contains(const List& list, const Value& value)
{
    return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

// Cube and octahedral maps are piecewise linear: one method draws them as well as another.
bool isPiecewiseLinear(MapKind map)
{
    return map == MapKind::cube || map == MapKind::octahedral;
}

void addRivals(Group& group)
{
    const auto add = [&](Rival rival, RivalFormats formats) {
        if (isSupported(rival))
            group.entries.push_back(
                {rival, nullptr, MapKind::cube, Sizing::equalTexels, group.cubeN, formats});
    };
    for (const RivalInfo& info : rivals())
        add(info.rival, RivalFormats::asTheLibrary);
    if (!group.scene->culledOverPlain || !group.cullBackFaces || group.cubeN != mainN)
        return;
    add(Rival::plain, RivalFormats::eightBit);
    add(Rival::culled, RivalFormats::eightBit);
}

void addMap(Group& group, MapKind map, const Options& options)
{
    const double texels = 6.0 * group.cubeN * group.cubeN;
    const int equalTexels = mirrorball::shortSideFromTexels(map, texels);
    const std::optional<int> equalAngle = equalAngleN(map, group.cubeN);
    bool first = true;
    for (const LibraryMethod& method : libraryMethods()) {
        if (!options.methods.empty() && !contains(options.methods, method.name))
            continue;
        if (!std::exchange(first, false) && isPiecewiseLinear(map))
            continue;
        const auto add = [&](Sizing sizing, int n) {
            group.entries.push_back({std::nullopt, &method, map, sizing, n, RivalFormats::asTheLibrary});
        };
        add(Sizing::equalTexels, equalTexels);
        if (equalAngle && *equalAngle != equalTexels)
            add(Sizing::equalAngle, *equalAngle);
    }
}

bool isWanted(const SceneChoice& scene, const Options& options)
{
    if (!options.scenes.empty())
        return contains(options.scenes, scene.name);
    return scene.quick || !options.quick;
}

bool isThere(const SceneChoice& scene)
{
    return scene.source.starts_with("builtin:") || std::filesystem::exists(scene.source);
}

std::vector<MapKind> mapsAt(int cubeN, bool cullBackFaces, const Options& options)
{
    if (!options.maps.empty())
        return options.maps;
    if (options.quick)
        return {std::begin(quickMaps), std::end(quickMaps)};
    if (cullBackFaces || cubeN != mainN)
        return {std::begin(mainMaps), std::end(mainMaps)};
    std::vector<MapKind> all;
    for (const mirrorball::MapInfo& info : mirrorball::maps())
        all.push_back(info.kind);
    return all;
}

std::vector<int> sizesOf(const Options& options)
{
    if (!options.sizes.empty())
        return options.sizes;
    if (options.quick)
        return {mainN};
    std::vector<int> sizes = {mainN};
    sizes.insert(sizes.end(), std::begin(otherN), std::end(otherN));
    return sizes;
}

double worstDiagonal(MapKind map, int n)
{
    static std::map<std::pair<MapKind, int>, double> known; // each takes a pass over all texels
    const auto [entry, isNew] = known.try_emplace({map, n}, 0.0);
    if (isNew)
        entry->second = mirrorball::mapMeasures(map, n).worstDiagonal;
    return entry->second;
}

} // namespace

std::string_view nameOf(Sizing sizing)
{
    return sizing == Sizing::equalTexels ? "equal texels" : "equal angle";
}

std::string Entry::methodName() const
{
    if (!rival)
        return std::string(method->name);
    const auto info = std::find_if(rivals().begin(), rivals().end(),
                                   [&](const RivalInfo& each) { return each.rival == *rival; });
    return std::string(info->name) + (formats == RivalFormats::eightBit ? ", 8-bit formats" : "");
}

std::optional<int> equalAngleN(MapKind map, int cubeN)
{
    if (map == MapKind::sphereMap)
        return std::nullopt;
    const double allowed = worstDiagonal(MapKind::cube, cubeN);
    // The widest texel shrinks as 1 / n but for small terms, so that the answer is next to this one.
    int n = std::max(1, static_cast<int>(std::lround(cubeN * worstDiagonal(map, cubeN) / allowed)));
    while (worstDiagonal(map, n) > allowed)
        ++n;
    while (n > 1 && worstDiagonal(map, n - 1) <= allowed)
        --n;
    return n;
}

std::vector<Group> makePlan(const Options& options, std::vector<std::string>& missing)
{
    std::vector<Group> groups;
    for (const SceneChoice& scene : sceneChoices()) {
        if (!isWanted(scene, options))
            continue;
        if (!isThere(scene)) {
            missing.push_back(std::string(scene.name));
            continue;
        }
        for (const int cubeN : sizesOf(options))
            for (const bool cullBackFaces : {false, true}) {
                if (cullBackFaces && (!scene.closed || cubeN != sizesOf(options).front()))
                    continue;
                Group group{&scene, cubeN, cullBackFaces, {}};
                addRivals(group);
                for (const MapKind map : mapsAt(cubeN, cullBackFaces, options))
                    addMap(group, map, options);
                groups.push_back(std::move(group));
            }
    }
    return groups;
}

} // namespace tests::benchmark
