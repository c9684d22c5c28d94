// From which directions shortest paths arrive at a point: what decides whether the frontier goes on
// there, touches itself, or vanishes (web/docs/definitions.md, section 2).
#pragma once

#include <vector>

#include "geodesic/propagation.h"

namespace girth {

/// A gap between arrivals counts as π if it is no smaller than this: a path that ties with another
/// within kTie may come from a direction as much beside it.
inline constexpr double kFullGap = kPi - 1e-4;

/// Paths to one point whose lengths differ by less than this share arrive together.
inline constexpr double kTogether = 1e-9;

/// Arrivals that leave a gap of this or more leave the frontier a way on. It is less than π by as
/// much as the direction of a path changes that arrives later by a share of kTogether: so a point
/// is no maximum where the saddle beside it is none.
inline constexpr double kNoGap = kPi - 2 * kTogether;

/// The end of a path from p to a point of a face.
struct PathHalf {
  geodesic::Bundle bundle;  ///< a bundle of the face; otherwise
  Index vertex{kNoIndex};   ///< the path to a corner of it; otherwise p itself lies in the face
};

/// A path that arrives at a point, and the direction back along it.
struct PathArrival {
  double direction, length;
  PathHalf half;
};

/// The paths that arrive at a point together.
struct Arrivals {
  std::vector<PathArrival> paths;  ///< by direction, once sorted
  double total{0};                 ///< the angle of the surface at the point
  bool open{false};                ///< it lies on a boundary: directions run from 0 to `total`
  /// The vertex that the point is; kNoIndex: none. Directions are those of the unfolding there;
  /// elsewhere they count from that of halfedge `base`.
  Index vertex{kNoIndex};
  Index base{kNoIndex};

  /// Whether a direction is left out: no two neighbours leave a gap of this width or more between
  /// them. On a boundary a gap may lie between it and the first of them. Sorts them.
  bool surround(double gap);
  /// The direction from the point, where that is no vertex, to another, both given in the frame of
  /// a halfedge of the face.
  double directionTo(const geodesic::Unfolding& unfolding, Index halfedge, geodesic::Vec2 point,
                     geodesic::Vec2 other) const;
};

/// The shortest paths to a point of a face, given in the frame of a halfedge, that are no longer
/// than `reach`. A way over a vertex at which it bends is none, however little it is longer than
/// the one that passes beside the vertex. The frontier has passed that, and no face at the point
/// has been forgotten. `arrivals` is filled in anew.
void findArrivals(const geodesic::Propagation& propagation, Index halfedge, geodesic::Vec2 point,
                  double reach, Arrivals& arrivals);

}  // namespace girth
