// Recorded formulas print as a careful person would write them: brackets where they are needed and nowhere
// else, variables for what is named or shared, numbers that GLSL reads as float.
#include "support/check.h"

#include <mirrorball/math/glsl_scalar.h>

namespace {

using Real = mirrorball::GlslScalar;
using mirrorball::GlslTree;
using mirrorball::GlslType;

Real variable(const char* name)
{
    return Real(mirrorball::glslVariable(GlslType::real, name));
}

std::string printed(const GlslTree& tree)
{
    const mirrorball::GlslBody body = mirrorball::printedGlsl(std::span(&tree, 1), "p_", "");
    return body.declarations + body.results[0];
}
std::string printed(const Real& value)
{
    return printed(value.tree);
}

void checkPrinted(const std::string& actual, const std::string& expected)
{
    if (actual != expected)
        std::fprintf(stderr, "printed: %s\nwanted:  %s\n", actual.c_str(), expected.c_str());
    CHECK(actual == expected);
}

void checkBrackets()
{
    const Real a = variable("a"), b = variable("b"), c = variable("d.x");
    checkPrinted(printed(a + b + c), "a + b + d.x");
    checkPrinted(printed(a + (b + c)), "a + (b + d.x)");
    checkPrinted(printed(a - (b - c)), "a - (b - d.x)");
    checkPrinted(printed(a * b + c), "a * b + d.x");
    checkPrinted(printed(a * (b + c)), "a * (b + d.x)");
    checkPrinted(printed(a / (b * c)), "a / (b * d.x)");
    checkPrinted(printed(a * b / c), "a * b / d.x");
    checkPrinted(printed(-(a + b)), "-(a + b)");
    checkPrinted(printed(-(-a)), "-(-a)");
    checkPrinted(printed(-Real(-2)), "-(-2.0)");
    checkPrinted(printed(-a * b), "-a * b");
    checkPrinted(printed(abs(a + b)), "abs(a + b)");
    checkPrinted(printed(select(a < b, a + b, -c)), "a < b ? a + b : -d.x");
    checkPrinted(printed(Real(2) * select(a < b, a, b)), "2.0 * (a < b ? a : b)");
    checkPrinted(printed(select(a < b, select(a < c, a, b), c)), "a < b ? (a < d.x ? a : b) : d.x");
    checkPrinted(printed(select(a < b, c, select(a < c, a, b))), "a < b ? d.x : a < d.x ? a : b");
    checkPrinted(printed(select(either(both(a < b, b <= c), isNan(a)), a, b)),
                 "(a < b && b <= d.x) || p_isNan(a) ? a : b");
}

void checkNumbers()
{
    checkPrinted(printed(Real(1)), "1.0");
    checkPrinted(printed(Real(-0.5)), "-0.5");
    checkPrinted(printed(Real(0.1)), "0.1");
    checkPrinted(printed(Real(0x1p-126)), "1.1754944e-38");
    checkPrinted(printed(Real(1e20)), "1e+20");
}

void checkVariables()
{
    const Real a = variable("a"), b = variable("b");
    const Real shared = a + b;
    checkPrinted(printed(shared * shared), "    float t = a + b;\nt * t");
    checkPrinted(printed(named(a + b, "sum") * b), "    float sum = a + b;\nsum * b");
    checkPrinted(printed(-a + b * -a), "-a + b * -a");
    const Real negative = -a;
    checkPrinted(printed(negative * negative), "-a * -a");
    // A name that is taken, by an argument or another variable, gets a number.
    checkPrinted(printed(named(a * b, "a") * b), "    float a2 = a * b;\na2 * b");
    const auto condition = named(a < b, "smaller");
    checkPrinted(printed(select(condition, a, b)), "    bool smaller = a < b;\nsmaller ? a : b");
    // Evaluated in C++ from right to left or from left to right: the text is the same.
    const Real product = named(a * b, "product"), sum = named(a + b, "sum");
    checkPrinted(printed(max(sum, product)),
                 "    float sum = a + b;\n    float product = a * b;\nmax(sum, product)");
}

void checkPrecision()
{
    const Real a = variable("a");
    const mirrorball::GlslIndex index =
        select(a < Real(0), mirrorball::GlslIndex(0),
               mirrorball::GlslIndex(mirrorball::glslVariable(GlslType::index, "k")));
    const GlslTree trees[] = {named(a + a, "twice").tree, index.tree};
    const mirrorball::GlslBody body = mirrorball::printedGlsl(trees, "", "highp ");
    checkPrinted(body.declarations, "    highp float twice = a + a;\n");
    checkPrinted(body.results[0], "twice");
    checkPrinted(body.results[1], "a < 0.0 ? 0 : k");
}

} // namespace

int main()
{
    checkBrackets();
    checkNumbers();
    checkVariables();
    checkPrecision();
}
