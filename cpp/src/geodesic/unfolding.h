// The faces laid flat: each halfedge has a planar frame of its own, and crossing a face is one
// rotation.
//
// In the frame of halfedge h its start lies at the origin and its end on the x axis; its face lies
// above, the face behind it below. Only + − × ÷ √ are used, so every platform gets the same bits.
//
// Vertices and faces are renumbered along a space-filling curve, so that what is near on the
// surface is near in memory. Everything in `geodesic` and `girth` counts in these numbers; `toMesh`
// and `fromMesh` translate.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geodesic/min_max.h"
#include "geodesic/prefetch.h"
#include "geodesic/tolerances.h"
#include "geodesic/vec2.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "mesh/angles.h"
#include "mesh/sides.h"

namespace girth::geodesic {

/// The numbers that a halfedge adds to its face, laid flat. The three of a face lie side by side:
/// 96 bytes, so that the part of the surface which a front goes over stays in the cache.
struct alignas(32) FlatHalfedge {
  double length;  ///< length of the edge, equal from either side
  Vec2 left;      ///< unit vector from its start to the vertex opposite
  Index from;     ///< the vertex that it starts from
  Index twin;     ///< the halfedge on the other side; kNoIndex: a boundary
};

/// A face seen from one of its sides: all that a window needs to cross it. Refers to the unfolding.
class Crossing {
 public:
  Crossing(const FlatHalfedge* halfedges, Index halfedge)
      : side_(halfedges + halfedge),
        next_(halfedges + nextSide(halfedge)),
        previous_(halfedges + previousSide(halfedge)) {}

  /// Lengths of the halfedge, and of the sides from `from` and from `to` up to the apex.
  double length() const { return side_->length; }
  double leftLength() const { return previous_->length; }
  double rightLength() const { return next_->length; }
  /// Unit vector from `from` to the apex.
  Vec2 left() const { return side_->left; }
  /// Unit vector from `to` to the apex, seen in the mirror (x → −x).
  Vec2 right() const { return next_->left; }
  /// The vertex opposite, in the frame of the halfedge.
  Vec2 apex() const { return leftLength() * left(); }
  /// The vertices where the halfedge starts and ends, and the one opposite.
  Index from() const { return side_->from; }
  Index to() const { return next_->from; }
  Index apexVertex() const { return previous_->from; }
  /// The halfedges beyond the two other sides; kNoIndex: a boundary.
  Index leftTwin() const { return previous_->twin; }
  Index rightTwin() const { return next_->twin; }

 private:
  const FlatHalfedge *side_, *next_, *previous_;
};

/// Directions beside that of a path, in radians: from `clockwise` ≤ 0 to `counterclockwise` ≥ 0.
/// Where lengths of paths tie but for rounding, which of them is the shortest cannot be told, and a
/// geodesic may go on from any.
struct Spread {
  double clockwise{0}, counterclockwise{0};
};

/// A surface prepared for unfolding. Immutable: shared by the solvers of all threads.
class Unfolding {
 public:
  explicit Unfolding(const SurfaceMesh& mesh);

  const SurfaceMesh& mesh() const { return *mesh_; }
  /// The frames measure in `unit()` model units, a power of two near the mean edge length.
  double unit() const { return unit_; }
  double meanEdgeLength() const { return meanEdgeLength_; }
  /// The mean edge length of a vertex's component alone.
  double meanEdgeLengthAround(Index vertex) const {
    return componentEdge_[mesh_->componentOf(Vertex(meshVertex_[vertex]))];
  }

  Index vertexCount() const { return static_cast<Index>(totalAngle_.size()); }
  Index halfedgeCount() const { return static_cast<Index>(halfedges_.size()); }
  Crossing crossing(Index halfedge) const { return {halfedges_.data(), halfedge}; }
  /// The halfedge on the other side; kNoIndex at a boundary.
  Index twin(Index halfedge) const { return halfedges_[halfedge].twin; }
  static Index next(Index halfedge) { return nextSide(halfedge); }
  static Index previous(Index halfedge) { return previousSide(halfedge); }
  /// A halfedge that starts from a vertex; at a boundary, the one with the boundary on its right.
  Index outgoing(Index vertex) const { return fans_[firstOfFan_[vertex]]; }
  /// The next halfedge from the same vertex, counter-clockwise; kNoIndex where the boundary is
  /// next.
  Index turnLeft(Index halfedge) const { return halfedges_[previous(halfedge)].twin; }
  /// The next halfedge from the same vertex, clockwise.
  Index turnRight(Index halfedge) const {
    const Index t = twin(halfedge);
    return t == kNoIndex ? kNoIndex : next(t);
  }

  /// The halfedges that start from a vertex, and so its faces, counter-clockwise from
  /// outgoing(vertex).
  std::span<const Index> fan(Index vertex) const {
    return {fans_.data() + firstOfFan_[vertex], firstOfFan_[vertex + 1] - firstOfFan_[vertex]};
  }
  /// Unit vector along the face's other side from the start of a halfedge, in its frame.
  Vec2 left(Index halfedge) const { return halfedges_[halfedge].left; }

