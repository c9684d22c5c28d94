// Exact geodesic distances from one vertex, growing outward: the engine under everything.
//
// Invariants
// - Every window stands for real paths: sigma + |root − x| is the length of a path of the surface
// for each
//   x that the window covers, and so is distance(v) of each vertex. Nothing is ever too short.
// - A window, or part of one, is dropped only where a path through an end of its edge is strictly
// shorter
//   at every point of it. A prefix of a shortest path is itself shortest, so no window that carries
//   a shortest path is lost, up to the point where the path stops being shortest. (The rules of
//   Chen and Han 1990 and of Xin and Wang 2009 are special cases of this trimming; like them it
//   looks at vertices only, never at other windows, so what is kept does not depend on the order of
//   the queue.)
// - Windows leave the queue in the order of their nearest point, give or take one bucket. When the
// frontier
//   stands at r, every window with a point nearer than r has entered its face and stands in the
//   list of its halfedge, and every saddle nearer than r has sent out its fan.
// - If a vertex becomes nearer after it was settled (possible within one bucket) it is settled
// again; what
//   it sent out before is too long, but still real.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geodesic/bucket_queue.h"
#include "geodesic/unfolding.h"
#include "geodesic/window.h"

namespace girth::geodesic {

/// How the best known path reaches a vertex.
struct Arrival {
  double distance{std::numeric_limits<double>::infinity()};
  /// Direction at the vertex in which the path comes in; known once settled.
  double direction{0};
  /// The window in which it comes; or, along an edge, the halfedge from the vertex back along it.
  Index carrier{kNoIndex};
  bool alongEdge{false};
  /// Only vertices that geodesics can pass are settled, and the source.
  bool settled{false};
};

/// How a path ends at a point of a face: in a window, or straight from a corner.
struct PathEnd {
  double distance{std::numeric_limits<double>::infinity()};
  Index window{kNoIndex};
  Index corner{kNoIndex};  ///< a vertex, where there is no window
};

/// One propagation at a time; scratch memory is kept between them and cleared in proportion to what
/// was touched. Lengths are in `unfolding.unit()`.
class Propagation {
 public:
  explicit Propagation(const Unfolding& unfolding)
      : unfolding_(&unfolding),
        queue_(kBucketWidth * unfolding.meanEdgeLength()),
        arrival_(unfolding.mesh().vertexCount()),
        first_(unfolding.mesh().halfedgeCount(), kNoIndex) {}

  /// Grows from `source` until the surface is covered or `visitor` has seen enough:
  ///   bool visitor.enough(double frontier)   everything nearer than the frontier is known; stop?
  ///   void visitor.onWindow(Index window, double tip)  it enters its face; `tip`: length of its
  ///   path to
  ///                                          the vertex opposite, infinite where it does not reach
  ///                                          it
  ///   void visitor.onVertex(Index vertex)    a vertex that geodesics can pass is settled
  template <class Visitor>
  void run(Index source, Visitor& visitor) {
    clear();
    source_ = source;
    touch(source).distance = 0;
    settle(source);
    visitor.onVertex(source);
    while (!queue_.empty()) {
      if (queue_.bucketDone()) {
        queue_.advance();
        if (visitor.enough(queue_.frontier())) return;
      }
      const Index item = queue_.pop();
      if (item & kVertexItem) {
        const Index vertex = item & ~kVertexItem;
        if (arrival_[vertex].settled) continue;
        settle(vertex);
        visitor.onVertex(vertex);
      } else {
        visitor.onWindow(item, enter(item));
      }
    }
    visitor.enough(std::numeric_limits<double>::infinity());
  }

  const Unfolding& unfolding() const { return *unfolding_; }
  Index source() const { return source_; }
  const Window& window(Index number) const { return windows_[number]; }
  std::size_t windowCount() const { return windows_.size(); }
  const Arrival& arrival(Index vertex) const { return arrival_[vertex]; }
  /// Windows that have entered the face through a halfedge: the first; others by `sibling`.
  Index firstWindow(Index halfedge) const { return first_[halfedge]; }
  /// The vertices that a path has reached.
  const std::vector<Index>& reachedVertices() const { return reached_; }

  /// The shortest path to a point of a face, from all windows that entered it and its corners;
  /// exact where the frontier has passed the point.
  PathEnd pathTo(Index face, Vec2 point) const {
    PathEnd best;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Side& side = unfolding_->side(h);
      const double overCorner = arrival_[side.from].distance + norm(point - side.start);
      if (overCorner < best.distance) best = {overCorner, kNoIndex, side.from};
      for (Index w = first_[h]; w != kNoIndex; w = windows_[w].sibling) {
        const double distance = windows_[w].distanceTo(point);
        if (distance < best.distance && windows_[w].covers(side, point)) {
          best = {distance, w, kNoIndex};
        }
      }
    }
    return best;
  }
  double distanceTo(Index face, Vec2 point) const { return pathTo(face, point).distance; }

