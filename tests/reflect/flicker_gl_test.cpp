// Mirrors do not flicker: along an eye's path the drawn picture changes from frame to frame at most a tenth more than
// the traced one. The argument is how many steps of a turn of 1,000 around the mirror are taken, 60 if it is left out.
#include "support/check.h"
#include "support/flicker.h"
#include "support/parallax.h"

#include <cstdio>
#include <cstdlib>

namespace {

using Words = std::vector<std::string>;

// A third of a second at 60 frames a second. A single step says little of the picture drawn: the traced one, of one ray
// a pixel, changes by leaps where edges pass the pixels' middles.
constexpr std::size_t window = 20;

void checkPath(const Words& scene, int steps)
{
    for (const char* const lookup : {"distance", "layered"}) {
        Words words = scene;
        words.insert(words.end(), {"--lookup", lookup});
        const tests::PathChanges changes = tests::changesAround(tests::renderOptions(words), steps, 1000);
        const double whole = tests::worstRatio(changes, changes.drawn.size());
        const double worst = tests::worstRatio(changes, window);
        std::printf(
            "%s, %s: %zu steps, drawn / traced change %.3f, worst of %zu steps %.3f, worst step %.3f\n",
            words[0].c_str(), lookup, changes.drawn.size(), whole, window, worst,
            tests::worstRatio(changes, 1));
        CHECK(whole <= 1.1 && worst <= 1.1);
        // It moves as well.
        CHECK(whole >= 0.5);
    }
}

} // namespace

int main(int argc, char** argv)
{
    const int steps = argc > 1 ? std::atoi(argv[1]) : 60;
    checkPath({"builtin:room", "--reflector", "sphere:0.5", "--pixels", "320x180"}, steps);
    checkPath({"/usr/share/assimp/models/IFC/AC14-FZK-Haus.ifc", "--reflector", "sphere:0.5", "--at",
               "9.8,1.1,-1.9", "--eye", "8.8,1.4,-1", "--light", "10.5,2.4,-1", "--pixels", "320x180"},
              steps);
}
