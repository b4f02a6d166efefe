// The cube map, with OpenGL's faces in OpenGL's order and orientation: +X -X +Y -Y +Z -Z. Great circles are
// straight within a face; texels at a corner have 1/5 the solid angle of those in the middle.
//
// Formula   on the face of the largest coordinate m: u = (s / |m| + 1) / 2, v = (t / |m| + 1) / 2, with
//           (s, t) from the table of the OpenGL specification: +X (-z, -y), -X (z, -y), +Y (x, z),
//           -Y (x, -z), +Z (x, -y), -Z (-x, -y). (-4, 3, -1) is on -X at (0.375, 0.125); a textbook that
//           takes s from y and t from z of that face has (0.875, 0.375) instead, which no OpenGL cube map
//           agrees with.
// Domain    every direction; from 1/64 above a face's horizon (0.9°) on its chart is held finite
// Seam      of equally large coordinates x goes before y before z
// Accuracy  (u, v) within 2^-22 in float, 4e-16 in double: tests/maps/maps_test.cpp
#pragma once

#include <mirrorball/maps/direction.h>
#include <mirrorball/maps/maps.h>

namespace mirrorball {

struct Cube
{
    static constexpr MapInfo info{MapKind::cube, "cube", 6, 1, 1};
    static constexpr Vec3<double> front{1, 0, 0};

    template <class Real>
    static Index<Real> componentOf(const Vec3<Real>& d)
    {
        const Real xSize = named(abs(d.x), "xSize");
        const Real ySize = named(abs(d.y), "ySize");
        const Real zSize = named(abs(d.z), "zSize");
        const auto face = [](const Real& coordinate, int positive) {
            return select(coordinate >= Real(0), Index<Real>(positive), Index<Real>(positive + 1));
        };
        const auto xLargest = named(both(xSize >= ySize, xSize >= zSize), "xLargest");
        return select(xLargest, face(d.x, 0), select(ySize >= zSize, face(d.y, 2), face(d.z, 4)));
    }

    // (s, t, distance along the face's axis).
    template <class Real>
    static Vec3<Real> local(const Index<Real>& component, const Vec3<Real>& d)
    {
        const Real side = named(sideOf<Real>(component), "side");
        const auto alongX = named(either(component == 0, component == 1), "alongX");
        const auto alongY = named(either(component == 2, component == 3), "alongY");
        return {select(alongX, -side * d.z, select(alongY, d.x, side * d.x)),
                select(alongX, -d.y, select(alongY, side * d.z, -d.y)),
                side * select(alongX, d.x, select(alongY, d.y, d.z))};
    }

    template <class Real>
    static Vec3<Real> fromLocal(const Index<Real>& component, const Vec3<Real>& p)
    {
        const Real side = named(sideOf<Real>(component), "side");
        const auto alongX = named(either(component == 0, component == 1), "alongX");
        const auto alongY = named(either(component == 2, component == 3), "alongY");
        return {select(alongX, side * p.z, select(alongY, p.x, side * p.x)),
                select(alongX, -p.y, select(alongY, side * p.z, -p.y)),
                select(alongX, -side * p.x, select(alongY, side * p.y, side * p.z))};
    }

    // The point (s, t) at distance 1 of the face's plane.
    template <class Real>
    static Vec2<Real> planeFromDirection(const Index<Real>& component, const Vec3<Real>& d)
    {
        const Vec3<Real> p = local(component, d);
        const Real divisor = named(max(p.z, Real(0x1p-6)), "divisor");
        return {p.x / divisor, p.y / divisor};
    }

    template <class Real>
    static Vec2<Real> squareFromDirection(const Index<Real>& component, const Vec3<Real>& d)
    {
        const Vec2<Real> st = planeFromDirection(component, d);
        return {unitFromSigned(st.x), unitFromSigned(st.y)};
    }

    // A direction of any length at a place `p` from the square's centre, whose sides are `reach` away; |p.x|, |p.y| <=
    // reach. At a texel's centre, in texels, float finds it without rounding.
    template <class Real>
    static Vec3<Real> rayFromCentre(const Index<Real>& component, const Vec2<Real>& p, const Real& reach)
    {
        return fromLocal(component, Vec3<Real>{p.x, p.y, reach});
    }

    template <class Real>
    static Vec3<Real> directionFromSquare(const Index<Real>& component, const Vec2<Real>& uv)
    {
        const Real s = named(signedFromUnit(uv.x), "s");
        const Real t = named(signedFromUnit(uv.y), "t");
        const Real range = named(sqrt(s * s + t * t + Real(1)), "range");
        return fromLocal(component, Vec3<Real>{named(s / range, "right"), named(t / range, "down"),
                                               named(Real(1) / range, "ahead")});
    }

private:
    // Faces 1, 3 and 5 look along a negative axis.
    template <class Real>
    static Real sideOf(const Index<Real>& component)
    {
        return select(either(either(component == 1, component == 3), component == 5), Real(-1), Real(1));
    }
};

} // namespace mirrorball
