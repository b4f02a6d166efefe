#include <mirrorball/maps/glsl.h>

#include "enumeration.h"

#include <mirrorball/error.h>
#include <mirrorball/maps/visit.h>
#include <mirrorball/math/dual.h>
#include <mirrorball/math/glsl_scalar.h>

#include <cctype>
#include <initializer_list>

namespace mirrorball {
namespace {

using Recorded = GlslScalar;

constexpr std::size_t longestLine = 100;

Recorded realVariable(const std::string& name)
{
    return Recorded(glslVariable(GlslType::real, name));
}
Vec2<Recorded> vec2Variable(const std::string& name)
{
    return {realVariable(name + ".x"), realVariable(name + ".y")};
}
Vec3<Recorded> vec3Variable(const std::string& name)
{
    return {realVariable(name + ".x"), realVariable(name + ".y"), realVariable(name + ".z")};
}

// Prints functions; knows the prefix and what stands before each float and int. GLSL ES may have been told to
// use less than 32 bits in a fragment shader, so there every declaration says highp.
class FunctionPrinter
{
public:
    FunctionPrinter(GlslVersion version, const std::string& prefix, GlslInputs inputs)
        : prefix_(prefix), precision_(version == GlslVersion::es300 ? "highp " : ""), inputs_(inputs)
    {
    }

    std::string function(const std::string& type, const std::string& name, const std::string& parameters,
                         const std::string& body) const
    {
        const std::string returned = type == "bool" ? type : precision_ + type;
        return returned + " " + prefix_ + name + "(" + parameters + ")\n{\n" + body + "}\n";
    }

    std::string parameter(const std::string& type, const std::string& name) const
    {
        return precision_ + type + " " + name;
    }

    // The statements that compute the roots, and their return: "return vec2(a, b);" for the constructor vec2.
    std::string returned(const std::string& constructor, std::initializer_list<GlslTree> roots) const
    {
        const GlslBody body = printedGlsl(std::span(roots.begin(), roots.size()), prefix_, precision_);
        const std::string start = "    return " + (constructor.empty() ? "" : constructor + "(");
        std::size_t width = start.size();
        for (const std::string& result : body.results)
            width += result.size() + 2;
        const std::string separator = width <= longestLine ? ", " : ",\n" + std::string(start.size(), ' ');
        std::string statement = start;
        for (const std::string& result : body.results)
            statement += (statement == start ? "" : separator) + result;
        return body.declarations + statement + (constructor.empty() ? ";\n" : ");\n");
    }

    std::string regularLine(const std::string& type, const std::string& helper, const std::string& name,
                            const std::string& from) const
    {
        return "    " + precision_ + type + " " + name + " = " + prefix_ + helper + "(" + from + ");\n";
    }

    // The argument made regular, where it may be anything.
    std::string regularised(const std::string& type, const std::string& helper, const std::string& name,
                            const std::string& from) const
    {
        if (inputs_ == GlslInputs::any)
            return regularLine(type, helper, name, from);
        return "    " + precision_ + type + " " + name + " = " + from + ";\n";
    }

