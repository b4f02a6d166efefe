// A scalar that records what is done to it, so that a formula can be printed as GLSL.
//
// A recorded value is a shared node of a tree; it is printed once the tree is whole, not while it is
// recorded, so the text depends on the formula alone and not on the order in which a compiler evaluates
// arguments. Values that are named or used more than once become local variables. Conditions and indices are
// recorded too.
#pragma once

#include <mirrorball/export.h>
#include <mirrorball/math/elementary.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mirrorball {

enum class GlslType { real, condition, index };

// How tightly an expression's outermost operator binds: the numbers of the GLSL specification's table.
enum class GlslPrecedence {
    primary = 1,
    unary = 3,
    product = 4,
    sum = 5,
    relation = 7,
    equality = 8,
    logicalAnd = 12,
    logicalOr = 14,
    selection = 15,
};

struct GlslNode
{
    GlslType type;
    GlslPrecedence precedence;
    std::string text; // $0, $1, $2 stand for the operands, @ for the prefix of a helper function
    std::vector<std::shared_ptr<const GlslNode>> operands;
    std::string name; // of the local variable, may be empty
};
using GlslTree = std::shared_ptr<const GlslNode>;

// None of these converts to bool or to a number: a formula cannot branch on them in C++.
struct GlslCondition
{
    GlslTree tree;
};

struct GlslIndex
{
    GlslTree tree;

    explicit GlslIndex(GlslTree recorded) : tree(std::move(recorded)) {}
    MIRRORBALL_EXPORT explicit GlslIndex(int number);
};

struct GlslScalar
{
    GlslTree tree;

    explicit GlslScalar(GlslTree recorded) : tree(std::move(recorded)) {}
    MIRRORBALL_EXPORT explicit GlslScalar(double number);
};

template <>
struct ScalarTraits<GlslScalar> : ScalarTraits<float>
{
    using Index = GlslIndex;
};

// A variable of the shader's, such as "direction.x".
MIRRORBALL_EXPORT GlslTree glslVariable(GlslType type, const std::string& text);
MIRRORBALL_EXPORT GlslTree glslOperation(GlslType type, GlslPrecedence precedence, const std::string& text,
                                         std::vector<GlslTree> operands);
MIRRORBALL_EXPORT GlslTree glslNamed(const GlslTree& tree, const std::string& name);

struct GlslBody
{
    std::string declarations;         // of the local variables, one a line, indented by four
    std::vector<std::string> results; // one expression a root
};

// `precision` stands before each float and int declared: "" or "highp ".
MIRRORBALL_EXPORT GlslBody printedGlsl(std::span<const GlslTree> roots, const std::string& prefix,
                                       const std::string& precision);

// ---- The vocabulary --------------------------------------------------------------------------------

inline GlslScalar glslReal(GlslPrecedence precedence, const char* text, std::vector<GlslTree> operands)
{
    return GlslScalar(glslOperation(GlslType::real, precedence, text, std::move(operands)));
}
inline GlslCondition glslCondition(GlslPrecedence precedence, const char* text,
                                   std::vector<GlslTree> operands)
{
    return {glslOperation(GlslType::condition, precedence, text, std::move(operands))};
}

inline GlslScalar operator-(const GlslScalar& a)
{
    return glslReal(GlslPrecedence::unary, "-$0", {a.tree});
}
inline GlslScalar operator+(const GlslScalar& a, const GlslScalar& b)
{
    return glslReal(GlslPrecedence::sum, "$0 + $1", {a.tree, b.tree});
}
inline GlslScalar operator-(const GlslScalar& a, const GlslScalar& b)
{
    return glslReal(GlslPrecedence::sum, "$0 - $1", {a.tree, b.tree});
}
inline GlslScalar operator*(const GlslScalar& a, const GlslScalar& b)
{
    return glslReal(GlslPrecedence::product, "$0 * $1", {a.tree, b.tree});
}
inline GlslScalar operator/(const GlslScalar& a, const GlslScalar& b)
{
    return glslReal(GlslPrecedence::product, "$0 / $1", {a.tree, b.tree});
}

