// Distances between pairs of points, along the surface.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <limits>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// Two points of a surface.
struct PointPair {
  /// The first point.
  SurfacePoint start;
  /// The second point.
  SurfacePoint end;
};

/// Which distances are wanted.
struct DistancesOptions {
  /// The points: two for each distance.
  std::vector<PointPair> pairs;
  /// Whether each distance has its shortest path too.
  bool paths{false};
};

/// The distance between two points.
struct Distance {
  /// The first point.
  SurfacePoint start;
  /// The second point.
  SurfacePoint end;
  /// Length of a shortest path along the surface, in model units; infinite where the points lie in
  /// different components.
  double length{std::numeric_limits<double>::infinity()};
  /// Length of the straight line between them, in model units.
  double straight{0};
  /// The path: the edges crossed and vertices passed in order. Between neighbours it is straight
  /// inside one face or along one edge. Empty where paths were not asked for, or there is none.
  std::vector<SurfacePoint> points;
};

/// Distances between pairs of points.
struct Distances {
  /// In the order of the pairs.
  std::vector<Distance> distances;
};

/// Measures the distances between pairs of points along the surface, exact to rounding
/// (GeodesicSolver::path). On all threads, the same bits for any number of them. Errors:
/// VERTEX_OUT_OF_RANGE, INVALID_POINT; LIMIT_EXCEEDED where a path takes too many windows;
/// CANCELLED.
///
/// \code
/// const auto one = girth::SurfacePoint::atVertex(girth::Vertex{0});
/// const auto two = girth::SurfacePoint::atVertex(girth::Vertex{1});
/// const auto found = girth::findDistances(mesh, {{{one, two}}}).value();
/// std::cout << found.distances[0].length << '\n';
/// \endcode
GIRTH_EXPORT Result<Distances> findDistances(const SurfaceMesh& mesh,
                                             const DistancesOptions& options,
                                             const ExecutionContext& context = {});

}  // namespace girth
