#include "girth/loop_search.h"

#include <algorithm>
#include <cmath>

namespace girth {

using geodesic::Arrival;
using geodesic::cross;
using geodesic::dot;
using geodesic::kTie;
using geodesic::kTouch;
using geodesic::norm;
using geodesic::Side;
using geodesic::Unfolding;
using geodesic::Vec2;
using geodesic::Window;

namespace {

/// Arrivals at a midpoint whose lengths differ by less than this share arrive together.
constexpr double kTogether = 1e-9;

bool longer(const LoopCandidate& a, const LoopCandidate& b) { return a.length > b.length; }

/// Directions, sorted, leave no gap of π or more on a circle of this total angle.
bool surrounds(std::vector<double>& directions, double total) {
  std::sort(directions.begin(), directions.end());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double next = i + 1 < directions.size() ? directions[i + 1] : directions[0] + total;
    if (next - directions[i] >= kPi - 1e-6) return false;
  }
  return directions.size() >= 3;
}

}  // namespace

void LoopSearch::start(const std::atomic<bool>* cancel) {
  cancel_ = cancel;
  candidates_.clear();
  found_ = cancelled_ = false;
}

bool LoopSearch::enough(double frontier) {
  while (!candidates_.empty() && candidates_.front().length / 2 * (1 + kTie) < frontier) {
    std::pop_heap(candidates_.begin(), candidates_.end(), longer);
    if (proven(candidates_.back())) {
      best_ = candidates_.back();
      found_ = true;
      return true;
    }
    candidates_.pop_back();
  }
  cancelled_ = cancel_ != nullptr && cancel_->load(std::memory_order_relaxed);
  return cancelled_;
}

void LoopSearch::onWindow(Index window, double tip) {
  const Index h = propagation_->window(window).halfedge;
  for (const Index side : {SurfaceMesh::next(h), SurfaceMesh::previous(h)}) {
    for (Index w = propagation_->firstWindow(side); w != kNoIndex;
         w = propagation_->window(w).sibling) {
      pair(window, w);
    }
  }
  if (std::isfinite(tip)) tryTip(window, tip);
}

void LoopSearch::onVertex(Index vertex) {
  const SurfaceMesh& mesh = propagation_->unfolding().mesh();
  Index h = mesh.outgoing(vertex);
  do {
    tryEdge(h);
    const Index opposite = SurfaceMesh::next(h);
    const Side& side = propagation_->unfolding().side(opposite);
    const Vec2 tip = propagation_->unfolding().side(h).start;
    for (Index w = propagation_->firstWindow(opposite); w != kNoIndex;
         w = propagation_->window(w).sibling) {
      const Window& window = propagation_->window(w);
      if (window.covers(side, tip)) tryTip(w, window.distanceTo(tip));
    }
    h = mesh.twin(SurfaceMesh::previous(h));
  } while (h != mesh.outgoing(vertex));
}

// Case 3: the line between the roots of two windows of one face.
void LoopSearch::pair(Index window, Index other) {
  const Window& a = propagation_->window(window);
  const Window& b = propagation_->window(other);
  const Side& sideA = propagation_->unfolding().side(a.halfedge);
  const Side& sideB = propagation_->unfolding().side(b.halfedge);
  if (!a.covers(sideA, b.root) || !b.covers(sideB, a.root)) return;

  const Vec2 line = b.root - a.root;
  const double distance = norm(line);
  // One root seen through two sides: both windows carry the same paths, past either side of a flat
  // vertex.
  if (!(distance > kTouch * sideA.length)) return;
  const double toMidpoint = (distance + b.sigma - a.sigma) / 2;
  if (!(toMidpoint >= 0 && toMidpoint <= distance)) return;
  const Vec2 q = a.root + (toMidpoint / distance) * line;
  const Index face = SurfaceMesh::faceOf(a.halfedge);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Side& side = propagation_->unfolding().side(h);
    if (cross(side.direction, q - side.start) < -kTouch * side.length) return;
  }
  propose(
      {a.sigma + distance + b.sigma, LoopCandidate::Ends::WindowWindow, window, other, face, q});
}

// Case 2: a window whose path runs to the opposite corner, which another path has reached before.
void LoopSearch::tryTip(Index window, double tip) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Window& w = propagation_->window(window);
  const Index out = SurfaceMesh::previous(w.halfedge);
  const Side& side = unfolding.side(out);
  const Arrival& corner = propagation_->arrival(side.from);
  if (!corner.settled) return;
  // q lies between the halfedge and the corner, as far from the corner as the paths differ by half.
  const double back = std::max(0.0, (tip - corner.distance) / 2);
  const Vec2 toRoot = w.root - side.start;
  const double length = norm(toRoot);
  if (back > length) return;
  const Vec2 q = side.start + (back / length) * toRoot;
  const Side& entry = unfolding.side(w.halfedge);
  if (cross(entry.direction, q - entry.start) < -kTouch * entry.length) return;
  const bool atSource = side.from == propagation_->source();
  if (!atSource &&
      !unfolding.straight(side.from, corner.direction, unfolding.directionTo(out, w.root))) {
    return;
  }
  propose({tip + corner.distance, LoopCandidate::Ends::WindowVertex, window, kNoIndex,
           SurfaceMesh::faceOf(w.halfedge), q});
}

