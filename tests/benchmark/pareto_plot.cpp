#include "pareto_plot.h"

#include "drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <span>

namespace tests::benchmark {

namespace {

// The picture: a square-ish field for the points, the legend to the right of it.
constexpr int width = 960, height = 600;
constexpr glm::vec2 fieldLow(90, 540), fieldHigh(650, 50); // y down
constexpr float legendX = 675;
constexpr float textSize = 13, titleSize = 16;
constexpr float markerRadius = 6;
constexpr glm::vec3 black(0.0f), grey(0.55f), lightGrey(0.88f);

// One colour a map, in the order of MapKind; after Okabe and Ito, distinguishable without colour vision.
constexpr glm::vec3 mapColours[] = {{0.00f, 0.45f, 0.70f}, {0.34f, 0.71f, 0.91f}, {0.90f, 0.62f, 0.00f},
                                    {0.35f, 0.35f, 0.35f}, {0.00f, 0.62f, 0.45f}, {0.80f, 0.47f, 0.65f},
                                    {0.84f, 0.37f, 0.00f}, {0.75f, 0.70f, 0.05f}};

// Values to places along an axis: linear, or logarithmic with a tick at every power of `base`.
struct Axis
{
    double low, high;
    double base; // 0 where linear

    float share(double value) const
    {
        const auto scale = [&](double v) { return base > 0.0 ? std::log(v) : v; };
        return static_cast<float>((scale(value) - scale(low)) / (scale(high) - scale(low)));
    }

