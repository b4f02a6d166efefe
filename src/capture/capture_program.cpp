#include "capture/capture_program.h"

#include "capture/views.h"
#include "capture_shaders.h"
#include "gl/context.h"
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

// The places where the outline of a triangle may turn back along the strips of its covering polygon.
int eventsOf(MapKind map)
{
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
    case MapKind::equirectangular:
        return 9;
    case MapKind::dualParaboloid:
        return 12;
    case MapKind::cube:
    case MapKind::equiAngularCube:
    case MapKind::octahedral:
        return 3;
    case MapKind::sphereMap:
        break;
    }
    return 1;
}

// Sag of an arc on the map over its chord, in texels: a constant times chord² (of unit directions). The
// constants are the suprema over arcs with both ends within 60 degrees of the equator and chords up to 1/2
// (for the sphere map within 120 degrees of its centre and up to 1/5), 0.183, 0.183, 0.0914 and 0.0813 in
// units of n, rounded up by a tenth; tests/capture/sag_test.cpp holds them.
std::string coverDefines(MapKind map)
{
    const bool tennisBall = map == MapKind::tennisBall || map == MapKind::tennisBallEven;
    const std::string sag = tennisBall                        ? "(0.2 * mirrorballCapture_size.x)"
                            : map == MapKind::equirectangular ? "(0.1 * mirrorballCapture_size.y)"
                                                              : "(0.09 * mirrorballCapture_size.x)";
    return define("ALONG", std::string(map == MapKind::equirectangular ? "x" : "y")) +
           define("ACROSS", std::string(map == MapKind::equirectangular ? "y" : "x")) +
           define("EQUIRECTANGULAR", map == MapKind::equirectangular) +
           define("PERIOD", std::string(map == MapKind::equirectangular ? "1.0" : "(4.0 / 3.0)")) +
           define("EVENTS", std::to_string(eventsOf(map))) + define("SAG", sag);
}

std::string_view coverShader(MapKind map)
{
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
    case MapKind::equirectangular:
        return shaders::coverLatitude;
    case MapKind::dualParaboloid:
        return shaders::coverStereographic;
    case MapKind::equiAngularCube:
    case MapKind::cube:
    case MapKind::octahedral:
        return shaders::coverLinear;
    case MapKind::sphereMap:
        break;
    }
    return shaders::coverSphereMap;
}

int scalarsOf(const std::string& type)
{
    // A matCxR, a vecN or a scalar.
    const std::size_t digit = type.find_first_of("234");
    if (digit == std::string::npos)
        return 1;
    const int first = type[digit] - '0';
    if (type.rfind("mat", 0) != 0)
        return first;
    return first * (type.size() > digit + 2 ? type[digit + 2] - '0' : first);
}

// Throws Error badShader when the exact path has no room for a varying of the host's, and names it. A
// triangle hands the fragment stage its varyings at all three vertices (flat ones once), beside 15 scalars of
// the library's own and gl_Position. Returns the scalars of one vertex.
int requireRoom(const CaptureProgram::Implementation& host, int views)
{
    constexpr int own = 15 + 4;
    constexpr int smallestPolygon = 4;
    const int limit = std::min(
        {gl::integer(GL_MAX_GEOMETRY_OUTPUT_COMPONENTS), gl::integer(GL_MAX_FRAGMENT_INPUT_COMPONENTS),
         gl::integer(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS) / (smallestPolygon * views)});
    int used = own;
    for (const Varying& varying : host.varyings) {
        const std::string asked =
            "varying '" + varying.type + " " + varying.name + "' of '" + host.desc.name + "'";
        const bool known = varying.type == "float" || varying.type == "int" || varying.type == "uint" ||
                           varying.type.find("vec") != std::string::npos || varying.type.rfind("mat", 0) == 0;
        if (!known || !varying.arraySuffix.empty() || varying.type[0] == 'd')
            throw Error(ErrorKind::badShader, asked,
                        "exact capture carries scalars, vectors and matrices only",
                        "split it up or capture with perVertex");
        used += scalarsOf(varying.type) * (varying.interpolation == "flat" ? 1 : 3);
        if (used > limit)
            throw Error(ErrorKind::badShader, asked,
                        "exact capture needs " + std::to_string(used) +
                            " scalars a vertex up to it and the driver has " + std::to_string(limit),
                        "hand over fewer varyings or capture with perVertex");
    }
    return used;
}

// The strips that a triangle's covering polygon is cut into: as many as the driver has room for, up to 10,
// where triangles are large; one, a box, where they are small.
int stripsOf(const CaptureProgram::Implementation& host, const Variant& variant)
{
    if (variant.path != Path::exact)
        return 1;
    const int views = variant.layers == LayerOrder::allAtOnce ? viewCount(variant.map) : 1;
    const int scalars = requireRoom(host, views);
    const int vertices = gl::integer(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS) / (scalars * views);
    return variant.large ? std::clamp(vertices / 2 - 1, 1, 10) : 1;
}

