// Two and three numbers of one kind of scalar: what the maps compute with.
#pragma once

namespace mirrorball {

template <class Real>
struct Vec2
{
    Real x, y;
};

template <class Real>
struct Vec3
{
    Real x, y, z;
};

} // namespace mirrorball
