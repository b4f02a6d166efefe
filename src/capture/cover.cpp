#include "capture/cover.h"

#include "capture/glsl_words.h"
#include "capture_shaders.h"
#include "gl/context.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace mirrorball::capture {

namespace {

// The places where the outline of a triangle may turn back along the strips of its covering polygon.
int eventsOf(MapKind map)
{
    switch (map) {
    case MapKind::tennisBall:
    case MapKind::tennisBallEven:
    case MapKind::cube:
    case MapKind::equiAngularCube:
    case MapKind::octahedral:
    case MapKind::equirectangular:
        return 9;
    case MapKind::dualParaboloid:
        return 12;
    case MapKind::sphereMap: // whose strips of azimuth need none
        break;
    }
    return 3;
}

// The widest texel of a layer, in radians: times its width in texels.
std::string_view spreadOf(MapKind map)
{
    switch (map) {
    case MapKind::tennisBall:
        return "1.6";
    case MapKind::tennisBallEven:
        return "1.9";
    case MapKind::dualParaboloid:
        return "4.1";
    case MapKind::cube:
        return "2.1";
    case MapKind::equiAngularCube:
        return "1.9";
    case MapKind::octahedral:
        return "6.2";
    case MapKind::equirectangular:
        return "6.4";
    case MapKind::sphereMap: // no bound at its rim
        break;
    }
    return "1e9";
}

// Half a step of the rasteriser's grid each way, in texels. OpenGL asks for 4 bits at least; more than 8 gain nothing.
std::string snapDefine()
{
    const int bits = std::clamp(gl::integer(GL_SUBPIXEL_BITS), 4, 8);
    return define("SNAP", std::to_string(0.7072 / static_cast<double>(1 << bits)));
}

} // namespace

// Sag of an arc on the map over its chord, in texels: a constant times chord² (of unit directions). The constants are
// the suprema over arcs with both ends within 60 degrees of the equator and chords up to 1/2, 0.183, 0.183 and 0.0914
// in units of n, rounded up by a tenth; tests/capture/error_law_test.cpp holds them, and those that stand in the
// shaders. Where coordinates are those of latitude and longitude it is also at most tan(latitude) · along · (slanted ·
// across + level · along) / n, with the steps of its ends in texels; rounded up by a twentieth. STRETCH is the most
// texels that a radian has where triangles count as straight: within 60 degrees of the equator 1.27 and 0.637 n, on the
// dual paraboloid where z > -0.6 1.25 n, on the sphere map 0.354 n over the root of 1 + z.
std::string coverDefines(MapKind map)
{
    const bool even = map == MapKind::tennisBallEven;
    const bool tennisBall = map == MapKind::tennisBall || even;
    const std::string sag =
        tennisBall ? "(0.2 * mirrorballCapture_size.x)" : "(0.1 * mirrorballCapture_size.y)";
    const std::string stretch = map == MapKind::equirectangular ? "(0.65 * mirrorballCapture_size.y)"
                                : map == MapKind::sphereMap     ? "(0.36 * mirrorballCapture_size.x)"
                                                                : "(1.3 * mirrorballCapture_size.x)";
    return define("ALONG", std::string(map == MapKind::equirectangular ? "x" : "y")) +
           define("ACROSS", std::string(map == MapKind::equirectangular ? "y" : "x")) +
           define("EQUIRECTANGULAR", map == MapKind::equirectangular) +
           define("PERIOD", std::string(map == MapKind::equirectangular ? "1.0" : "(4.0 / 3.0)")) +
           // A curve of longitude has one inflection each half turn; others have no more in a layer.
           define("LONGEST_STRIP", std::string(tennisBall                        ? "0.6"
                                               : map == MapKind::equirectangular ? "0.45"
                                               : map == MapKind::octahedral      ? "0.0"
                                                                                 : "2.0")) +
           // Around a circle of longitude a triangle may leave a layer and come back.
           define("WRAPS", std::string(tennisBall || map == MapKind::equirectangular ? "true" : "false")) +
           define("BANDS", tennisBall || map == MapKind::equirectangular || map == MapKind::dualParaboloid ||
                               map == MapKind::sphereMap) +
           // On the dual paraboloid the others tell on which side of its circle an edge has the triangle.
           define("NARROWINGS", std::string(map == MapKind::dualParaboloid ? "2" : "1")) +
           define("EVENTS", std::to_string(eventsOf(map))) + define("SAG", sag) + define("STRETCH", stretch) +
           define("SPREAD", std::string(spreadOf(map)) + " / mirrorballCapture_size.x") +
           define("SLANTED_SAG", std::string(even         ? "0.72"
                                             : tennisBall ? "0.366"
                                                          : "0.72")) +
           define("LEVEL_SAG", std::string(even         ? "0.23"
                                           : tennisBall ? "0.215"
                                                        : "0.43")) +
           snapDefine();
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

} // namespace mirrorball::capture