    std::vector<double> ticks() const
    {
        std::vector<double> result;
        if (base > 0.0) {
            for (double value = low; value <= high * 1.001; value *= base)
                result.push_back(value);
            return result;
        }
        const double rough = (high - low) / 6.0;
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        const double step = power * (rough / power < 2.0 ? 2.0 : rough / power < 5.0 ? 5.0 : 10.0);
        for (double value = std::ceil(low / step) * step; value <= high + 1e-9 * step; value += step)
            result.push_back(value);
        return result;
    }
};

// From the power of the base at or below `low` to the one at or above `high`.
Axis logarithmicAxis(double low, double high, double base)
{
    return {std::pow(base, std::floor(std::log(low) / std::log(base))),
            std::pow(base, std::ceil(std::log(high) / std::log(base))), base};
}

std::string label(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

// The marker of the index-th method: a polygon with so many corners, turned.
std::vector<glm::vec2> marker(std::size_t index, const glm::vec2& at, float radius)
{
    constexpr struct
    {
        int corners;
        float turn; // radians
    } shapes[] = {{24, 0.0f},  {4, 0.785f},  {3, -1.571f}, {4, 0.0f},
                  {3, 1.571f}, {5, -1.571f}, {6, 0.0f},    {3, 0.0f}};
    const auto& shape = shapes[index % std::size(shapes)];
    std::vector<glm::vec2> points;
    for (int corner = 0; corner < shape.corners; ++corner) {
        const float angle = shape.turn + 2.0f * std::numbers::pi_v<float> * static_cast<float>(corner) /
                                             static_cast<float>(shape.corners);
        points.push_back(at + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

void drawMarker(Drawing& drawing, std::size_t shape, const glm::vec2& at, const glm::vec3& colour,
                bool filled)
{
    drawing.polygon(marker(shape, at, markerRadius), colour);
    if (!filled)
        drawing.polygon(marker(shape, at, 0.55f * markerRadius), glm::vec3(1.0f));
}

class Plotter
{
public:
    Plotter(const PlotTexts& texts, std::span<const PlotPoint> points)
        : texts_(texts), points_(points), drawing_(width, height)
    {
        for (const PlotPoint& point : points_)
            if (std::find(methods_.begin(), methods_.end(), point.method) == methods_.end())
                methods_.push_back(point.method);
        setAxes();
        drawAxes();
        drawFront();
        for (const PlotPoint& point : points_)
            drawMarker(drawing_, shapeOf(point), place(point), colourOf(point), point.isFilled);
        drawLegend();
    }

    const Drawing& drawing() const { return drawing_; }

private:
    // Zero errors stand on the lowest line of a logarithmic axis.
    void setAxes()
    {
        double cheapest = 1.0, dearest = 1.0, most = 0.0, least = std::numeric_limits<double>::infinity();
        for (const PlotPoint& point : points_) {
            cheapest = std::min(cheapest, point.cost);
            dearest = std::max(dearest, point.cost);
            most = std::max(most, point.error);
            if (point.error > 0.0)
                least = std::min(least, point.error);
        }
        cost_ = logarithmicAxis(cheapest, 1.02 * dearest, 2.0);
        if (!texts_.isLogarithmic)
            error_ = {0.9 * least, 1.05 * most, 0.0};
        else if (most > 0.0)
            error_ = logarithmicAxis(0.1 * least, most, 10.0);
        else
            error_ = {0.001, 1.0, 10.0}; // nothing is wrong anywhere
    }

    glm::vec2 place(const PlotPoint& point) const
    {
        const double error = texts_.isLogarithmic && !(point.error > 0.0) ? error_.low : point.error;
        return {std::lerp(fieldLow.x, fieldHigh.x, cost_.share(point.cost)),
                std::lerp(fieldLow.y, fieldHigh.y, error_.share(error))};
    }

    std::size_t shapeOf(const PlotPoint& point) const
    {
        return static_cast<std::size_t>(std::find(methods_.begin(), methods_.end(), point.method) -
                                        methods_.begin());
    }

    static glm::vec3 colourOf(const PlotPoint& point)
    {
        return point.map ? mapColours[static_cast<std::size_t>(*point.map)] : black;
    }

    void drawAxes()
    {
        for (const double tick : cost_.ticks()) {
            const float x = std::lerp(fieldLow.x, fieldHigh.x, cost_.share(tick));
            drawing_.line({{x, fieldLow.y}, {x, fieldHigh.y}}, lightGrey, 1);
            drawing_.text({x, fieldLow.y + 20}, label(tick), textSize, Anchor::middle);
        }
        for (const double tick : error_.ticks()) {
            const float y = std::lerp(fieldLow.y, fieldHigh.y, error_.share(tick));
            drawing_.line({{fieldLow.x, y}, {fieldHigh.x, y}}, lightGrey, 1);
            const bool isZero = texts_.isLogarithmic && tick == error_.low;
            drawing_.text({fieldLow.x - 8, y + 4}, isZero ? "0" : label(tick), textSize, Anchor::end);
        }
        drawing_.line({{fieldLow.x, fieldHigh.y}, fieldLow, {fieldHigh.x, fieldLow.y}}, black, 1.5f);
        drawing_.text({0.5f * (fieldLow.x + fieldHigh.x), fieldLow.y + 45}, texts_.costAxis, textSize,
                      Anchor::middle);
        drawing_.text({30, 0.5f * (fieldLow.y + fieldHigh.y)}, texts_.errorAxis, textSize, Anchor::middle,
                      black, true);
        drawing_.text({fieldLow.x, 30}, texts_.title, titleSize);
    }

    // Those that no other beats in both cost and error, as stairs.
    void drawFront()
    {
        std::vector<PlotPoint> sorted(points_.begin(), points_.end());
        std::sort(sorted.begin(), sorted.end(), [](const PlotPoint& a, const PlotPoint& b) {
            return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
        });
        std::vector<glm::vec2> stairs;
        double least = std::numeric_limits<double>::infinity();
        for (const PlotPoint& point : sorted) {
            if (point.error >= least)
                continue;
            least = point.error;
            const glm::vec2 at = place(point);
            stairs.push_back(stairs.empty() ? glm::vec2(at.x, fieldHigh.y)
                                            : glm::vec2(at.x, stairs.back().y));
            stairs.push_back(at);
        }
        stairs.push_back({fieldHigh.x, stairs.back().y});
        drawing_.line(std::move(stairs), {0.85f, 0.1f, 0.1f}, 2);
    }

    void legendLine(float& y, std::size_t shape, const glm::vec3& colour, bool filled,
                    const std::string& text)
    {
        drawMarker(drawing_, shape, {legendX, y - 5}, colour, filled);
        drawing_.text({legendX + 14, y}, text, textSize);
        y += 20;
    }

    void drawLegend()
    {
        float y = fieldHigh.y + 10;
        for (const bool byHand : {true, false}) {
            drawing_.text({legendX - 6, y},
                          byHand ? std::string("by hand, black") : "mirrorball, by " + texts_.method,
                          textSize);
            y += 20;
            for (std::size_t method = 0; method < methods_.size(); ++method) {
                const auto used = std::find_if(points_.begin(), points_.end(), [&](const PlotPoint& point) {
                    return !point.map == byHand && shapeOf(point) == method;
                });
                if (used != points_.end())
                    legendLine(y, method, byHand ? black : grey, true, methods_[method]);
            }
            y += 8;
        }
        drawing_.text({legendX - 6, y}, "mirrorball, by map", textSize);
        y += 20;
        for (const mirrorball::MapInfo& info : mirrorball::maps()) {
            const auto used = std::find_if(points_.begin(), points_.end(),
                                           [&](const PlotPoint& point) { return point.map == info.kind; });
            if (used != points_.end())
                legendLine(y, 0, mapColours[static_cast<std::size_t>(info.kind)], true,
                           std::string(info.name));
        }
        y += 8;
        legendLine(y, 0, grey, true, texts_.filled);
        legendLine(y, 0, grey, false, texts_.hollow);
        drawing_.line({{legendX - 7, y - 5}, {legendX + 7, y - 5}}, {0.85f, 0.1f, 0.1f}, 2);
        drawing_.text({legendX + 14, y}, "Pareto front", textSize);
    }

    const PlotTexts& texts_;
    std::span<const PlotPoint> points_;
    std::vector<std::string> methods_; // the marker's shape is the index
    Axis cost_{}, error_{};
    Drawing drawing_;
};

} // namespace

void writeParetoPlot(const std::filesystem::path& pathWithoutEnding, const PlotTexts& texts,
                     const std::vector<PlotPoint>& points)
{
    const Plotter plotter(texts, points);
    plotter.drawing().writeSvg(pathWithoutEnding.string() + ".svg");
    plotter.drawing().writePng(pathWithoutEnding.string() + ".png");
}

} // namespace tests::benchmark
