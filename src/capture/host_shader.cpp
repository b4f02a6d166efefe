#include "capture/host_shader.h"

#include "capture/glsl_words.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace mirrorball::capture {

namespace {

bool startsIdentifier(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The offset after a comment that begins at `at`, or `at` if none does.
std::size_t afterComment(const std::string& text, std::size_t at)
{
    if (text.compare(at, 2, "//") == 0)
        return std::min(text.find('\n', at), text.size());
    if (text.compare(at, 2, "/*") == 0) {
        const std::size_t close = text.find("*/", at + 2);
        return close == std::string::npos ? text.size() : close + 2;
    }
    return at;
}

// The offset of the end of a preprocessor line that begins at `at`; a backslash continues it.
std::size_t afterDirective(const std::string& text, std::size_t at)
{
    while (at < text.size() && text[at] != '\n') {
        if (text[at] == '\\' && at + 1 < text.size())
            ++at;
        const std::size_t next = afterComment(text, at);
        at = next > at ? next : at + 1;
    }
    return std::min(at, text.size());
}

// What a statement with a braced part that goes on to a semicolon begins with: structs and interface blocks.
constexpr std::string_view blockHeads[] = {"struct", "in",       "out",    "uniform",       "layout", "const",
                                           "buffer", "centroid", "smooth", "noperspective", "flat"};

} // namespace

HostShader::HostShader(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name))
{
    // Line ends of Windows go: beside the library's own ones drivers lose count of lines.
    std::size_t kept = 0;
    for (std::size_t at = 0; at < text_.size(); ++at)
        if (text_.compare(at, 2, "\r\n") != 0)
            text_[kept++] = text_[at];
    text_.resize(kept);
    readVersion();
    readTokens();
    readDeclarations();
    if (!mentions("main"))
        throw Error(ErrorKind::badShader, name_, "it has no main function");
}

std::string_view HostShader::text(const Token& token) const
{
    return std::string_view(text_).substr(token.begin, token.end - token.begin);
}

bool HostShader::mentions(std::string_view identifier) const
{
    return std::any_of(tokens_.begin(), tokens_.end(),
                       [&](const Token& token) { return token.isIdentifier && text(token) == identifier; });
}

std::string HostShader::nameBeginningWith(std::string_view prefix) const
{
    const auto found = std::find_if(tokens_.begin(), tokens_.end(), [&](const Token& token) {
        return token.isIdentifier && text(token).substr(0, prefix.size()) == prefix;
    });
    return found == tokens_.end() ? std::string() : std::string(text(*found));
}

void HostShader::readVersion()
{
    std::size_t at = 0;
    while (at < text_.size()) {
        const std::size_t next = afterComment(text_, at);
        if (next > at)
            at = next;
        else if (std::isspace(static_cast<unsigned char>(text_[at])) != 0)
            ++at;
        else
            break;
    }
    const std::size_t end = std::min(text_.find('\n', at), text_.size());
    const std::string line = text_.substr(at, end - at);
    const std::size_t digits = line.find_first_of("0123456789");
    const bool isVersion = line.rfind("#", 0) == 0 && line.find("version") != std::string::npos;
    if (!isVersion || digits == std::string::npos)
        throw Error(ErrorKind::badShader, name_, "it does not begin with a #version line",
                    "begin it with #version 330 core or later");
    version_ = std::atoi(line.c_str() + digits);
    if (version_ < 330 || line.find("es", digits) != std::string::npos)
        throw Error(ErrorKind::badShader, name_, "it is written for " + line.substr(line.find("version")),
                    "use #version 330 core or later");
    versionLine_ = line + "\n";
    bodyBegin_ = std::min(end + 1, text_.size());
}

void HostShader::readTokens()
{
    std::size_t at = bodyBegin_;
    preludeAt_ = bodyBegin_;
    bool lineStart = true;
    int conditions = 0;           // #if that are open
    bool extensionBefore = false; // since preludeAt_
    while (at < text_.size()) {
        const char c = text_[at];
        if (const std::size_t next = afterComment(text_, at); next > at) {
            at = next;
        } else if (c == '#' && lineStart) {
            const std::size_t end = afterDirective(text_, at);
            const std::string_view name = directiveName(std::string_view(text_).substr(at, end - at));
            conditions += name.substr(0, 2) == "if" ? 1 : name == "endif" ? -1 : 0;
            extensionBefore = extensionBefore || name == "extension";
            if (tokens_.empty() && extensionBefore && conditions == 0) {
                preludeAt_ = std::min(end + 1, text_.size());
                extensionBefore = false;
            }
            directives_.push_back({at, end});
            at = end;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            lineStart = lineStart || c == '\n';
            ++at;
        } else {
            lineStart = false;
            std::size_t end = at + 1;
            if (continuesIdentifier(c))
                while (end < text_.size() && continuesIdentifier(text_[end]))
                    ++end;
            tokens_.push_back({at, end, startsIdentifier(c)});
            at = end;
        }
    }
}

