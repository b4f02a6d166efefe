// What is measured against what: groups of contenders whose frames are drawn in turn.
#pragma once

#include "contender.h"
#include "rivals.h"

#include <mirrorball/maps/maps.h>
#include <mirrorball/maps/measures.h>

#include <optional>
#include <string>
#include <vector>

namespace tests::benchmark {

// Of the cube: the size that every scene is measured at, and that aims are of.
constexpr int mainN = 256;

// How a map's n follows from the cube's n of its group.
enum class Sizing {
    equalTexels, // as many texels in all as the cube map
    equalAngle,  // no texel is wider (corner to corner) than the cube map's widest
};
std::string_view nameOf(Sizing sizing);

struct Entry
{
    std::optional<Rival> rival; // or else one of the library's:
    const LibraryMethod* method = nullptr;
    mirrorball::MapKind map = mirrorball::MapKind::cube;
    Sizing sizing = Sizing::equalTexels;
    int n = 0;
    RivalFormats formats = RivalFormats::asTheLibrary;

    std::string methodName() const;
};

enum class Vertices {
    shared, // as the scene has them
    own     // every triangle has three of its own
};

struct Group
{
    const SceneChoice* scene;
    int cubeN; // of the rivals
    bool cullBackFaces;
    bool isRivalCheck; // nothing but six passes, plain and culled, in 8-bit formats
    Vertices vertices;
    std::vector<Entry> entries; // "six passes, culled" is among them
};
bool isSameGroup(const Group& a, const Group& b); // but for their entries

// errors: those of pass 1, of rows that earlier reports bring; nothing: only these.
enum class Part { both, captures, lookUps, errors, nothing };

struct Options
{
    Part part = Part::both;
    bool quick = false;
    int frames = 30;
    std::vector<std::string> scenes, methods;
    std::vector<mirrorball::MapKind> maps;
    std::vector<int> sizes;        // the cube's n
    std::vector<std::string> from; // folders of earlier reports
    std::string folder;
};

// Empty lists mean all, or with quick a selection. Scenes whose file is not there are left out and named in
// `missing`. Needs a context.
std::vector<Group> makePlan(const Options& options, std::vector<std::string>& missing);

// mapMeasures, which passes over all texels, kept for the next time.
const mirrorball::MapMeasures& measuresOf(mirrorball::MapKind map, int n);

// The smallest n of the map with which no texel is wider than the widest of a cube map of n = cubeN; empty
// for the sphere map, whose rim is infinitely stretched.
std::optional<int> equalAngleN(mirrorball::MapKind map, int cubeN);

} // namespace tests::benchmark
