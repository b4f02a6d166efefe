// Reads the host's GLSL just far enough to reuse it: the #version line, the declarations at global scope and
// every identifier. No preprocessing is done. A declaration counts even inside an #if branch; a mark, a macro
// defined beside it, tells the library's own text whether the driver's preprocessor came by.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball::capture {

// One name declared at global scope with a storage qualifier.
struct Declaration
{
    std::string storage;            // "in", "out" or "uniform"
    std::string interpolation;      // "flat", "noperspective", "smooth" or ""
    std::string auxiliary;          // "centroid", "sample" or ""
    std::string type;               // "vec3"; "" for layout(early_fragment_tests) in
    std::string name;               // "normal"; for an interface block the block's name
    std::string arraySuffix;        // "[4]" or ""
    std::string location;           // N of layout(location = N), as written; "" for none
    std::size_t begin = 0, end = 0; // of the whole statement in the text, the semicolon included
    // Of an interface block, whose type and name are the block's.
    bool isBlock = false;
    bool hasConditions = false; // preprocessor lines between its members
    std::vector<Declaration> members;
    std::string instance; // "" for none; arraySuffix is the instance's
};

class HostShader
{
public:
    // Throws Error badShader when the text has no #version line of 330 or later or no main function. `name`
    // is for messages: "the vertex shader of 'phong'".
    HostShader(std::string text, std::string name);

    const std::string& name() const { return name_; }
    int version() const { return version_; }
    const std::string& versionLine() const { return versionLine_; } // "#version 330 core\n"
    const std::vector<Declaration>& declarations() const { return declarations_; }
    bool mentions(std::string_view identifier) const;
    // N of `#define name N` or `const int name = N`.
    std::optional<int> constant(std::string_view name) const;
    std::string nameBeginningWith(std::string_view prefix) const; // the first such identifier, or ""

    struct Replacement
    {
        std::string from, to;
    };

    // What is changed in the text; names are those of declarations.
    struct Changes
    {
        std::vector<Replacement> identifiers; // whole identifiers
        // Lose their qualifiers and become plain global variables; a block with an instance name becomes a
        // structure of that name, and one without loses its braces.
        std::vector<std::string> globals;
        std::vector<std::string> withoutLayout; // lose layout(…) only
        std::vector<std::string> removed;       // the whole statement
        std::string prelude; // goes in before the first declaration, after all #extension lines
        std::string mark;    // where not empty, declaration k is followed by #define <mark>k
    };

    // The text after the #version line, headed by a #line so that messages keep the host's line numbers.
    std::string body(const Changes& changes) const;

    // The preprocessor lines that decide what is compiled, with the marks among them and nothing else:
    // another stage asks it which declarations there are.
    std::string skeleton(const std::string& mark) const;

private:
    struct Token
    {
        std::size_t begin, end;
        bool isIdentifier;
    };
    struct Span
    {
        std::size_t begin, end;
    };

    void readVersion();
    void readTokens();
    void readDeclarations();
    // One for each name of a statement, or one for layout(early_fragment_tests) in.
    std::vector<Declaration> statement(std::size_t firstToken, std::size_t lastToken) const;
    void readMembers(Declaration& block, std::size_t at, std::size_t lastToken) const;
    std::string arraySuffix(std::size_t& at, std::size_t lastToken) const;
    std::string_view text(const Token& token) const;
    std::string lineDirective(std::size_t at) const; // names the host's line number at this offset
    std::string marksAt(std::size_t end, const std::string& mark) const;
    const Declaration* declarationAround(const Token& token) const;
    std::size_t closingParenthesis(std::size_t token) const;
    std::string asGlobal(const Declaration& block, std::size_t token) const;
    bool allNamed(const Declaration& statement, const std::vector<std::string>& names) const;

    std::string text_;
    std::string name_;
    int version_ = 0;
    std::string versionLine_;
    std::size_t bodyBegin_ = 0;    // just after the #version line
    std::size_t preludeAt_ = 0;    // just after the last #extension line
    std::vector<Token> tokens_;    // of the body, preprocessor lines and comments left out
    std::vector<Span> directives_; // preprocessor lines of the body
    std::vector<Declaration> declarations_;
};

} // namespace mirrorball::capture
