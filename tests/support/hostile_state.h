// States that a host may legally leave its context in, and that spoil the drawing of a guest that trusts the
// defaults: one named entry for each, from a scissor of one pixel to samplers on every unit. A library must
// draw the same image from each of them, and leave each as it was (GlState judges that).
//
//     tests::HostileState hostile;
//     for (const std::string& name : hostile.names()) {
//         hostile.apply({name});
//         …
//         hostile.undo();
//     }
//
// Needs OpenGL 3.3 or later, core or compatibility; what the context lacks is not among the names. Construct
// it in a context whose state is OpenGL's default, save for the viewport, the scissor box and the debug
// output, and destroy it with the same context current.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tests {

struct HostObjects;
struct HostileEntry;

class HostileState
{
public:
    HostileState();
    ~HostileState(); // undoes what is applied
    HostileState(const HostileState&) = delete;
    HostileState& operator=(const HostileState&) = delete;

    const std::vector<std::string>& names() const { return names_; }

    // Adds these states, in the order of names(), whatever order they are given in. Precondition: they are
    // names of this context, and none is applied already.
    void apply(const std::vector<std::string>& chosen);

    // Each name with probability 1/2; the same for the same seed and names on every platform.
    std::vector<std::string> random(std::uint32_t seed) const;

    // Back to OpenGL's defaults.
    void undo();

    // Transform feedback that is active and not paused, on the host's own program: the one state in which
    // OpenGL forbids a guest to change the program, so that it must refuse. Not among the names, and not to
    // be combined with them; undo() ends it.
    void beginTransformFeedback();

private:
    std::unique_ptr<HostObjects> objects_;
    std::vector<const HostileEntry*> entries_; // one a name, in the same order
    std::vector<std::string> names_;
    std::vector<const HostileEntry*> applied_;
};

} // namespace tests
