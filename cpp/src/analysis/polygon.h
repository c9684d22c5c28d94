// Closed polygons in the plane.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/convex_hull.h"

namespace girth {

/// Whether a point lies inside a closed polygon: how many sides cross the ray to the right.
inline bool isInside(const Point2& p, const std::vector<Point2>& polygon) {
  bool isIn = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point2 &a = polygon[j], &b = polygon[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isIn = !isIn;
  }
  return isIn;
}

}  // namespace girth
