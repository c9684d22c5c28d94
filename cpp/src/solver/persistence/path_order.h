// The cyclic order of shortest paths round p: which of two leaves the other to its right.
//
// Shortest paths from one point do not cross. So they have a cyclic order: that of their directions
// at p; where they leave p along one way and part at a vertex, that of their directions there. It
// is the order in which one meets their ends on the way round the part of the surface in which
// shortest paths go on, an open disk. This order alone says which parts loops cut off
// (saddle_tree.h).
#pragma once

#include <bitset>
#include <vector>

#include "solver/search/arrivals.h"
#include "solver/search/loop_search.h"

namespace girth {

/// A place where a path turns or may turn: p, or a vertex on the path that has more than 2π or lies
/// on a boundary.
struct Bend {
  Index vertex;  ///< kNoIndex: p, where that is no vertex
  double turn;   ///< at p: the direction; elsewhere counter-clockwise from the way back
};

/// The bends of a path, in order from p on.
using BentPath = std::vector<Bend>;

/// Whether `a` leaves p to the right of `b`; the order is cut open at direction 0.
bool leavesRightOf(const BentPath& a, const BentPath& b);

/// Finds the bends of shortest paths that a propagation has found. It follows a path back straight
/// through the unfolded faces, from root to root; no windows are needed. O(faces on the path).
class PathOrder {
 public:
  explicit PathOrder(const geodesic::Propagation& propagation)
      : propagation_(&propagation), unfolding_(&propagation.unfolding()) {}

  /// A half of a loop that has been proven; where its midpoint is a vertex that one half ends with,
  /// that half turns into the other.
  BentPath ofHalf(const LoopCandidate& loop, const PathHalf& half, const PathHalf& other) const;
  /// A path that arrives at a point of a face, given in the frame of a halfedge.
  BentPath ofArrival(const PathHalf& half, Index halfedge, geodesic::Vec2 point) const;
  /// A path that arrives at a vertex.
  BentPath ofArrivalAt(Index vertex, const PathHalf& half) const;
  /// The path to a boundary vertex, and on across the boundary.
  BentPath beyondBoundary(Index vertex) const;

  /// Whether two paths run beside each other: they leave p, and turn at vertices, alike.
  bool runBeside(const BentPath& a, const BentPath& b) const;
  /// Whether a path runs between two that run beside each other.
  static bool liesBetween(const BentPath& path, const BentPath& a, const BentPath& b);

  /// Whether paths may part at a vertex: paths that pass it list it as a bend.
  bool bends(Index vertex) const;
  /// The direction at a vertex of the edge to a neighbour.
  double directionOfEdge(Index vertex, Index neighbour) const;

 private:
  /// The part of a path that is still to be followed back.
  struct Rest {
    Index vertex{kNoIndex};  ///< it leaves this vertex in `direction`; or
    double direction{0};
    geodesic::Bundle bundle;  ///< it comes in this bundle to `point` of its frame; or it is done
    geodesic::Vec2 point;
  };

  /// The side on which a path passes each vertex that it meets on the way back: that of rounding,
  /// or the other.
  struct Choices {
    static constexpr unsigned kMost = 64;
    std::bitset<kMost> other;
    unsigned made{0};
  };

  Rest back(Rest rest, BentPath& backwards) const;
  Rest wayTo(Index vertex, BentPath& backwards) const;
  bool straightBack(const Rest& rest, Choices& choices, BentPath& backwards, Rest& root) const;
  void graze(Index vertex, bool onLeft, BentPath& backwards) const;
  double roundAngle(Index vertex) const;
  bool turnsAt(const Bend& bend) const;
  double turn(Index vertex, double direction) const;
  Bend atOrigin(const geodesic::Propagation::Origin& origin, geodesic::Vec2 towards) const;
  BentPath finished(Rest rest, BentPath backwards) const;

  const geodesic::Propagation* propagation_;
  const geodesic::Unfolding* unfolding_;
};

}  // namespace girth
