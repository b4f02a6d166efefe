// The dual-paraboloid map: two hemispheres, each seen in a parabolic mirror. Conformal: texels stay square,
// but their size varies by two, and the corners of each square lie on the other hemisphere.
//
// Formula   component 0: (a, b) = (x, y) / (1 - z); component 1: (x, y) / (1 + z)
// Source    Heidrich and Seidel, View-independent Environment Maps, 1998
// Domain    every direction; within 2.5° of the point opposite a component's centre its chart is held finite
// Seam      the circle z = 0, which belongs to component 1
// Accuracy  (u, v) within 2^-22 in float, 4e-16 in double, inside the square: tests/maps/maps_test.cpp
#pragma once

#include <mirrorball/maps/direction.h>
#include <mirrorball/maps/maps.h>

namespace mirrorball {

struct DualParaboloid
{
    static constexpr MapInfo info{MapKind::dualParaboloid, "dual-paraboloid", 2, 1, 1};
    static constexpr Vec3<double> front{0, 0, -1};

    template <class Real>
    static Index<Real> componentOf(const Vec3<Real>& d)
    {
        return select(d.z < Real(0), Index<Real>(0), Index<Real>(1));
    }

    template <class Real>
    static Vec2<Real> squareFromDirection(const Index<Real>& component, const Vec3<Real>& d)
    {
        const Real radius = named(length(d), "radius");
        const Real ahead = select(component == 0, -d.z, d.z);
        // 2^-10 of the length is reached 2.5° from the opposite point.
        const Real divisor = named(max(radius + ahead, Real(0x1p-10) * radius), "divisor");
        return {unitFromSigned(d.x / divisor), unitFromSigned(d.y / divisor)};
    }

    // A direction of any length at a place `p` from the square's centre, whose sides are `reach` away; |p.x|, |p.y| <=
    // reach. At a texel's centre, in texels, float finds it without rounding up to n = 4096.
    template <class Real>
    static Vec3<Real> rayFromCentre(const Index<Real>& component, const Vec2<Real>& p, const Real& reach)
    {
        const Real ahead = named(reach * reach - (p.x * p.x + p.y * p.y), "ahead");
        const Real twice = named(Real(2) * reach, "twice");
        return {twice * p.x, twice * p.y, select(component == 0, -ahead, ahead)};
    }

    template <class Real>
    static Vec3<Real> directionFromSquare(const Index<Real>& component, const Vec2<Real>& uv)
    {
        const Real a = named(signedFromUnit(uv.x), "a");
        const Real b = named(signedFromUnit(uv.y), "b");
        const Real rr = named(a * a + b * b, "rr");
        const Real divisor = named(Real(1) + rr, "divisor");
        const Real ahead = named((Real(1) - rr) / divisor, "ahead");
        return {Real(2) * a / divisor, Real(2) * b / divisor, select(component == 0, -ahead, ahead)};
    }
};

} // namespace mirrorball
