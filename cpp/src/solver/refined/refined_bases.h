// Where the loops of a large surface are based: all its vertices, as points of the surface on which
// loops are looked for.
#pragma once

#include <vector>

#include "geodesic/unfolding.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "mesh/flat_vertices.h"

namespace girth {

/// The vertices of a surface, with other numbers: first those that are vertices of the ground, on
/// which loops are looked for, in the numbers of its unfolding; then the others, which lie in its
/// faces or on its edges, by these.
struct RefinedBases {
  /// How many are vertices of the ground.
  Index onGround{0};
  /// The vertex of the surface at each.
  std::vector<Index> vertices;
  /// Their points of the ground, in the numbers of its mesh.
  std::vector<SurfacePoint> places;

  /// The base of each vertex of the surface.
  std::vector<Index> ofVertices() const;
};

/// The bases where all vertices are vertices of the ground, or all but the flat ones (`lean`; null:
/// there are none). `ground`: the unfolding of the lean surface, or of the surface itself.
RefinedBases basesOn(const geodesic::Unfolding& ground, const LeanSurface* lean);

}  // namespace girth
