// The tennis-ball map: two congruent rectangles, 90° by 270°, laid round the sphere like a tennis ball's
// halves. Latitude and longitude in each, kept within 45° of its equator: area varies by sqrt(2), angles by
// sqrt(2), and of the classical maps none has a smaller worst texel (docs/maps.md).
//
// Formula   component 0: a = asin(y) / (pi/4), b = atan2(x, z) / (3 pi/4);
//           component 1: the same of (y, x, -z)
// Domain    every direction; the chart reaches a = ±2 at its poles and b = ±4/3 at its cut
// Seam      z = 0 where |y| <= sqrt(1/2) or |x| >= sqrt(1/2), |y| = sqrt(1/2) and |x| = sqrt(1/2) elsewhere;
//           the rectangles overlap by 6 %, texels past the seam belong to nobody
// Poles     a component's own poles lie in the other component; there b is 0
// Accuracy  (u, v) within 2^-22 in float, 4e-16 in double, inside the square: tests/maps/maps_test.cpp
#pragma once

#include <mirrorball/maps/direction.h>
#include <mirrorball/maps/maps.h>

namespace mirrorball {

struct TennisBall
{
    static constexpr MapInfo info{MapKind::tennisBall, "tennis-ball", 2, 1, 3};
    static constexpr Vec3<double> front{0, 0, 1};

    // |y| <= sqrt(1/2) of the length without a root: y² <= x² + z².
    template <class Real>
    static Index<Real> componentOf(const Vec3<Real>& d)
    {
        const Real xx = named(d.x * d.x, "xx");
        const Real yy = named(d.y * d.y, "yy");
        const Real zz = named(d.z * d.z, "zz");
        const auto inFront = both(d.z >= Real(0), yy <= xx + zz);
        const auto behind = both(d.z <= Real(0), xx >= yy + zz);
        return select(either(inFront, behind), Index<Real>(0), Index<Real>(1));
    }

    // The rotation that takes a component to component 0. It is its own inverse.
    template <class Real>
    static Vec3<Real> local(const Index<Real>& component, const Vec3<Real>& d)
    {
        const auto first = named(component == 0, "first");
        return {named(select(first, d.x, d.y), "x"), named(select(first, d.y, d.x), "y"),
                named(select(first, d.z, -d.z), "z")};
    }

    template <class Real>
    static Vec2<Real> squareFromDirection(const Index<Real>& component, const Vec3<Real>& d)
    {
        const Vec3<Real> p = local(component, d);
        const Real latitude = named(atan2Pi(p.y, length(p.x, p.z)), "latitude");
        const Real longitude = named(atan2Pi(p.x, p.z), "longitude");
        return {Real(2) * latitude + Real(0.5), Real(2.0 / 3.0) * longitude + Real(0.5)};
    }

    template <class Real>
    static Vec3<Real> directionFromSquare(const Index<Real>& component, const Vec2<Real>& uv)
    {
        const Real latitude = named(Real(0.5) * (uv.x - Real(0.5)), "latitude");
        const Real longitude = named(Real(1.5) * (uv.y - Real(0.5)), "longitude");
        const Real radius = named(cosPi(latitude), "radius");
        return local(component,
                     Vec3<Real>{named(radius * sinPi(longitude), "right"), named(sinPi(latitude), "up"),
                                named(radius * cosPi(longitude), "ahead")});
    }
};

} // namespace mirrorball