// What the geometry stage writes at most for one triangle: `corners` for each view.
int cornersOf(const CaptureProgram::Implementation& host, const Variant& variant)
{
    return variant.path == Path::exact ? 2 * stripsOf(host, variant) + 2 : 3;
}

// Whether clip distances cut off what lies outside a view: a cube face is cut by its own frustum, a mapped
// mesh is known to lie within the chart, and exact capture tests every texel.
bool cuts(const Variant& variant)
{
    return variant.path == Path::textbook ||
           (variant.path == Path::linear && variant.map == MapKind::octahedral);
}

// What the shaders' #if lines ask.
std::string defines(const CaptureProgram::Implementation& host, const Variant& variant)
{
    const int corners = cornersOf(host, variant);
    const int vertices = corners * (variant.layers == LayerOrder::allAtOnce ? viewCount(variant.map) : 1);
    const bool tennisBall = variant.map == MapKind::tennisBall || variant.map == MapKind::tennisBallEven;
    const bool textbook = variant.depthTerm == DepthTerm::textbook;
    const bool wraps = variant.map == MapKind::equirectangular || variant.map == MapKind::sphereMap;
    return define("VIEWS", std::to_string(viewCount(variant.map))) +
           define("CORNERS", std::to_string(corners)) + define("VERTICES", std::to_string(vertices)) +
           define("STRIPS", std::to_string(corners / 2 - 1)) +
           define("LAYER(view)", std::string(variant.map == MapKind::octahedral ? "0" : "(view)")) +
           define("POSITION", host.desc.position) + define("TENNIS_BALL", tennisBall) +
           define("DUAL_PARABOLOID", variant.map == MapKind::dualParaboloid) +
           define("EQUI_ANGULAR_CUBE", variant.map == MapKind::equiAngularCube) +
           define("OCTAHEDRAL", variant.map == MapKind::octahedral) +
           define("TEXTBOOK_TENNIS_BALL", textbook && tennisBall) +
           define("TEXTBOOK_DUAL_PARABOLOID", textbook && variant.map == MapKind::dualParaboloid) +
           define("CLIPS_RANGE", variant.path == Path::linear) +
           define("DROPS_SMEAR", variant.path == Path::textbook && wraps) +
           define("PERSPECTIVE", variant.path == Path::mapped) + define("CUTS", cuts(variant)) +
           define("ALL_AT_ONCE", variant.layers == LayerOrder::allAtOnce) + coverDefines(variant.map);
}

// The texts of one capture program, put together around the host's.
class Assembly
{
public:
    Assembly(const CaptureProgram::Implementation& host, const Variant& variant)
        : host_(host), variant_(variant), defines_(defines(host, variant)),
          map_(mapGlsl(variant.map, GlslVersion::glsl330, prefix, GlslInputs::regular))
    {
    }

    bool isExact() const { return variant_.path == Path::exact; }
    bool hasGeometryShader() const { return isExact() || variant_.layers == LayerOrder::allAtOnce; }

    std::string vertex() const
    {
        const bool clips = host_.vertex.mentions("gl_ClipDistance");
        const std::string ignored = prefix + "ignoredClipDistance";
        std::string text = host_.vertex.versionLine() +
                           host_.vertex.body({{"main", prefix + "hostMain"}, {"gl_ClipDistance", ignored}},
                                             {}, clips ? "float " + ignored + "[8];\n" : "") +
                           ours();
        if (hasGeometryShader())
            return text + std::string(shaders::vertexAll);
        return text + map_ + project() + std::string(shaders::vertexOne);
    }

    std::string geometry() const
    {
        std::string text(isExact() ? shaders::geometryExact : shaders::geometryAll);
        replaceAll(text, "MIRRORBALL_VARYINGS", isExact() ? exactVaryings() : copiedVaryings());
        const std::string head =
            host_.vertex.versionLine() + "#extension GL_ARB_gpu_shader5 : enable\n" + defines_ + map_;
        if (!isExact())
            return head + project() + text;
        // The covering polygons are functions; they come before main and after the declarations of layouts.
        return head + std::string(shaders::coverCommon) + std::string(coverShader(variant_.map)) +
               std::string(shaders::trianglePlane) + text;
    }