    const std::string& prefix() const { return prefix_; }

private:
    std::string prefix_;
    std::string precision_;
    GlslInputs inputs_;
};

// ---- What the maps call, each before those that it is called by ------------------------------------

std::string regularSquareFunction(const FunctionPrinter& print)
{
    const Vec2<Recorded> uv = regularSquare(vec2Variable("uv"));
    return print.function("vec2", "regularSquare", print.parameter("vec2", "uv"),
                          print.returned("vec2", {uv.x.tree, uv.y.tree}));
}

std::string regularDirectionFunction(const FunctionPrinter& print, const Vec3<double>& front)
{
    const Vec3<Recorded> d = regularDirection(vec3Variable("direction"), front);
    return print.function("vec3", "regularDirection", print.parameter("vec3", "direction"),
                          print.returned("vec3", {d.x.tree, d.y.tree, d.z.tree}));
}

struct Helper
{
    std::string name;
    std::string text;
};

// Decided on bits, as in scalar.h.
std::string bitTest(const FunctionPrinter& print, const char* name, const char* comparison)
{
    return print.function("bool", name, print.parameter("float", "x"),
                          "    return (floatBitsToUint(x) & 0x7fffffffu) " + std::string(comparison) +
                              " 0x7f800000u;\n");
}

std::vector<Helper> helpers(const FunctionPrinter& print, const Vec3<double>& front)
{
    const Recorded x = realVariable("x");
    const Recorded y = realVariable("y");
    const Recorded t = realVariable("t");
    const std::string xParameter = print.parameter("float", "x");
    const auto real = [&](const char* name, const std::string& parameters, const Recorded& value) {
        return Helper{name, print.function("float", name, parameters, print.returned("", {value.tree}))};
    };
    return {
        {"isNan", bitTest(print, "isNan", ">")},
        {"isInfinite", bitTest(print, "isInfinite", "==")},
        real("signNotZero", xParameter, signNotZero<Recorded>(x)),
        real("flushed", xParameter, flushed<Recorded>(x)),
        real("infinitySign", xParameter, infinitySign<Recorded>(x)),
        {"regularDirection", regularDirectionFunction(print, front)},
        {"regularSquare", regularSquareFunction(print)},
        real("atanPi", print.parameter("float", "t"), atanPiPolynomial(t)),
        real("atan2Pi", print.parameter("float", "y") + ", " + xParameter, atan2Pi<Recorded>(y, x)),
        real("sinPiAcute", xParameter, sinPiPolynomial(x)),
        real("sinPi", xParameter, sinPi<Recorded>(x)),
        real("cosPi", xParameter, cosPi<Recorded>(x)),
    };
}

// The helpers that `text` calls, and those that they call.
std::string neededHelpers(const FunctionPrinter& print, const Vec3<double>& front, const std::string& text)
{
    const std::vector<Helper> all = helpers(print, front);
    std::string needed;
    for (auto helper = all.rbegin(); helper != all.rend(); ++helper) {
        const std::string call = print.prefix() + helper->name + "(";
        if ((needed + text).find(call) != std::string::npos)
            needed = helper->text + "\n" + needed;
    }
    return needed;
}

// ---- The map's own functions -----------------------------------------------------------------------

template <class Map>
std::string componentOfFunction(const FunctionPrinter& print)
{
    const std::string parameters = print.parameter("vec3", "direction");
    const std::string body = print.returned("", {Map::componentOf(vec3Variable("d")).tree});
    if constexpr (Map::info.components == 1)
        return print.function("int", "componentOf", parameters, body);
    return print.function("int", "componentOf", parameters,
                          print.regularised("vec3", "regularDirection", "d", "direction") + body);
}

template <class Map>
std::string squareFromDirectionFunction(const FunctionPrinter& print)
{
    const GlslIndex component(glslVariable(GlslType::index, "component"));
    const Vec2<Recorded> uv = Map::squareFromDirection(component, vec3Variable("d"));
    return print.function("vec2", "squareFromDirection",
                          print.parameter("int", "component") + ", " + print.parameter("vec3", "direction"),
                          print.regularised("vec3", "regularDirection", "d", "direction") +
                              print.returned("vec2", {uv.x.tree, uv.y.tree}));
}

template <class Map>
std::string directionFromSquareFunction(const FunctionPrinter& print)
{
    const GlslIndex component(glslVariable(GlslType::index, "component"));
    const Vec3<Recorded> d = Map::directionFromSquare(component, vec2Variable("p"));
    return print.function("vec3", "directionFromSquare",
                          print.parameter("int", "component") + ", " + print.parameter("vec2", "uv"),
                          print.regularised("vec2", "regularSquare", "p", "uv") +
                              print.returned("vec3", {d.x.tree, d.y.tree, d.z.tree}));
}

std::string coordinateFromDirectionFunction(const FunctionPrinter& print)
{
    return print.function("vec3", "coordinateFromDirection", print.parameter("vec3", "direction"),
                          print.regularLine("int", "componentOf", "component", "direction") +
                              print.regularLine("vec2", "squareFromDirection", "uv", "component, direction") +
                              "    return vec3(clamp(uv, 0.0, 1.0), float(component));\n");
}

template <class Map>
constexpr bool hasRays = requires(const GlslIndex& component, const Vec2<Recorded>& p)
{
    Map::rayFromCentre(component, p, p.x);
};

template <class Map>
std::string rayFunctions(const FunctionPrinter& print)
{
    const auto both = [&](const std::string& body, const std::string& length) {
        return print.function("vec3", "rayOfTexel",
                              print.parameter("int", "component") + ", " + print.parameter("vec2", "place") +
                                  ", " + print.parameter("vec2", "size"),
                              body) +
               "\n" +
               print.function("float", "rayLength", print.parameter("vec3", "ray"),
                              "    return " + length + ";\n");
    };
    if constexpr (hasRays<Map>) {
        const GlslIndex component(glslVariable(GlslType::index, "component"));
        const Vec3<Recorded> ray = Map::rayFromCentre(component, vec2Variable("p"), realVariable("reach"));
        return both(print.regularised("float", "", "reach", "0.5 * size.x") +
                        print.regularised("vec2", "", "p", "place - reach") +
                        print.returned("vec3", {ray.x.tree, ray.y.tree, ray.z.tree}),
                    "length(ray)");
    } else
        return both("    return " + print.prefix() + "directionFromSquare(component, place / size);\n",
                    "1.0");
}

// The chain rule through squareFromDirection, recorded instead of computed.
template <class Map>
std::string squareDerivativesFunction(const FunctionPrinter& print)
{
    const auto variable = [](const std::string& axis) {
        return BasicDual<Recorded>(realVariable("direction." + axis), realVariable("alongU." + axis),
                                   realVariable("alongV." + axis));
    };
    const GlslIndex component(glslVariable(GlslType::index, "component"));
    const Vec3<BasicDual<Recorded>> d{variable("x"), variable("y"), variable("z")};
    const Vec2<BasicDual<Recorded>> uv = Map::squareFromDirection(component, d);
    return print.function(
        "vec4", "squareDerivatives",
        print.parameter("int", "component") + ", " + print.parameter("vec3", "direction") + ", " +
            print.parameter("vec3", "alongU") + ", " + print.parameter("vec3", "alongV"),
        print.returned("vec4", {uv.x.alongU.tree, uv.y.alongU.tree, uv.x.alongV.tree, uv.y.alongV.tree}));
}

// GLSL reserves names with two underscores in a row and those that begin with gl_.
void checkPrefix(const std::string& prefix)
{
    const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
    bool valid = prefix.empty() || isLetter(prefix[0]);
    for (const char c : prefix)
        valid = valid && (isLetter(c) || std::isdigit(static_cast<unsigned char>(c)));
    valid = valid && prefix.find("__") == std::string::npos && prefix.rfind("gl_", 0) != 0;
    if (!valid)
        throw Error(ErrorKind::badArgument, "prefix of a map's GLSL functions", "'" + prefix + "'",
                    "give an identifier without two underscores in a row that does not begin with gl_");
}

} // namespace

std::string glslVersionLine(GlslVersion version)
{
    switch (version) {
    case GlslVersion::glsl330:
        return "#version 330 core\n";
    case GlslVersion::glsl400:
        return "#version 400 core\n";
    case GlslVersion::glsl450:
        return "#version 450 core\n";
    case GlslVersion::es300:
        break;
    }
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2DArray;\n";
}

std::string mapGlsl(MapKind map, GlslVersion version, const std::string& prefix, GlslInputs inputs)
{
    mapInfo(map); // throws
    requireOneOf(version, GlslVersion::es300, "a version of GLSL", "GlslVersion");
    checkPrefix(prefix);
    const FunctionPrinter print(version, prefix, inputs);
    return visitMap(map, [&](auto formula) {
        using Map = decltype(formula);
        const std::string functions =
            componentOfFunction<Map>(print) + "\n" + squareFromDirectionFunction<Map>(print) + "\n" +
            directionFromSquareFunction<Map>(print) + "\n" + coordinateFromDirectionFunction(print);
        return "// Map " + std::string(Map::info.name) + ", printed from its C++ formula.\nconst " +
               print.parameter("int", prefix + "components") + " = " + std::to_string(Map::info.components) +
               ";\n\n" + neededHelpers(print, Map::front, functions) + functions;
    });
}

std::string mapRaysGlsl(MapKind map, GlslVersion version, const std::string& prefix)
{
    mapInfo(map); // throws
    checkPrefix(prefix);
    const FunctionPrinter print(version, prefix, GlslInputs::regular);
    return visitMap(map, [&](auto formula) { return rayFunctions<decltype(formula)>(print); });
}

std::string mapDerivativesGlsl(MapKind map, GlslVersion version, const std::string& prefix)
{
    mapInfo(map); // throws
    checkPrefix(prefix);
    const FunctionPrinter print(version, prefix, GlslInputs::regular);
    return visitMap(map, [&](auto formula) { return squareDerivativesFunction<decltype(formula)>(print); });
}

} // namespace mirrorball
