#include "support/gl_state.h"

#include "support/gl_state_recorder.h"

#include <epoxy/egl.h>

#include <charconv>
#include <cstdint>
#include <map>

namespace tests {

namespace {

std::string hexadecimal(std::uintptr_t value)
{
    char text[2 * sizeof value];
    const auto end = std::to_chars(std::begin(text), std::end(text), value, 16).ptr;
    return "0x" + std::string(text, end);
}

template <class Number>
std::string decimal(Number value)
{
    char text[32]; // the shortest text that gives the same number back has at most 24 characters
    const auto end = std::to_chars(std::begin(text), std::end(text), value).ptr;
    return std::string(text, end);
}

template <class Value, class Print>
std::string list(std::span<const Value> values, Print print)
{
    if (values.size() == 1)
        return print(values[0]);
    std::string text = "(";
    for (const Value& value : values)
        text += (text.size() > 1 ? ", " : "") + print(value);
    return text + ")";
}

// Which context is current is state too. Contexts that EGL did not make all show as 0x0.
void recordCurrentContext(StateRecorder& recorder)
{
    const auto address = [](const void* handle) {
        return hexadecimal(reinterpret_cast<std::uintptr_t>(handle));
    };
    recorder.add("eglGetCurrentContext", address(eglGetCurrentContext()));
    recorder.add("eglGetCurrentSurface(EGL_DRAW)", address(eglGetCurrentSurface(EGL_DRAW)));
    recorder.add("eglGetCurrentSurface(EGL_READ)", address(eglGetCurrentSurface(EGL_READ)));
    if (has(debugOutput)) {
        void* pointer = nullptr;
        glGetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &pointer);
        recorder.add("GL_DEBUG_CALLBACK_FUNCTION", address(pointer));
        glGetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &pointer);
        recorder.add("GL_DEBUG_CALLBACK_USER_PARAM", address(pointer));
    }
}

} // namespace

bool has(const Gate& gate)
{
    if (gate.compatibility) {
        GLint profile = 0;
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
        if ((profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) == 0)
            return false;
    }
    return epoxy_gl_version() >= gate.version ||
           (gate.extension != nullptr && epoxy_has_gl_extension(gate.extension));
}

int limit(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void StateRecorder::addSymbols(std::string name, std::span<const GLint64> values)
{
    add(std::move(name),
        list(values, [](GLint64 value) { return hexadecimal(static_cast<std::uintptr_t>(value)); }));
}

void StateRecorder::addNumbers(std::string name, std::span<const double> values)
{
    add(std::move(name), list(values, decimal<double>));
}

void StateRecorder::addFloats(std::string name, std::span<const GLfloat> values)
{
    add(std::move(name), list(values, decimal<GLfloat>));
}

std::string indexed(std::string_view name, int index)
{
    return std::string(name) + "[" + std::to_string(index) + "]";
}

GlState GlState::capture()
{
    GlState state;
    StateRecorder recorder(state.items_);
    recordCurrentContext(recorder);
    recordFixedState(recorder);
    recordFixedFunction(recorder);
    recordIndexedState(recorder);
    recordTextureUnits(recorder);
    recordBoundFramebuffers(recorder);
    recordBoundVertexArray(recorder);
    recordBoundBuffers(recorder);
    return state;
}

std::vector<std::string> differences(const GlState& before, const GlState& after)
{
    std::map<std::string_view, std::string_view> newValues;
    for (const GlState::Item& item : after.items())
        newValues.emplace(item.name, item.value);

    std::vector<std::string> lines;
    const auto report = [&](std::string_view name, std::string_view from, std::string_view to) {
        lines.push_back(std::string(name) + ": " + std::string(from) + " → " + std::string(to));
    };
    for (const GlState::Item& item : before.items()) {
        const auto found = newValues.extract(item.name);
        if (found.empty())
            report(item.name, item.value, "absent");
        else if (found.mapped() != item.value)
            report(item.name, item.value, found.mapped());
    }
    for (const auto& [name, value] : newValues)
        report(name, "absent", value);
    return lines;
}

std::vector<std::string> takeErrors()
{
    std::vector<std::string> errors;
    while (errors.size() < 16) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR)
            break;
        errors.push_back(hexadecimal(error));
    }
    return errors;
}

std::vector<std::string> changesBy(const std::function<void()>& call)
{
    const GlState before = GlState::capture();
    call();
    std::vector<std::string> changes = differences(before, GlState::capture());
    for (const std::string& error : takeErrors())
        changes.push_back("glGetError: 0x0 → " + error);
    return changes;
}

} // namespace tests
