// The point farthest from the source: where the loop turns round if nothing closes before.
#pragma once

#include "geodesic/propagation.h"

namespace girth {

struct FarthestPoint {
  double distance{0};
  /// In the frame of a halfedge of a face that contains it.
  Index halfedge{0};
  geodesic::Vec2 point;
};

/// After a propagation over the whole surface: the exact maximum of the distance. It lies at a
/// vertex, or where three paths arrive together inside a face or on its rim (Sharir and Schorr
/// 1986: at least three shortest paths end there). Few faces can hold it; those are quartered until
/// few paths compete. On a boundary two paths are enough.
FarthestPoint farthestPoint(const geodesic::Propagation& propagation);

}  // namespace girth
