// Convex hulls in a plane, and what callipers and a tape show of them.
#pragma once

#include <vector>

namespace girth {

/// A point of a plane.
struct Point2 {
  double x{0}, y{0};
};

/// Twice the area of the triangle o, a, b: positive where it runs counter-clockwise.
inline double cross(const Point2& o, const Point2& a, const Point2& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The corners of the convex hull, counter-clockwise (Andrew 1979). O(n log n).
std::vector<Point2> convexHull(std::vector<Point2> points);

/// The length of a closed polygon's outline.
double perimeterOf(const std::vector<Point2>& polygon);

/// The distances of two parallel lines that hold a convex polygon between them.
struct Widths {
  double least{0}, greatest{0};
};

/// Both by turning the two lines once round (Toussaint 1983). O(n).
Widths widthsOf(const std::vector<Point2>& hull);

}  // namespace girth
