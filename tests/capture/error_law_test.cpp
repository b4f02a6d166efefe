// The constants of capture are suprema: how far an arc of a great circle departs from a straight edge on a map,
// over densely sampled arcs, is never more than the law says, and the law is not much more than is attained.
#include "capture/error_law.h"
#include "capture/views.h"
#include "support/check.h"

#include <mirrorball/maps/maps.h>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <random>
#include <string>

using namespace mirrorball;

namespace {

constexpr double degree = glm::pi<double>() / 180.0;
constexpr int steps = 32; // along an arc

glm::dvec3 slerp(const glm::dvec3& a, const glm::dvec3& b, double t)
{
    const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    return (std::sin((1.0 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

// Somewhere on the map, in units of n.
glm::dvec2 placeOf(MapKind map, int component, const glm::dvec3& direction)
{
    const MapInfo& info = mapInfo(map);
    return squareFromDirection(map, component, direction) * glm::dvec2(info.widthInN, info.heightInN);
}

// A unit direction at an angle from another one, in a heading.
glm::dvec3 ahead(const glm::dvec3& from, double angle, double heading)
{
    const glm::dvec3 helper = std::abs(from.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 east = glm::normalize(glm::cross(helper, from)), north = glm::cross(from, east);
    return std::cos(angle) * from + std::sin(angle) * (std::cos(heading) * east + std::sin(heading) * north);
}

class Random
{
public:
    double uniform(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }

    glm::dvec3 direction()
    {
        const double z = uniform(-1.0, 1.0), around = uniform(0.0, 2.0 * glm::pi<double>());
        return {std::sqrt(1.0 - z * z) * std::cos(around), std::sqrt(1.0 - z * z) * std::sin(around), z};
    }

private:
    std::mt19937_64 generator_{5};
};

// bendOf times angle² bounds the distance between a straight edge, traversed at constant speed, and the arc, in
// any heading and anywhere in the bounds. For small bounds it is attained: the most of it is returned.
double greatestShareOfBend(MapKind map, Random& random)
{
    double greatest = 0.0;
    for (int turn = 0; turn < 20000; ++turn) {
        const glm::dvec3 centre = random.direction();
        const double reach = turn % 2 == 0 ? random.uniform(1e-3, 5e-3) : random.uniform(5e-3, 0.5);
        for (int view = 0; view < capture::viewCount(map); ++view) {
            const std::optional<double> bend = capture::bendOf(map, view, centre, std::sin(reach));
            if (!bend)
                continue;
            const double heading = random.uniform(0.0, 2.0 * glm::pi<double>());
            const glm::dvec3 a = ahead(centre, reach, heading);
            const glm::dvec3 b =
                ahead(centre, turn % 4 < 2 ? reach : random.uniform(0.0, reach),
                      turn % 4 < 2 ? heading + glm::pi<double>() : random.uniform(0.0, 6.28));
            const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
            if (angle < 1e-3)
                continue;
            const glm::dvec2 from = placeOf(map, view, a), to = placeOf(map, view, b);
            double off = 0.0;
            for (int step = 1; step < steps; ++step) {
                const double t = static_cast<double>(step) / steps;
                off = std::max(off, glm::distance(placeOf(map, view, slerp(a, b, t)), glm::mix(from, to, t)));
            }
            const double share = off / (*bend * angle * angle);
            // Places are doubles of size 1: 1e-15 of them against bends of 1e-8 at least.
            if (*bend * angle * angle > 1e-8 && share > 1.0 + 1e-6)
                std::printf("%s: %g of the bend at %g %g %g, view %d, reach %g\n",
                            std::string(mapInfo(map).name).c_str(), share, centre.x, centre.y, centre.z, view,
                            reach);
            CHECK(*bend * angle * angle <= 1e-8 || share <= 1.0 + 1e-6);
            if (*bend * angle * angle > 1e-8)
                greatest = std::max(greatest, share);
        }
    }
    return greatest;
}

// The greatest sag over chord² of arcs that `allows` both ends of, with chords up to `longest`; chordOf measures
// them as the shader does.
double greatestSag(MapKind map, int component, const std::vector<glm::dvec3>& starts, double longest,
                   const std::function<bool(const glm::dvec3&)>& allows,
                   const std::function<double(const glm::dvec3&, const glm::dvec3&)>& chordOf)
{
    double greatest = 0.0;
    for (const glm::dvec3& a : starts) {
        if (!allows(a))
            continue;
        for (const double part : {0.1, 0.5, 0.9, 1.0})
            for (int index = 0; index < 72; ++index) {
                const glm::dvec3 b = ahead(a, 2.0 * std::asin(0.5 * longest * part), 5.0 * index * degree);
                const double chord = chordOf(a, b);
                if (!allows(b) || !(chord <= longest))
                    continue;
                const glm::dvec2 from = placeOf(map, component, a);
                const glm::dvec2 along = glm::normalize(placeOf(map, component, b) - from);
                for (int step = 1; step < steps; ++step) {
                    const glm::dvec2 p =
                        placeOf(map, component, slerp(a, b, static_cast<double>(step) / steps)) - from;
                    greatest = std::max(greatest, std::abs(along.x * p.y - along.y * p.x) / (chord * chord));
                }
            }
    }
    return greatest;
}

// The greatest share of tan(latitude) · along · (slanted · across + level · along) that a sag has, as
// cover_latitude.glsl takes it; steps in units of n, `across` of latitude.
double greatestShareOfSteps(MapKind map, double slanted, double level)
{
    const bool turned = map == MapKind::equirectangular; // longitude along x, 0 at -z
    double greatest = 0.0;
    for (int tenth = -600; tenth <= 600; tenth += 5) {
        const double latitude = 0.1 * tenth * degree;
        const glm::dvec3 a(0.0, std::sin(latitude), (turned ? -1.0 : 1.0) * std::cos(latitude));
        for (const double part : {0.1, 0.5, 0.9, 1.0})
            for (int index = 0; index < 180; ++index) {
                const glm::dvec3 b = ahead(a, 2.0 * std::asin(0.25 * part), 2.0 * index * degree);
                if (std::abs(a.y) > 0.866 || std::abs(b.y) > 0.866)
                    continue;
                const double sine = std::min(1.033 * std::max(std::abs(a.y), std::abs(b.y)), 0.9);
                const glm::dvec2 from = placeOf(map, 0, a), way = placeOf(map, 0, b) - from;
                const double along = std::abs(turned ? way.x : way.y),
                             across = std::abs(turned ? way.y : way.x);
                const double bound =
                    sine / std::sqrt(1.0 - sine * sine) * along * (slanted * across + level * along);
                double sag = 0.0;
                for (int step = 1; step < steps; ++step) {
                    const glm::dvec2 p =
                        placeOf(map, 0, slerp(a, b, static_cast<double>(step) / steps)) - from;
                    sag = std::max(sag, std::abs(way.x * p.y - way.y * p.x) / glm::length(way));
                }
                CHECK(sag <= bound + 1e-9);
                if (bound > 1e-7)
                    greatest = std::max(greatest, sag / bound);
            }
    }
    return greatest;
}

// The sphere map's law, as cover_sphere_map.glsl takes it, in units of n and chord²: with room, the least 1 + z along
// the arc, a sag is at most `plain` / room, and at most `leaning` · lean / room^1.5 where lean is the z of the normal.
struct DiscLaw
{
    double plain, leaning;
};

DiscLaw greatestOnDisc()
{
    constexpr double leastRoom = 0.03, longest = 0.5;
    DiscLaw greatest{};
    for (int half = 0; half <= 332; ++half) {
        const double angle = 0.5 * half * degree;
        const glm::dvec3 a(std::sin(angle), 0.0, std::cos(angle));
        for (const double part : {0.02, 0.1, 0.5, 1.0})
            for (int index = 0; index < 360; ++index) {
                const double chord = part * longest;
                const glm::dvec3 b = ahead(a, 2.0 * std::asin(0.5 * chord), index * degree);
                double room = 1.0 + std::min(a.z, b.z);
                const double roomByEnds = room - 0.51 * chord;
                const glm::dvec2 from = placeOf(MapKind::sphereMap, 0, a);
                const glm::dvec2 way = placeOf(MapKind::sphereMap, 0, b) - from;
                double sag = 0.0;
                for (int step = 1; step < steps; ++step) {
                    const glm::dvec3 between = slerp(a, b, static_cast<double>(step) / steps);
                    const glm::dvec2 p = placeOf(MapKind::sphereMap, 0, between) - from;
                    sag = std::max(sag, std::abs(way.x * p.y - way.y * p.x) / glm::length(way));
                    room = std::min(room, 1.0 + between.z);
                }
                CHECK(roomByEnds <= room);
                const double lean = std::abs(glm::normalize(glm::cross(a, b)).z);
                if (room < leastRoom)
                    continue;
                const double bend = sag / (chord * chord);
                greatest.plain = std::max(greatest.plain, bend * room);
                if (lean > 1e-3) // others are straight to the last digits
                    greatest.leaning = std::max(greatest.leaning, bend * room * std::sqrt(room) / lean);
            }
    }
    return greatest;
}

double spaceChord(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::distance(a, b);
}

// Latitude and longitude as the covers of capture's geometry stage take them: within 60 degrees (sine 0.866) of
// the plane y = 0, longitude 0 at ±z.
std::vector<glm::dvec3> latitudes(double sign)
{
    std::vector<glm::dvec3> all;
    for (int tenth = -600; tenth <= 600; tenth += 5) {
        const double latitude = 0.1 * tenth * degree;
        all.push_back({0.0, std::sin(latitude), sign * std::cos(latitude)});
    }
    return all;
}

// The most that a map stretches a radian where `allows` says so, in units of n.
double greatestStretch(MapKind map, int component, const std::vector<glm::dvec3>& starts,
                       const std::function<bool(const glm::dvec3&)>& allows)
{
    constexpr double angle = 1e-4;
    double greatest = 0.0;
    for (const glm::dvec3& a : starts)
        for (int index = 0; index < 72 && allows(a); ++index)
            greatest = std::max(
                greatest, glm::distance(placeOf(map, component, a),
                                        placeOf(map, component, ahead(a, angle, 5.0 * index * degree))) /
                              angle);
    return greatest;
}

// The widest texel of a map in radians, times its width in texels.
double greatestSpread(MapKind map)
{
    constexpr int cells = 60;
    constexpr double step = 1e-4; // of the layer's width
    const MapInfo& info = mapInfo(map);
    const double height = static_cast<double>(info.widthInN) / info.heightInN;
    double greatest = 0.0;
    for (int component = 0; component < info.components; ++component)
        for (int row = 0; row < cells; ++row)
            for (int column = 0; column < cells; ++column) {
                const glm::dvec2 at((column + 0.503) / cells, (row + 0.507) / cells);
                const glm::dvec3 here = directionFromSquare(map, component, at);
                for (int index = 0; index < 36; ++index) {
                    const double heading = 5.0 * index * degree;
                    const glm::dvec2 move(step * std::cos(heading), step * height * std::sin(heading));
                    greatest = std::max(
                        greatest, glm::distance(here, directionFromSquare(map, component, at + move)) / step);
                }
            }
    return greatest;
}

void checkStretch(const char* name, double found, double constant)
{
    std::printf("%-18s stretch %.4f of %.4f\n", name, found, constant);
    CHECK(found <= constant);
    CHECK(found >= constant / 1.25);
}

void checkSag(const char* name, double found, double constant)
{
    std::printf("%-18s sag %.4f of %.4f\n", name, found, constant);
    CHECK(found <= constant);
    CHECK(found >= constant / 1.25);
}

} // namespace

int main()
{
    Random random;
    for (const MapInfo& info : maps()) {
        if (capture::isPiecewiseLinear(info.kind))
            continue;
        const double share = greatestShareOfBend(info.kind, random);
        std::printf("%-18s at most %.4f of the bend\n", std::string(info.name).c_str(), share);
        CHECK(share >= 1.0 / 1.25);
    }

    // The constants stand in coverDefines of cover.cpp, in units of n.
    const auto within60 = [](const glm::dvec3& d) { return std::abs(d.y) <= 0.866; };
    checkSag("tennis-ball", greatestSag(MapKind::tennisBall, 0, latitudes(1.0), 0.5, within60, spaceChord),
             0.2);
    checkSag("tennis-ball-even",
             greatestSag(MapKind::tennisBallEven, 0, latitudes(1.0), 0.5, within60, spaceChord), 0.2);
    checkSag("equirectangular",
             greatestSag(MapKind::equirectangular, 0, latitudes(-1.0), 0.5, within60, spaceChord), 0.1);
    checkStretch("tennis-ball", greatestStretch(MapKind::tennisBall, 0, latitudes(1.0), within60), 1.3);
    checkStretch("tennis-ball-even", greatestStretch(MapKind::tennisBallEven, 0, latitudes(1.0), within60),
                 1.3);
    checkStretch("equirectangular", greatestStretch(MapKind::equirectangular, 0, latitudes(-1.0), within60),
                 0.65);
    struct Steps
    {
        MapKind map;
        double slanted, level;
    };
    for (const Steps& law :
         {Steps{MapKind::tennisBall, 0.366, 0.215}, Steps{MapKind::tennisBallEven, 0.72, 0.23},
          Steps{MapKind::equirectangular, 0.72, 0.43}})
    {
        const double share = greatestShareOfSteps(law.map, law.slanted, law.level);
        std::printf("%-18s at most %.4f of the steps' sag\n", std::string(mapInfo(law.map).name).c_str(),
                    share);
        CHECK(share >= 1.0 / 1.25);
    }
    std::vector<glm::dvec3> around;
    for (int tenth = 0; tenth <= 1200; tenth += 5)
        around.push_back({std::sin(0.1 * tenth * degree), 0.0, std::cos(0.1 * tenth * degree)});
    const DiscLaw onDisc = greatestOnDisc();
    checkSag("sphere-map", onDisc.plain, 0.05);
    checkSag("sphere-map, leaning", onDisc.leaning, 0.073);
    // In units of n over the root of 1 + z.
    double stretch = 0.0;
    for (int half = 0; half <= 332; ++half) {
        const glm::dvec3 d(std::sin(0.5 * half * degree), 0.0, std::cos(0.5 * half * degree));
        const auto always = [](const glm::dvec3&) { return true; };
        stretch =
            std::max(stretch, greatestStretch(MapKind::sphereMap, 0, {d}, always) * std::sqrt(1.0 + d.z));
    }
    checkStretch("sphere-map", stretch, 0.36);

    // cover_stereographic.glsl: chords on the map, of (a, b) in [-1, 1], hence n / 2.
    const auto onMap = [](const glm::dvec3& a, const glm::dvec3& b) {
        return 2.0 *
               glm::distance(placeOf(MapKind::dualParaboloid, 1, a), placeOf(MapKind::dualParaboloid, 1, b));
    };
    checkSag(
        "dual-paraboloid",
        greatestSag(
            MapKind::dualParaboloid, 1, around, 0.5, [](const glm::dvec3& d) { return d.z >= -0.6; }, onMap),
        0.1271 / 2.0);
    around.push_back({0.8, 0.0, -0.6});
    checkStretch(
        "dual-paraboloid",
        greatestStretch(MapKind::dualParaboloid, 1, around, [](const glm::dvec3& d) { return d.z >= -0.6; }),
        1.3);
    for (const auto& [map, spread] :
         std::initializer_list<std::pair<MapKind, double>>{{MapKind::tennisBall, 1.6},
                                                           {MapKind::tennisBallEven, 1.9},
                                                           {MapKind::dualParaboloid, 4.1},
                                                           {MapKind::cube, 2.1},
                                                           {MapKind::equiAngularCube, 1.9},
                                                           {MapKind::octahedral, 6.2},
                                                           {MapKind::equirectangular, 6.4}})
    {
        const double found = greatestSpread(map);
        std::printf("%-18s spread %.4f of %.4f\n", std::string(mapInfo(map).name).c_str(), found, spread);
        CHECK(found <= spread);
        CHECK(found >= spread / 1.25);
    }
    // cover_linear.glsl: chords before the axes are bent.
    const auto onFace = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::distance(glm::dvec2(a) / a.z, glm::dvec2(b) / b.z);
    };
    std::vector<glm::dvec3> face;
    for (int x = -20; x <= 20; ++x)
        for (int y = -20; y <= 20; ++y)
            face.push_back(glm::normalize(glm::dvec3(0.1 * x, 0.1 * y, 1.0)));
    checkSag(
        "equi-angular-cube",
        greatestSag(
            MapKind::equiAngularCube, 4, face, 0.5, [](const glm::dvec3& d) { return d.z >= 0.3; }, onFace),
        0.08 / 2.0);
    return 0;
}
