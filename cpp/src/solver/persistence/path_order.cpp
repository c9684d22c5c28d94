#include "solver/persistence/path_order.h"

#include <algorithm>
#include <cmath>

namespace girth {

using geodesic::Arrival;
using geodesic::cross;
using geodesic::Crossing;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

namespace {

/// A path that passes a vertex this near, as a share of the edge, passes through it.
constexpr double kGraze = 1e-9;

/// A vertex where paths can part has so much more than a straight angle on both sides.
constexpr double kBending = 1e-8;

/// Two turns that differ by less are one.
constexpr double kSameTurn = 1e-8;

/// A root is where a vertex is if it lies no farther from it, as a share of the side.
constexpr double kAtRoot = 1e-6;

/// Paths of which one direction differs by less than this from the other's run beside each other.
constexpr double kAlike = 1e-4;

/// As if a boundary vertex had so much angle beyond the boundary.
constexpr double kBeyond = 2 * kPi;

}  // namespace

bool leavesRightOf(const BentPath& a, const BentPath& b) {
  std::size_t i = 0;
  while (i + 1 < a.size() && i + 1 < b.size() && a[i + 1].vertex == b[i + 1].vertex) ++i;
  return i < a.size() && i < b.size() && a[i].turn < b[i].turn;
}

BentPath PathOrder::ofHalf(const LoopCandidate& loop, const PathHalf& half,
                           const PathHalf& other) const {
  if (half.bundle.halfedge != kNoIndex || half.vertex == kNoIndex) {
    return ofArrival(half, loop.halfedge, loop.midpoint);
  }
  // The loop goes on from the vertex: towards the root of the other half, or along the edge.
  Rest rest;
  rest.vertex = half.vertex;
  if (other.bundle.halfedge != kNoIndex) {
    const Index h = other.bundle.halfedge;
    rest.direction = unfolding_->directionOf(Unfolding::previous(h),
                                             unfolding_->toPrevious(h, other.bundle.root));
  } else {
    rest.direction = directionOfEdge(half.vertex, other.vertex);
  }
  return finished(rest, {});
}

BentPath PathOrder::ofArrival(const PathHalf& half, Index halfedge, Vec2 point) const {
  Rest rest;
  const Index face = faceOfSide(halfedge);
  if (half.bundle.halfedge != kNoIndex) {
    rest.bundle = half.bundle;
    rest.point = unfolding_->toFrame(halfedge, half.bundle.halfedge, point);
    return finished(rest, {});
  }
  if (half.vertex != kNoIndex) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (unfolding_->crossing(h).from() != half.vertex) continue;
      rest.vertex = half.vertex;
      rest.direction = unfolding_->directionOf(h, unfolding_->toFrame(halfedge, h, point));
    }
    return finished(rest, {});
  }
  for (const Propagation::Origin& origin : propagation_->origins()) {
    if (origin.face != face) continue;
    return {atOrigin(origin, unfolding_->toFrame(halfedge, 3 * face, point) - origin.place)};
  }
  return {};
}

BentPath PathOrder::ofArrivalAt(Index vertex, const PathHalf& half) const {
  Rest rest;
  if (half.bundle.halfedge != kNoIndex) {
    rest.bundle = half.bundle;
    rest.point = unfolding_->crossing(half.bundle.halfedge).apex();
  } else {
    rest.vertex = half.vertex;
    rest.direction = directionOfEdge(half.vertex, vertex);
  }
  return finished(rest, {});
}

BentPath PathOrder::beyondBoundary(Index vertex) const {
  BentPath backwards;
  if (propagation_->isSource(vertex)) {
    backwards.push_back({vertex, unfolding_->totalAngle(vertex) + kBeyond / 2});
    return backwards;
  }
  if (propagation_->settled(vertex)) {  // otherwise no path goes past it
    const double beyond = unfolding_->totalAngle(vertex) + kBeyond / 2;
    backwards.push_back({vertex, beyond - propagation_->arrivalDirection(vertex)});
  }
  const Rest rest = wayTo(vertex, backwards);
  return finished(rest, std::move(backwards));
}

BentPath PathOrder::finished(Rest rest, BentPath backwards) const {
  while (rest.vertex != kNoIndex || rest.bundle.halfedge != kNoIndex) rest = back(rest, backwards);
  std::reverse(backwards.begin(), backwards.end());
  return backwards;
}

