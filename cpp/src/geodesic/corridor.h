// Where the shortest paths between two points lie, without the windows of a whole disk.
#pragma once

#include <optional>

#include "geodesic/goal.h"
#include "geodesic/propagation.h"
#include "girth/execution.h"

namespace girth::geodesic {

/// On larger surfaces all windows of a disk take too much memory: half a gigabyte at 80,000
/// triangles of a potato.
inline constexpr Index kMostFacesKept = 30'000;

/// A goal for a propagation from one point: it leaves out what lies on no way to the other one that
/// is as short as `length`, in `unfolding.unit()`. One search back from there, by the same
/// propagation, whose windows are forgotten as they cross. Nothing where that was cancelled, or met
/// the budget.
std::optional<Goal> corridor(Propagation& propagation, const SurfacePoint& from,
                             const SurfacePoint& to, double length,
                             const ExecutionContext& context);

}  // namespace girth::geodesic
