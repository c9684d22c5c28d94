#include "solver/search/loop_search.h"

#include <algorithm>
#include <cmath>

namespace girth {

using geodesic::Arrival;
using geodesic::cross;
using geodesic::Crossing;
using geodesic::CrossingResult;
using geodesic::dot;
using geodesic::kAim;
using geodesic::kShortest;
using geodesic::kShunned;
using geodesic::kTie;
using geodesic::kTouch;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;
using geodesic::Window;

namespace {

bool longer(const LoopCandidate& a, const LoopCandidate& b) { return a.length > b.length; }

}  // namespace

void LoopSearch::start(const std::atomic<bool>* cancel) {
  cancel_ = cancel;
  candidates_.clear();
  judged_.clear();
  for (Gathered& gathered : gathered_) gathered.halfedge = kNoIndex;
  nearer_ = {};
  pairs_ = 0;
  found_ = cancelled_ = false;
}

bool LoopSearch::enough(double frontier) {
  while (!interrupted() && !candidates_.empty() &&
         candidates_.front().length / 2 * (1 + kShortest) < frontier) {
    if (propagation_->windowsCrossed() + effort() > propagation_->budget()) return false;
    std::pop_heap(candidates_.begin(), candidates_.end(), longer);
    const bool isLoop = proven(candidates_.back());
    if (isLoop) best_ = candidates_.back();
    candidates_.pop_back();
    if (isLoop) return found_ = true;
  }
  return cancelled_;
}

bool LoopSearch::interrupted() {
  return cancelled_ = cancel_ != nullptr && cancel_->load(std::memory_order_relaxed);
}

void LoopSearch::onCrossing(Index halfedge, std::uint32_t first, const CrossingResult& result) {
  // A straight line from behind this halfedge to behind another side runs through that side.
  const Index next = Unfolding::next(halfedge), previous = Unfolding::previous(halfedge);
  if (result.towardsLeft && propagation_->enteredCount(previous) > 0) {
    pairAcross(halfedge, first, previous);
  }
  if (result.towardsRight && propagation_->enteredCount(next) > 0) {
    pairAcross(halfedge, first, next);
  }
  const Crossing c = propagation_->unfolding().crossing(halfedge);
  if (result.apexEnd > 0 && propagation_->settled(c.apexVertex())) {
    for (std::uint32_t i = first + result.apexBegin; i < first + result.apexEnd; ++i) {
      tryApex(halfedge, propagation_->window(halfedge, i));
    }
  }
  for (const Propagation::Origin& origin : propagation_->origins()) {
    if (origin.face != faceOfSide(halfedge)) continue;
    for (std::uint32_t i = first; i < propagation_->enteredCount(halfedge); ++i) {
      tryOrigin(halfedge, propagation_->window(halfedge, i), origin);
    }
  }
}

void LoopSearch::onVertex(Index vertex) {
  if (propagation_->isSource(vertex)) return;  // loops that meet there come later
  tryEdgesOnwards(vertex);
  if (propagation_->reachedOnce(vertex)) return;  // by the window of its own path
  for (const Index edge : propagation_->unfolding().fan(vertex)) {
    const Index opposite = Unfolding::next(edge);
    const auto [begin, end] = propagation_->apexWindows(opposite);
    for (std::uint32_t k = begin; k < end; ++k) {
      tryApex(opposite, propagation_->window(opposite, k));
    }
  }
}

// Case 3: the line between the roots of two windows of one face.
void LoopSearch::pairAcross(Index halfedge, std::uint32_t first, Index other) {
  const Unfolding& unfolding = propagation_->unfolding();
  const double length = unfolding.crossing(halfedge).length();
  const double otherLength = unfolding.crossing(other).length();
  const std::vector<Window>* others = nullptr;
  for (std::uint32_t i = first; i < propagation_->enteredCount(halfedge); ++i) {
    // Pairs that are left undone do not count: the propagation gives up, or is cancelled, next.
    if (interrupted() || effort() > propagation_->budget()) return;
    const Window a = propagation_->window(halfedge, i);
    // The window as seen from the other side: its root must lie beyond the face.
    const Vec2 root = unfolding.toFrame(halfedge, other, a.root);
    if (root.y <= 0) continue;
    if (others == nullptr) others = &windowsOf(other);
    pairs_ += others->size();
    const Vec2 from = unfolding.toFrame(halfedge, other, {a.gapFrom, 0}) - root;
    const Vec2 to = unfolding.toFrame(halfedge, other, {length - a.gapTo, 0}) - root;
    for (const Window& b : *others) {
      const Vec2 ray = b.root - root;
      if (cross(from, ray) <= Window::slack(from, ray) &&
          cross(to, ray) >= -Window::slack(to, ray) && b.covers(otherLength, root)) {
        pair(halfedge, a, other, b);
      }
    }
  }
}

/// All windows that have entered through a halfedge. Where they are many, only those that have come
/// since the last time are looked up: they lie far apart.
const std::vector<Window>& LoopSearch::windowsOf(Index halfedge) {
  auto& [gatheredOf, windows] = gathered_[halfedge % gathered_.size()];
  if (gatheredOf != halfedge) windows.clear();
  gatheredOf = halfedge;
  const std::size_t known = windows.size();
  propagation_->entered(halfedge, windows, known);
  pairs_ += kPairsPerWindow / 2 * (windows.size() - known);
  return windows;
}

void LoopSearch::pair(Index halfedge, const Window& a, Index other, const Window& b) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Crossing c = unfolding.crossing(halfedge);
  const Vec2 rootB = unfolding.toFrame(other, halfedge, b.root);
  const Vec2 line = rootB - a.root;
  const double distance = norm(line);
  // One root seen through two sides: both windows carry the same paths, past either side of a flat
  // vertex.
  if (!(distance > kTouch * c.length())) return;
  const double toMidpoint = (distance + b.sigma - a.sigma) / 2;
  if (!(toMidpoint >= 0 && toMidpoint <= distance)) return;
  const Vec2 q = a.root + (toMidpoint / distance) * line;
  const double length = a.sigma + distance + b.sigma;
  if (!worthwhile(length, halfedge, q)) return;
  propose({length,
           {{halfedge, a.root, a.sigma}, kNoIndex},
           {{other, b.root, b.sigma}, kNoIndex},
           halfedge,
           q});
}

