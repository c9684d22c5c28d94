#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "girth/print_check.h"
#include "mesh/vector.h"

namespace girth {

namespace {

struct Point2 {
  double x, y;
};

double cross(const Point2& o, const Point2& a, const Point2& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The corners of the convex hull, counter-clockwise (Andrew 1979).
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

/// The least width of a convex polygon: one of the two lines lies along a side.
double widthOf(const std::vector<Point2>& hull) {
  if (hull.size() < 3) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    if (!(length > 0)) continue;
    double width = 0;
    for (const Point2& p : hull) width = std::max(width, cross(a, b, p) / length);
    least = std::min(least, width);
  }
  return std::isfinite(least) ? least : 0;
}

}  // namespace

double sectionWidth(const SurfaceMesh& mesh, const GirthLoop& loop) {
  if (loop.kind != LoopKind::Loop) return 0;
  const std::vector<Vec3> points = polyline(mesh, loop);
  if (points.size() < 3) return 0;
  // Normal to the mean plane (Newell); lengths are shares of the loop's, so that nothing overflows.
  const double unit = 1 / loop.length;
  Vec3 normal{};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    normal = normal + cross(unit * (points[i] - points[0]), unit * (points[i + 1] - points[0]));
  }
  const double area = norm(normal);
  if (!(area > 0)) return 0;
  normal = (1 / area) * normal;
  // Two directions across the normal (Duff et al. 2017).
  const double sign = normal.z < 0 ? -1 : 1;
  const double a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
  const Vec3 right{1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
  const Vec3 up{b, sign + normal.y * normal.y * a, -normal.y};
  std::vector<Point2> flat;
  for (const Vec3& p : points) {
    const Vec3 d = unit * (p - points[0]);
    flat.push_back({dot(d, right), dot(d, up)});
  }
  return loop.length * widthOf(convexHull(std::move(flat)));
}

}  // namespace girth
