// One surface in fewer triangles: without the vertices at which it is flat.
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// A surface without its flat vertices.
struct LeanSurface {
  /// Each of its vertices is one of the original surface, in the same order.
  SurfaceMesh mesh;
  /// Where the vertices of the original surface lie on it: those of a crease on its edge.
  std::vector<SurfacePoint> places;
};

/// How far coordinates may be off, as shares of the largest: midpoints of midpoints in double
/// precision, and coordinates that a file has in single precision.
inline constexpr double kRoundedDoubles = 4e-15;
inline constexpr double kRoundedSingles = 6e-8;

/// Edges are collapsed where all faces round a vertex stay in their planes: inside a plane, along a
/// straight crease, along a straight boundary. `rounding`: by which share of the largest coordinate
/// all coordinates may be off; a face may turn from the plane of the original one as far as that
/// turns it, and vertices that go stay within twice that distance of the surface. Lengths of
/// paths change by no more than about that distance. Faces that would become needles are left as
/// they are. Components, genus and boundaries stay as they are, and so does a surface with
/// coordinates beyond 1e60, or all below 1e-60. Equal inputs always give equal triangles. O(n) for
/// the usual mesh, some 10 µs a vertex that goes.
///
/// Errors: CANCELLED.
Result<LeanSurface> withoutFlatVertices(const SurfaceMesh& mesh, double rounding,
                                        const ExecutionContext& context);

}  // namespace girth