  /// Prefetches what crossing the face of a halfedge needs.
  void prefetchCrossing(Index halfedge) const {
    prefetch(&halfedges_[3 * faceOfSide(halfedge)], 3);
  }
  /// Prefetches what is known of a vertex; and its fan, which needs that.
  void prefetchVertex(Index vertex) const {
    prefetch(&firstOfFan_[vertex]);
    prefetch(&totalAngle_[vertex]);
    prefetch(&passable_[vertex]);
  }
  void prefetchFan(Index vertex) const { prefetch(fan(vertex).data(), fan(vertex).size()); }

  /// Direction of a halfedge at the vertex it starts from: its angle, counter-clockwise, from
  /// outgoing(vertex), in [0, totalAngle).
  double direction(Index halfedge) const { return direction_[halfedge]; }
  /// Direction of its edge at the vertex it ends at.
  double directionBack(Index halfedge) const {
    const Index back = twin(halfedge);
    return back != kNoIndex ? direction(back) : totalAngle(crossing(halfedge).to());
  }
  /// Total angle of a vertex, inside the surface.
  double totalAngle(Index vertex) const { return totalAngle_[vertex]; }
  bool boundary(Index vertex) const { return twin(outgoing(vertex)) == kNoIndex; }
  /// Whether geodesics can pass through a vertex: its angle leaves π on both sides of a path, or on
  /// the one side that a boundary vertex has.
  bool passable(Index vertex) const { return passable_[vertex] != 0; }
  /// Whether windows start anew at a vertex: a saddle, or a corner of the boundary that sticks into
  /// the surface.
  bool saddle(Index vertex) const { return passable_[vertex] == 2; }

  /// The line beside a convex vertex on its better side keeps at least twice as far away as this,
  /// since no root is nearer than the shortest edge; 0 at others.
  double leastPassing(Index vertex) const {
    if (passable(vertex)) return 0;
    double shortest = crossing(outgoing(vertex)).length();
    for (const Index h : fan(vertex)) shortest = lesser(shortest, crossing(h).leftLength());
    const double missing = (boundary(vertex) ? kPi : 2 * kPi) - totalAngle(vertex);
    return shortest * missing / 8;
  }

  /// Whether a path that arrives at a vertex from one direction, or within `spread` of it, and
  /// leaves in another is locally shortest there: every side within the surface has an angle of at
  /// least π (web/docs/definitions.md, section 1).
  bool straight(Index vertex, double arriving, double leaving, Spread spread) const {
    const double between = std::fabs(arriving - leaving);
    if (leaving < arriving) spread = {-spread.counterclockwise, -spread.clockwise};
    return between - spread.clockwise >= kPi - kStraight &&
           (boundary(vertex) ||
            totalAngle(vertex) - between + spread.counterclockwise >= kPi - kStraight);
  }

  /// Direction, at the vertex where `halfedge` starts, of a vector of its frame that points into
  /// the face. A vector that rounding has put below the halfedge has a smaller one, even below 0:
  /// the windows go on along the vector itself.
  double directionOf(Index halfedge, Vec2 vector) const {
    return direction_[halfedge] + signedAngleOf(vector.x, vector.y);
  }

  /// A point given in the frame of a halfedge, in that of the next or the previous one of its face,
  /// or of its twin.
  Vec2 toNext(Index halfedge, Vec2 p) const {
    const Vec2 right = halfedges_[next(halfedge)].left;
    const Vec2 along{-right.x, right.y}, d{p.x - halfedges_[halfedge].length, p.y};
    return {dot(d, along), cross(along, d)};
  }
  Vec2 toPrevious(Index halfedge, Vec2 p) const {
    const Crossing c = crossing(halfedge);
    const Vec2 along = -1 * c.left(), d = p - c.apex();
    return {dot(d, along), cross(along, d)};
  }
  Vec2 toTwin(Index halfedge, Vec2 p) const { return {halfedges_[halfedge].length - p.x, -p.y}; }
  /// From the frame of one halfedge of a face to that of another.
  Vec2 toFrame(Index halfedge, Index target, Vec2 p) const {
    if (target == next(halfedge)) return toNext(halfedge, p);
    if (target == previous(halfedge)) return toPrevious(halfedge, p);
    return p;
  }

  /// A halfedge of a face that contains a surface point; for a point of an edge or a vertex, along
  /// that edge or out of that vertex.
  Index home(const SurfacePoint& point) const;
  /// Where a surface point lies in the frame of a halfedge, if it belongs to its face.
  std::optional<Vec2> placeIn(Index halfedge, const SurfacePoint& point) const;

  /// A surface point in the numbers of the mesh, and back.
  SurfacePoint toMesh(const SurfacePoint& point) const;
  SurfacePoint fromMesh(const SurfacePoint& point) const;
  Index vertexInMesh(Index vertex) const { return meshVertex_[vertex]; }

 private:
  const SurfaceMesh* mesh_;
  double unit_, meanEdgeLength_;
  std::vector<double> componentEdge_;  // the mean edge length of each component
  std::vector<FlatHalfedge> halfedges_;
  std::vector<Index> fans_;        // halfedges round all vertices, one fan behind the other
  std::vector<Index> firstOfFan_;  // by vertex, and the end
  std::vector<double> direction_, totalAngle_;
  std::vector<std::uint8_t> passable_;
  std::vector<Index> meshVertex_, vertexOfMesh_, meshFace_, faceOfMesh_;
};

}  // namespace girth::geodesic
