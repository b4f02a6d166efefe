// The octahedral map: one square, the upper half of an octahedron in the middle and the lower half folded out
// over its diagonals. Great circles are straight within an octant.
//
// Formula   (a, b) = (x, y) / (|x| + |y| + |z|), folded where z < 0:
//           a' = (1 - |b|) sign a, b' = (1 - |a|) sign b
// Source    Cigolle et al., A Survey of Efficient Representations for Independent Unit Vectors,
//           JCGT 3(2), 2014
// Domain    every direction
// Seam      the border: (u, v) and the point mirrored in the middle of its side are the same direction, and
//           so the square continues beyond it; (0, 0, -1) is all four corners, of which squareFromDirection
//           gives (1, 1)
// Accuracy  (u, v) within 2^-22 in float, 4e-16 in double: tests/maps/maps_test.cpp
#pragma once

#include <mirrorball/maps/direction.h>
#include <mirrorball/maps/maps.h>

namespace mirrorball {

struct Octahedral
{
    static constexpr MapInfo info{MapKind::octahedral, "octahedral", 1, 1, 1};
    static constexpr Vec3<double> front{0, 0, 1};

    template <class Real>
    static Index<Real> componentOf(const Vec3<Real>&)
    {
        return Index<Real>(0);
    }

    template <class Real>
    static Vec2<Real> squareFromDirection(const Index<Real>&, const Vec3<Real>& d)
    {
        const Real sum = named(abs(d.x) + abs(d.y) + abs(d.z), "sum");
        const Real a = named(d.x / sum, "a");
        const Real b = named(d.y / sum, "b");
        const auto below = named(d.z < Real(0), "below");
        return {unitFromSigned(select(below, (Real(1) - abs(b)) * signNotZero(d.x), a)),
                unitFromSigned(select(below, (Real(1) - abs(a)) * signNotZero(d.y), b))};
    }

    // A direction of any length at a place `p` from the square's centre, whose sides are `reach` away; |p.x|, |p.y| <=
    // reach. At a texel's centre, in texels, float finds it without rounding.
    template <class Real>
    static Vec3<Real> rayFromCentre(const Index<Real>&, const Vec2<Real>& p, const Real& reach)
    {
        const Real z = named(reach - abs(p.x) - abs(p.y), "z");
        const auto below = named(z < Real(0), "below");
        return {select(below, (reach - abs(p.y)) * signNotZero(p.x), p.x),
                select(below, (reach - abs(p.x)) * signNotZero(p.y), p.y), z};
    }

    template <class Real>
    static Vec3<Real> directionFromSquare(const Index<Real>& component, const Vec2<Real>& uv)
    {
        // Past a side: mirrored in it, and in the side's middle.
        const Real a0 = named(signedFromUnit(uv.x), "a0");
        const Real b0 = named(signedFromUnit(uv.y), "b0");
        const auto pastA = named(abs(a0) > Real(1), "pastA");
        const auto pastB = named(abs(b0) > Real(1), "pastB");
        const Real a1 = named(select(pastA, Real(2) * signNotZero(a0) - a0, a0), "a1");
        const Real b1 = named(select(pastB, Real(2) * signNotZero(b0) - b0, b0), "b1");
        const Real a = named(select(pastB, -a1, a1), "a");
        const Real b = named(select(pastA, -b1, b1), "b");

        const Vec3<Real> ray = rayFromCentre(component, Vec2<Real>{a, b}, Real(1));
        const Real x = named(ray.x, "x");
        const Real y = named(ray.y, "y");
        const Real size = named(length(Vec3<Real>{x, y, ray.z}), "size");
        return {x / size, y / size, ray.z / size};
    }
};

} // namespace mirrorball
