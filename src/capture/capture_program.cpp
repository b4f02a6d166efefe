#include "capture/capture_program.h"

#include "capture/cover.h"
#include "capture/glsl_words.h"
#include "capture/varyings_glsl.h"
#include "capture/varyings_room.h"
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

Carriage carriageOf(const Variant& variant)
{
    return variant.path == Path::exact               ? Carriage::exact
           : variant.path == Path::tessellated       ? Carriage::copied
           : variant.layers == LayerOrder::allAtOnce ? Carriage::copied
                                                     : Carriage::direct;
}

int viewsAtOnce(const Variant& variant)
{
    return variant.layers == LayerOrder::allAtOnce ? viewCount(variant.map) : 1;
}

// What the geometry stage writes at least for one triangle: a covering polygon of one strip, or the triangle.
int smallestOutput(const Variant& variant)
{
    return viewsAtOnce(variant) * (variant.path == Path::exact ? 4 : 3);
}

// The strips that a triangle's covering polygon is cut into: as many as the driver has room for, up to 6,
// where triangles are large; one, a box, where they are small.
int stripsOf(const CaptureProgram::Implementation& host, const Variant& variant)
{
    if (variant.path != Path::exact || !variant.large)
        return 1;
    const int scalars = scalarsOf(host.varyings, Carriage::exact);
    const int vertices =
        gl::integer(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS) / (scalars * viewsAtOnce(variant));
    return std::clamp(vertices / 2 - 1, 1, 6);
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
    return variant.path == Path::textbook || variant.path == Path::tessellated ||
           (variant.path == Path::linear && variant.map == MapKind::octahedral);
}

// Whether triangles may need more than a simple polygon. Small ones do where a layer holds poles, a cut or folds.
bool coversCurved(const Variant& variant)
{
    return variant.large || variant.map == MapKind::equirectangular || variant.map == MapKind::octahedral;
}

// What the shaders' #if lines ask.
std::string defines(const CaptureProgram::Implementation& host, const Variant& variant)
{
    const int corners = cornersOf(host, variant);
    int turnedViews = 0; // a bit for each view
    for (int view = 0; view < viewCount(variant.map); ++view)
        turnedViews |= orientation(variant.map, view) < 0 ? 1 << view : 0;
    const bool tennisBall = variant.map == MapKind::tennisBall || variant.map == MapKind::tennisBallEven;
    const bool textbook = variant.depthTerm == DepthTerm::textbook;
    const bool wraps = variant.map == MapKind::equirectangular || variant.map == MapKind::sphereMap;
    // A view's matrices come alone where views are drawn one at a time: software rasterisers fetch from an array
    // at an index that is not a constant for each vertex anew.
    const bool together = variant.layers == LayerOrder::allAtOnce;
    return define("VIEWS", std::to_string(viewCount(variant.map))) +
           define("SLOTS", std::to_string(viewsAtOnce(variant))) +
           define("SLOT(view)", std::string(together ? "(view)" : "0")) +
           define("CORNERS", std::to_string(corners)) +
           define("VERTICES", std::to_string(corners * viewsAtOnce(variant))) +
           define("STRIPS", std::to_string(corners / 2 - 1)) +
           define("LAYER(view)", std::string(variant.map == MapKind::octahedral ? "0" : "(view)")) +
           define("TURNED_VIEWS", std::to_string(turnedViews)) + define("POSITION", host.desc.position) +
           define("TENNIS_BALL", tennisBall) +
           define("DUAL_PARABOLOID", variant.map == MapKind::dualParaboloid) +
           define("EQUI_ANGULAR_CUBE", variant.map == MapKind::equiAngularCube) +
           define("OCTAHEDRAL", variant.map == MapKind::octahedral) +
           define("TEXTBOOK_TENNIS_BALL", textbook && tennisBall) +
           define("TEXTBOOK_DUAL_PARABOLOID", textbook && variant.map == MapKind::dualParaboloid) +
           define("CLIPS_RANGE", variant.path == Path::linear && !variant.withinRange) +
           define("DROPS_SMEAR", variant.path == Path::textbook && wraps) +
           define("PERSPECTIVE", variant.path == Path::mapped || variant.path == Path::tessellated) +
           define("CUTS", cuts(variant)) + define("ALL_AT_ONCE", together) +
           define("CURVED", coversCurved(variant)) + define("PEELS", variant.peels) +
           define("HIDES", variant.hides) + coverDefines(variant.map);
}

// The texts of one capture program, put together around the host's.
class Assembly
{
public:
    Assembly(const CaptureProgram::Implementation& host, const Variant& variant)
        : host_(host), variant_(variant), carriage_(carriageOf(variant)), defines_(defines(host, variant)),
          map_(mapGlsl(variant.map, GlslVersion::glsl330, prefix, GlslInputs::regular)),
          rays_(mapRaysGlsl(variant.map, GlslVersion::glsl330, prefix))
    {
    }

    bool isExact() const { return variant_.path == Path::exact; }
    bool isTessellated() const { return variant_.path == Path::tessellated; }
    bool hasGeometryShader() const { return carriage_ != Carriage::direct && !isTessellated(); }
    // Whether varyings pass another stage between vertex and fragment stage.
    bool carries() const { return carriage_ != Carriage::direct; }