void HostShader::readDeclarations()
{
    int depth = 0; // of braces, brackets and parentheses
    std::size_t first = 0;
    for (std::size_t index = 0; index < tokens_.size(); ++index) {
        const std::string_view token = text(tokens_[index]);
        if (token == "{" || token == "(" || token == "[")
            ++depth;
        else if (token == "}" || token == ")" || token == "]")
            --depth;
        if (depth != 0)
            continue;
        if (token == ";") {
            for (Declaration& declaration : statement(first, index))
                if (!declaration.storage.empty() || declaration.type.empty())
                    declarations_.push_back(std::move(declaration));
            first = index + 1;
        } else if (token == "}") {
            // A function's body ends a statement; a block's or struct's goes on to its semicolon.
            if (!contains(blockHeads, text(tokens_[first])))
                first = index + 1;
        }
    }
}

std::size_t HostShader::closingParenthesis(std::size_t token) const
{
    int depth = 0;
    for (; token < tokens_.size(); ++token) {
        depth += text(tokens_[token]) == "(" ? 1 : 0;
        if (text(tokens_[token]) == ")" && --depth == 0)
            break;
    }
    return token;
}

// [4], [N][2]; "" where there is none.
std::string HostShader::arraySuffix(std::size_t& at, std::size_t lastToken) const
{
    std::string suffix;
    int depth = 0;
    while (at < lastToken && (depth > 0 || text(tokens_[at]) == "[")) {
        depth += text(tokens_[at]) == "[" ? 1 : text(tokens_[at]) == "]" ? -1 : 0;
        suffix += text(tokens_[at++]);
    }
    return suffix;
}

// `at` is the opening brace.
void HostShader::readMembers(Declaration& block, std::size_t at, std::size_t lastToken) const
{
    block.isBlock = true;
    block.name = block.type;
    std::size_t first = ++at;
    for (; at < lastToken && text(tokens_[at]) != "}"; ++at) {
        if (text(tokens_[at]) != ";")
            continue;
        for (Declaration& member : statement(first, at)) {
            if (member.interpolation.empty())
                member.interpolation = block.interpolation;
            block.members.push_back(std::move(member));
        }
        first = at + 1;
    }
    if (++at < lastToken)
        block.instance = text(tokens_[at++]);
    block.arraySuffix = arraySuffix(at, lastToken);
    block.hasConditions = std::any_of(directives_.begin(), directives_.end(), [&](const Span& span) {
        return span.begin > block.begin && span.begin < block.end;
    });
}

std::vector<Declaration> HostShader::statement(std::size_t firstToken, std::size_t lastToken) const
{
    Declaration declaration;
    declaration.begin = tokens_[firstToken].begin;
    declaration.end = tokens_[lastToken].end;
    std::size_t at = firstToken;
    for (; at < lastToken; ++at) {
        const std::string_view word = text(tokens_[at]);
        if (word == "layout") {
            const std::size_t close = std::min(closingParenthesis(at), lastToken);
            for (; at < close; ++at) {
                const std::string_view inner = text(tokens_[at]);
                if (inner == "early_fragment_tests")
                    declaration.name = inner;
                for (std::size_t value = at + 2; inner == "location" && value < close; ++value) {
                    if (text(tokens_[value]) == ",")
                        break;
                    declaration.location += text(tokens_[value]);
                }
            }
        } else if (word == "in" || word == "out" || word == "uniform") {
            declaration.storage = word;
        } else if (contains(interpolations, word)) {
            declaration.interpolation = word;
        } else if (contains(auxiliaries, word)) {
            declaration.auxiliary = word;
        } else if (!contains(otherQualifiers, word)) {
            break;
        }
    }
    if (at >= lastToken)
        return declaration.name.empty() ? std::vector<Declaration>() : std::vector{declaration};
    declaration.type = text(tokens_[at++]);
    if (at < lastToken && text(tokens_[at]) == "{") {
        readMembers(declaration, at, lastToken);
        return {declaration};
    }
    std::vector<Declaration> all;
    const std::string typeSuffix = arraySuffix(at, lastToken);
    while (at < lastToken) {
        declaration.name = text(tokens_[at++]);
        declaration.arraySuffix = arraySuffix(at, lastToken) + typeSuffix;
        all.push_back(declaration);
        while (at < lastToken && text(tokens_[at]) != ",") // an initialiser of a uniform
            ++at;
        ++at;
    }
    return all;
}

std::optional<int> HostShader::constant(std::string_view name) const
{
    for (const Span& span : directives_) {
        std::istringstream words(text_.substr(span.begin, span.end - span.begin));
        std::string directive, defined;
        int value = 0;
        if (words >> directive >> defined >> value && directive == "#define" && defined == name)
            return value;
    }
    for (std::size_t at = 0; at + 4 < tokens_.size(); ++at)
        if (text(tokens_[at]) == "const" && text(tokens_[at + 1]) == "int" && text(tokens_[at + 2]) == name &&
            text(tokens_[at + 3]) == "=")
            return std::atoi(std::string(text(tokens_[at + 4])).c_str());
    return std::nullopt;
}

} // namespace mirrorball::capture
