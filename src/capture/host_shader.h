// Reads the host's GLSL just far enough to reuse it: the #version line, the declarations at global scope and
// every identifier. No preprocessing is done: a declaration counts even inside an #if branch.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball::capture {

// One name declared at global scope with a storage qualifier.
struct Declaration
{
    std::string storage;       // "in", "out" or "uniform"
    std::string interpolation; // "flat", "noperspective", "smooth" or "" (also for centroid and sample)
    std::string type;          // "vec3"
    std::string name;          // "normal"; for an interface block the block's name
    std::string arraySuffix;   // "[4]" or ""
    bool isBlock = false;
    bool hasLocation = false;       // layout(location = …) is written
    std::size_t begin = 0, end = 0; // of the whole statement in the text, the semicolon included
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

    struct Replacement
    {
        std::string from, to;
    };

    // The text after the #version line, headed by a #line so that messages keep the host's line numbers.
    // Whole identifiers are replaced; the declarations of `globals` (names) lose their qualifiers and become
    // plain global variables. `prelude` goes in before the first declaration, after all #extension lines.
    std::string body(const std::vector<Replacement>& identifiers,
                     const std::vector<std::string>& globals = {}, const std::string& prelude = {}) const;

private:
    struct Token
    {
        std::size_t begin, end;
        bool isIdentifier;
    };

    void readVersion();
    void readTokens();
    void readDeclarations();
    void readStatement(std::size_t firstToken, std::size_t lastToken);
    std::string_view text(const Token& token) const;
    std::string lineDirective(std::size_t at) const; // names the host's line number at this offset

    std::string text_;
    std::string name_;
    int version_ = 0;
    std::string versionLine_;
    std::size_t bodyBegin_ = 0; // just after the #version line
    std::size_t preludeAt_ = 0; // just after the last #extension line
    std::vector<Token> tokens_; // of the body, preprocessor lines and comments left out
    std::vector<Declaration> declarations_;
};

} // namespace mirrorball::capture
