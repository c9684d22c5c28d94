// Whether a triangle would lie on faces of a surface.
#pragma once

#include <array>

#include "mesh/nearest_point.h"

namespace girth::prepare {

/// The faces of a surface, to be compared with triangles.
class FaceOverlap {
 public:
  /// `scale` brings coordinates to a scale near 1.
  FaceOverlap(const SurfaceMesh& mesh, double scale);

  /// Whether a triangle of a component, its corners scaled, lies with some of its area on a face of
  /// that component, or on any other that is turned the same way: faces of two bodies that touch
  /// are turned against each other. Planes count as one where they differ by less than a millionth.
  bool covers(const std::array<Vec3, 3>& triangle, Index component) const;

 private:
  const SurfaceMesh& mesh_;
  NearestSearch search_;
};

}  // namespace girth::prepare
