// The girth along a path: a shortest one, or one that was drawn.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// The girth at one place of a path.
struct PathStation {
  double distance{0};             ///< along the path from its first point, in model units
  double girth{0};                ///< there, in model units
  LoopKind kind{LoopKind::Loop};  ///< how it came about
  SurfacePoint point;             ///< where: GirthSolver::loop gives the loop
};

/// Where along a path the girth is wanted.
struct PathProfileOptions {
  /// At so many equal distances, both ends among them; 0: none, otherwise at least 2.
  std::size_t samples{100};
  /// At every point of the path as well: a shortest path has one wherever it crosses an edge.
  bool crossings{true};
};

/// The shortest paths from each point to the next, as one path: the points where one piece ends and
/// the next begins are there twice. Time: GeodesicSolver::path for each piece; of the context, only
/// `cancel` matters. Errors: USAGE for fewer than two points; INVALID_POINT (element: the place of
/// the second one among the points) where two neighbours lie in different components; those of
/// GeodesicSolver::path.
GIRTH_EXPORT Result<std::vector<SurfacePoint>> shortestPathThrough(
    const SurfaceMesh& mesh, std::span<const SurfacePoint> points,
    const ExecutionContext& context = {});

/// The girth along a path, in the order of the distances. Every value is the exact girth at its
/// point, also inside faces; nothing is interpolated. Places nearer to each other than a share of
/// 1e-9 of the path are one.
///
/// `path`: points in order, each two neighbours in one face, between which it runs straight, as
/// GeodesicPath::points or a SurfaceCurve. Time: a girth for each place, on all threads. Any number
/// of threads gives the same result. Errors: INVALID_POINT (element: the point's place in the path)
/// where a point is none of the surface or two neighbours lie in no common face, and where there is
/// no point at all; INVALID_OPTION (one sample, or more than 10 million; neither samples nor
/// crossings); CANCELLED.
GIRTH_EXPORT Result<std::vector<PathStation>> girthAlong(const SurfaceMesh& mesh,
                                                         std::span<const SurfacePoint> path,
                                                         const PathProfileOptions& options = {},
                                                         const ExecutionContext& context = {});

/// The narrowest place of a path near its narrowest stations: where the girth is least between
/// their neighbours, to 1e-9 of it. It is not proven that nothing narrower lies between two other
/// stations. `stations`: of girthAlong for the same path. Time: some fifty values for each of up to
/// 16 stations. Errors: as girthAlong; USAGE where there is no station.
GIRTH_EXPORT Result<PathStation> leastAlong(const SurfaceMesh& mesh,
                                            std::span<const SurfacePoint> path,
                                            std::span<const PathStation> stations,
                                            const ExecutionContext& context = {});

}  // namespace girth
