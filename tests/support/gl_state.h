// The judge of "the host's GL state is left as it was": every queryable item of the current context's state,
// taken before and after a call, and compared item by item. It is independent of the library's own guard on
// purpose.
//
// Covered: bindings (framebuffers, buffers with their ranges, textures and samplers of every unit, image
// units, program, pipeline, vertex array, transform feedback), fixed state with its indexed forms (viewports,
// scissors, depth ranges, blending and colour masks per draw buffer, clip distances, sample masks), pixel
// storage, debug groups, active queries, the current EGL context; and the state of the objects that are
// bound: framebuffer attachments, vertex attributes, buffer sizes, and the parameters of textures and
// samplers on the first units. In a compatibility context also matrices, fixed-function enables and pixel
// transfer.
//
// Not covered, because OpenGL has no query for it: whether conditional rendering is active. Not covered,
// because reading it clears it: the pending error; takeErrors() is for that.
//
// Needs OpenGL 3.3 or later, core or compatibility. Raises no GL error of its own and leaves the state alone.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tests {

class GlState
{
public:
    struct Item
    {
        std::string name;  // "GL_DEPTH_FUNC", "GL_BLEND[2]", "GL_TEXTURE_2D[5] GL_TEXTURE_WRAP_S"; unique
        std::string value; // "0x203", "(0, 0, 1, 1)"
    };

    // The state of the context that is current on this thread.
    static GlState capture();

    const std::vector<Item>& items() const { return items_; }

private:
    std::vector<Item> items_;
};

// One line for each item that differs, "GL_DEPTH_FUNC: 0x201 → 0x203", in the order of capture. An item that
// only one of the two has, such as an attachment of a framebuffer that was bound in one only, shows as
// "absent" in the other.
std::vector<std::string> differences(const GlState& before, const GlState& after);

// The errors that are pending, read and cleared, as "0x502". At most 16: a lost context may answer for ever.
std::vector<std::string> takeErrors();

// What a call did to the context: the differences between before and after it, then a line for each GL error
// that is pending afterwards. Empty is the answer a library owes its host. Precondition: no error is pending.
std::vector<std::string> changesBy(const std::function<void()>& call);

} // namespace tests
