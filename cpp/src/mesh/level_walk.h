// Steps from face to face between the vertices below a level and those above.
#pragma once

#include <span>

#include "girth/surface_mesh.h"

namespace girth {

/// A face with vertices on both sides of a level has one side that rises, from below to at least
/// the level, and one that falls.
class LevelWalk {
 public:
  /// `values`: for each vertex; they must outlive the walk.
  LevelWalk(const SurfaceMesh& mesh, std::span<const double> values, double level)
      : mesh_(mesh), values_(values), level_(level) {}

  /// Whether a halfedge leads from below to above.
  bool rises(Halfedge h) const { return isBelow(mesh_.from(h)) && !isBelow(mesh_.to(h)); }

  /// The side of a face that rises, or falls; none where the face lies on one side of the level.
  Halfedge sideOf(Face face, bool isRising) const {
    for (Index k = 0; k < 3; ++k) {
      const Halfedge h = SurfaceMesh::side(face, k);
      if (isBelow(mesh_.from(h)) == isRising && isBelow(mesh_.to(h)) != isRising) return h;
    }
    return Halfedge::none;
  }

 private:
  bool isBelow(Vertex v) const { return values_[v] < level_; }

  const SurfaceMesh& mesh_;
  std::span<const double> values_;
  double level_;
};

}  // namespace girth
