// Which faces have no area to speak of.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "girth/surface_mesh.h"
#include "mesh/vector.h"

namespace girth {

/// A face whose smallest height is below this share of its longest side has no area to speak of:
/// its shape would be made of rounding errors.
inline constexpr double kFlattestFace = 1e-12;

/// The size of the largest coordinate of a surface.
inline double extentOf(const SurfaceMesh& mesh) {
  double extent = 0;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return extent;
}

/// A power of two that brings coordinates of at most `extent` to a scale near 1, where products
/// neither overflow nor lose bits.
inline double scaleFor(double extent) {
  int exponent = 0;
  std::frexp(extent, &exponent);
  return std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
}

/// Sides, lengths and area of a face whose corners have been brought to a scale near 1. Side k runs
/// from corner k to the next one.
struct FaceShape {
  std::array<Vec3, 3> side;
  std::array<double, 3> length;
  double doubleArea;

  explicit FaceShape(const std::array<Vec3, 3>& corner) {
    for (std::size_t k = 0; k < 3; ++k) {
      side[k] = corner[(k + 1) % 3] - corner[k];
      length[k] = norm(side[k]);
    }
    doubleArea = norm(cross(side[0], side[1]));
  }

  double longest() const { return std::max({length[0], length[1], length[2]}); }
  double shortest() const { return std::min({length[0], length[1], length[2]}); }
  bool hasArea() const {
    return doubleArea > kFlattestFace * longest() * longest() && shortest() > 0;
  }
};

}  // namespace girth
