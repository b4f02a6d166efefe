// From a MapKind to the map's formula: the one place that lists them.
#pragma once

#include <mirrorball/maps/cube.h>
#include <mirrorball/maps/dual_paraboloid.h>
#include <mirrorball/maps/equi_angular_cube.h>
#include <mirrorball/maps/equirectangular.h>
#include <mirrorball/maps/octahedral.h>
#include <mirrorball/maps/sphere_map.h>
#include <mirrorball/maps/tennis_ball.h>
#include <mirrorball/maps/tennis_ball_even.h>

#include <cassert>
#include <utility>

namespace mirrorball {

// visitor(Map{}), where Map is the formula of that kind.
template <class Visitor>
decltype(auto) visitMap(MapKind map, Visitor&& visitor)
{
    switch (map) {
    case MapKind::tennisBall:
        return visitor(TennisBall{});
    case MapKind::tennisBallEven:
        return visitor(TennisBallEven{});
    case MapKind::dualParaboloid:
        return visitor(DualParaboloid{});
    case MapKind::cube:
        return visitor(Cube{});
    case MapKind::equiAngularCube:
        return visitor(EquiAngularCube{});
    case MapKind::octahedral:
        return visitor(Octahedral{});
    case MapKind::equirectangular:
        return visitor(Equirectangular{});
    case MapKind::sphereMap:
        break;
    }
    assert(map == MapKind::sphereMap);
    return visitor(SphereMap{});
}

} // namespace mirrorball