    // The library's text comes before the host's, so that no macro or global name of the host's can meet it;
    // what comes after only calls.
    std::string vertex() const
    {
        HostShader::Changes changes;
        changes.identifiers = {{"main", prefix + "hostMain"}};
        changes.removed = {"gl_PerVertex", "gl_ClipDistance"};
        changes.prelude = ours() + (carries() ? std::string(shaders::vertexAll)
                                              : map_ + project() + std::string(shaders::vertexOne));
        if (host_.vertex.mentions("gl_ClipDistance")) {
            changes.identifiers.push_back({"gl_ClipDistance", prefix + "ignoredClipDistance"});
            changes.prelude += "float " + prefix + "ignoredClipDistance[8];\n";
        }
        // The geometry stage reads varyings by name.
        for (const Varying& varying : host_.varyings)
            if (carries())
                changes.withoutLayout.push_back(varying.block.empty() ? varying.vertexName : varying.block);
        return host_.vertex.versionLine() + host_.vertex.body(changes) + "#line 1 1\n" +
               std::string(shaders::vertexMain);
    }

    std::string geometry() const
    {
        std::string text = host_.vertex.versionLine() + "#extension GL_ARB_gpu_shader5 : enable\n" +
                           arraysOfArrays() + defines_ + map_;
        if (isExact())
            text += std::string(shaders::coverCommon) + std::string(coverShader(variant_.map)) +
                    std::string(shaders::trianglePlane) +
                    (variant_.hides ? std::string(shaders::geometryBehind) : "") +
                    std::string(shaders::geometryExact);
        else
            text += project() + std::string(shaders::geometryAll);
        return text + host_.fragment.skeleton(declarationMark) + geometryVaryings(host_.varyings, carriage_);
    }

    std::string tessellationControl() const
    {
        return "#version 400 core\n" + arraysOfArrays() + defines_ +
               std::string(shaders::tessellationControl) + host_.fragment.skeleton(declarationMark) +
               controlVaryings(host_.varyings);
    }

    std::string tessellationEvaluation() const
    {
        return "#version 400 core\n" + arraysOfArrays() + defines_ + map_ + project() +
               std::string(shaders::tessellationEvaluation) + host_.fragment.skeleton(declarationMark) +
               evaluationVaryings(host_.varyings);
    }

    std::string fragment() const
    {
        const bool facing = isExact() && host_.fragment.mentions("gl_FrontFacing");
        const bool primitive = isExact() && host_.fragment.mentions("gl_PrimitiveID");
        HostShader::Changes changes;
        changes.identifiers = {{"main", prefix + "hostMain"}};
        changes.globals = host_.outputs.others;
        changes.withoutLayout = {host_.outputs.colour};
        changes.removed = {"gl_FragDepth", "gl_FragCoord", "early_fragment_tests"};
        changes.mark = carries() || !variant_.ownPosition ? declarationMark : "";
        for (const Varying& varying : host_.varyings)
            if (carries())
                changes.globals.push_back(varying.statement());
        const auto substitute = [&](const std::string& type, const std::string& from, const std::string& to) {
            changes.prelude += type + " " + prefix + to + ";\n";
            changes.identifiers.push_back({from, prefix + to});
        };
        if (facing)
            substitute("bool", "gl_FrontFacing", "hostFrontFacing");
        if (primitive)
            substitute("int", "gl_PrimitiveID", "hostPrimitiveID");
        if (host_.fragment.mentions("gl_FragDepth"))
            substitute("float", "gl_FragDepth", "ignoredDepth");
        const bool dropsSmear = defines_.find("DROPS_SMEAR 1") != std::string::npos;
        changes.prelude += ours() + define("READS_FRONT_FACING", facing) +
                           define("READS_PRIMITIVE_ID", primitive) + (isExact() || dropsSmear ? map_ : "") +
                           (isExact() ? rays_ : "") + std::string(shaders::fragmentPeel) +
                           std::string(isExact() ? shaders::fragmentExact : shaders::fragmentInterpolated);
        return host_.fragment.versionLine() + host_.fragment.body(changes) + "#line 1 1\n" +
               fragmentVaryings(host_.varyings, carriage_) +
               (isExact() ? "" : fragmentPosition(variant_.ownPosition ? nullptr : host_.positionVarying())) +
               std::string(shaders::fragmentMain);
    }

private:
    // An array reaches the stage after the vertex shader's as an array of them.
    static std::string arraysOfArrays() { return "#extension GL_ARB_arrays_of_arrays : enable\n"; }

    // The lines of the library's text count as those of source string 1.
    std::string ours() const { return "#line 1 1\n" + defines_; }

    std::string project() const
    {
        return std::string(variant_.path == Path::linear ? shaders::projectLinear : shaders::projectMapped);
    }

    const CaptureProgram::Implementation& host_;
    Variant variant_;
    Carriage carriage_;
    std::string defines_;
    std::string map_;
    std::string rays_;
};

