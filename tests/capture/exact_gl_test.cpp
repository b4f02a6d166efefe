// Exact capture against a ray tracer, at every texel.
#include "support/check.h"
#include "support/exactness.h"

#include <mirrorball/headless/context.h>

#include <cstdio>
#include <cstring>

using namespace mirrorball;

int main(int argc, char** argv)
{
    const headless::Context context;
    const char* const scene = argc > 1 ? argv[1] : "builtin:room";
    const int n = argc > 2 ? std::atoi(argv[2]) : 64;
    const examples::Scene loaded = examples::loadScene(scene);
    for (const MapInfo& info : maps())
        for (const CaptureMethod method :
             {CaptureMethod::exact, CaptureMethod::automatic, CaptureMethod::perVertex}) {
            const tests::Exactness found = tests::exactnessOf(
                loaded, {0.01, 0.02, 0.03},
                {.map = info.kind, .n = n, .near = 0.05f, .far = 10000.0f, .method = method});
            std::printf("%-18s %d: wrong %.4f %% (%zu, %zu far off), holes %zu, distance %.2g\n",
                        std::string(info.name).c_str(), static_cast<int>(method), found.wrongPercent(),
                        found.wrong, found.wrongFarOff, found.holes, found.worstDistance);
        }
    return 0;
}
