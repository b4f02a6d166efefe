// A plain alphabet of straight strokes, so that a PNG needs no font file.
#include "drawing.h"

#include <array>

namespace tests::benchmark {

namespace {

struct Glyph
{
    char letter;
    // Strokes, separated by blanks; a point is two digits, x from 0 to 4 and y upwards from 0 to 8. The base
    // line is y = 2, small letters reach y = 6 and capitals y = 8.
    const char* strokes;
};

constexpr Glyph glyphs[] = {
    {'0', "120307183847433212"},
    {'1', "172822 1232"},
    {'2', "07183847460242"},
    {'3', "07183847463515 354443321203"},
    {'4', "32380444"},
    {'5', "480805354443321203"},
    {'6', "4738180703123243443505"},
    {'7', "084812"},
    {'8', "15060718384746351504031232434435"},
    {'9', "0312324347381807061545"},
    {'a', "16364542 441403123243"},
    {'b', "0802 0516364543321203"},
    {'c', "4536160503123243"},
    {'d', "4842 4536160503123243"},
    {'e', "04444536160503123243"},
    {'f', "48382722 1636"},
    {'g', "4641301001 4536160503123243"},
    {'h', "0802 0516364542"},
    {'i', "2622 2828"},
    {'j', "26211000 2828"},
    {'k', "0802 0446 2542"},
    {'l', "282332"},
    {'m', "0602 05162522 25364542"},
    {'n', "0602 0516364542"},
    {'o', "160503123243453616"},
    {'p', "0600 0516364543321203"},
    {'q', "4640 4536160503123243"},
    {'r', "0602 05163645"},
    {'s', "45361605143443321203"},
    {'t', "28233242 1636"},
    {'u', "0603123243 4642"},
    {'v', "062246"},
    {'w', "0612253246"},
    {'x', "0642 4602"},
    {'y', "0622 461000"},
    {'z', "06460242"},
    {'A', "022842 1535"},
    {'B', "02083847463505 3544433202"},
    {'C', "4738180703123243"},
    {'D', "02083847433202"},
    {'E', "48080242 0535"},
    {'F', "480802 0535"},
    {'G', "47381807031232434525"},
    {'H', "0802 4842 0545"},
    {'I', "2822 1838 1232"},
    {'J', "4843321203"},
    {'K', "0802 0448 1542"},
    {'L', "080242"},
    {'M', "0208254842"},
    {'N', "02084248"},
    {'O', "180703123243473818"},
    {'P', "02083847463505"},
    {'Q', "180703123243473818 2442"},
    {'R', "02083847463505 2542"},
    {'S', "473818070615354443321203"},
    {'T', "0848 2822"},
    {'U', "080312324348"},
    {'V', "082248"},
    {'W', "0812253248"},
    {'X', "0842 4802"},
    {'Y', "082548 2522"},
    {'Z', "08480242"},
    {'.', "2222"},
    {',', "2211"},
    {'\'', "2827"},
    {'-', "1535"},
    {'/', "0248"},
    {'%', "0248 0818170708 3343423233"},
    {'(', "38272332"},
    {')', "18272312"},
    {':', "2525 2222"},
    {'=', "0646 0444"},
    {'+', "2723 0545"},
};

constexpr float capHeight = 6.0f; // of the grid, for a text of a size of 0.72 em
constexpr float emPerCap = 0.72f;
constexpr float advance = 5.6f; // from letter to letter, on the grid
constexpr float baseLine = 2.0f;

const char* strokesOf(char letter)
{
    for (const Glyph& glyph : glyphs)
        if (glyph.letter == letter)
            return glyph.strokes;
    return ""; // a blank
}

} // namespace

std::vector<std::vector<glm::vec2>> strokesOf(std::string_view words, float size)
{
    const float unit = size * emPerCap / capHeight;
    std::vector<std::vector<glm::vec2>> strokes;
    float x = 0.0f;
    for (const char letter : words) {
        const std::string_view points = strokesOf(letter);
        bool startsStroke = true;
        for (std::size_t at = 0; at < points.size();) {
            if (points[at] == ' ') {
                startsStroke = true;
                ++at;
                continue;
            }
            if (startsStroke)
                strokes.emplace_back();
            startsStroke = false;
            const auto gridX = static_cast<float>(points[at] - '0');
            const auto gridY = static_cast<float>(points[at + 1] - '0');
            strokes.back().push_back({x + unit * gridX, unit * (baseLine - gridY)});
            at += 2;
        }
        x += unit * advance;
    }
    return strokes;
}

float widthOf(std::string_view words, float size)
{
    return static_cast<float>(words.size()) * size * emPerCap / capHeight * advance;
}

} // namespace tests::benchmark
