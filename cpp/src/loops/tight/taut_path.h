// Curves between two fixed points drawn tight, by the steps of closed ones (taut_loop.h); and loose
// curves, open and closed, from points.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "girth/execution.h"
#include "girth/surface_point.h"
#include "loops/tight/strip.h"
#include "loops/tight/taut_loop.h"

namespace girth::loops {

/// An open curve: its nodes, of which all but the two ends are vertices, and the edges that it
/// crosses between: run i leads from node i to the next. Numbers are those of the unfolding.
struct TautPath {
  std::vector<SurfacePoint> nodes;
  std::vector<Run> runs;
};

/// The curve through points in order, of the unfolding, each two neighbours in one face. Nothing
/// where they are not. O(points), times the faces of vertices.
std::optional<TautPath> loosePath(const Unfolding& unfolding, std::span<const SurfacePoint> points);

/// The closed one, which goes on from the last point to the first.
std::optional<TautLoop> looseClosed(const Unfolding& unfolding,
                                    std::span<const SurfacePoint> points);

/// Draws a curve tight between its ends. `GaveUp`: also where it is cancelled.
Tightened tightenBetween(const Unfolding& unfolding, TautPath& path,
                         const ExecutionContext& context);

/// Its length, in model units.
double lengthOf(const Unfolding& unfolding, const TautPath& path);

/// Its points, of the mesh.
std::vector<SurfacePoint> pointsOf(const Unfolding& unfolding, const TautPath& path);

}  // namespace girth::loops