LinkedProgram link(const CaptureProgram::Implementation& host, const Variant& variant)
{
    requireRoom(host.varyings, carriageOf(variant), smallestOutput(variant), host.desc.name);
    const Assembly assembly(host, variant);
    std::vector<gl::ShaderSource> sources = {{GL_VERTEX_SHADER, assembly.vertex(), host.vertex.name()},
                                             {GL_FRAGMENT_SHADER, assembly.fragment(), host.fragment.name()}};
    if (assembly.hasGeometryShader())
        sources.push_back({GL_GEOMETRY_SHADER, assembly.geometry(),
                           "the library's geometry shader for '" + host.desc.name + "'"});
    if (assembly.isTessellated()) {
        sources.push_back({GL_TESS_CONTROL_SHADER, assembly.tessellationControl(),
                           "the library's tessellation control shader for '" + host.desc.name + "'"});
        sources.push_back({GL_TESS_EVALUATION_SHADER, assembly.tessellationEvaluation(),
                           "the library's tessellation evaluation shader for '" + host.desc.name + "'"});
    }
    LinkedProgram result;
    try {
        result.program =
            gl::linkProgram(sources, "capture program '" + host.desc.name + "'", [&](unsigned int program) {
                glBindFragDataLocation(program, 0, host.outputs.colour.c_str());
                glBindFragDataLocation(program, 1, (prefix + "distance").c_str());
            });
    } catch (const Error& error) {
        requireNoneWithoutResource(host.varyings, carriageOf(variant), error.what(), host.desc.name);
        throw;
    }
    const auto location = [&](const char* name) {
        return glGetUniformLocation(result.program.name(), (prefix + name).c_str());
    };
    result.probeFromWorld = location("probeFromWorld");
    result.centre = location("centre");
    result.view = location("view");
    result.depth = location("depth");
    result.range = location("range");
    result.size = location("size");
    result.clipFromDirection = location("clipFromDirection");
    result.inwardPlanes = location("inwardPlanes");
    result.lineFromDirection = location("lineFromDirection");
    result.cullBackFaces = location("cullBackFaces");
    result.steps = location("steps");
    result.firstAround = location("firstAround");
    result.texelsPerSample = location("texelsPerSample");
    result.layer = location("layer");
    result.separation = location("separation");
    result.farthest = location("farthest");
    result.writesDepth = variant.path == Path::exact;
    result.usesClipDistances = cuts(variant);
    return result;
}

} // namespace

} // namespace capture

CaptureProgram::Implementation::Implementation(Desc givenDesc)
    : desc(std::move(givenDesc)), vertex(desc.vertexSource, "the vertex shader of '" + desc.name + "'"),
      fragment(desc.fragmentSource, "the fragment shader of '" + desc.name + "'"),
      varyings(capture::varyingsOf(vertex, fragment)), outputs(capture::outputsOf(fragment))
{
    for (const capture::HostShader* const shader : {&vertex, &fragment})
        if (const std::string clash = shader->nameBeginningWith(capture::prefix); !clash.empty())
            throw Error(ErrorKind::badShader, shader->name(), "it uses the name '" + clash + "'",
                        "names that begin with " + capture::prefix + " are the library's");
    requirePosition();
}

// Of an expression that is more than a name the compiler tells what is wrong.
void CaptureProgram::Implementation::requirePosition() const
{
    const std::string advice =
        "say with CaptureProgram::Desc::position what holds the position in world space, as a vec3";
    if (desc.position.empty())
        throw Error(ErrorKind::badShader, vertex.name(), "the name of its position is empty", advice);
    const bool isName = std::ranges::all_of(desc.position, capture::continuesIdentifier);
    if (isName && !vertex.mentions(desc.position))
        throw Error(ErrorKind::badShader, vertex.name(), "it has no '" + desc.position + "'", advice);
    std::string type = desc.position == "gl_Position" ? "vec4" : "";
    for (const capture::Declaration& declaration : vertex.declarations())
        if (declaration.name == desc.position && !declaration.isBlock &&
            type != "vec3") // of several branches
            type = declaration.type;
    if (type == "vec4" || type == "vec2" || type == "float")
        throw Error(ErrorKind::badShader, vertex.name(), "its '" + desc.position + "' is a " + type, advice);
}

bool CaptureProgram::Implementation::fits(const capture::Variant& variant) const
{
    return capture::hasRoom(varyings, capture::carriageOf(variant), capture::smallestOutput(variant));
}

const capture::Varying* CaptureProgram::Implementation::positionVarying() const
{
    const auto found = std::find_if(varyings.begin(), varyings.end(), [&](const capture::Varying& varying) {
        const bool isSmooth = varying.interpolation.empty() || varying.interpolation == "smooth";
        return varying.vertexName == desc.position && varying.block.empty() && varying.type == "vec3" &&
               varying.arraySuffix.empty() && varying.auxiliary.empty() && isSmooth;
    });
    return found == varyings.end() ? nullptr : &*found;
}

capture::LinkedProgram& CaptureProgram::Implementation::program(capture::Variant variant)
{
    variant.ownPosition = variant.ownPosition || positionVarying() == nullptr;
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