// Case 1: the paths to both ends of an edge, and the edge.
void LoopSearch::tryEdge(Index halfedge) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Side& side = unfolding.side(halfedge);
  const Index a = side.from, b = unfolding.side(SurfaceMesh::next(halfedge)).from;
  const Arrival& atA = propagation_->arrival(a);
  const Arrival& atB = propagation_->arrival(b);
  if (!atA.settled || !atB.settled) return;
  const double along = (side.length + atB.distance - atA.distance) / 2;
  if (!(along >= -kTouch * side.length && along <= side.length * (1 + kTouch))) return;
  const Index source = propagation_->source();
  if (a != source && !unfolding.straight(a, atA.direction, unfolding.direction(halfedge))) return;
  if (b != source && !unfolding.straight(b, atB.direction, unfolding.direction(side.twin))) return;
  propose({atA.distance + side.length + atB.distance, LoopCandidate::Ends::VertexVertex, halfedge,
           kNoIndex, SurfaceMesh::faceOf(halfedge), side.at(std::clamp(along, 0.0, side.length))});
}

void LoopSearch::propose(const LoopCandidate& candidate) {
  // Most candidates that cannot be proven are seen through at once, from the corners alone.
  const double half = candidate.length / 2 * (1 - kTie);
  for (Index h = 3 * candidate.face; h < 3 * candidate.face + 3; ++h) {
    const Side& side = propagation_->unfolding().side(h);
    const double rest = half - propagation_->arrival(side.from).distance;
    const Vec2 d = candidate.midpoint - side.start;
    if (rest > 0 && rest * rest > dot(d, d)) return;
    // No geodesic passes a convex vertex, though its neighbours on one side may tend to that line.
    if (!propagation_->unfolding().passable(side.from) && norm(d) <= 2 * kTouch * side.length)
      return;
  }
  candidates_.push_back(candidate);
  std::push_heap(candidates_.begin(), candidates_.end(), longer);
}

bool LoopSearch::proven(const LoopCandidate& candidate) const {
  return propagation_->distanceTo(candidate.face, candidate.midpoint) >=
         candidate.length / 2 * (1 - kTie);
}

bool LoopSearch::closesUpon(const LoopCandidate& candidate) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const Vec2 q = candidate.midpoint;
  const double reach = candidate.length / 2 * (1 + kTogether);
  std::vector<double> directions;

  // At a vertex: the arrivals in all of its faces and along its edges.
  const Index face = candidate.face;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Side& side = unfolding.side(h);
    if (norm(q - side.start) > kTogether * side.length) continue;
    Index out = h;
    do {
      const Arrival& neighbour = propagation_->arrival(unfolding.side(SurfaceMesh::next(out)).from);
      if (neighbour.settled && neighbour.distance + unfolding.side(out).length <= reach) {
        directions.push_back(unfolding.direction(out));
      }
      const Index opposite = SurfaceMesh::next(out);
      const Vec2 tip = unfolding.side(out).start;
      for (Index i = propagation_->firstWindow(opposite); i != kNoIndex;
           i = propagation_->window(i).sibling) {
        const Window& w = propagation_->window(i);
        if (w.distanceTo(tip) <= reach && w.covers(unfolding.side(opposite), tip)) {
          directions.push_back(unfolding.directionTo(out, w.root));
        }
      }
      out = unfolding.side(SurfaceMesh::previous(out)).twin;
    } while (out != h);
    return surrounds(directions, unfolding.totalAngle(side.from));
  }

  // Inside a face or on an edge of it.
  const auto arrive = [&](Vec2 from) {
    const Vec2 d = from - q;
    const double angle = angleOf(d.x, std::fabs(d.y));
    directions.push_back(d.y < 0 ? 2 * kPi - angle : angle);
  };
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Side& side = unfolding.side(h);
    const Arrival& corner = propagation_->arrival(side.from);
    if (corner.settled && corner.distance + norm(q - side.start) <= reach) arrive(side.start);
    for (Index i = propagation_->firstWindow(h); i != kNoIndex;
         i = propagation_->window(i).sibling) {
      const Window& w = propagation_->window(i);
      if (w.distanceTo(q) <= reach && w.covers(side, q)) arrive(w.root);
    }
  }
  return surrounds(directions, 2 * kPi);
}

}  // namespace girth
