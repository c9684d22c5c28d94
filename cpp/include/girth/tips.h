// Tips: where a shape ends, cut off by the lines along which the girth jumps.
#pragma once

#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// A line across edges of the surface: a point in the middle of each, in order.
struct ContourLine {
  /// The middles of the edges that it crosses.
  std::vector<SurfacePoint> points;
  /// Whether it comes back to its first point, which is not repeated. Otherwise it ends at the
  /// boundary, or, an arc, inside faces.
  bool closed{false};
};

/// A region that the discontinuity contour cuts off.
struct Tip {
  /// Its vertices, in rising order.
  std::vector<Vertex> vertices;
  /// The line that cuts it off: usually one closed line.
  std::vector<ContourLine> contour;
  /// Area inside the contour, in squared model units.
  double area{0};
  /// Length of the contour, in model units.
  double boundaryLength{0};
  /// The vertex of the region that is farthest from the contour, along the surface.
  Vertex apex;
  /// How far, in model units.
  double apexDistance{0};
  /// How far the girth rises from outside to inside, in model units: the median over the edges that
  /// the contour crosses. Tips that noise makes rise little.
  double jump{0};
};

/// A part of the discontinuity contour that is no tip's: it ends somewhere, or where it meets the
/// contour of a tip, which it follows closely.
struct OpenArc {
  ContourLine line;  ///< where it runs; never closed
  double length{0};  ///< its length, in model units
  double jump{0};    ///< how far the girth rises across it, in model units: as of a tip
};

/// The tips of a surface, and what else the girth jumps along.
struct Tips {
  /// Largest jump first.
  std::vector<Tip> tips;
  /// Longest first.
  std::vector<OpenArc> arcs;
  /// Edges that the contour crosses.
  Index crossedEdges{0};
};

/// The tips of a surface by the criterion of the paper (section 6.2; web/docs/definitions.md,
/// section 5), which has no parameter: the discontinuity contour crosses every edge ab with |I(a) −
/// I(b)| > 2 |ab|, since across any other edge the girth cannot change so fast.
///
/// Without these edges the vertices fall apart into pieces. Where two pieces meet, the one with the
/// larger girth is a tip, together with everything that only it connects to the other (pieces
/// between the two go with the one whose girth is nearer to theirs), if the girth rises into this
/// region at the middle one of its rim's edges. Regions that have more than half of their rims in
/// common are one tip, the one with the larger jump: they differ by a small piece on the contour.
/// All other edges of the contour form arcs, which are kept apart and never closed.
///
/// `girth`: I(v) for each vertex; where it is NaN (not computed), no edge is crossed. Time
/// O(n log n) and a propagation of distances for each tip, unless the pieces are many. Errors:
/// USAGE where the values are not as many as the vertices; CANCELLED.
///
/// \code
/// const girth::GirthField field = girth::girthField(mesh);
/// for (const girth::Tip& tip : girth::findTips(mesh, field.values).value().tips) {
///   std::cout << tip.apexDistance << '\n';
/// }
/// \endcode
GIRTH_EXPORT Result<Tips> findTips(const SurfaceMesh& mesh, std::span<const double> girth,
                                   const ExecutionContext& context = {});

}  // namespace girth
