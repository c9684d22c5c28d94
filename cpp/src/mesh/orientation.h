// Which side of a plane a point is on, without an error of rounding.
#pragma once

#include "girth/surface_mesh.h"

namespace girth {

/// 1 where `d` lies in front of the plane through a, b and c (from there they run clockwise), -1
/// where it lies behind it, 0 where it lies on it: the sign of det(a - d, b - d, c - d), exact as
/// long as no product of three coordinates overflows or underflows (Shewchuk 1997: rounded first,
/// and as a sum without rounding only where that decides nothing).
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace girth