    std::string fragment() const
    {
        const bool facing = isExact() && host_.fragment.mentions("gl_FrontFacing");
        const bool primitive = isExact() && host_.fragment.mentions("gl_PrimitiveID");
        std::vector<HostShader::Replacement> replacements = {{"main", prefix + "hostMain"}};
        if (facing)
            replacements.push_back({"gl_FrontFacing", prefix + "hostFrontFacing"});
        if (primitive)
            replacements.push_back({"gl_PrimitiveID", prefix + "hostPrimitiveID"});
        const std::string prelude = (facing ? "bool " + prefix + "hostFrontFacing;\n" : "") +
                                    (primitive ? "int " + prefix + "hostPrimitiveID;\n" : "");
        std::vector<std::string> globals;
        if (hasGeometryShader())
            for (const Varying& varying : host_.varyings)
                globals.push_back(varying.name);
        std::string text(isExact() ? shaders::fragmentExact : shaders::fragmentInterpolated);
        replaceAll(text, "MIRRORBALL_READ_VARYINGS", hasGeometryShader() ? readVaryings() : "");
        const bool dropsSmear = defines_.find("DROPS_SMEAR 1") != std::string::npos;
        return host_.fragment.versionLine() + host_.fragment.body(replacements, globals, prelude) + ours() +
               define("READS_FRONT_FACING", facing) + define("READS_PRIMITIVE_ID", primitive) +
               (isExact() || dropsSmear ? map_ : "") +
               (dropsSmear ? "uniform vec2 " + prefix + "size;\n" : "") +
               (hasGeometryShader() ? fragmentVaryings() : "") + text;
    }

private:
    // What comes after the host's text counts its lines as those of source string 1.
    std::string ours() const { return "#line 1 1\n" + defines_; }

    std::string project() const
    {
        return std::string(variant_.path == Path::linear ? shaders::projectLinear : shaders::projectMapped);
    }

    static std::string qualifier(const Varying& varying)
    {
        return varying.interpolation.empty() ? "" : varying.interpolation + " ";
    }

    static bool isFlat(const Varying& varying) { return varying.interpolation == "flat"; }

    static std::string inputOf(const Varying& varying)
    {
        return qualifier(varying) + "in " + varying.type + " " + varying.name + "[]" + varying.arraySuffix +
               ";\n";
    }

    // A varying as the geometry stage passes it on: under the library's name, from one vertex each time.
    std::string copiedVaryings() const
    {
        std::string declarations, copies;
        for (const Varying& varying : host_.varyings) {
            declarations += inputOf(varying) + qualifier(varying) + "out " + varying.type + " " + prefix +
                            varying.name + varying.arraySuffix + ";\n";
            copies += "    " + prefix + varying.name + " = " + varying.name + "[corner];\n";
        }
        return declarations + "void " + prefix + "copyVaryings(int corner)\n{\n" + copies + "}\n";
    }

    // For exact capture: the values at all three vertices, flat; a flat varying has that of the last vertex
    // only.
    std::string exactVaryings() const
    {
        std::string declarations, copies;
        for (const Varying& varying : host_.varyings) {
            declarations += inputOf(varying);
            for (int corner = isFlat(varying) ? 2 : 0; corner < 3; ++corner) {
                const std::string name = prefix + varying.name + std::to_string(corner);
                declarations += "flat out " + varying.type + " " + name + ";\n";
                copies += "    " + name + " = " + varying.name + "[" + std::to_string(corner) + "];\n";
            }
        }
        return declarations + "void " + prefix + "copyVaryings()\n{\n" + copies + "}\n";
    }

    std::string fragmentVaryings() const
    {
        std::string declarations;
        for (const Varying& varying : host_.varyings) {
            if (!isExact()) {
                declarations += qualifier(varying) + "in " + varying.type + " " + prefix + varying.name +
                                varying.arraySuffix + ";\n";
                continue;
            }
            for (int corner = isFlat(varying) ? 2 : 0; corner < 3; ++corner)
                declarations +=
                    "flat in " + varying.type + " " + prefix + varying.name + std::to_string(corner) + ";\n";
        }
        return declarations;
    }

    std::string readVaryings() const
    {
        std::string reads;
        for (const Varying& varying : host_.varyings) {
            const std::string name = prefix + varying.name;
            if (!isExact())
                reads += varying.name + " = " + name + ";\n    ";
            else if (isFlat(varying))
                reads += varying.name + " = " + name + "2;\n    ";
            else
                reads += varying.name + " = weight.x * " + name + "0 + weight.y * " + name +
                         "1 + weight.z * " + name + "2;\n    ";
        }
        return reads;
    }

    const CaptureProgram::Implementation& host_;
    Variant variant_;
    std::string defines_;
    std::string map_;
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
    result.lineFromDirection = location("lineFromDirection");
    result.cullBackFaces = location("cullBackFaces");
    result.writesDepth = variant.path == Path::exact;
    result.usesClipDistances = cuts(variant);
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
