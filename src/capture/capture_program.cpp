#include "capture/capture_program.h"

#include "capture/views.h"
#include "capture_shaders.h"
#include "gl/program.h"

#include <mirrorball/error.h>
#include <mirrorball/maps/glsl.h>

#include <epoxy/gl.h>

#include <algorithm>

namespace mirrorball {

namespace capture {

namespace {

// Names of the library's in capture programs; another prefix than pass 2's, so that a reflective object can
// be drawn into another object's map with the snippet of pass 2 in its shader.
const std::string prefix = "mirrorballCapture_";

void replaceAll(std::string& text, std::string_view from, std::string_view to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::string define(const std::string& name, const std::string& value)
{
    return "#define MIRRORBALL_" + name + " " + value + "\n";
}

std::string define(const std::string& name, bool value)
{
    return define(name, std::string(value ? "1" : "0"));
}

// What the shaders' #if lines ask.
std::string defines(const Variant& variant, const std::string& position)
{
    const bool tennisBall = variant.map == MapKind::tennisBall || variant.map == MapKind::tennisBallEven;
    const bool textbook = variant.depthTerm == DepthTerm::textbook;
    const bool wraps = variant.map == MapKind::equirectangular || variant.map == MapKind::sphereMap;
    return define("VIEWS", std::to_string(viewCount(variant.map))) +
           define("VERTICES", std::to_string(3 * viewCount(variant.map))) +
           define("LAYER(view)", std::string(variant.map == MapKind::octahedral ? "0" : "(view)")) +
           define("POSITION", position) + define("TENNIS_BALL", tennisBall) +
           define("DUAL_PARABOLOID", variant.map == MapKind::dualParaboloid) +
           define("EQUI_ANGULAR_CUBE", variant.map == MapKind::equiAngularCube) +
           define("TEXTBOOK_TENNIS_BALL", textbook && tennisBall) +
           define("TEXTBOOK_DUAL_PARABOLOID", textbook && variant.map == MapKind::dualParaboloid) +
           define("CLIPS_RANGE", isPiecewiseLinear(variant.map)) + define("DROPS_SMEAR", wraps);
}

// The texts of one capture program, put together around the host's.
class Assembly
{
public:
    Assembly(const CaptureProgram::Implementation& host, const Variant& variant)
        : host_(host), variant_(variant), defines_(defines(variant, host.desc.position)),
          map_(mapGlsl(variant.map, GlslVersion::glsl330, prefix)),
          project_(isPiecewiseLinear(variant.map) ? shaders::projectLinear : shaders::projectTextbook)
    {
    }

    bool hasGeometryShader() const { return variant_.layers == LayerOrder::allAtOnce; }

    std::string vertex() const
    {
        std::string text = host_.vertex.versionLine() +
                           host_.vertex.body({{"main", prefix + "hostMain"},
                                              {"gl_ClipDistance", prefix + "ignoredClipDistance"}}) +
                           ours();
        if (host_.vertex.mentions("gl_ClipDistance"))
            text.insert(host_.vertex.versionLine().size(), "float " + prefix + "ignoredClipDistance[8];\n");
        if (hasGeometryShader())
            return text + std::string(shaders::vertexAll);
        return text + map_ + project_ + std::string(shaders::vertexOne);
    }

    std::string geometry() const
    {
        std::string declarations, copies;
        for (const Varying& varying : host_.varyings) {
            const std::string qualifier = varying.interpolation.empty() ? "" : varying.interpolation + " ";
            declarations +=
                qualifier + "in " + varying.type + " " + varying.name + "[]" + varying.arraySuffix + ";\n";
            declarations +=
                qualifier + "out " + varying.type + " " + prefix + varying.name + varying.arraySuffix + ";\n";
            copies += "    " + prefix + varying.name + " = " + varying.name + "[corner];\n";
        }
        std::string text(shaders::geometryAll);
        replaceAll(text, "MIRRORBALL_VARYINGS",
                   declarations + "void " + prefix + "copyVaryings(int corner)\n{\n" + copies + "}\n");
        return host_.vertex.versionLine() + defines_ + map_ + project_ + text;
    }

    std::string fragment() const
    {
        std::string text(shaders::fragmentInterpolated);
        std::string reads, declarations;
        std::vector<std::string> globals;
        if (hasGeometryShader())
            for (const Varying& varying : host_.varyings) {
                const std::string qualifier =
                    varying.interpolation.empty() ? "" : varying.interpolation + " ";
                declarations += qualifier + "in " + varying.type + " " + prefix + varying.name +
                                varying.arraySuffix + ";\n";
                reads += varying.name + " = " + prefix + varying.name + ";\n    ";
                globals.push_back(varying.name);
            }
        replaceAll(text, "MIRRORBALL_READ_VARYINGS", reads);
        const bool needsMap = text.find("DROPS_SMEAR") != std::string::npos &&
                              defines_.find("DROPS_SMEAR 1") != std::string::npos;
        return host_.fragment.versionLine() + host_.fragment.body({{"main", prefix + "hostMain"}}, globals) +
               ours() + (needsMap ? map_ + "uniform vec2 " + prefix + "size;\n" : "") + declarations + text;
    }

private:
    // What comes after the host's text counts its lines as those of source string 1.
    std::string ours() const { return "#line 1 1\n" + defines_; }

    const CaptureProgram::Implementation& host_;
    Variant variant_;
    std::string defines_;
    std::string map_;
    std::string project_;
};

LinkedProgram link(const CaptureProgram::Implementation& host, const Variant& variant)
{
    const Assembly assembly(host, variant);
    std::vector<gl::ShaderSource> sources = {{GL_VERTEX_SHADER, assembly.vertex(), host.vertex.name()},
                                             {GL_FRAGMENT_SHADER, assembly.fragment(), host.fragment.name()}};
    if (assembly.hasGeometryShader())
        sources.push_back({GL_GEOMETRY_SHADER, assembly.geometry(),
                           "the library's geometry shader for '" + host.desc.name + "'"});
    LinkedProgram result;
    result.program =
        gl::linkProgram(sources, "capture program '" + host.desc.name + "'", [&](unsigned int program) {
            if (!host.colourOutput.empty())
                glBindFragDataLocation(program, 0, host.colourOutput.c_str());
            glBindFragDataLocation(program, 1, (prefix + "distance").c_str());
        });
    const auto location = [&](const char* name) {
        return glGetUniformLocation(result.program.name(), (prefix + name).c_str());
    };
    result.probeFromWorld = location("probeFromWorld");
    result.view = location("view");
    result.depth = location("depth");
    result.range = location("range");
    result.size = location("size");
    result.clipFromDirection = location("clipFromDirection");
    result.inwardPlanes = location("inwardPlanes");
    result.usesClipDistances = variant.map != MapKind::cube;
    return result;
}

std::vector<Varying> varyingsOf(const HostShader& fragment)
{
    std::vector<Varying> varyings;
    for (const Declaration& declaration : fragment.declarations()) {
        if (declaration.storage != "in")
            continue;
        if (declaration.isBlock)
            throw Error(ErrorKind::badShader, fragment.name(),
                        "it reads the interface block '" + declaration.name + "'",
                        "declare its members as varyings of their own");
        varyings.push_back(
            {declaration.type, declaration.name, declaration.arraySuffix, declaration.interpolation});
    }
    return varyings;
}

// The output that receives the colour: the first one. Its name, or "" when a layout qualifier says where it
// goes.
std::string colourOutputOf(const HostShader& fragment)
{
    const auto& declarations = fragment.declarations();
    const auto output =
        std::find_if(declarations.begin(), declarations.end(),
                     [](const Declaration& declaration) { return declaration.storage == "out"; });
    if (output == declarations.end())
        throw Error(ErrorKind::badShader, fragment.name(), "it has no output",
                    "declare one: out vec4 colour;");
    return output->hasLocation ? "" : output->name;
}

} // namespace

} // namespace capture

CaptureProgram::Implementation::Implementation(Desc givenDesc)
    : desc(std::move(givenDesc)), vertex(desc.vertexSource, "the vertex shader of '" + desc.name + "'"),
      fragment(desc.fragmentSource, "the fragment shader of '" + desc.name + "'"),
      varyings(capture::varyingsOf(fragment)), colourOutput(capture::colourOutputOf(fragment))
{
}

const capture::LinkedProgram& CaptureProgram::Implementation::program(const capture::Variant& variant)
{
    const auto found = programs.find(variant);
    if (found != programs.end())
        return found->second;
    return programs.emplace(variant, capture::link(*this, variant)).first->second;
}

CaptureProgram::CaptureProgram(Desc desc) : implementation_(std::make_unique<Implementation>(std::move(desc)))
{
}
CaptureProgram::~CaptureProgram() = default;
CaptureProgram::CaptureProgram(CaptureProgram&&) noexcept = default;
CaptureProgram& CaptureProgram::operator=(CaptureProgram&&) noexcept = default;

const CaptureProgram::Desc& CaptureProgram::desc() const
{
    return implementation_->desc;
}

} // namespace mirrorball
