// The equi-angular cube map: the cube's faces with equal angles along u and v, so that texels differ by
// sqrt(2) in solid angle instead of 5.
//
// Formula   cube, with (4/pi) atan on each coordinate of the face
// Source    Brown, Bringing pixels front and center in VR video, 2017
// Domain    every direction; from 1/64 above a face's horizon (0.9°) on its chart is held there, near ±1.98
// Seam      as cube.h
// Accuracy  (u, v) within 2^-22 in float, 4e-16 in double: tests/maps/maps_test.cpp
#pragma once

#include <mirrorball/maps/cube.h>

namespace mirrorball {

struct EquiAngularCube
{
    static constexpr MapInfo info{MapKind::equiAngularCube, "equi-angular-cube", 6, 1, 1};
    static constexpr Vec3<double> front = Cube::front;

    template <class Real>
    static Index<Real> componentOf(const Vec3<Real>& d)
    {
        return Cube::componentOf(d);
    }

    template <class Real>
    static Vec2<Real> squareFromDirection(const Index<Real>& component, const Vec3<Real>& d)
    {
        const Vec3<Real> p = Cube::local(component, d);
        const Real divisor = named(max(p.z, Real(0x1p-6)), "divisor");
        return {Real(2) * atan2Pi(p.x, divisor) + Real(0.5), Real(2) * atan2Pi(p.y, divisor) + Real(0.5)};
    }

    // tan(A) and tan(B) at distance 1, times cos(A) cos(B).
    template <class Real>
    static Vec3<Real> directionFromSquare(const Index<Real>& component, const Vec2<Real>& uv)
    {
        const Real across = named(Real(0.5) * (uv.x - Real(0.5)), "across");
        const Real down = named(Real(0.5) * (uv.y - Real(0.5)), "down");
        const Real cosAcross = named(cosPi(across), "cosAcross");
        const Real cosDown = named(cosPi(down), "cosDown");
        const Vec3<Real> p{named(sinPi(across) * cosDown, "s"), named(sinPi(down) * cosAcross, "t"),
                           named(cosAcross * cosDown, "m")};
        const Real range = named(length(p), "range");
        return Cube::fromLocal(component, Vec3<Real>{named(p.x / range, "right"), named(p.y / range, "below"),
                                                     named(p.z / range, "ahead")});
    }
};

} // namespace mirrorball