  std::size_t memoryBytes() const {
    return windows_.capacity() * sizeof(Window) + arrival_.capacity() * sizeof(Arrival) +
           (first_.capacity() + reached_.capacity() + entered_.capacity()) * sizeof(Index) +
           queue_.memoryBytes();
  }

 private:
  static constexpr double kBucketWidth = 0.0625;  // of the mean edge: wider ones overshoot the end
  static constexpr Index kVertexItem = 0x80000000u;

  void clear() {
    queue_.clear();
    windows_.clear();
    for (const Index v : reached_) arrival_[v] = Arrival{};
    for (const Index h : entered_) first_[h] = kNoIndex;
    reached_.clear();
    entered_.clear();
  }

  Arrival& touch(Index vertex) {
    Arrival& arrival = arrival_[vertex];
    if (std::isinf(arrival.distance)) reached_.push_back(vertex);
    return arrival;
  }

  /// A path of this length reaches a vertex.
  void reach(Index vertex, double distance, Index carrier, bool alongEdge) {
    if (!(distance < arrival_[vertex].distance * (1 - kRounding))) return;
    Arrival& arrival = touch(vertex);
    arrival.distance = distance;
    arrival.carrier = carrier;
    arrival.alongEdge = alongEdge;
    arrival.settled = false;
    if (unfolding_->passable(vertex)) queue_.push(distance, vertex | kVertexItem);
  }

  /// A window leaves the queue: it joins its halfedge's list and continues across its face. Returns
  /// the length of its path to the opposite vertex, infinite where that lies outside the window.
  double enter(Index number) {
    const Index h = windows_[number].halfedge;
    if (first_[h] == kNoIndex) entered_.push_back(h);
    windows_[number].sibling = first_[h];
    first_[h] = number;
    const Window w = windows_[number];  // a copy: children may move the array

    const Side& side = unfolding_->side(h);
    const Index right = SurfaceMesh::next(h), left = SurfaceMesh::previous(h);
    const Side& rightSide = unfolding_->side(right);
    const Side& leftSide = unfolding_->side(left);
    const Vec2 tip = leftSide.start;

    const double height = cross(side.direction, side.start - w.root);
    if (!(height > 0))
      return std::numeric_limits<double>::infinity();            // seen edge-on: nothing beyond
    const Vec2 rayFrom = side.at(w.gapFrom) - w.root;            // along the window's left bound
    const Vec2 rayTo = side.at(side.length - w.gapTo) - w.root;  // along its right bound
    const Vec2 rayTip = tip - w.root;
    const double slack = kSnap * side.length * (std::fabs(rayTip.x) + std::fabs(rayTip.y));
    const double tipLeft = cross(rayFrom, rayTip);  // > 0: the tip lies left of the window
    const double tipRight = cross(rayTo, rayTip);   // < 0: right of it

    double tipDistance = std::numeric_limits<double>::infinity();
    if (tipLeft <= slack && tipRight >= -slack) {
      tipDistance = w.sigma + norm(rayTip);
      reach(leftSide.from, tipDistance, number, false);
    }
    // Where a bounding ray meets a side, measured from the corner at this halfedge: similar
    // triangles, so that a gap of zero stays zero.
    const auto alongLeft = [&](Vec2 ray, double gap) {
      return gap * height / -cross(leftSide.direction, ray);
    };
    const auto alongRight = [&](Vec2 ray, double gap) {
      return gap * height / cross(ray, rightSide.direction);
    };
    if (tipLeft < 0) {  // something passes left of the tip
      const bool whole = tipRight >= -slack;
      const double end = alongLeft(rayFrom, w.gapFrom);
      const double start =
          whole ? 0 : std::max(0.0, leftSide.length - alongLeft(rayTo, side.length - w.gapTo));
      continueAcross(w, number, left, start, end);
    }
    if (tipRight > 0) {  // and right of it
      const bool whole = tipLeft <= slack;
      const double start = alongRight(rayTo, w.gapTo);
      const double end =
          whole ? 0
                : std::max(0.0, rightSide.length - alongRight(rayFrom, side.length - w.gapFrom));
      continueAcross(w, number, right, start, end);
    }
    return tipDistance;
  }

