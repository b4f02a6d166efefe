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
constexpr std::string_view otherQualifiers[] = {"centroid", "sample", "invariant", "precise", "highp",
                                                "mediump",  "lowp",   "const",     "patch"};

template <class List>
bool contains(const List& list, std::string_view word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

} // namespace

HostShader::HostShader(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name))
{
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
    versionLine_ = line.substr(0, line.find('\r')) + "\n";
    bodyBegin_ = std::min(end + 1, text_.size());
}

void HostShader::readTokens()
{
    std::size_t at = bodyBegin_;
    preludeAt_ = bodyBegin_;
    bool lineStart = true;
    while (at < text_.size()) {
        const char c = text_[at];
        if (const std::size_t next = afterComment(text_, at); next > at) {
            at = next;
        } else if (c == '#' && lineStart) {
            const std::size_t end = afterDirective(text_, at);
            if (tokens_.empty() &&
                std::string_view(text_).substr(at, end - at).find("extension") != std::string_view::npos)
                preludeAt_ = std::min(end + 1, text_.size());
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
            const bool goesOn = index + 1 < tokens_.size() && [&] {
                const std::string_view head = text(tokens_[first]);
                return head == "struct" || head == "in" || head == "out" || head == "uniform" ||
                       head == "layout" || head == "const" || head == "buffer" || head == "flat" ||
                       head == "smooth";
            }();
            if (!goesOn)
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
            int depth = 0;
            do {
                ++at;
                const std::string_view inner = text(tokens_[at]);
                depth += inner == "(" ? 1 : inner == ")" ? -1 : 0;
                declaration.hasLocation = declaration.hasLocation || inner == "location";
            } while (depth > 0 && at < lastToken);
        } else if (word == "in" || word == "out" || word == "uniform") {
            declaration.storage = word;
        } else if (contains(interpolations, word)) {
            declaration.interpolation = word;
        } else if (!contains(otherQualifiers, word)) {
            break;
        }
    }
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

std::string HostShader::body(const std::vector<Replacement>& identifiers,
                             const std::vector<std::string>& globals, const std::string& prelude) const
{
    // Statements whose qualifiers go: several names may share one.
    std::vector<std::pair<std::size_t, std::size_t>> statements;
    for (const Declaration& declaration : declarations_)
        if (contains(globals, declaration.name))
            statements.emplace_back(declaration.begin, declaration.end);
    const auto inStatement = [&](const Token& token) {
        return std::any_of(statements.begin(), statements.end(),
                           [&](const auto& s) { return token.begin >= s.first && token.end <= s.second; });
    };
    const auto isQualifier = [](std::string_view word) {
        return word == "in" || contains(interpolations, word) || contains(otherQualifiers, word);
    };
    std::string result = lineDirective(bodyBegin_) + text_.substr(bodyBegin_, preludeAt_ - bodyBegin_);
    if (!prelude.empty())
        result += prelude + lineDirective(preludeAt_);
    std::size_t copied = preludeAt_;
    for (std::size_t index = 0; index < tokens_.size(); ++index) {
        const Token& token = tokens_[index];
        const std::string_view word = text(token);
        std::size_t end = token.end;
        std::string replacement;
        const auto found = std::find_if(identifiers.begin(), identifiers.end(),
                                        [&](const Replacement& candidate) { return candidate.from == word; });
        if (inStatement(token) && word == "layout") {
            while (text(tokens_[index]) != ")")
                ++index;
            end = tokens_[index].end;
        } else if (token.isIdentifier && found != identifiers.end()) {
            replacement = found->to;
        } else if (!inStatement(token) || !isQualifier(word)) {
            continue;
        }
        result.append(text_, copied, token.begin - copied);
        result += replacement;
        copied = end;
    }
    result.append(text_, copied, text_.size() - copied);
    return result + "\n";
}

} // namespace mirrorball::capture
