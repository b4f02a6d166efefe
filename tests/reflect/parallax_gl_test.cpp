// Look-ups against the tracer: how far what a mirror shows is from what it should show.
#include "support/check.h"
#include "support/parallax.h"

#include <cstdio>

using namespace mirrorball;

namespace {

struct Named
{
    const char* name;
    Lookup lookup;
};

constexpr Named lookups[] = {{"infinite", Lookup::infinite},
                             {"sphere", Lookup::sphere},
                             {"box", Lookup::box},
                             {"distance", Lookup::distance},
                             {"layered", Lookup::layered}};

void report(const char* scene, const char* name, const tests::ParallaxErrors& errors)
{
    std::printf(
        "%-24s %-9s %7d pixels, mean %7.4f p95 %7.3f max %7.2f degrees, wrong %6.3f %% (grazing %6.2f %%), "
        "%5.2f dB\n",
        scene, name, errors.pixels, errors.mean, errors.p95, errors.max, errors.wrongPercent,
        errors.grazingWrongPercent, errors.psnr);
}

} // namespace

int main(int argc, char** argv)
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    const tests::ParallaxJudge judge(tests::renderOptions(words));
    for (const Named& lookup : lookups)
        report(words[0].c_str(), lookup.name, judge.judge(MapKind::tennisBall, lookup.lookup));
    return 0;
}