  /// The part of a window that leaves its face through side `h`, between the gaps `start` and `end`
  /// from the two ends of h, less what the ends of h make useless; queued as a new window.
  void continueAcross(const Window& w, Index parent, Index h, double start, double end) {
    const Side& side = unfolding_->side(h);
    if (!trim(arrival_[side.from].distance - w.sigma, w.root - side.start, side.direction, start))
      return;
    const Index to = unfolding_->side(SurfaceMesh::next(h)).from;
    if (!trim(arrival_[to].distance - w.sigma, w.root - side.at(side.length), -1 * side.direction,
              end))
      return;
    if (!(start + end < side.length * (1 - kSliver))) return;

    // The nearest point: the foot of the root's perpendicular, or the end of the interval next to
    // it.
    const Vec2 toRoot = w.root - side.start;
    const double foot = dot(side.direction, toRoot), height = cross(side.direction, toRoot);
    const double aside = std::clamp(foot, start, side.length - end) - foot;
    const double nearest = std::sqrt(aside * aside + height * height);
    queue_.push(w.sigma + nearest, static_cast<Index>(windows_.size()));
    windows_.push_back(
        {side.toTwin(w.root), w.sigma, end, start, side.twin, parent, w.rootVertex, kNoIndex});
  }

  /// Moves the near end of an interval away from a vertex V of its line, as far as the path over V
  /// and along the line is strictly shorter. `lead`: distance(V) − sigma; `root`: the root seen
  /// from V; `along`: unit vector from V into the interval. False: nothing is left.
  ///
  /// The two lengths are equal at x where lead + x = |root − x·along|: one point at most, and the
  /// path over V wins on the near side of it.
  static bool trim(double lead, Vec2 root, Vec2 along, double& gap) {
    const double excess = dot(root, root) * (1 - kTrim) - lead * lead;
    const double slope = 2 * (dot(root, along) + lead);
    if (!(slope > 0)) return lead > 0 && excess <= 0;
    gap = std::max(
        gap, excess / slope);  // where nothing is won, the quotient is negative or not a number
    return true;
  }

  /// The best path to a vertex is known: note its direction and, at a saddle and the source, send
  /// windows into all directions in which a path can go on straight.
  void settle(Index vertex) {
    Arrival& arrival = arrival_[vertex];
    arrival.settled = true;
    const double total = unfolding_->totalAngle(vertex);
    if (vertex == source_) {
      fan(vertex, 0, total);
      return;
    }
    if (arrival.alongEdge) {
      arrival.direction = unfolding_->direction(arrival.carrier);
    } else {
      const Window& w = windows_[arrival.carrier];
      arrival.direction = unfolding_->directionTo(SurfaceMesh::previous(w.halfedge), w.root);
    }
    const double start = arrival.direction + kPi - kFanOverlap;
    const double width = total - 2 * kPi + 2 * kFanOverlap;
    if (unfolding_->saddle(vertex)) {
      fan(vertex, start < total ? start : start - total, width);
    }
  }

  /// Sends windows from a vertex into the directions from `start` in [0, total) to start + width.
  void fan(Index vertex, double start, double width) {
    const SurfaceMesh& mesh = unfolding_->mesh();
    const double total = unfolding_->totalAngle(vertex);
    Index h = mesh.outgoing(vertex);
    do {
      // The fan, measured from this halfedge, and the same a whole turn earlier.
      const double first = start - unfolding_->direction(h), corner = mesh.cornerAngle(h);
      sendThrough(vertex, h, std::max(first, 0.0), std::min(first + width, corner));
      sendThrough(vertex, h, std::max(first - total, 0.0), std::min(first - total + width, corner));
      h = mesh.twin(SurfaceMesh::previous(h));
    } while (h != mesh.outgoing(vertex));
  }

  /// Sends a window from the vertex where h starts through the face of h, between two angles
  /// against h.
  void sendThrough(Index vertex, Index h, double low, double high) {
    if (low > high) return;
    const Index across = SurfaceMesh::next(h), back = SurfaceMesh::previous(h);
    const Side& side = unfolding_->side(h);
    const double distance = arrival_[vertex].distance;
    if (low <= 0) reach(unfolding_->side(across).from, distance + side.length, side.twin, true);

    // Where a ray meets the opposite side, measured from the end that lies `angle` away from it:
    // that end and the other divide the face in the ratio of the two triangles' areas.
    const double corner = unfolding_->mesh().cornerAngle(h);
    const double length = unfolding_->side(across).length;
    const auto gap = [&](double angle, double nearSide, double farSide) {
      if (angle <= 0) return 0.0;
      const double nearArea = nearSide * cosSin(angle).sin;
      const double farArea = farSide * cosSin(std::max(corner - angle, 0.0)).sin;
      return length * (nearArea / (nearArea + farArea));
    };
    const double sideLength = side.length, backLength = unfolding_->side(back).length;
    const Window w{side.start, distance, 0, 0, kNoIndex, kNoIndex, vertex, kNoIndex};
    continueAcross(w, kNoIndex, across, gap(low, sideLength, backLength),
                   gap(corner - high, backLength, sideLength));
  }

  const Unfolding* unfolding_;
  BucketQueue queue_;
  Index source_{0};
  std::vector<Window> windows_;
  std::vector<Arrival> arrival_;
  std::vector<Index> first_;    // by halfedge
  std::vector<Index> reached_;  // vertices to clear
  std::vector<Index> entered_;  // halfedges to clear
};

}  // namespace girth::geodesic
