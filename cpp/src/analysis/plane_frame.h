// Two directions across a normal.
#pragma once

#include "analysis/convex_hull.h"
#include "mesh/vector.h"

namespace girth {

/// The frame right, up, normal, counter-clockwise seen from the normal's tip (Duff et al. 2017).
struct PlaneFrame {
  /// `normal`: of length 1.
  explicit PlaneFrame(const Vec3& normal) {
    const double sign = normal.z < 0 ? -1 : 1;
    const double a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
    right = {1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
    up = {b, sign + normal.y * normal.y * a, -normal.y};
  }

  Point2 flat(const Vec3& p) const { return {dot(p, right), dot(p, up)}; }
  Vec3 inSpace(const Point2& p) const { return p.x * right + p.y * up; }

  Vec3 right, up;
};

}  // namespace girth
