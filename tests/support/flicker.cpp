#include "support/flicker.h"

#include "support/picture_error.h"
#include "trace.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tests {

namespace {

using render::Picture;

std::vector<render::Camera> turnAround(const render::Setup& setup, int steps, int stepsATurn)
{
    std::vector<render::Camera> path;
    const glm::dvec3 centre = setup.mirrors[0].reflector.at;
    for (int step = 0; step <= steps; ++step) {
        const double angle = 2.0 * std::numbers::pi * step / stepsATurn;
        const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, setup.camera.up));
        render::Camera camera = setup.camera;
        camera.eye = centre + turn * (setup.camera.eye - centre);
        camera.look = centre + turn * (setup.camera.look - centre);
        path.push_back(camera);
    }
    return path;
}

double changeOf(const Picture& before, const Picture& after, const std::vector<bool>& counted)
{
    double sum = 0.0;
    for (std::size_t index = 0; index < counted.size(); ++index)
        for (int channel = 0; counted[index] && channel < 3; ++channel)
            sum += std::abs(encoded(after.samples[index].colour[channel]) -
                            encoded(before.samples[index].colour[channel]));
    return sum;
}

// The pictures of one camera.
struct Both
{
    Picture drawn, traced;

    bool isMirror(std::size_t index) const
    {
        return drawn.reflectors[index] == 1 && traced.reflectors[index] == 1;
    }
};

void addStep(PathChanges& changes, const Both& before, const Both& after)
{
    std::vector<bool> counted(after.drawn.samples.size());
    for (std::size_t index = 0; index < counted.size(); ++index)
        counted[index] = before.isMirror(index) && after.isMirror(index);
    changes.drawn.push_back(changeOf(before.drawn, after.drawn, counted));
    changes.traced.push_back(changeOf(before.traced, after.traced, counted));
}

} // namespace

PathChanges changesAround(const render::Options& options, int steps, int stepsATurn)
{
    render::Setup setup = render::setupOf(options);
    const std::vector<render::Camera> path = turnAround(setup, steps, stepsATurn);
    PathChanges changes;
    Both before;
    std::size_t number = 0;
    const auto pixels = [&](const Picture& samples) {
        return render::reduced(samples, options.supersample, options.view);
    };
    render::drawPath(setup, options, path, [&](const Picture& drawn) {
        setup.camera = path[number];
        Both now{pixels(drawn), pixels(render::tracePicture(setup, options))};
        if (number++ > 0)
            addStep(changes, before, now);
        before = std::move(now);
    });
    return changes;
}

double worstRatio(const PathChanges& changes, std::size_t window)
{
    double worst = 0.0;
    for (std::size_t first = 0; first + window <= changes.drawn.size(); ++first) {
        const auto sum = [&](const std::vector<double>& steps) {
            const auto from = steps.begin() + static_cast<std::ptrdiff_t>(first);
            return std::accumulate(from, from + static_cast<std::ptrdiff_t>(window), 0.0);
        };
        worst = std::max(worst, sum(changes.drawn) / sum(changes.traced));
    }
    return worst;
}

} // namespace tests
