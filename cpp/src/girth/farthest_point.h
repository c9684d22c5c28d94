// The point farthest from the source: where the loop turns round if nothing closes before.
#pragma once

#include "geodesic/propagation.h"

namespace girth {

struct FarthestPoint {
  double distance{0};
  /// In the frame of a face that contains it.
  Index face{0};
  geodesic::Vec2 point;
  /// The window of a shortest path to it; kNoIndex: it is a vertex, `vertex`.
  Index window{kNoIndex};
  Index vertex{kNoIndex};
};

/// After a propagation over the whole surface: the exact maximum of the distance. It lies at a vertex, or
/// where three windows of one face arrive together (Sharir and Schorr 1986: at least three shortest paths
/// end there). O(k³) for the k windows of a face, on the few faces whose corners do not rule them out.
FarthestPoint farthestPoint(const geodesic::Propagation& propagation);

}  // namespace girth
