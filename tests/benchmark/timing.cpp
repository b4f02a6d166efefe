#include "timing.h"

#include "stats.h"
#include "support/driver.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tests::benchmark {

namespace {

// A GL query object; it is not among the library's kinds of objects.
class Query
{
public:
    explicit Query(GLenum target) : target_(target) { glGenQueries(1, &name_); }
    ~Query() { glDeleteQueries(1, &name_); }
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;

    void begin() const { glBeginQuery(target_, name_); }
    void end() const { glEndQuery(target_); }
    GLuint64 result() const // waits for it
    {
        GLuint64 value = 0;
        glGetQueryObjectui64v(name_, GL_QUERY_RESULT, &value);
        return value;
    }

private:
    GLenum target_;
    GLuint name_ = 0;
};

struct Samples
{
    std::vector<double> wall, cpu, gpu;

    void add(const Sample& sample)
    {
        wall.push_back(sample.wall);
        cpu.push_back(sample.cpu);
        if (sample.gpu)
            gpu.push_back(*sample.gpu);
    }
};

constexpr double fewestFrames = 2.0;

} // namespace

Quartiles quartilesOf(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    // Linear between the two nearest ranks.
    const auto at = [&](double fraction) {
        const double rank = fraction * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(rank);
        const std::size_t above = std::min(below + 1, values.size() - 1);
        return std::lerp(values[below], values[above], rank - static_cast<double>(below));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

Sample timed(const std::function<void()>& work)
{
    const std::unique_ptr<Query> elapsed =
        tests::isSoftwareRasteriser() ? nullptr : std::make_unique<Query>(GL_TIME_ELAPSED);
    // Finishes what is before it, and the GPU would wait for the CPU between a query's begin and a finish.
    examples::Stopwatch watch;
    if (elapsed)
        elapsed->begin();
    work();
    if (elapsed)
        elapsed->end();
    Sample sample{watch.wallMilliseconds(), watch.cpuMilliseconds(), std::nullopt};
    if (elapsed)
        sample.gpu = 1e-6 * static_cast<double>(elapsed->result());
    return sample;
}

const char* costName()
{
    return tests::isSoftwareRasteriser() ? "CPU" : "GPU";
}

std::vector<Timing> measure(std::span<const std::unique_ptr<Contender>> contenders, int warmUp, int frames,
                            const std::function<void()>& afterEach, double millisecondsAContender)
{
    const int tellingFrame = std::min(1, warmUp - 1); // where there is a second one: the first also compiles
    std::vector<Samples> samples(contenders.size());
    std::vector<int> last(contenders.size(), warmUp + frames);
    for (int frame = 0; frame < warmUp + frames; ++frame)
        for (std::size_t index = 0; index < contenders.size(); ++index) {
            Samples discarded;
            const bool isSlow = last[index] < warmUp + frames; // and warm by now
            if (frame < last[index] && !(isSlow && frame < warmUp))
                (frame < warmUp ? discarded : samples[index]).add(timed([&] { contenders[index]->draw(); }));
            if (frame == tellingFrame) {
                const double affordable = millisecondsAContender / discarded.wall.front();
                last[index] = warmUp + std::min(frames, static_cast<int>(std::max(affordable, fewestFrames)));
            }
            afterEach();
        }
    std::vector<Timing> timings;
    for (const Samples& of : samples)
        timings.push_back({quartilesOf(of.wall), quartilesOf(of.cpu),
                           of.gpu.empty() ? std::nullopt : std::optional<Quartiles>(quartilesOf(of.gpu)),
                           of.wall.size()});
    return timings;
}

WorkCounts countWork(Contender& contender)
{
    WorkCounts counts;
    if (!epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query") && epoxy_gl_version() < 46) {
        counts.sent = contender.draw();
        return counts;
    }
    const Query vertices(GL_VERTEX_SHADER_INVOCATIONS_ARB), primitives(GL_CLIPPING_INPUT_PRIMITIVES_ARB),
        fragments(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
    const std::array<const Query*, 3> queries = {&vertices, &primitives, &fragments};
    for (const Query* query : queries)
        query->begin();
    counts.sent = contender.draw();
    for (const Query* query : queries)
        query->end();
    counts.vertexShaderRuns = vertices.result();
    counts.primitivesClipped = primitives.result();
    counts.fragmentShaderRuns = fragments.result();
    return counts;
}

} // namespace tests::benchmark
