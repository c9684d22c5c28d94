#include "analysis/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace girth {
namespace {

double distanceOf(const Point2& a, const Point2& b) {
  return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

}  // namespace

std::vector<Point2> convexHull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Point2> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = hull.size();
    for (const Point2& p : points) {
      while (hull.size() >= first + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // where the other half starts
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double perimeterOf(const std::vector<Point2>& polygon) {
  double length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    length += distanceOf(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return length;
}

Widths widthsOf(const std::vector<Point2>& hull) {
  const std::size_t count = hull.size();
  if (count < 2) return {};
  if (count == 2) return {0, distanceOf(hull[0], hull[1])};
  Widths widths{HUGE_VAL, 0};
  std::size_t far = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 &a = hull[i], &b = hull[(i + 1) % count];
    const double side = distanceOf(a, b);
    if (!(side > 0)) continue;
    // The corner farthest from this side, the last of those that are equally far; it goes round
    // with the sides.
    for (std::size_t steps = 0; steps < count; ++steps) {
      if (cross(a, b, hull[(far + 1) % count]) < cross(a, b, hull[far])) break;
      far = (far + 1) % count;
    }
    widths.least = std::min(widths.least, cross(a, b, hull[far]) / side);
    // The greatest width joins an end of some side to the corner that is farthest from that side.
    for (const Point2& p : {hull[far], hull[(far + count - 1) % count]}) {
      widths.greatest = std::max({widths.greatest, distanceOf(a, p), distanceOf(b, p)});
    }
  }
  return std::isfinite(widths.least) ? widths : Widths{0, widths.greatest};
}

}  // namespace girth