inline GlslCondition operator<(const GlslScalar& a, const GlslScalar& b)
{
    return glslCondition(GlslPrecedence::relation, "$0 < $1", {a.tree, b.tree});
}
inline GlslCondition operator<=(const GlslScalar& a, const GlslScalar& b)
{
    return glslCondition(GlslPrecedence::relation, "$0 <= $1", {a.tree, b.tree});
}
inline GlslCondition operator>(const GlslScalar& a, const GlslScalar& b)
{
    return glslCondition(GlslPrecedence::relation, "$0 > $1", {a.tree, b.tree});
}
inline GlslCondition operator>=(const GlslScalar& a, const GlslScalar& b)
{
    return glslCondition(GlslPrecedence::relation, "$0 >= $1", {a.tree, b.tree});
}
inline GlslCondition operator==(const GlslIndex& a, int k)
{
    return glslCondition(GlslPrecedence::equality, "$0 == $1", {a.tree, GlslIndex(k).tree});
}
inline GlslCondition operator<(const GlslIndex& a, int k)
{
    return glslCondition(GlslPrecedence::relation, "$0 < $1", {a.tree, GlslIndex(k).tree});
}
inline GlslCondition both(const GlslCondition& a, const GlslCondition& b)
{
    return glslCondition(GlslPrecedence::logicalAnd, "$0 && $1", {a.tree, b.tree});
}
inline GlslCondition either(const GlslCondition& a, const GlslCondition& b)
{
    return glslCondition(GlslPrecedence::logicalOr, "$0 || $1", {a.tree, b.tree});
}
inline GlslCondition isNan(const GlslScalar& x)
{
    return glslCondition(GlslPrecedence::primary, "@isNan($0)", {x.tree});
}
inline GlslCondition isInfinite(const GlslScalar& x)
{
    return glslCondition(GlslPrecedence::primary, "@isInfinite($0)", {x.tree});
}

inline GlslScalar select(const GlslCondition& condition, const GlslScalar& yes, const GlslScalar& no)
{
    return glslReal(GlslPrecedence::selection, "$0 ? $1 : $2", {condition.tree, yes.tree, no.tree});
}
inline GlslIndex select(const GlslCondition& condition, const GlslIndex& yes, const GlslIndex& no)
{
    return GlslIndex(glslOperation(GlslType::index, GlslPrecedence::selection, "$0 ? $1 : $2",
                                   {condition.tree, yes.tree, no.tree}));
}

// A function of one or two numbers.
inline GlslScalar glslCall(const char* text, std::vector<GlslTree> operands)
{
    return glslReal(GlslPrecedence::primary, text, std::move(operands));
}
inline GlslScalar abs(const GlslScalar& x)
{
    return glslCall("abs($0)", {x.tree});
}
inline GlslScalar sqrt(const GlslScalar& x)
{
    return glslCall("sqrt($0)", {x.tree});
}
inline GlslScalar min(const GlslScalar& a, const GlslScalar& b)
{
    return glslCall("min($0, $1)", {a.tree, b.tree});
}
inline GlslScalar max(const GlslScalar& a, const GlslScalar& b)
{
    return glslCall("max($0, $1)", {a.tree, b.tree});
}
inline GlslScalar atanPi(const GlslScalar& t)
{
    return glslCall("@atanPi($0)", {t.tree});
}
inline GlslScalar sinPiAcute(const GlslScalar& x)
{
    return glslCall("@sinPiAcute($0)", {x.tree});
}
inline GlslScalar signNotZero(const GlslScalar& x)
{
    return select(x < GlslScalar(0), GlslScalar(-1), GlslScalar(1));
}

// Printed as helper functions, whose bodies are the templates of elementary.h.
inline GlslScalar atan2Pi(const GlslScalar& y, const GlslScalar& x)
{
    return glslCall("@atan2Pi($0, $1)", {y.tree, x.tree});
}
inline GlslScalar sinPi(const GlslScalar& x)
{
    return glslCall("@sinPi($0)", {x.tree});
}
inline GlslScalar cosPi(const GlslScalar& x)
{
    return glslCall("@cosPi($0)", {x.tree});
}

inline GlslScalar named(const GlslScalar& value, const char* name)
{
    return GlslScalar(glslNamed(value.tree, name));
}
inline GlslCondition named(const GlslCondition& value, const char* name)
{
    return {glslNamed(value.tree, name)};
}

} // namespace mirrorball
