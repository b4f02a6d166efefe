// What is wrong with the host's shaders is said in the host's own names and line numbers, and the limit of
// varyings is where it is said to be.
#include "support/check.h"
#include "support/driver.h"
#include "support/wall_patches.h"

#include <mirrorball/error.h>
#include <mirrorball/headless/context.h>

#include <epoxy/gl.h>

using namespace mirrorball;
using namespace tests;

namespace {

// Both sides of the limit of varyings: what the library accepts links, and one more is refused by name.
void checkLimit(const WallPatches& walls, const CapturePath& path, const std::string& type,
                const std::string& qualifier, const std::string& array = "")
{
    const auto sources = [&](int count) {
        std::string vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvec3 place;\n",
                    fragment = "#version 330 core\nout vec4 colour;\n", set, sum;
        for (int index = 0; index < count; ++index) {
            const std::string name = "varying" + std::to_string(index);
            vertex += qualifier + "out " + type + " " + name + array + ";\n";
            fragment += qualifier + "in " + type + " " + name + array + ";\n";
            const std::string value = array.empty() ? name : name + "[1]";
            set += value + " = " + type + "(place.x);\n";
            sum += " + vec4(" + value +
                   (type == "mat4"   ? "[0]"
                    : type == "vec4" ? ""
                    : type == "vec3" ? ", 0.0"
                                     : "") +
                   ")";
        }
        return CaptureProgram::Desc{
            .name = "limit",
            .vertexSource = vertex + "void main() { place = position;\n" + set + "}\n",
            .fragmentSource = fragment + "void main() { colour = vec4(0.0)" + sum + "; }\n",
            .position = "place"};
    };
    ReflectionProbe probe(descOf(path, 4));
    std::string message;
    int fits = 0;
    for (int fails = 200; fails - fits > 1;) {
        const int count = (fits + fails) / 2;
        try {
            CaptureProgram program(sources(count));
            captured(probe, program, walls);
            fits = count;
        } catch (const Error& error) {
            fails = count;
            CHECK(error.kind() == ErrorKind::badShader);
            message = error.what();
        }
    }
    // The first that has no room is named, by the library and not by a driver that could not link.
    const std::string named = "'" + type + " varying" + std::to_string(fits) + array + "'";
    if (message.find(named) == std::string::npos)
        std::printf("%s\n", message.c_str());
    CHECK(message.find(named) != std::string::npos);
    std::printf("%-18s method %d, layers %d: %3d varyings of type %s%s%s\n",
                std::string(mapInfo(path.map).name).c_str(), static_cast<int>(path.method),
                static_cast<int>(path.layers), fits, qualifier.c_str(), type.c_str(), array.c_str());
    CHECK(fits >= (type == "mat4" ? 2 : 8));
}

// Of the error, or nothing where there is none.
std::string messageIfRefused(const CaptureProgram::Desc& desc, const WallPatches& walls,
                             const CapturePath& path)
{
    try {
        CaptureProgram program(desc);
        ReflectionProbe probe(descOf(path, 4));
        captured(probe, program, walls);
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::badShader);
        return error.what();
    }
    return {};
}

std::string messageOf(const CaptureProgram::Desc& desc, const WallPatches& walls, const CapturePath& path)
{
    const std::string message = messageIfRefused(desc, walls, path);
    if (message.empty())
        std::printf("'%s' compiled\n", desc.name.c_str());
    CHECK(!message.empty());
    return message;
}

// A driver's log names source string 0 and the line: "0:12(5): error".
bool namesLine(const std::string& message, const std::string& text, const std::string& line)
{
    const auto at = text.find(line);
    CHECK(at != std::string::npos);
    const auto number = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const bool named = message.find("0:" + std::to_string(number) + "(") != std::string::npos ||
                       message.find("0(" + std::to_string(number) + ")") != std::string::npos;
    if (!named)
        std::printf("line %td: %s\n", number, message.c_str());
    return named;
}

void replaceOnce(std::string& text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    CHECK(at != std::string::npos);
    text.replace(at, from.size(), to);
}

