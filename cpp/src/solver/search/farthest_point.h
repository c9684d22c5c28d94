// The point farthest from the source: where the loop turns round if nothing closes before.
#pragma once

#include <cstddef>
#include <limits>

#include "geodesic/propagation.h"
#include "girth/execution.h"

namespace girth {

struct FarthestPoint {
  double distance{0};
  /// In the frame of a halfedge of a face that contains it.
  Index halfedge{0};
  geodesic::Vec2 point;
  /// No point is farther than this; where the search is complete, give or take rounding `distance`.
  double atMost{0};
  /// False: the limit was met, or the work cancelled. `distance` is that of the farthest point
  /// found.
  bool complete{false};
};

/// After a propagation over the whole surface: the exact maximum of the distance. It lies at a
/// vertex, or where three paths arrive together inside a face or on its rim (Sharir and Schorr
/// 1986: at least three shortest paths end there). On a boundary two paths are enough. Parts of the
/// faces that can hold it are halved, the most promising first, until few paths compete, or until
/// all points of a part are equally far up to kTie. Gives up when more than `mostWork` paths into
/// faces have been looked at; of the context, only `cancel` matters.
FarthestPoint farthestPoint(const geodesic::Propagation& propagation,
                            std::size_t mostWork = std::numeric_limits<std::size_t>::max(),
                            const ExecutionContext& context = {});

/// A distance that no point of the component is beyond, after a propagation that may have stopped
/// on the way: over vertices that it has reached, along edges to the others, and into faces from
/// their corners. O(n log n).
double noPointIsFarther(const geodesic::Propagation& propagation);

}  // namespace girth