/// The loop that a window and the path to a point of the face make, `atPoint` long; nothing where
/// there clearly is none.
std::optional<LoopCandidate> LoopSearch::pairWithPoint(Index halfedge, const Window& window,
                                                       Vec2 point, double atPoint,
                                                       Index vertex) const {
  const double length = propagation_->unfolding().crossing(halfedge).length();
  if (!window.covers(length, point)) return std::nullopt;
  const double tip = window.distanceTo(point);
  const Vec2 toRoot = window.root - point;
  const double reach = norm(toRoot);
  // q lies between the halfedge and the point, as far from that as the paths differ by half.
  const double back = std::max(0.0, (tip - atPoint) / 2);
  if (!(reach > kTouch * length) || back > reach) return std::nullopt;
  const Vec2 q = point + (back / reach) * toRoot;
  if (!worthwhile(tip + atPoint, halfedge, q)) return std::nullopt;
  return LoopCandidate{
      tip + atPoint, {{halfedge, window.root, window.sigma}, kNoIndex}, {{}, vertex}, halfedge, q};
}

// Case 2: a window whose path runs to the opposite corner, which another path has reached before.
void LoopSearch::tryApex(Index halfedge, const Window& window) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Crossing c = unfolding.crossing(halfedge);
  const Arrival& arrival = propagation_->arrival(c.apexVertex());
  if (arrival.way == Arrival::Way::Window && arrival.bundle.halfedge == halfedge &&
      arrival.bundle.root.x == window.root.x && arrival.bundle.root.y == window.root.y) {
    return;  // the path that reached the corner, once more
  }
  const auto candidate = pairWithPoint(halfedge, window, c.apex(),
                                       propagation_->distance(c.apexVertex()), c.apexVertex());
  if (!candidate) return;
  const Index out = Unfolding::previous(halfedge);
  const Vec2 towards = unfolding.toPrevious(halfedge, window.root);
  if (propagation_->passesStraight(c.apexVertex(), unfolding.directionOf(out, towards))) {
    propose(*candidate);
  }
}

// Tries a loop whose other end is p itself, inside the face or on a side of it.
void LoopSearch::tryOrigin(Index halfedge, const Window& window,
                           const Propagation::Origin& origin) {
  const Vec2 p = propagation_->unfolding().toFrame(3 * origin.face, halfedge, origin.place);
  if (const auto candidate = pairWithPoint(halfedge, window, p, 0, kNoIndex)) propose(*candidate);
}

// Case 1 for the edges of a settled vertex along which its path can go on. They are few: at a
// saddle those between the faces into which it goes on, and the sides of these, lest rounding
// decide.
void LoopSearch::tryEdgesOnwards(Index vertex) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Arrival& arrival = propagation_->arrival(vertex);
  if (arrival.onwardsFrom != kNoIndex) {
    for (Index edge = arrival.onwardsFrom; edge != arrival.onwardsTo;) {
      tryEdge(edge);
      edge = unfolding.turnLeft(edge);
    }
    tryEdge(arrival.onwardsTo);
    tryEdge(unfolding.turnLeft(arrival.onwardsTo));
    return;
  }
  const std::span<const Index> fan = unfolding.fan(vertex);
  for (const Index edge : fan) {
    if (propagation_->passesStraight(vertex, unfolding.direction(edge))) tryEdge(edge);
  }
  // The boundary on the far side.
  if (unfolding.boundary(vertex)) tryEdge(Unfolding::previous(fan.back()));
}

