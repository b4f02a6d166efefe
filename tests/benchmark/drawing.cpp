#include "drawing.h"

#include <mirrorball/error.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace tests::benchmark {

namespace {

// Of the picture's pixels, each way: edges are averaged over so many samples squared.
constexpr int samples = 4;

float linearFromSrgb(float value)
{
    // IEC 61966-2-1.
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

class Raster
{
public:
    Raster(int width, int height)
        : width_(width * samples), height_(height * samples),
          pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), glm::vec3(1.0f))
    {
    }

    // Even-odd, sampled at the middle of every sample's row.
    void fill(std::vector<glm::vec2> points, const glm::vec3& srgb)
    {
        const glm::vec3 colour(linearFromSrgb(srgb.r), linearFromSrgb(srgb.g), linearFromSrgb(srgb.b));
        for (glm::vec2& point : points)
            point *= static_cast<float>(samples);
        for (int row = 0; row < height_; ++row) {
            const float y = static_cast<float>(row) + 0.5f;
            std::vector<float> crossings;
            for (std::size_t index = 0; index < points.size(); ++index) {
                const glm::vec2 a = points[index], b = points[(index + 1) % points.size()];
                if ((a.y <= y) != (b.y <= y))
                    crossings.push_back(a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y));
            }
            std::sort(crossings.begin(), crossings.end());
            for (std::size_t pair = 0; pair + 1 < crossings.size(); pair += 2)
                fillSpan(row, crossings[pair], crossings[pair + 1], colour);
        }
    }

    // Each piece as a rectangle that reaches half the thickness beyond both ends; a point becomes a dot.
    void stroke(const std::vector<glm::vec2>& points, const glm::vec3& colour, float thickness)
    {
        for (std::size_t index = 0; index + 1 < points.size(); ++index) {
            const glm::vec2 way = points[index + 1] - points[index];
            const float length = glm::length(way);
            const glm::vec2 along = 0.5f * thickness * (length > 0.0f ? way / length : glm::vec2(1.0f, 0.0f));
            const glm::vec2 across(-along.y, along.x);
            const glm::vec2 a = points[index] - along, b = points[index + 1] + along;
            fill({a - across, b - across, b + across, a + across}, colour);
        }
    }

    mirrorball::io::Image averaged() const
    {
        mirrorball::io::Image image{width_ / samples, height_ / samples, 3, {}};
        for (int row = 0; row < image.height; ++row)
            for (int column = 0; column < image.width; ++column) {
                glm::vec3 sum(0.0f);
                for (int y = 0; y < samples; ++y)
                    for (int x = 0; x < samples; ++x)
                        sum += pixels_[index(row * samples + y, column * samples + x)];
                sum /= static_cast<float>(samples * samples);
                image.pixels.insert(image.pixels.end(), {sum.r, sum.g, sum.b});
            }
        return image;
    }

private:
    std::size_t index(int row, int column) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(column);
    }

    void fillSpan(int row, float from, float to, const glm::vec3& colour)
    {
        const int first = std::max(0, static_cast<int>(std::ceil(from - 0.5f)));
        const int last = std::min(width_ - 1, static_cast<int>(std::ceil(to - 0.5f)) - 1);
        for (int column = first; column <= last; ++column)
            pixels_[index(row, column)] = colour;
    }

    int width_, height_;
    std::vector<glm::vec3> pixels_;
};

std::string hex(const glm::vec3& colour)
{
    const glm::ivec3 byte(glm::round(255.0f * colour));
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte.r & 255, byte.g & 255, byte.b & 255);
    return text;
}

std::string pointList(const std::vector<glm::vec2>& points)
{
    std::ostringstream out;
    out.precision(5);
    for (const glm::vec2& point : points)
        out << point.x << ',' << point.y << ' ';
    return out.str();
}

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char letter : text)
        result += letter == '&' ? "&amp;" : letter == '<' ? "&lt;" : std::string(1, letter);
    return result;
}

const char* svgName(Anchor anchor)
{
    return anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
}

} // namespace

void Drawing::polygon(std::vector<glm::vec2> points, const glm::vec3& colour)
{
    shapes_.emplace_back(Polygon{std::move(points), colour});
}

void Drawing::line(std::vector<glm::vec2> points, const glm::vec3& colour, float thickness)
{
    shapes_.emplace_back(Line{std::move(points), colour, thickness});
}

void Drawing::text(const glm::vec2& at, std::string_view words, float size, Anchor anchor,
                   const glm::vec3& colour, bool upwards)
{
    shapes_.emplace_back(Text{at, std::string(words), size, anchor, colour, upwards});
}

void Drawing::writeSvg(const std::filesystem::path& path) const
{
    std::ofstream out(path);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width_ << "\" height=\"" << height_
        << "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    for (const auto& shape : shapes_) {
        if (const auto* polygon = std::get_if<Polygon>(&shape))
            out << "<polygon points=\"" << pointList(polygon->points) << "\" fill=\"" << hex(polygon->colour)
                << "\"/>\n";
        else if (const auto* line = std::get_if<Line>(&shape))
            out << "<polyline points=\"" << pointList(line->points) << "\" fill=\"none\" stroke=\""
                << hex(line->colour) << "\" stroke-width=\"" << line->thickness << "\"/>\n";
        else if (const auto* text = std::get_if<Text>(&shape)) {
            out << "<text x=\"" << text->at.x << "\" y=\"" << text->at.y << "\" font-size=\"" << text->size
                << "\" text-anchor=\"" << svgName(text->anchor) << "\" fill=\"" << hex(text->colour) << '"';
            if (text->upwards)
                out << " transform=\"rotate(-90 " << text->at.x << ' ' << text->at.y << ")\"";
            out << '>' << escaped(text->words) << "</text>\n";
        }
    }
    out << "</svg>\n";
    if (!out.flush())
        throw mirrorball::Error(mirrorball::ErrorKind::unwritable, "a plot in '" + path.string() + "'",
                                "the file cannot be written", "name a place that can");
}

void Drawing::writePng(const std::filesystem::path& path) const
{
    Raster raster(width_, height_);
    for (const auto& shape : shapes_) {
        if (const auto* polygon = std::get_if<Polygon>(&shape))
            raster.fill(polygon->points, polygon->colour);
        else if (const auto* line = std::get_if<Line>(&shape))
            raster.stroke(line->points, line->colour, line->thickness);
        else if (const auto* text = std::get_if<Text>(&shape)) {
            const float share = text->anchor == Anchor::start    ? 0.0f
                                : text->anchor == Anchor::middle ? 0.5f
                                                                 : 1.0f;
            const float shift = share * widthOf(text->words, text->size);
            for (std::vector<glm::vec2> stroke : strokesOf(text->words, text->size)) {
                for (glm::vec2& point : stroke) {
                    point.x -= shift;
                    point = text->at + (text->upwards ? glm::vec2(point.y, -point.x) : point);
                }
                raster.stroke(stroke, text->colour, text->size / 11.0f); // the weight of a plain typeface
            }
        }
    }
    mirrorball::io::writePng(path, raster.averaged());
}

} // namespace tests::benchmark
