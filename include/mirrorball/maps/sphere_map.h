// The sphere map of OpenGL's GL_SPHERE_MAP: all directions as a mirroring ball shows them to a distant eye.
// Equal area, but its texels stretch without bound towards the rim of the disc, which is the one direction
// (0, 0, -1).
//
// Formula   m = 2 sqrt(x² + y² + (z + 1)²), u = x / m + 1/2, v = y / m + 1/2
// Source    OpenGL 2.1 specification, section 2.11.4, Generating Texture Coordinates
// Domain    every direction; outside the disc the square repeats its rim
// Seam      the rim: (0, 0, -1) has (1, 1/2)
// Accuracy  (u, v) within 2^-22 in float, 4e-16 in double: tests/maps/maps_test.cpp. With L = |(x, y, z)|,
//           behind the ball sqrt((L - z) / 2L) is taken along the unit vector of (x, y), for L + z has no
//           accurate digit there. A step in (u, v) at distance e from the rim turns the direction by about
//           sqrt(2 / e) steps.
#pragma once

#include <mirrorball/maps/direction.h>
#include <mirrorball/maps/maps.h>

namespace mirrorball {

struct SphereMap
{
    static constexpr MapInfo info{MapKind::sphereMap, "sphere-map", 1, 1, 1};
    static constexpr Vec3<double> front{0, 0, 1};

    template <class Real>
    static Index<Real> componentOf(const Vec3<Real>&)
    {
        return Index<Real>(0);
    }

    template <class Real>
    static Vec2<Real> squareFromDirection(const Index<Real>&, const Vec3<Real>& d)
    {
        const Real radius = named(length(d), "radius");
        const auto behind = named(d.z < Real(0), "behind");
        const Real ahead = named(max(d.z, Real(0)), "ahead");
        const Real inFront = Real(1) / sqrt(Real(2) * radius * (radius + ahead));
        const Real nearRim = sqrt((radius - d.z) / (Real(2) * radius));
        const Vec2<Real> toRim = unitVector(d.x, d.y);
        const Real factor = named(select(behind, nearRim, inFront), "factor");
        return {unitFromSigned(factor * select(behind, toRim.x, d.x)),
                unitFromSigned(factor * select(behind, toRim.y, d.y))};
    }

    template <class Real>
    static Vec3<Real> directionFromSquare(const Index<Real>&, const Vec2<Real>& uv)
    {
        const Real a = named(signedFromUnit(uv.x), "a");
        const Real b = named(signedFromUnit(uv.y), "b");
        const Real rr = named(min(a * a + b * b, Real(1)), "rr");
        const Real scale = named(Real(2) * sqrt(Real(1) - rr), "scale");
        return {a * scale, b * scale, Real(1) - Real(2) * rr};
    }

    // A direction of any length at a place `p` from the square's centre, whose sides are `reach` away; |p.x|, |p.y| <=
    // reach. At a texel's centre, in texels up to n = 4096, only z is rounded, and no digit is lost at the rim.
    template <class Real>
    static Vec3<Real> rayFromCentre(const Index<Real>&, const Vec2<Real>& p, const Real& reach)
    {
        const Real pp = named(p.x * p.x + p.y * p.y, "pp");
        const Real inside = named(reach * reach - pp, "inside");
        const auto beyond = named(inside <= Real(0), "beyond");
        const Real root = named(sqrt(select(beyond, Real(1), inside)), "root");
        return {select(beyond, Real(0), p.x), select(beyond, Real(0), p.y),
                select(beyond, Real(-1), (inside - pp) / (Real(2) * root))};
    }

private:
    // (x, y) at length 1, however short it was; (1, 0) for (0, 0).
    template <class Real>
    static Vec2<Real> unitVector(const Real& x, const Real& y)
    {
        const Real size = named(max(abs(x), abs(y)), "size");
        const auto none = named(size <= Real(0), "none");
        const Real safeSize = named(select(none, Real(1), size), "safeSize");
        const Real across = named(select(none, Real(1), x / safeSize), "across");
        const Real up = named(y / safeSize, "up");
        const Real range = named(length(across, up), "range");
        return {across / range, up / range};
    }
};

} // namespace mirrorball
