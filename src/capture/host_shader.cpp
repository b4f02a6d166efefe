#include "capture/host_shader.h"

#include <mirrorball/error.h>

#include <algorithm>
#include <cctype>

namespace mirrorball::capture {

namespace {

bool startsIdentifier(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool continuesIdentifier(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
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

constexpr std::string_view interpolations[] = {"flat", "noperspective", "smooth"};
constexpr std::string_view auxiliaries[] = {"centroid", "sample"};
constexpr std::string_view otherQualifiers[] = {"invariant", "precise", "highp", "mediump",
                                                "lowp",      "const",   "patch"};
// What a statement with a braced part that goes on to a semicolon begins with: structs and interface blocks.
constexpr std::string_view blockHeads[] = {"struct", "in",       "out",    "uniform",       "layout", "const",
                                           "buffer", "centroid", "smooth", "noperspective", "flat"};

template <class List>
bool contains(const List& list, std::string_view word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

bool isQualifier(std::string_view word)
{
    return word == "in" || word == "out" || contains(interpolations, word) || contains(auxiliaries, word) ||
           contains(otherQualifiers, word);
}

// The word after the # of a preprocessor line.
std::string_view directiveName(std::string_view line)
{
    const std::size_t begin = line.find_first_not_of(" \t", 1);
    if (begin == std::string_view::npos)
        return {};
    std::size_t end = begin;
    while (end < line.size() && continuesIdentifier(line[end]))
        ++end;
    return line.substr(begin, end - begin);
}

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
            readStatement(first, index);
            first = index + 1;
        } else if (token == "}") {
            // A function's body ends a statement; a block's or struct's goes on to its semicolon.
            if (!contains(blockHeads, text(tokens_[first])))
                first = index + 1;
        }
    }
}

void HostShader::readStatement(std::size_t firstToken, std::size_t lastToken)
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
    if (at >= lastToken && !declaration.name.empty())
        declarations_.push_back(declaration);
    if (declaration.storage.empty() || at >= lastToken)
        return;
    declaration.type = text(tokens_[at++]);
    if (at < lastToken && text(tokens_[at]) == "{") {
        declaration.isBlock = true;
        declaration.name = declaration.type;
        declarations_.push_back(declaration);
        return;
    }
    std::string typeSuffix;
    const auto readSuffix = [&] {
        std::string suffix;
        int depth = 0;
        while (at < lastToken && (depth > 0 || text(tokens_[at]) == "[")) {
            depth += text(tokens_[at]) == "[" ? 1 : text(tokens_[at]) == "]" ? -1 : 0;
            suffix += text(tokens_[at++]);
        }
        return suffix;
    };
    typeSuffix = readSuffix();
    while (at < lastToken) {
        declaration.name = text(tokens_[at++]);
        declaration.arraySuffix = readSuffix() + typeSuffix;
        declarations_.push_back(declaration);
        while (at < lastToken && text(tokens_[at]) != ",") // an initialiser of a uniform
            ++at;
        ++at;
    }
}

std::string HostShader::lineDirective(std::size_t at) const
{
    const auto lines = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return "#line " + std::to_string(lines + 1) + " 0\n";
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

// Several names may share a statement; this is the first of them.
const Declaration* HostShader::declarationAround(const Token& token) const
{
    const auto found = std::find_if(declarations_.begin(), declarations_.end(), [&](const Declaration& d) {
        return token.begin >= d.begin && token.end <= d.end;
    });
    return found == declarations_.end() ? nullptr : &*found;
}

bool HostShader::allNamed(const Declaration& statement, const std::vector<std::string>& names) const
{
    return std::all_of(declarations_.begin(), declarations_.end(), [&](const Declaration& d) {
        return d.begin != statement.begin || contains(names, d.name);
    });
}

std::string HostShader::marksAt(std::size_t end, const std::string& mark) const
{
    std::string marks;
    for (std::size_t index = 0; index < declarations_.size() && !mark.empty(); ++index)
        if (declarations_[index].end == end)
            marks += "\n#define " + mark + std::to_string(index);
    return marks;
}

std::string HostShader::body(const Changes& changes) const
{
    std::string result = lineDirective(bodyBegin_) + text_.substr(bodyBegin_, preludeAt_ - bodyBegin_);
    if (!changes.prelude.empty())
        result += changes.prelude + lineDirective(preludeAt_);
    std::size_t copied = preludeAt_;
    const auto replace = [&](std::size_t begin, std::size_t end, const std::string& with) {
        result.append(text_, copied, begin - copied);
        result += with;
        copied = end;
    };
    for (std::size_t index = 0; index < tokens_.size(); ++index) {
        const Token& token = tokens_[index];
        const std::string_view word = text(token);
        const Declaration* const statement = declarationAround(token);
        const bool isGlobal = statement != nullptr && allNamed(*statement, changes.globals);
        const bool isBare = isGlobal || (statement != nullptr && allNamed(*statement, changes.withoutLayout));
        const auto found = std::find_if(changes.identifiers.begin(), changes.identifiers.end(),
                                        [&](const Replacement& candidate) { return candidate.from == word; });
        if (statement != nullptr && allNamed(*statement, changes.removed)) {
            while (tokens_[index].end < statement->end)
                ++index;
            // Line ends within the statement stay, so that the lines after it keep their numbers.
            replace(token.begin, statement->end,
                    std::string(static_cast<std::size_t>(std::count(
                                    text_.begin() + static_cast<std::ptrdiff_t>(token.begin),
                                    text_.begin() + static_cast<std::ptrdiff_t>(statement->end), '\n')),
                                '\n'));
        } else if (isBare && word == "layout") {
            index = closingParenthesis(index);
            replace(token.begin, tokens_[index].end, "");
        } else if (isGlobal && isQualifier(word)) {
            replace(token.begin, token.end, "");
        } else if (token.isIdentifier && found != changes.identifiers.end()) {
            replace(token.begin, token.end, found->to);
        } else if (const std::string marks = word == ";" ? marksAt(token.end, changes.mark) : "";
                   !marks.empty()) {
            replace(token.begin, token.end, ";" + marks + "\n" + lineDirective(token.end));
        }
    }
    result.append(text_, copied, text_.size() - copied);
    return result + "\n";
}

std::string HostShader::skeleton(const std::string& mark) const
{
    std::string result;
    std::size_t next = 0; // declaration
    const auto marksBefore = [&](std::size_t at) {
        for (; next < declarations_.size() && declarations_[next].end <= at; ++next)
            result += "#define " + mark + std::to_string(next) + "\n";
    };
    for (const Span& span : directives_) {
        marksBefore(span.begin);
        const std::string_view line = std::string_view(text_).substr(span.begin, span.end - span.begin);
        const std::string_view name = directiveName(line);
        if (name != "extension" && name != "line" && name != "pragma" && name != "version")
            result.append(line).append("\n");
    }
    marksBefore(text_.size());
    return result;
}

} // namespace mirrorball::capture