void checkMessages(const WallPatches& walls)
{
    for (const CapturePath& path : fewCapturePaths()) {
        std::string broken = awkwardVertex;
        replaceOnce(broken, "byLocation = position;", "byLocation = nothing;");
        std::string message = messageOf(
            {.name = "first", .vertexSource = broken, .fragmentSource = awkwardFragment}, walls, path);
        CHECK(namesLine(message, broken, "byLocation = nothing;"));
        CHECK(message.find("the vertex shader of 'first'") != std::string::npos);
        for (const bool isWindows : {false, true}) {
            broken = awkwardFragment;
            replaceOnce(broken, "bright = vec4(9.0);", "bright = nothing;");
            if (isWindows)
                broken = withCarriageReturns(broken);
            message = messageOf({.name = "second", .vertexSource = awkwardVertex, .fragmentSource = broken},
                                walls, path);
            CHECK(namesLine(message, broken, "bright = nothing;"));
            CHECK(message.find("the fragment shader of 'second'") != std::string::npos);
        }
        // Of another type than the vertex shader's: the driver's link error, with the program's name. NVIDIA's links.
        broken = awkwardFragment;
        replaceOnce(broken, "in vec3 weight;", "in vec4 weight;");
        replaceOnce(broken, "addTo(sum, weight);", "addTo(sum, weight.xyz);");
        message = messageIfRefused({.name = "third", .vertexSource = awkwardVertex, .fragmentSource = broken},
                                   walls, path);
        CHECK((isNvidia() && message.empty()) ||
              (message.find("weight") != std::string::npos && message.find("'third'") != std::string::npos));
    }
    const CapturePath any{MapKind::tennisBall, CaptureMethod::exact, LayerOrder::oneAtATime};
    const auto refused = [&](const std::string& vertex, const std::string& fragment,
                             const std::string& named) {
        const std::string message =
            messageOf({.name = "bad", .vertexSource = vertex, .fragmentSource = fragment}, walls, any);
        if (message.find(named) == std::string::npos)
            std::printf("%s\n", message.c_str());
        CHECK(message.find(named) != std::string::npos);
    };
    const std::string head = "#version 330 core\n",
                      end = "out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n";
    refused("void main() {}", head + end, "#version");
    refused(plainVertex, "#version 300 es\n" + end, "300 es");
    refused(plainVertex, head + "out vec4 colour;\n", "no main");
    refused(plainVertex, head + "void main() {}\n", "no output");
    refused(plainVertex, head + "float mirrorballCapture_weight;\n" + end, "mirrorballCapture_weight");
    refused(plainVertex, head + "out vec4 colours[2];\nvoid main() { colours[0] = vec4(1.0); }\n", "colours");
    // What cannot be carried is named.
    const std::string hands = head + "layout(location = 0) in vec3 position;\nout vec3 positionInWorld;\n",
                      places = "void main() { positionInWorld = position; ";
    refused(hands + "out float several[3];\n" + places + "several = float[3](1.0, 2.0, 3.0); }\n",
            head + "in float several[2 + 1];\nout vec4 colour;\nvoid main() { colour = vec4(several[1]); }\n",
            "'float several[2+1]'");
    const std::string structure = "struct Pair { vec3 a; vec3 b; };\n";
    refused(hands + structure + "out Pair pair;\n" + places + "pair.a = pair.b = position; }\n",
            head + structure + "in Pair pair;\nout vec4 colour;\nvoid main() { colour = pair.a.xyzz; }\n",
            "'Pair pair'");
    refused(
        hands + "out Block { vec3 a; } blocks[2];\n" + places + "blocks[0].a = blocks[1].a = position; }\n",
        head +
            "in Block { vec3 a; } blocks[2];\nout vec4 colour;\nvoid main() { colour = blocks[1].a.xyzz; }\n",
        "'vec3 blocks.a'");
    refused(hands + "out Block {\n#if 1\nvec3 a;\n#endif\n} block;\n" + places + "block.a = position; }\n",
            head + "in Block { vec3 a; } block;\nout vec4 colour;\nvoid main() { colour = block.a.xyzz; }\n",
            "'vec3 block.a'");
}

// A position that the vertex shader has not.
void checkPosition()
{
    try {
        CaptureProgram(
            {.name = "plain",
             .vertexSource = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n",
             .fragmentSource = "#version 330 core\nout vec4 colour;\nvoid main() { colour = vec4(0.0); }\n"});
        CHECK(!"accepted");
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::badShader);
        const std::string message = error.what();
        CHECK(message.find("positionInWorld") != std::string::npos &&
              message.find("Desc::position") != std::string::npos);
    }
}

} // namespace

int main()
{
    const headless::Context context;
    checkPosition();
    const WallPatches walls;
    checkMessages(walls);
    std::printf("%s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    for (const CapturePath& path : fewCapturePaths())
        for (const char* const type : {"float", "vec3", "mat4"})
            checkLimit(walls, path, type, "");
    checkLimit(walls, fewCapturePaths()[0], "float", "flat ");
    checkLimit(walls, fewCapturePaths()[0], "float", "", "[4]");
    // Too many for all layers in one draw: each view has its own, with as much room as ever.
    checkLimit(walls, {MapKind::cube, CaptureMethod::exact, LayerOrder::allAtOnce}, "vec4", "");
    return 0;
}