// Case 1: the paths to both ends of an edge, and the edge.
void LoopSearch::tryEdge(Index halfedge) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Crossing c = unfolding.crossing(halfedge);
  if (!propagation_->settled(c.from()) || !propagation_->settled(c.to())) return;
  // The path to one end that comes along the edge is no loop.
  const auto alongEdge = [&](Index vertex, Index other) {
    const Arrival& arrival = propagation_->arrival(vertex);
    return arrival.way == Arrival::Way::Edge && arrival.before == other;
  };
  if (alongEdge(c.from(), c.to()) || alongEdge(c.to(), c.from())) return;
  const double atFrom = propagation_->distance(c.from()), atTo = propagation_->distance(c.to());
  const double along = (c.length() + atTo - atFrom) / 2;
  if (!(along >= -kTouch * c.length() && along <= c.length() * (1 + kTouch))) return;
  const double length = atFrom + c.length() + atTo;
  const Vec2 q{std::clamp(along, 0.0, c.length()), 0};
  if (!worthwhile(length, halfedge, q)) return;
  if (!propagation_->passesStraight(c.from(), unfolding.direction(halfedge)) ||
      !propagation_->passesStraight(c.to(), unfolding.directionBack(halfedge))) {
    return;
  }
  propose({length, {{}, c.from()}, {{}, c.to()}, halfedge, q});
}

/// Most pairs are refuted at once: q lies outside the face, or is nearer over a corner. A midpoint
/// beyond a side belongs to the face there, and is judged among the windows of that face.
bool LoopSearch::worthwhile(double length, Index halfedge, Vec2 midpoint) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const double half = length / 2 * (1 - kShortest);
  for (const Index h : {halfedge, Unfolding::next(halfedge), Unfolding::previous(halfedge)}) {
    const Crossing c = unfolding.crossing(h);
    const Vec2 q = unfolding.toFrame(halfedge, h, midpoint);
    if (q.y < -std::min(kTouch * c.length(), kAim * length)) return false;
    const double rest = half - propagation_->distance(c.from());
    if (rest > 0 && rest * rest > dot(q, q)) return false;
    // No geodesic passes a convex vertex, though its neighbours on one side may tend to that line.
    if (norm(q) < kShunned * length && norm(q) < unfolding.leastPassing(c.from())) return false;
  }
  return true;
}

void LoopSearch::propose(const LoopCandidate& candidate) {
  candidates_.push_back(candidate);
  std::push_heap(candidates_.begin(), candidates_.end(), longer);
}

bool LoopSearch::proven(const LoopCandidate& candidate) {
  const Index face = faceOfSide(candidate.halfedge);
  if (propagation_->forgotten(face)) return false;
  const double half = candidate.length / 2 * (1 - kShortest);
  // On round shapes thousands of candidates fall one after the other to the same window.
  if (faceOfSide(nearer_.halfedge) == face &&
      propagation_->isNearer(candidate.halfedge, candidate.midpoint, half, nearer_)) {
    return false;
  }
  for (Index h = 3 * face; h < 3 * face + 3; ++h) pairs_ += propagation_->enteredCount(h);
  if (propagation_->findNearer(candidate.halfedge, candidate.midpoint, half, nearer_)) return false;
  if (isJudged(candidate)) return false;
  if (!judged_.empty() && judged_.back().length < candidate.length * (1 - kTie)) judged_.clear();
  judged_.push_back(candidate);
  return !closesUpon(candidate);
}

/// Whether the same loop has been judged, up to rounding. Where n windows of one root meet n of
/// another, the search meets one loop n² times.
bool LoopSearch::isJudged(const LoopCandidate& candidate) const {
  const double slack = kTie * candidate.length;
  const auto isSame = [&](const PathHalf& a, const PathHalf& b) {
    return a.vertex == b.vertex && a.bundle.halfedge == b.bundle.halfedge &&
           (a.bundle.halfedge == kNoIndex || norm(a.bundle.root - b.bundle.root) <= slack);
  };
  return std::any_of(judged_.begin(), judged_.end(), [&](const LoopCandidate& judged) {
    return judged.halfedge == candidate.halfedge &&
           norm(judged.midpoint - candidate.midpoint) <= slack &&
           isSame(judged.there, candidate.there) && isSame(judged.back, candidate.back);
  });
}

/// Whether the frontier closes at the midpoint from all sides at once: the paths that arrive there
/// leave no gap of π in which it could go on.
bool LoopSearch::closesUpon(const LoopCandidate& candidate) {
  findArrivals(*propagation_, candidate.halfedge, candidate.midpoint,
               candidate.length / 2 * (1 + kShortest), arrivals_);
  return arrivals_.surround(kFullGap) && (arrivals_.open || arrivals_.paths.size() >= 3);
}

}  // namespace girth
