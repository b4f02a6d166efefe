// Where exact capture puts varyings: every scalar has a place of its own, is read where it was written, and no more
// room is taken than is counted.
#include "capture/packing.h"
#include "capture/varyings.h"

#include "support/check.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace mirrorball::capture;

namespace {

Varying varying(const std::string& type, const std::string& name, bool flat = false, int elements = 1)
{
    Varying made{0, type, name, elements > 1 ? "[]" : "", flat ? "flat" : "", "", name};
    made.elements = elements;
    return made;
}

// "mirrorballCapture_packed[3].y" and so on, in the order of a text.
std::vector<std::string> placesIn(const std::string& text)
{
    std::vector<std::string> places;
    for (std::size_t at = text.find(prefix + "packed"); at != std::string::npos;
         at = text.find(prefix + "packed", at + 1))
        places.push_back(text.substr(at, text.find('.', at) + 2 - at));
    return places;
}

// Returns all places of a varying.
std::vector<std::string> checkReadsWhatIsWritten(const Packing& packing, std::size_t index, const Varying& of)
{
    std::vector<std::string> all;
    for (int corner = isFlat(of) ? 2 : 0; corner < 3; ++corner)
        for (int element = 0; element < of.elements; ++element) {
            const std::vector<std::string> written =
                placesIn(packing.write(index, corner, element, "source"));
            CHECK(written == placesIn(packing.read(index, corner, element)));
            all.insert(all.end(), written.begin(), written.end());
        }
    return all;
}

void checkApart(const std::vector<Varying>& varyings, int floats, int integers)
{
    const Packing packing(varyings);
    std::set<std::string> taken;
    for (std::size_t index = 0; index < varyings.size(); ++index)
        for (const std::string& place : checkReadsWhatIsWritten(packing, index, varyings[index]))
            CHECK(taken.insert(place).second);
    CHECK(taken.size() == static_cast<std::size_t>(floats + integers));
    CHECK(packing.scalars() == (floats + 3) / 4 * 4 + (integers + 3) / 4 * 4);
}

// One name in two branches of an #if: one place, with room for the larger, whichever comes first.
void checkBranches(const Varying& first, const Varying& second, int floats)
{
    const std::vector<Varying> varyings = {varying("vec2", "before"), first, varying("float", "between"),
                                           second, varying("vec3", "behind")};
    const Packing packing(varyings);
    std::set<std::string> others, shared;
    for (const std::size_t index : {0u, 2u, 4u})
        for (const std::string& place : checkReadsWhatIsWritten(packing, index, varyings[index]))
            CHECK(others.insert(place).second);
    for (const std::size_t index : {1u, 3u})
        for (const std::string& place : checkReadsWhatIsWritten(packing, index, varyings[index]))
            shared.insert(place);
    for (const std::string& place : shared)
        CHECK(others.count(place) == 0);
    CHECK(shared.size() == static_cast<std::size_t>(floats));
    CHECK(packing.scalars() == (6 + 3 + 9 + floats + 3) / 4 * 4);
}

} // namespace

int main()
{
    checkApart({}, 0, 0);
    checkApart({varying("float", "a")}, 3, 0);
    checkApart({varying("vec3", "position"), varying("vec3", "normal"), varying("vec2", "uv")}, 24, 0);
    checkApart({varying("mat2x3", "m"), varying("uvec3", "u", true), varying("float", "f", true, 5),
                varying("ivec2", "i", true, 3), varying("vec4", "v", false, 2), varying("mat4", "turned")},
               18 + 5 + 24 + 48, 3 + 6);
    checkBranches(varying("float", "x", true), varying("float", "x"), 3);
    checkBranches(varying("float", "x"), varying("float", "x", true), 3);
    checkBranches(varying("vec2", "x"), varying("vec2", "x", false, 4), 24);

    // What is put together is of the varying's own type.
    const std::vector<Varying> typed = {varying("mat2x3", "m"), varying("uint", "u", true)};
    const Packing packing(typed);
    CHECK(packing.read(0, 0, 0).starts_with("mat2x3("));
    CHECK(packing.write(0, 0, 0, "m").find("= m[1].z;") != std::string::npos);
    CHECK(packing.read(1, 2, 0).starts_with("uint("));
    CHECK(packing.write(1, 2, 0, "u").find("= int(u);") != std::string::npos);
    return 0;
}
