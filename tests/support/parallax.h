// How far a mirror's picture is from the traced one: where it shows the wrong surface, and how the shaded
// pictures differ.
#pragma once

#include "draw.h"
#include "trace.h"

#include <optional>
#include <string>
#include <vector>

namespace tests {

// Over the pixels of the first reflector in which something is mirrored, or shown as if.
struct ParallaxErrors
{
    int pixels = 0;
    // Between the surface shown and the one that should be, seen from the probe, in degrees; where one of
    // them is nothing the pixel is wrong and has no angle.
    double mean = 0.0, p95 = 0.0, max = 0.0;
    // Share of pixels that show a position more than 0.03 * (1 + length of the reflected ray) off, or none;
    // grazing ones, where the cosine between normal and eye is below 0.1, count for themselves.
    double wrongPercent = 0.0, grazingWrongPercent = 0.0;
    double psnr = 0.0; // decibels, of the sRGB encoded colours
    double flip = 0.0; // the mean over the reflector's pixels
};

struct NamedLookup
{
    const char* name;
    mirrorball::Lookup lookup;
};

constexpr NamedLookup lookups[] = {{"infinite", mirrorball::Lookup::infinite},
                                   {"sphere", mirrorball::Lookup::sphere},
                                   {"box", mirrorball::Lookup::box},
                                   {"distance", mirrorball::Lookup::distance},
                                   {"layered", mirrorball::Lookup::layered}};

constexpr const char* houseFile = "/usr/share/assimp/models/IFC/AC14-FZK-Haus.ifc";

// A room of the house: where the mirror stands, and seen from where under which light.
struct HouseRoom
{
    const char* name;
    const char* at;
    const char* eye;
    const char* light;
};

// Every room of the file's (its IfcSpaces) that is 2.2 m wide, which leaves out the corridor. The mirror stands in its
// middle, 1.1 m above the floor, the eye at (-1, 0.3, 0.9) from it, the light at (0.7, 1.3, 0.9). A stair fills the
// middle of the living room: there it is the middle of what is free beside it.
constexpr HouseRoom houseRooms[] = {{"living room", "9.8,1.1,-1.9", "8.8,1.4,-1", "10.5,2.4,-1"},
                                    {"bedroom", "9.675,1.1,-6.975", "8.675,1.4,-6.075", "10.375,2.4,-6.075"},
                                    {"bathroom", "5.725,1.1,-7.845", "4.725,1.4,-6.945", "6.425,2.4,-6.945"},
                                    {"study", "2.05,1.1,-7.845", "1.05,1.4,-6.945", "2.75,2.4,-6.945"},
                                    {"kitchen", "2.05,1.1,-2.155", "1.05,1.4,-1.255", "2.75,2.4,-1.255"},
                                    {"gallery", "6,3.8,-5", "5,4.1,-4.1", "6.7,5.1,-4.1"}};

std::vector<std::string> wordsOf(const HouseRoom& room); // scene, eye and light, as on render's command line

// Whether a look-up errs no more than `infinite` does, by any of the measures but the largest angle, which is one
// pixel's.
bool neverWorse(const ParallaxErrors& errors, const ParallaxErrors& infinite);

// The traced pictures of one setup, and drawn ones against them.
class ParallaxJudge
{
public:
    // `options` as on render's command line; its map, look-up and view do not matter.
    explicit ParallaxJudge(const render::Options& options);

    // As the library draws it, in a context of its own, with the options' size of the map or another one.
    ParallaxErrors judge(mirrorball::MapKind map, mirrorball::Lookup lookup,
                         std::optional<int> n = std::nullopt) const;

    // The positions that a picture shows, and its colours, drawn by whomever.
    ParallaxErrors judge(const render::Picture& positions, const render::Picture& colours) const;

    const render::Setup& setup() const { return setup_; }

private:
    render::Picture draw(const render::Options& options, examples::View view) const;

    render::Options options_;
    render::Setup setup_;
    render::Picture positions_, colours_;
};

// The largest n with which a map has no more texels than the tennis-ball map of n = 256.
int sizeOfEqualTexels(mirrorball::MapKind map);

// The direction through the middle of a sample of the picture, the top row first.
glm::dvec3 unitRay(const render::Camera& camera, int x, int y);

// A command line of render, parsed. The output need not be given.
render::Options renderOptions(const std::vector<std::string>& words);

} // namespace tests
