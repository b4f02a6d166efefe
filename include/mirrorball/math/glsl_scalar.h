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

struct GlslNode;
using GlslTree = std::shared_ptr<const GlslNode>;
struct GlslNode
{
    GlslType type;
    GlslPrecedence precedence;
    std::string text; // $0, $1, $2 stand for the operands, @ for the prefix of a helper function
    std::vector<GlslTree> operands;
    std::string name; // of the local variable, may be empty
};

// A number or a variable of the shader's, such as "direction.x"; what is computed from others; the same with
// a name.
MIRRORBALL_EXPORT GlslTree glslNumber(double number);
MIRRORBALL_EXPORT GlslTree glslNumber(int number);
MIRRORBALL_EXPORT GlslTree glslVariable(GlslType type, const std::string& text);
MIRRORBALL_EXPORT GlslTree glslOperation(GlslType type, GlslPrecedence precedence, const char* text,
                                         std::vector<GlslTree> operands);
MIRRORBALL_EXPORT GlslTree glslNamed(const GlslTree& tree, const char* name);

struct GlslBody
{
    std::string declarations;         // of the local variables, one a line, indented by four
    std::vector<std::string> results; // one expression a root
};

// `precision` stands before each float and int declared: "" or "highp ".
MIRRORBALL_EXPORT GlslBody printedGlsl(std::span<const GlslTree> roots, const std::string& prefix,
                                       const std::string& precision);

// ---- The vocabulary. Nothing here converts to bool or int: a formula cannot branch on it in C++. ---

struct GlslCondition
{
    GlslTree tree;

    using P = GlslPrecedence;
    static GlslCondition of(P precedence, const char* text, const GlslTree& a, const GlslTree& b)
    {
        return {glslOperation(GlslType::condition, precedence, text, {a, b})};
    }

    friend GlslCondition both(const GlslCondition& a, const GlslCondition& b)
    {
        return of(P::logicalAnd, "$0 && $1", a.tree, b.tree);
    }
    friend GlslCondition either(const GlslCondition& a, const GlslCondition& b)
    {
        return of(P::logicalOr, "$0 || $1", a.tree, b.tree);
    }
    friend GlslCondition named(const GlslCondition& value, const char* name)
    {
        return {glslNamed(value.tree, name)};
    }
};

struct GlslIndex
{
    GlslTree tree;

    explicit GlslIndex(GlslTree recorded) : tree(std::move(recorded)) {}
    explicit GlslIndex(int number) : tree(glslNumber(number)) {}

    friend GlslCondition operator==(const GlslIndex& a, int k)
    {
        return GlslCondition::of(GlslPrecedence::equality, "$0 == $1", a.tree, glslNumber(k));
    }
    friend GlslIndex select(const GlslCondition& condition, const GlslIndex& yes, const GlslIndex& no)
    {
        return GlslIndex(glslOperation(GlslType::index, GlslPrecedence::selection, "$0 ? $1 : $2",
                                       {condition.tree, yes.tree, no.tree}));
    }
};

struct GlslScalar
{
    GlslTree tree;

    explicit GlslScalar(GlslTree recorded) : tree(std::move(recorded)) {}
    explicit GlslScalar(double number) : tree(glslNumber(number)) {}

    using P = GlslPrecedence;
    using S = GlslScalar;
    static S of(P precedence, const char* text, std::vector<GlslTree> operands)
    {
        return S(glslOperation(GlslType::real, precedence, text, std::move(operands)));
    }
    static S call(const char* text, const S& a) { return of(P::primary, text, {a.tree}); }
    static S call(const char* text, const S& a, const S& b) { return of(P::primary, text, {a.tree, b.tree}); }
    static GlslCondition relation(const char* text, const S& a, const S& b)
    {
        return GlslCondition::of(P::relation, text, a.tree, b.tree);
    }
    static GlslCondition test(const char* text, const S& x)
    {
        return {glslOperation(GlslType::condition, P::primary, text, {x.tree})};
    }

    // The number 0, such as the derivative of a constant: what vanishes with it is not printed.
    bool isZero() const { return tree->operands.empty() && tree->text == "0.0"; }

    friend S operator-(const S& a) { return a.isZero() ? a : of(P::unary, "-$0", {a.tree}); }
    friend S operator+(const S& a, const S& b)
    {
        return a.isZero() ? b : b.isZero() ? a : of(P::sum, "$0 + $1", {a.tree, b.tree});
    }
    friend S operator-(const S& a, const S& b)
    {
        return a.isZero() ? -b : b.isZero() ? a : of(P::sum, "$0 - $1", {a.tree, b.tree});
    }
    friend S operator*(const S& a, const S& b)
    {
        return a.isZero() ? a : b.isZero() ? b : of(P::product, "$0 * $1", {a.tree, b.tree});
    }
    friend S operator/(const S& a, const S& b)
    {
        return a.isZero() ? a : of(P::product, "$0 / $1", {a.tree, b.tree});
    }

    friend GlslCondition operator<(const S& a, const S& b) { return relation("$0 < $1", a, b); }
    friend GlslCondition operator<=(const S& a, const S& b) { return relation("$0 <= $1", a, b); }
    friend GlslCondition operator>(const S& a, const S& b) { return relation("$0 > $1", a, b); }
    friend GlslCondition operator>=(const S& a, const S& b) { return relation("$0 >= $1", a, b); }
    friend GlslCondition isNan(const S& x) { return test("@isNan($0)", x); }
    friend GlslCondition isInfinite(const S& x) { return test("@isInfinite($0)", x); }
    friend S select(const GlslCondition& condition, const S& yes, const S& no)
    {
        if (yes.isZero() && no.isZero())
            return yes;
        return of(P::selection, "$0 ? $1 : $2", {condition.tree, yes.tree, no.tree});
    }
    friend S named(const S& value, const char* name)
    {
        return value.isZero() ? value : S(glslNamed(value.tree, name));
    }

    friend S abs(const S& x) { return call("abs($0)", x); }
    friend S sqrt(const S& x) { return call("sqrt($0)", x); }
    friend S min(const S& a, const S& b) { return call("min($0, $1)", a, b); }
    friend S max(const S& a, const S& b) { return call("max($0, $1)", a, b); }
    friend S atanPi(const S& t) { return call("@atanPi($0)", t); }
    friend S sinPiAcute(const S& x) { return call("@sinPiAcute($0)", x); }

    // Calls of helper functions, whose bodies are printed from the templates of scalar.h and elementary.h.
    friend S signNotZero(const S& x) { return call("@signNotZero($0)", x); }
    friend S flushed(const S& x) { return call("@flushed($0)", x); }
    friend S infinitySign(const S& x) { return call("@infinitySign($0)", x); }
    friend S atan2Pi(const S& y, const S& x) { return call("@atan2Pi($0, $1)", y, x); }
    friend S sinPi(const S& x) { return call("@sinPi($0)", x); }
    friend S cosPi(const S& x) { return call("@cosPi($0)", x); }
};

template <>
struct ScalarTraits<GlslScalar> : ScalarTraits<float>
{
    using Index = GlslIndex;
};

} // namespace mirrorball
