// Shortest paths from p, ordered round p: which of two leaves the other to its right.
//
// Shortest paths from one point do not cross. So they have a cyclic order: that of their directions
// at p; where they leave p along one way and part at a vertex, that of their directions there. It
// is the order in which one meets their ends on the way round the part of the surface in which
// shortest paths go on, an open disk. What loops cut apart follows from this order alone
// (saddle_tree.h).
#pragma once

#include <bitset>
#include <vector>

#include "girth/arrivals.h"
#include "girth/loop_search.h"

namespace girth {

/// Where a path turns, or might: p, and the vertices on its way that have more than 2π, or lie on a
/// boundary.
struct Bend {
  Index vertex;  ///< kNoIndex: p, where that is no vertex
  double turn;   ///< at p: the direction; elsewhere counter-clockwise from the way back
};

/// A path as its bends, in order from p on.
using Course = std::vector<Bend>;

/// Whether `a` leaves p to the right of `b`; the order is cut open at direction 0.
bool leavesRightOf(const Course& a, const Course& b);

/// Finds the courses of shortest paths that a propagation has found. The way back is straight
/// through the unfolded faces, from root to root; it needs no windows. O(faces on the path).
class Courses {
 public:
  explicit Courses(const geodesic::Propagation& propagation)
      : propagation_(&propagation), unfolding_(&propagation.unfolding()) {}

  /// A half of a loop that has been proven; where its midpoint is a vertex that one half ends with,
  /// that half turns into the other.
  Course ofHalf(const LoopCandidate& loop, const PathHalf& half, const PathHalf& other) const;
  /// A path that arrives at a point of a face, given in the frame of a halfedge.
  Course ofArrival(const PathHalf& half, Index halfedge, geodesic::Vec2 point) const;
  /// A path that arrives at a vertex.
  Course ofArrivalAt(Index vertex, const PathHalf& half) const;
  /// The path to a boundary vertex, and on across the boundary.
  Course beyondBoundary(Index vertex) const;

  /// Whether two paths run beside each other: they leave p, and turn at vertices, alike.
  bool runBeside(const Course& a, const Course& b) const;
  /// Whether a path runs between two that run beside each other.
  static bool liesBetween(const Course& path, const Course& a, const Course& b);

  /// Whether paths may part at a vertex: it is listed in the courses that pass it.
  bool bends(Index vertex) const;
  /// The direction at a vertex of the edge to a neighbour.
  double directionOfEdge(Index vertex, Index neighbour) const;

 private:
  /// What of a path is still to be followed back.
  struct Rest {
    Index vertex{kNoIndex};  ///< it leaves this vertex in `direction`; or
    double direction{0};
    geodesic::Bundle bundle;  ///< it comes in this bundle to `point` of its frame; or it is done
    geodesic::Vec2 point;
  };

  /// On which side of the vertices that it meets the way back goes on: the one that rounding has
  /// it, or the other.
  struct Choices {
    static constexpr unsigned kMost = 64;
    std::bitset<kMost> other;
    unsigned made{0};
  };

  Rest back(Rest rest, Course& backwards) const;
  Rest wayTo(Index vertex, Course& backwards) const;
  bool straightBack(const Rest& rest, Choices& choices, Course& backwards, Rest& root) const;
  void graze(Index vertex, bool onLeft, Course& backwards) const;
  double roundAngle(Index vertex) const;
  bool turnsAt(const Bend& bend) const;
  double turn(Index vertex, double direction) const;
  Bend atOrigin(const geodesic::Propagation::Origin& origin, geodesic::Vec2 towards) const;
  Course finished(Rest rest, Course backwards) const;

  const geodesic::Propagation* propagation_;
  const geodesic::Unfolding* unfolding_;
};

}  // namespace girth
