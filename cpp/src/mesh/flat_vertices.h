// The same surface in fewer triangles: without the vertices at which it is flat.
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
  /// Where the vertices of the original surface lie on it.
  std::vector<SurfacePoint> places;
};

/// Faces and boundaries that are rounded to doubles turn by no more than this.
inline constexpr double kTurnOfDoubles = 1e-9;
/// The same for a plane that was divided finely and rounded to single precision, or to six digits:
/// lengths of paths then differ by about 1e-7 of themselves.
inline constexpr double kTurnOfSingles = 5e-4;

/// Edges are collapsed where all faces round a vertex stay in their planes: inside a plane, along a
/// straight crease, along a straight boundary. `turn`: how far a face may turn from the plane of
/// the original one, and a boundary from its direction; the sine of the angle, in (0, 0.1). Faces
/// that would become needles are left as they are. Components, genus and boundaries stay as they
/// are, and so does a surface with coordinates beyond 1e60, or all below 1e-60. The same input
/// always gives the same triangles. O(n) for the usual mesh, some 10 µs a vertex that goes.
///
/// Errors: CANCELLED.
Result<LeanSurface> withoutFlatVertices(const SurfaceMesh& mesh, double turn, const ExecutionContext& context);

}  // namespace girth
