#include "plan.h"

#include "support/driver.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tests::benchmark {

namespace {

using mirrorball::MapKind;

constexpr int otherN[] = {64, 128, 512, 1024};
// Measured by every method, at every size and with back faces culled; the others to compare with.
constexpr MapKind mainMaps[] = {MapKind::tennisBall, MapKind::tennisBallEven};
constexpr MapKind quickMaps[] = {MapKind::tennisBall, MapKind::tennisBallEven, MapKind::cube};

template <class List, class Value>
bool contains(const List& list, const Value& value)
{
    return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

void addRivals(Group& group)
{
    const RivalFormats formats = group.isRivalCheck ? RivalFormats::eightBit : RivalFormats::asTheLibrary;
    for (const RivalInfo& info : rivals()) {
        const bool isAside = group.isRivalCheck && info.rival != Rival::plain && info.rival != Rival::culled;
        if (isSupported(info.rival) && !isAside)
            group.entries.push_back(
                {info.rival, nullptr, MapKind::cube, Sizing::equalTexels, group.cubeN, formats});
    }
}

// Where a map has few triangles to draw, every frame is cheap.
bool isSmall(const SceneChoice& scene)
{
    return scene.name == "cards" || scene.name == "room";
}

// There perVertex and tessellated are automatic by another name: the same programs draw the same.
bool isPiecewiseLinear(MapKind map)
{
    return map == MapKind::cube || map == MapKind::octahedral;
}

// What is left out, so that a run ends within reach: methods of the least interest where they were measured
// elsewhere. A method that was asked for is never left out; perVertex and tessellated are drawn at equal texels only.
bool isMeasured(const LibraryMethod& method, MapKind map, Sizing sizing, const Group& group,
                const Options& options)
{
    const bool isAutomatic = method.method == mirrorball::CaptureMethod::automatic;
    const bool isExact = method.method == mirrorball::CaptureMethod::exact;
    if (!options.methods.empty())
        return contains(options.methods, method.name) &&
               (sizing == Sizing::equalTexels || isAutomatic || isExact);
    if (isPiecewiseLinear(map) && !isAutomatic && !isExact)
        return false;
    // Models have many surfaces behind one another.
    if (method.nearFirst)
        return contains(mainMaps, map) && group.cubeN == mainN && isModel(*group.scene);
    if (method.isTurned)
        return !options.quick && contains(mainMaps, map) && group.cubeN == mainN;
    if (method.layers == mirrorball::LayerOrder::allAtOnce)
        return !options.quick && map == MapKind::tennisBall && sizing == Sizing::equalTexels &&
               group.cubeN == mainN && !group.cullBackFaces;
    if (sizing == Sizing::equalAngle) // of the tennis-ball maps, which can be right that way, `exact` as well
        return isAutomatic || (isExact && contains(mainMaps, map));
    return contains(mainMaps, map) || isAutomatic || isExact || isSmall(*group.scene) || options.quick;
}

void addMap(Group& group, MapKind map, const Options& options)
{
    const double texels = 6.0 * group.cubeN * group.cubeN;
    const int equalTexels = mirrorball::shortSideFromTexels(map, texels);
    const std::optional<int> equalAngle = equalAngleN(map, group.cubeN);
    const auto add = [&](const LibraryMethod& method, Sizing sizing, int n) {
        if (isMeasured(method, map, sizing, group, options))
            group.entries.push_back({std::nullopt, &method, map, sizing, n, RivalFormats::asTheLibrary});
    };
    for (const LibraryMethod& method : libraryMethods()) {
        add(method, Sizing::equalTexels, equalTexels);
        if (equalAngle && *equalAngle != equalTexels)
            add(method, Sizing::equalAngle, *equalAngle);
    }
}

bool isWanted(const SceneChoice& scene, const Options& options)
{
    if (!options.scenes.empty())
        return contains(options.scenes, scene.name);
    return scene.quick || !options.quick;
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

std::vector<int> sizesOf(const SceneChoice& scene, const Options& options)
{
    if (!options.sizes.empty()) {
        std::vector<int> sizes = options.sizes; // the report's aims are those of the first
        std::ranges::sort(sizes);
        std::stable_partition(sizes.begin(), sizes.end(), [](int n) { return n == mainN; });
        return sizes;
    }
    if (options.quick || !scene.everySize)
        return {mainN};
    std::vector<int> sizes = {mainN};
    sizes.insert(sizes.end(), std::begin(otherN), std::end(otherN));
    return sizes;
}

double worstDiagonal(MapKind map, int n)
{
    return measuresOf(map, n).worstDiagonal;
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

bool isSameGroup(const Group& a, const Group& b)
{
    return a.scene == b.scene && a.cubeN == b.cubeN && a.cullBackFaces == b.cullBackFaces &&
           a.isRivalCheck == b.isRivalCheck && a.vertices == b.vertices;
}

const mirrorball::MapMeasures& measuresOf(MapKind map, int n)
{
    static std::map<std::pair<MapKind, int>, mirrorball::MapMeasures> known;
    const auto [entry, isNew] = known.try_emplace({map, n});
    if (isNew)
        entry->second = mirrorball::mapMeasures(map, n);
    return entry->second;
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
        const std::vector<int> sizes = sizesOf(scene, options);
        for (const int cubeN : sizes)
            for (const bool cullBackFaces : {false, true}) {
                if (cullBackFaces && (!scene.closed || cubeN != sizes.front()))
                    continue;
                Group group{&scene, cubeN, cullBackFaces, false, Vertices::shared, {}};
                addRivals(group);
                for (const MapKind map : mapsAt(cubeN, cullBackFaces, options))
                    addMap(group, map, options);
                groups.push_back(std::move(group));
            }
        if (scene.culledOverPlain && tests::isSoftwareRasteriser()) // which the expected ratios are of
            for (const Vertices vertices : {Vertices::shared, Vertices::own}) {
                groups.push_back({&scene, mainN, true, true, vertices, {}});
                addRivals(groups.back());
            }
    }
    return groups;
}

} // namespace tests::benchmark
