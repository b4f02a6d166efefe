// Where exact capture puts the host's varyings between geometry and fragment stage: scalar after scalar into registers
// of four, so that they take as much room as is counted for them. Left to themselves drivers may give a vec3 or an
// array's element a whole register.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mirrorball::capture {

struct Varying;

struct TypeShape
{
    int columns, rows; // 1 × 1: a scalar; 1 × n: a vector
    bool isInteger;

    int scalars() const { return columns * rows; }
};

// Of float, int, uint, their vectors and matrices; of other types, which capture does not carry, nothing.
std::optional<TypeShape> shapeOf(const std::string& type);

bool isFlat(const Varying& varying);

class Packing
{
public:
    explicit Packing(std::span<const Varying> varyings);

    int scalars() const; // of whole registers, a vertex

    std::string declarations(const std::string& direction) const; // "in" or "out"
    // Statements that put an element of a varying's value at a corner away, read by components of `source`.
    std::string write(std::size_t varying, int corner, int element, const std::string& source) const;
    // An expression of the varying's type.
    std::string read(std::size_t varying, int corner, int element) const;

private:
    struct Place
    {
        std::string name, type;
        TypeShape shape;
        int corners, elements;
        int first; // scalar, among the floats or the integers; -1: not yet known

        int scalars() const { return corners * elements * shape.scalars(); }
    };

    std::string at(const Place& place, int corner, int element, int scalar) const;

    std::vector<Place> places_;
    int floats_ = 0, integers_ = 0;
};

} // namespace mirrorball::capture
