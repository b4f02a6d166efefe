#include "capture/packing.h"

#include "capture/varyings.h"

#include <algorithm>
#include <map>

namespace mirrorball::capture {

namespace {

int registersOf(int scalars)
{
    return (scalars + 3) / 4;
}

std::map<std::string, TypeShape> knownShapes()
{
    std::map<std::string, TypeShape> all = {
        {"float", {1, 1, false}}, {"int", {1, 1, true}}, {"uint", {1, 1, true}}};
    for (int size = 2; size <= 4; ++size) {
        const std::string suffix = std::to_string(size);
        all["vec" + suffix] = {1, size, false};
        all["ivec" + suffix] = all["uvec" + suffix] = {1, size, true};
        all["mat" + suffix] = {size, size, false};
        for (int rows = 2; rows <= 4; ++rows)
            all["mat" + suffix + "x" + std::to_string(rows)] = {size, rows, false};
    }
    return all;
}

// What picks one scalar of a value.
std::string component(const TypeShape& shape, int scalar)
{
    if (shape.scalars() == 1)
        return "";
    const std::string row(1, "xyzw"[scalar % shape.rows]);
    return (shape.columns > 1 ? "[" + std::to_string(scalar / shape.rows) + "]" : "") + "." + row;
}

} // namespace

std::optional<TypeShape> shapeOf(const std::string& type)
{
    static const std::map<std::string, TypeShape> known = knownShapes();
    const auto found = known.find(type);
    return found == known.end() ? std::nullopt : std::optional(found->second);
}

bool isFlat(const Varying& varying)
{
    return varying.interpolation == "flat";
}

Packing::Packing(std::span<const Varying> varyings)
{
    for (const Varying& varying : varyings)
        places_.push_back({varying.name, varying.type, shapeOf(varying.type).value_or(TypeShape{1, 4, false}),
                           isFlat(varying) ? 1 : 3, std::max(varying.elements, 1), -1});
    // Branches of an #if may declare one name twice: they have the same place, with room for the largest.
    for (const Place& place : places_) {
        if (place.first >= 0)
            continue;
        int& used = place.shape.isInteger ? integers_ : floats_;
        const int first = used;
        for (Place& other : places_)
            if (other.name == place.name && other.shape.isInteger == place.shape.isInteger) {
                other.first = first;
                used = std::max(used, first + other.scalars());
            }
    }
}

int Packing::scalars() const
{
    return 4 * (registersOf(floats_) + registersOf(integers_));
}

std::string Packing::declarations(const std::string& direction) const
{
    const auto array = [&](const char* type, const char* name, int scalars) {
        return scalars == 0 ? ""
                            : "flat " + direction + " " + type + " " + prefix + name + "[" +
                                  std::to_string(registersOf(scalars)) + "];\n";
    };
    return array("vec4", "packed", floats_) + array("ivec4", "packedNumbers", integers_);
}

std::string Packing::at(const Place& place, int corner, int element, int scalar) const
{
    const int slot = place.corners == 1 ? 0 : corner; // a flat one has the provoking vertex's value
    const int index = place.first + (slot * place.elements + element) * place.shape.scalars() + scalar;
    return prefix + (place.shape.isInteger ? "packedNumbers[" : "packed[") + std::to_string(index / 4) +
           "]." + "xyzw"[index % 4];
}

std::string Packing::write(std::size_t varying, int corner, int element, const std::string& source) const
{
    const Place& place = places_[varying];
    std::string lines;
    for (int scalar = 0; scalar < place.shape.scalars(); ++scalar) {
        const std::string value = source + component(place.shape, scalar);
        lines += at(place, corner, element, scalar) + " = " +
                 (place.shape.isInteger ? "int(" + value + ")" : value) + ";\n";
    }
    return lines;
}

std::string Packing::read(std::size_t varying, int corner, int element) const
{
    const Place& place = places_[varying];
    std::string list;
    for (int scalar = 0; scalar < place.shape.scalars(); ++scalar)
        list += (scalar > 0 ? ", " : "") + at(place, corner, element, scalar);
    return place.type == "float" ? list : place.type + "(" + list + ")";
}

} // namespace mirrorball::capture