/// Follows the path back by one straight piece, or past one vertex.
PathOrder::Rest PathOrder::back(Rest rest, BentPath& backwards) const {
  if (rest.vertex != kNoIndex) {
    if (propagation_->isSource(rest.vertex)) {
      // Just short of a whole turn is the direction 0.
      const double total = unfolding_->totalAngle(rest.vertex);
      const bool isWhole = !unfolding_->boundary(rest.vertex) && rest.direction > total - kSameTurn;
      backwards.push_back({rest.vertex, isWhole ? rest.direction - total : rest.direction});
      return {};
    }
    if (bends(rest.vertex)) backwards.push_back({rest.vertex, turn(rest.vertex, rest.direction)});
    return wayTo(rest.vertex, backwards);
  }
  // Where the way back meets vertices, either side of them may be the right one; the root shows. At
  // a dead end the last choice is changed first.
  constexpr int kMostTrials = 1024;
  const std::size_t known = backwards.size();
  Choices choices;
  Rest root;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    backwards.resize(known);
    choices.made = 0;
    if (straightBack(rest, choices, backwards, root)) return root;
    unsigned last = std::min(choices.made, Choices::kMost);
    while (last > 0 && choices.other[last - 1]) --last;
    if (last == 0) break;
    choices.other[last - 1] = true;
    for (unsigned k = last; k < Choices::kMost; ++k) choices.other[k] = false;
  }
  return {};
}

/// The way to a vertex.
PathOrder::Rest PathOrder::wayTo(Index vertex, BentPath& backwards) const {
  const Arrival& arrival = propagation_->arrival(vertex);
  Rest rest;
  switch (arrival.way) {
    case Arrival::Way::None:
    case Arrival::Way::Source:
      break;
    case Arrival::Way::Edge:
      rest.vertex = arrival.before;
      rest.direction = directionOfEdge(arrival.before, vertex);
      break;
    case Arrival::Way::Straight:
      for (const Propagation::Origin& origin : propagation_->origins()) {
        const Index face = faceOfSide(arrival.corner);
        if (origin.face != face) continue;
        const Vec2 there = unfolding_->toFrame(arrival.corner, 3 * face, {0, 0});
        backwards.push_back(atOrigin(origin, there - origin.place));
        break;
      }
      break;
    case Arrival::Way::Window:
      rest.bundle = arrival.bundle;
      rest.point = unfolding_->crossing(arrival.bundle.halfedge).apex();
      break;
  }
  return rest;
}

double PathOrder::directionOfEdge(Index vertex, Index neighbour) const {
  for (const Index h : unfolding_->fan(vertex)) {
    if (unfolding_->crossing(h).to() == neighbour) return unfolding_->direction(h);
  }
  return unfolding_->totalAngle(vertex);  // the last edge before a boundary
}

/// Goes back along the straight line from the point of `rest` through the faces behind its bundle
/// to the root. False: the root has not been met.
bool PathOrder::straightBack(const Rest& rest, Choices& choices, BentPath& backwards,
                             Rest& root) const {
  const double sigma = rest.bundle.sigma;
  Index h = rest.bundle.halfedge;
  Vec2 from = rest.bundle.root, point = rest.point;
  for (std::size_t faces = 0; faces < unfolding_->halfedgeCount(); ++faces) {
    const double length = unfolding_->crossing(h).length();
    const double rise = point.y - from.y;
    // A line that runs along the side crosses it where it comes to it.
    const bool isAlong = rise <= kGraze * norm(point - from);
    const double t = isAlong ? point.x : from.x - (point.x - from.x) * from.y / rise;
    if (!(t >= -kAtRoot * length && t <= length * (1 + kAtRoot))) return false;
    if (t <= kGraze * length) graze(unfolding_->crossing(h).from(), true, backwards);
    if (t >= length * (1 - kGraze)) graze(unfolding_->crossing(h).to(), false, backwards);

    const Index behind = unfolding_->twin(h);
    if (behind == kNoIndex) return false;
    from = unfolding_->toTwin(h, from);
    point = {length - std::clamp(t, 0.0, length), 0};
    const Crossing c = unfolding_->crossing(behind);
    const Vec2 apex = c.apex();
    const double side = std::max(c.leftLength(), c.rightLength());
    const Index apexVertex = c.apexVertex();
    if (norm(from - apex) <= kAtRoot * side && propagation_->distance(apexVertex) == sigma) {
      root = {};
      root.vertex = apexVertex;
      root.direction = unfolding_->directionOf(Unfolding::previous(behind),
                                               unfolding_->toPrevious(behind, point));
      return true;
    }
    if (sigma == 0) {
      for (const Propagation::Origin& origin : propagation_->origins()) {
        if (origin.face != faceOfSide(behind)) continue;
        const Vec2 place = unfolding_->toFrame(3 * origin.face, behind, origin.place);
        if (norm(from - place) > kAtRoot * (side + c.length())) continue;
        const Vec2 towards = unfolding_->toFrame(behind, 3 * origin.face, point) - origin.place;
        backwards.push_back(atOrigin(origin, towards));
        root = {};
        return true;
      }
    }
    // The line leaves the face on the far side of the apex from where that lies.
    const Vec2 line = from - point, toApex = apex - point;
    const double beside = cross(line, toApex);
    bool apexOnLeft = beside > 0;
    if (std::fabs(beside) <= kGraze * norm(line) * side) {
      if (choices.made < Choices::kMost && choices.other[choices.made]) apexOnLeft = !apexOnLeft;
      ++choices.made;
    }
    h = apexOnLeft ? Unfolding::next(behind) : Unfolding::previous(behind);
    from = unfolding_->toFrame(behind, h, from);
    point = unfolding_->toFrame(behind, h, point);
    if (!(from.y <= kGraze * (norm(from) + length))) return false;
  }
  return false;
}

