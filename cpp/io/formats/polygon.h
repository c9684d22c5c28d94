// Polygons of a file to triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::io {

/// Cuts polygons into triangles along diagonals, with the corners' order kept.
class PolygonCutter {
 public:
  /// Appends the triangles of the polygon with these corners (at least three, each below the number
  /// of positions) to `triangles`: corners - 2 of them, by their places among the corners. Convex
  /// and concave polygons are cut properly as seen along their mean normal; one that crosses itself
  /// is cut somehow. A quadrilateral is cut along its shorter diagonal where both are inside.
  ///
  /// False where cutting has taken more work in all than any reasonable file asks for.
  bool cut(std::span<const double> positions, std::span<const Index> corners,
           std::vector<Index>& triangles);

 private:
  void project(std::span<const double> positions, std::span<const Index> corners);
  double turn(std::size_t a, std::size_t b, std::size_t c) const;
  bool inTriangle(std::size_t point, std::size_t a, std::size_t b, std::size_t c) const;

  struct Point {
    double u, v;
  };
  std::vector<Point> flat_;
  std::vector<std::size_t> left_;
  std::uint64_t work_{0};
};

}  // namespace girth::io
