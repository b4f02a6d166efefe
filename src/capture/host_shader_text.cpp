// Writing the host's text anew.
#include "capture/glsl_words.h"
#include "capture/host_shader.h"

namespace mirrorball::capture {

std::string HostShader::lineDirective(std::size_t at) const
{
    const auto lines = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return "#line " + std::to_string(lines + 1) + " 0\n";
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

// What becomes of a block's token.
std::string HostShader::asGlobal(const Declaration& block, std::size_t token) const
{
    const std::string_view word = text(tokens_[token]);
    const bool isOpen = token + 1 < tokens_.size() && text(tokens_[token + 1]) == "{";
    if (!block.instance.empty())
        return std::string(word == block.storage && token + 2 < tokens_.size() &&
                                   text(tokens_[token + 1]) == block.name && text(tokens_[token + 2]) == "{"
                               ? "struct"
                           : isQualifier(word) ? ""
                                               : word);
    const bool isFrame = word == "{" || word == "}" || (word == block.name && isOpen) ||
                         (word == ";" && tokens_[token].end == block.end);
    return std::string(isFrame || isQualifier(word) ? "" : word);
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
        const std::string marks = word == ";" ? marksAt(token.end, changes.mark) : "";
        const std::string afterMarks = marks.empty() ? "" : marks + "\n" + lineDirective(token.end);
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
        } else if (isGlobal && statement->isBlock && word != asGlobal(*statement, index)) {
            replace(token.begin, token.end, asGlobal(*statement, index) + afterMarks);
        } else if (isGlobal && isQualifier(word)) {
            replace(token.begin, token.end, "");
        } else if (token.isIdentifier && found != changes.identifiers.end()) {
            replace(token.begin, token.end, found->to);
        } else if (!afterMarks.empty()) {
            replace(token.begin, token.end, ";" + afterMarks);
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
