// A picture of filled polygons, lines and text, written as SVG and as PNG.
#pragma once

#include <mirrorball/io/image.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tests::benchmark {

enum class Anchor { start, middle, end };

// Coordinates are pixels from the top left corner, y down; colours are sRGB in [0, 1].
class Drawing
{
public:
    Drawing(int width, int height) : width_(width), height_(height) {}

    void polygon(std::vector<glm::vec2> points, const glm::vec3& colour);
    void line(std::vector<glm::vec2> points, const glm::vec3& colour, float thickness);
    // `at` is on the base line; upwards means turned by 90 degrees, read from below.
    void text(const glm::vec2& at, std::string_view words, float size, Anchor anchor = Anchor::start,
              const glm::vec3& colour = {0, 0, 0}, bool upwards = false);

    // Throws mirrorball::Error, unwritable.
    void writeSvg(const std::filesystem::path& path) const;
    void writePng(const std::filesystem::path& path) const;

private:
    struct Polygon
    {
        std::vector<glm::vec2> points;
        glm::vec3 colour;
    };
    struct Line
    {
        std::vector<glm::vec2> points;
        glm::vec3 colour;
        float thickness;
    };
    struct Text
    {
        glm::vec2 at;
        std::string words;
        float size;
        Anchor anchor;
        glm::vec3 colour;
        bool upwards;
    };

    int width_, height_;
    std::vector<std::variant<Polygon, Line, Text>> shapes_;
};

// The strokes of a text in the PNG: polylines, with `at` on the base line, y down.
std::vector<std::vector<glm::vec2>> strokesOf(std::string_view words, float size);
float widthOf(std::string_view words, float size);

} // namespace tests::benchmark
