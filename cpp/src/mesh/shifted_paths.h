// How long a path of a surface without its flat vertices is on the surface with them.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "mesh/flat_vertices.h"
#include "mesh/vector.h"

namespace girth {

/// Rounding puts a flat vertex a little beside its place on the lean surface. Along a straight
/// piece of a path such shifts cancel out, up to their squares; where the path crosses a crease,
/// they do not. So a geodesic keeps its length but for what the shifts of the points at edges make
/// of it. Refers to both surfaces.
class ShiftedPaths {
 public:
  /// O(n log n).
  ShiftedPaths(const SurfaceMesh& surface, const LeanSurface& lean);

  /// Whether no vertex is off by so much that it matters: 1e-12 of its edge.
  bool isEmpty() const { return shifts_.empty(); }
  /// How much longer a loop of the lean surface is on the surface, based at one of its vertices.
  /// `points`: of the lean surface, from the base back to it. O(points log n).
  double excess(Vertex base, std::span<const SurfacePoint> points) const;

 private:
  /// A vertex on an edge of the lean surface.
  struct Shift {
    Index edge;  ///< the smaller of its halfedges
    double t;    ///< the vertex's share of that
    Vec3 by;
  };

  /// The edge of a point on one, and its share of that.
  std::pair<Index, double> onEdge(const SurfacePoint& point) const;
  Vec3 shiftAt(const SurfacePoint& point) const;

  const SurfaceMesh& surface_;
  const SurfaceMesh& lean_;
  std::vector<Shift> shifts_;  // by edge and share
};

}  // namespace girth