/// A path passes a vertex that it touches: as if it went through it, as far to one side as it can.
void PathOrder::graze(Index vertex, bool onLeft, BentPath& backwards) const {
  if (!bends(vertex) || propagation_->isSource(vertex)) return;
  if (!backwards.empty() && backwards.back().vertex == vertex) return;
  backwards.push_back({vertex, onLeft ? kPi : roundAngle(vertex) - kPi});
}

/// Whether a path turns at a vertex that it passes, and does not go straight on along one side.
bool PathOrder::turnsAt(const Bend& bend) const {
  return bend.turn > kPi + kAlike && bend.turn < roundAngle(bend.vertex) - kPi - kAlike;
}

bool PathOrder::runBeside(const BentPath& a, const BentPath& b) const {
  const auto rounds = [&](const Bend& bend) {  // at p, directions come round to 0
    if (bend.vertex == kNoIndex) return 2 * kPi;
    return unfolding_->boundary(bend.vertex) ? roundAngle(bend.vertex)
                                             : unfolding_->totalAngle(bend.vertex);
  };
  std::size_t i = 0, k = 0;
  for (;; ++i, ++k) {
    // Vertices that are only passed do not count.
    while (i > 0 && i < a.size() && !turnsAt(a[i])) ++i;
    while (k > 0 && k < b.size() && !turnsAt(b[k])) ++k;
    if (i >= a.size() || k >= b.size()) return i >= a.size() && k >= b.size();
    if (a[i].vertex != b[k].vertex) return false;
    const double apart = std::fabs(a[i].turn - b[k].turn);
    if (apart > kAlike && (i > 0 || rounds(a[0]) - apart > kAlike)) return false;
  }
}

bool PathOrder::liesBetween(const BentPath& path, const BentPath& a, const BentPath& b) {
  if (a.empty() || b.empty()) return false;
  const bool isRight = leavesRightOf(a, b);
  const BentPath &right = isRight ? a : b, &left = isRight ? b : a;
  const bool isWithin = leavesRightOf(right, path) && leavesRightOf(path, left);
  const bool isOutside = leavesRightOf(path, right) || leavesRightOf(left, path);
  return left[0].turn - right[0].turn > kAlike ? isOutside : isWithin;
}

bool PathOrder::bends(Index vertex) const {
  return unfolding_->boundary(vertex) || unfolding_->totalAngle(vertex) > 2 * kPi + kBending;
}

double PathOrder::roundAngle(Index vertex) const {
  return unfolding_->totalAngle(vertex) + (unfolding_->boundary(vertex) ? kBeyond : 0);
}

double PathOrder::turn(Index vertex, double direction) const {
  const double turn = direction - propagation_->arrivalDirection(vertex);
  return turn < 0 ? turn + roundAngle(vertex) : turn;
}

/// Directions at a source that is no vertex are those of its home (Unfolding::home).
Bend PathOrder::atOrigin(const Propagation::Origin& origin, Vec2 towards) const {
  const Index home = unfolding_->home(propagation_->source(origin.source));
  const bool isBehind = faceOfSide(home) != origin.face;
  const Index frame = isBehind ? unfolding_->twin(home) : home;
  // A vector turns with the frame: the image of its end less that of its start.
  Vec2 v = unfolding_->toFrame(3 * origin.face, frame, towards) -
           unfolding_->toFrame(3 * origin.face, frame, {0, 0});
  if (isBehind) v = -1 * v;
  const double direction = fullAngleOf(v.x, v.y);
  return {kNoIndex, direction > 2 * kPi - kSameTurn ? direction - 2 * kPi : direction};
}

}  // namespace girth
