// Curves drawn tight: the geodesic that a curve on a surface is moved to while it only gets
// shorter.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// The shape of a curve that is drawn tight.
enum class TightKind : std::uint8_t {
  Path,   ///< it joins two ends, which stay
  Loop,   ///< it is closed
  Point,  ///< it contracts to a point: it bounds a disk that it slips off
};
/// "path", "loop" or "point".
GIRTH_EXPORT std::string_view toString(TightKind kind);

/// The curves than which none is shorter (web/docs/definitions.md, section 5).
enum class TightPromise : std::uint8_t {
  Shortest,  ///< all curves of the homotopy class, with the same ends
  Local,     ///< all curves that it can be moved to without passing over a convex vertex
  Shorter,   ///< unknown: it was given up after too many steps, and is only no longer
};
/// "shortest", "local" or "shorter".
GIRTH_EXPORT std::string_view toString(TightPromise promise);

/// Which curve is drawn tight.
struct TightenOptions {
  /// The curve, point by point. Neighbours that lie in one face are joined straight, others by a
  /// shortest path.
  std::vector<SurfacePoint> points;
  /// Whether it goes on from the last point to the first, and no point stays. Otherwise both ends
  /// stay, also where they are one point.
  bool closed{false};
  /// Whether all its points stay: each piece between two is drawn tight by itself.
  bool fixed{false};
};

/// A piece of a curve between two points that stay; of a closed curve without any, all of it.
struct TightPiece {
  /// The length before, in model units.
  double lengthBefore{0};
  /// The length when it is tight, in model units.
  double length{0};
  /// The curves that it is shorter than.
  TightPromise promise{TightPromise::Shorter};
  /// Where it begins.
  SurfacePoint start;
  /// Where it ends.
  SurfacePoint end;
};

/// A curve drawn tight.
struct TightCurve {
  /// Whether it is open or closed, or only a point.
  TightKind kind{TightKind::Point};
  /// The weakest promise of its pieces.
  TightPromise promise{TightPromise::Shorter};
  /// The component that it lies on.
  Index component{kNoIndex};
  /// The length of the curve through the points that were given, in model units.
  double lengthBefore{0};
  /// The length of the tight one, in model units.
  double length{0};
  /// Its pieces, in order: one, but where all points stay.
  std::vector<TightPiece> pieces;
  /// The edges that it crosses and the vertices that it passes, in order; straight between
  /// neighbours. The last point of a closed curve equals the first. Empty where it is a point.
  std::vector<SurfacePoint> points;
};

/// Draws a curve tight: it is moved over the surface and only gets shorter, until it is straight in
/// all faces and across all edges, and has at least π on both sides of each vertex that it passes,
/// on the inner side alone at a boundary (Xin, He and Fu 2012).
///
/// It stays in its homotopy class. No curve of the class is shorter where the component has no
/// convex vertex but at its boundary, where an open curve is as long as the distance of its ends,
/// or where it contracts; elsewhere none is that it can be moved to without passing over a convex
/// vertex. A closed curve with equally long ones beside it stays among them. Lengths are exact to
/// rounding; an angle that lacks 1e-8 of π counts as straight, and a point with a share below 1e-10
/// lies on the edge or at the vertex beside it.
///
/// Time: linear in the curve for each vertex that it is moved over, and a shortest path between
/// ends. Errors: INVALID_OPTION (no points); VERTEX_OUT_OF_RANGE; INVALID_POINT (also of a curve
/// over several components); LIMIT_EXCEEDED where a shortest path takes too many windows;
/// CANCELLED.
///
/// \code
/// girth::TightenOptions options;
/// options.points = {girth::SurfacePoint::atVertex(girth::Vertex{0}),
///                   girth::SurfacePoint::atVertex(girth::Vertex{1}),
///                   girth::SurfacePoint::atVertex(girth::Vertex{2})};
/// const auto tight = girth::tighten(mesh, options).value();
/// std::cout << tight.lengthBefore << " to " << tight.length << '\n';
/// \endcode
GIRTH_EXPORT Result<TightCurve> tighten(const SurfaceMesh& mesh, const TightenOptions& options,
                                        const ExecutionContext& context = {});

}  // namespace girth
