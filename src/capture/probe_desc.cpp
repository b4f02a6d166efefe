#include "capture/map_textures.h"
#include "capture/probe_implementation.h"
#include "enumeration.h"
#include "finite.h"
#include "gl/context.h"
#include "number_text.h"

#include <mirrorball/error.h>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>

#include <string>

namespace mirrorball::capture {

namespace {

void requirePossibleMethod(const ReflectionProbe::Desc& desc)
{
    if (!(desc.epsilon > 0.0f))
        throw Error(ErrorKind::badArgument, "a probe's epsilon", "it is " + numberText(desc.epsilon),
                    "give a number of texels above 0");
    if (desc.method == CaptureMethod::tessellated && epoxy_gl_version() < 40)
        throw Error(ErrorKind::unsupported, "tessellated capture", "the context is older than OpenGL 4.0",
                    "make a newer one or use exact");
    if (desc.method == CaptureMethod::tessellated && desc.layers == LayerOrder::allAtOnce)
        throw Error(ErrorKind::badArgument, "tessellated capture into all layers at once",
                    "there is no such order", "draw one layer at a time or use exact");
    const bool textbookMap = desc.map == MapKind::tennisBall || desc.map == MapKind::dualParaboloid;
    if (desc.depthTerm == DepthTerm::textbook && !(textbookMap && desc.method == CaptureMethod::perVertex))
        throw Error(ErrorKind::badArgument, "textbook depth terms",
                    "there are none for this method on the " + std::string(mapInfo(desc.map).name) + " map",
                    "use perVertex on tennis-ball or dual-paraboloid");
}

} // namespace

void requirePossible(const ReflectionProbe::Desc& desc)
{
    requireOneOf(desc.map, maps().back().kind, "a probe's map", "MapKind");
    requireOneOf(desc.method, CaptureMethod::tessellated, "a probe's method", "CaptureMethod");
    requireOneOf(desc.layers, LayerOrder::allAtOnce, "a probe's order of layers", "LayerOrder");
    requireOneOf(desc.depthTerm, DepthTerm::textbook, "a probe's depth term", "DepthTerm");
    requireOneOf(desc.colour, ColourFormat::rgba8, "a probe's colour format", "ColourFormat");
    requireFinite(glm::value_ptr(desc.captureOrigin), 3, "a capture origin");
    requireFinite(glm::value_ptr(desc.background), 4, "a probe's background");
    gl::requireContext();
    requireMapSize(desc.map, desc.n, desc.supersample);
    if (desc.colourTexture != 0 && desc.colourTexture == desc.distanceTexture)
        throw Error(ErrorKind::badArgument, "a map that the host owns", "one texture is given twice",
                    "give one for colours and one for distances");
    if ((desc.colourTexture == 0) != (desc.distanceTexture == 0))
        throw Error(ErrorKind::badArgument, "a map that the host owns",
                    "only one of its two textures is given", "give colour and distance, or neither");
    requirePossibleMethod(desc);
    if (desc.layersOfDepth < 1 || desc.layersOfDepth > 2 || !(desc.layerSeparation >= 0.0f))
        throw Error(ErrorKind::badArgument, "a probe's layers of depth",
                    std::to_string(desc.layersOfDepth) + ", separated by " + numberText(desc.layerSeparation),
                    "ask for 1 or 2, separated by 0 or more");
}

} // namespace mirrorball::capture
