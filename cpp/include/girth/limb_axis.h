// The axis of a limb or another tube: the middles of the loops that are swept along it.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/girth_profile.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// One of the loops that are swept along a tube.
struct AxisStation {
  double distance{0};  ///< along the axis from its first point, in model units
  /// Over the surface: how far along the first station is, and on along the path, in model units.
  double along{0};
  double girth{0};  ///< the loop's length, in model units
  /// A point of the axis: the mean of the loop's points, each part counted by its length.
  Vec3 centre;
  double area{0};  ///< the area that the loop encloses in its mean plane, in squared model units
  /// The loop, as GirthLoop::points; the last point equals the first.
  std::vector<SurfacePoint> points;
};

/// The axis along a profile, as Limb::profile. Loops are swept along the shortest path from the
/// first to the last station at which a loop goes round: the exact loops at equal distances on it,
/// as many as there are such stations, at least two. The axis leads straight from the middle of
/// one loop to that of the next. Places without a loop are left out, and so is one whose loop has
/// the same middle as the one before (to 1e-9 of its length). Empty where no loop goes round.
///
/// The girth and the middle of each loop are exact to rounding; the axis is as fine as the loops
/// are close. Where a loop on the way goes round a bump instead, its middle lies there. Time: a
/// path, a value and a loop for each, on all threads. Any number of threads gives the same result.
/// Errors: VERTEX_OUT_OF_RANGE or INVALID_POINT where the place of one of the two stations is none
/// of the surface, or they lie in different components; CANCELLED.
GIRTH_EXPORT Result<std::vector<AxisStation>> limbAxis(const SurfaceMesh& mesh,
                                                       const GirthProfile& profile,
                                                       const ExecutionContext& context = {});

}  // namespace girth
