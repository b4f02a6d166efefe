// The equirectangular map, the usual panorama: longitude across, latitude down, north first, -z in the
// middle. Texels shrink to nothing at the poles.
//
// Formula   u = 1/2 + atan2(x, -z) / 2 pi, v = 1/2 - asin(y) / pi
// Domain    every direction; u continues round the cut, v over the poles
// Seam      the cut x = 0, z > 0: u = 1 on it, and beside it where x < 0 u begins at 0
// Poles     (0, ±1, 0) have u = 1/2, exactly
// Accuracy  (u, v) within 2^-22 in float, 4e-16 in double: tests/maps/maps_test.cpp
#pragma once

#include <mirrorball/maps/direction.h>
#include <mirrorball/maps/maps.h>

namespace mirrorball {

struct Equirectangular
{
    static constexpr MapInfo info{MapKind::equirectangular, "equirectangular", 1, 2, 1};
    static constexpr Vec3<double> front{0, 0, -1};

    template <class Real>
    static Index<Real> componentOf(const Vec3<Real>&)
    {
        return Index<Real>(0);
    }

    template <class Real>
    static Vec2<Real> squareFromDirection(const Index<Real>&, const Vec3<Real>& d)
    {
        const Real longitude = named(atan2Pi(d.x, -d.z), "longitude");
        const Real latitude = named(atan2Pi(d.y, length(d.x, d.z)), "latitude");
        return {Real(0.5) * longitude + Real(0.5), Real(0.5) - latitude};
    }

    template <class Real>
    static Vec3<Real> directionFromSquare(const Index<Real>&, const Vec2<Real>& uv)
    {
        const Real longitude = named(signedFromUnit(uv.x), "longitude");
        const Real latitude = named(Real(0.5) - uv.y, "latitude");
        const Real radius = named(cosPi(latitude), "radius");
        return {radius * sinPi(longitude), sinPi(latitude), -radius * cosPi(longitude)};
    }
};

} // namespace mirrorball
