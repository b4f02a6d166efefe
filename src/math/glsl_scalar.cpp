#include <mirrorball/math/glsl_scalar.h>

#include <charconv>
#include <map>
#include <set>

namespace mirrorball {
namespace {

bool isLeaf(const GlslNode& node)
{
    return node.operands.empty();
}

// What costs nothing to write twice: a variable, a number, either with a minus.
bool isTrivial(const GlslNode& node)
{
    return isLeaf(node) || (node.precedence == GlslPrecedence::unary && isLeaf(*node.operands[0]));
}

// Whether operand k needs brackets: where the grammar wants them, in right operands (float addition is not
// associative), and where a reader would ask: && inside ||, a selection inside a selection's first value.
bool needsBrackets(const GlslNode& node, std::size_t k, GlslPrecedence operand)
{
    switch (node.precedence) {
    case GlslPrecedence::primary:
        return false; // between the brackets of a call
    case GlslPrecedence::selection:
        return k < 2 && operand == GlslPrecedence::selection;
    case GlslPrecedence::logicalAnd:
    case GlslPrecedence::logicalOr:
        return operand > GlslPrecedence::equality && operand != node.precedence;
    case GlslPrecedence::product:
    case GlslPrecedence::sum:
        return k == 0 ? operand > node.precedence : operand >= node.precedence;
    default:
        return operand >= node.precedence;
    }
}

class Printer
{
public:
    Printer(const std::string& prefix, const std::string& precision) : prefix_(prefix), precision_(precision)
    {
    }

    void count(const GlslTree& tree)
    {
        if (++uses_[tree.get()] > 1)
            return;
        if (isLeaf(*tree))
            taken_.insert(tree->text.substr(0, tree->text.find('.')));
        for (const GlslTree& operand : tree->operands)
            count(operand);
    }

    // Declares what the tree needs and has not yet, then gives its expression.
    std::string text(const GlslTree& tree)
    {
        if (const auto variable = variables_.find(tree.get()); variable != variables_.end())
            return variable->second;
        const std::string expression = filledIn(*tree);
        const bool shared = uses_.at(tree.get()) > 1 && !isTrivial(*tree);
        if (!shared && tree->name.empty())
            return expression;
        const std::string name = freeName(tree->name.empty() ? "t" : tree->name);
        declarations_ += "    " + typeName(tree->type) + " " + name + " = " + expression + ";\n";
        return variables_[tree.get()] = name;
    }

    const std::string& declarations() const { return declarations_; }

private:
    std::string filledIn(const GlslNode& node)
    {
        std::vector<std::string> operands;
        for (std::size_t k = 0; k < node.operands.size(); ++k) {
            const std::string operand = text(node.operands[k]);
            const bool isVariable = variables_.contains(node.operands[k].get());
            const bool brackets = !isVariable && needsBrackets(node, k, node.operands[k]->precedence);
            operands.push_back(brackets ? "(" + operand + ")" : operand);
        }
        std::string result;
        for (std::size_t i = 0; i < node.text.size(); ++i) {
            if (node.text[i] == '$')
                result += operands[static_cast<std::size_t>(node.text[++i] - '0')];
            else
                result += node.text[i] == '@' ? prefix_ : std::string(1, node.text[i]);
        }
        return result;
    }

    std::string typeName(GlslType type) const
    {
        switch (type) {
        case GlslType::real:
            return precision_ + "float";
        case GlslType::index:
            return precision_ + "int";
        default:
            return "bool";
        }
    }

    std::string freeName(const std::string& wanted)
    {
        std::string name = wanted;
        for (int suffix = 2; !taken_.insert(name).second; ++suffix)
            name = wanted + std::to_string(suffix);
        return name;
    }

    std::string prefix_;
    std::string precision_;
    std::map<const GlslNode*, int> uses_;
    std::map<const GlslNode*, std::string> variables_;
    std::set<std::string> taken_;
    std::string declarations_;
};

} // namespace

// The shortest decimal that reads back as the same float.
GlslTree glslNumber(double number)
{
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(number)).ptr;
    const std::string text(digits, end);
    const bool hasPoint = text.find_first_of(".e") != std::string::npos;
    const auto precedence = number < 0 ? GlslPrecedence::unary : GlslPrecedence::primary;
    return glslOperation(GlslType::real, precedence, (hasPoint ? text : text + ".0").c_str(), {});
}

GlslTree glslNumber(int number)
{
    return glslVariable(GlslType::index, std::to_string(number));
}

GlslTree glslVariable(GlslType type, const std::string& text)
{
    return glslOperation(type, GlslPrecedence::primary, text.c_str(), {});
}

GlslTree glslOperation(GlslType type, GlslPrecedence precedence, const char* text,
                       std::vector<GlslTree> operands)
{
    return std::make_shared<const GlslNode>(GlslNode{type, precedence, text, std::move(operands), {}});
}

GlslTree glslNamed(const GlslTree& tree, const char* name)
{
    GlslNode node = *tree;
    node.name = name;
    return std::make_shared<const GlslNode>(std::move(node));
}

GlslBody printedGlsl(std::span<const GlslTree> roots, const std::string& prefix, const std::string& precision)
{
    Printer printer(prefix, precision);
    for (const GlslTree& root : roots)
        printer.count(root);
    GlslBody body;
    for (const GlslTree& root : roots)
        body.results.push_back(printer.text(root));
    body.declarations = printer.declarations();
    return body;
}

} // namespace mirrorball
