// A loop of the girth moved along the surface: what the girth beside its base is no more than.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "loops/tight/strip.h"

namespace girth::loops {

/// A loop based at a point, and the strip of faces that it runs through.
///
/// Laid flat, the strip is a polygon without holes, in which the shortest path from a point to a
/// point is convex in both ends. When the base moves straight within a face, both ends of the loop
/// move so, and the length of the loop drawn tight within the strip is convex along the segment: on
/// none of its points is it more than at both ends.
class MovedLoop {
 public:
  /// `points`: as GirthLoop::points. The unfolding must outlive this.
  MovedLoop(const Unfolding& unfolding, std::span<const SurfacePoint> points);

  /// Which side of the loop its strip is on where it passes vertices.
  enum class Side : bool { Left, Right };

  /// Its length in model units, drawn tight within the strip, based at a share of the way from its
  /// base to a point of the mesh; both lie in the face. Infinite where the loop cannot be followed.
  /// O(points).
  double lengthTowards(Face face, const SurfacePoint& point, double share, Side side) const;
  /// At the point itself: on the side on which it is less.
  double lengthAt(Face face, const SurfacePoint& point) const;

 private:
  /// Appends the edges crossed on the way round a vertex from one face to another; false where the
  /// boundary is in between.
  bool turn(Index vertex, Index from, Index to, bool isLeft, Run& run) const;
  /// Appends the edges crossed at a point between two pieces of the loop.
  bool pass(const SurfacePoint& point, Index from, Index to, Side side, Run& run) const;
  /// The halfedges crossed at the base, from a face to where the loop begins and from where it ends
  /// back to the face: round a vertex on the side on which they are fewer. Nothing where the
  /// boundary is in between.
  std::optional<std::pair<Run, Run>> ends(Index face) const;
  /// The halfedge of a face that starts from one of its vertices.
  Index outOf(Index vertex, Index face) const;

  const Unfolding* unfolding_;
  /// In the numbers of the unfolding; `faces_[i]` has the points i and i + 1. None where the loop
  /// cannot be followed.
  std::vector<SurfacePoint> points_;
  std::vector<Index> faces_;
};

}  // namespace girth::loops
