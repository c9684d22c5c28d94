// How far each vertex is from some points, along the surface.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <limits>
#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "girth/vertex_function.h"

namespace girth {

/// The points that distances are measured from, and how far.
struct DistanceFieldOptions {
  /// Where distances are measured from: each is that from the nearest of these points.
  std::vector<SurfacePoint> from;
  /// Vertices farther away than this, in model units, have an infinite distance.
  double radius{std::numeric_limits<double>::infinity()};
};

/// The distance of each vertex from the nearest of some points, in model units, exact to rounding
/// (girth/geodesic_solver.h). Infinite beyond the radius, and in components that have none of the
/// points; NaN where it would take more windows than the solver's budget. Without points they are
/// distances from the first vertex. All distances are found with the first one that is asked for,
/// on one thread, in about O(n^1.5) for the usual mesh of n faces. Errors: VERTEX_OUT_OF_RANGE,
/// INVALID_POINT, INVALID_RADIUS (negative, or not a number).
GIRTH_EXPORT Result<VertexFunction<double>> distanceFunction(
    const SurfaceMesh& mesh, const DistanceFieldOptions& options = {});
/// The mesh must outlive the function: keep it in a variable.
Result<VertexFunction<double>> distanceFunction(const SurfaceMesh&&,
                                                const DistanceFieldOptions& options = {}) = delete;

}  // namespace girth
