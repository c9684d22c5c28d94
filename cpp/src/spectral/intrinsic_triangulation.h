// Triangles that are known by the lengths of their sides only.
#pragma once

#include <vector>

#include "girth/execution.h"
#include "girth/surface_mesh.h"
#include "mesh/sides.h"

namespace girth::spectral {

/// A triangulation of a surface by straight edges between its vertices. Numbered like SurfaceMesh:
/// halfedge 3 f + k is side k of face f. Two sides of a face may be the same edge, and an edge may
/// lead back to its vertex.
class IntrinsicTriangulation {
 public:
  /// The faces of a surface, made longer where they are too flat (spectrum.h). Lengths are
  /// multiplied by `unit()`, a power of two that brings the longest to between ½ and 1. O(n).
  explicit IntrinsicTriangulation(const SurfaceMesh& mesh);

  /// Flips edges until the sum of the angles opposite to each is at most π: the intrinsic Delaunay
  /// triangulation. Stops early after 100 flips an edge, which no surface is known to need; what
  /// there is then is still a triangulation of the surface. Usually O(n). False where cancelled.
  bool makeDelaunay(const ExecutionContext& context);

  double unit() const { return unit_; }
  Index halfedgeCount() const { return static_cast<Index>(from_.size()); }
  Index from(Index halfedge) const { return from_[halfedge]; }
  Index to(Index halfedge) const { return from_[nextSide(halfedge)]; }
  Index twin(Index halfedge) const { return twin_[halfedge]; }
  double length(Index halfedge) const { return length_[halfedge]; }
  /// Area of a face.
  double area(Index face) const;
  /// Cotangent of the angle opposite to a side.
  double oppositeCotangent(Index halfedge) const;

 private:
  void lengthenFlatFaces();
  bool isDelaunay(Index halfedge) const;
  /// The other diagonal of the two faces at an edge; false, and nothing done, where rounding would
  /// leave a face without area.
  bool flip(Index halfedge);

  std::vector<Index> from_, twin_;
  std::vector<double> length_;
  double unit_{1};
};

}  // namespace girth::spectral
