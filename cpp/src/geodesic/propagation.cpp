#include "geodesic/propagation.h"

#include <algorithm>

#include "geodesic/min_max.h"
#include "geodesic/trimming.h"
#include "infinity.h"

namespace girth::geodesic {

namespace {

/// Whether a window from `begin` to `end`, but for `except`, may have a straight line of this
/// length to a point. Looks at roots alone, without square roots.
bool hasNearRoot(const WindowList& list, std::uint32_t begin, std::uint32_t end,
                 std::uint32_t except, Vec2 point, double length) {
  constexpr double kSlack = 1 + 1e-12;
  const WindowRun* run = list.newest;
  while (run != nullptr && run->begin >= end) run = run->older;
  for (; run != nullptr && run->begin + run->count > begin; run = run->older) {
    const double* const fields = run->fields();
    for (std::uint32_t i = std::max(begin, run->begin); i < end && i < run->begin + run->count;
         ++i) {
      const double* const at = fields + (i - run->begin);
      const Vec2 way = point - Vec2{at[0], at[run->stride]};
      const double most = length - at[2 * run->stride];
      if (most >= 0 && dot(way, way) <= most * most * kSlack && i != except) return true;
    }
  }
  return false;
}

/// Bounds as floats: never less, and never more.
float roundedUp(double a) { return static_cast<float>(a * (1 + 1e-7)); }
float roundedDown(double a) { return static_cast<float>(a * (1 - 1e-7)); }

Vec2 normalized(Vec2 a) { return (1 / norm(a)) * a; }

/// Paths that are no longer than this tie with one of this length.
double tied(double length) { return length * (1 + 2 * kRounding); }

/// Whether the path of a window, on a halfedge of this length, to a point of its face is shorter
/// than `length`.
bool reaches(const Window& w, double halfedge, Vec2 point, double length) {
  const double rest = length - w.sigma;
  return rest > 0 && dot(point - w.root, point - w.root) < rest * rest &&
         w.covers(halfedge, point) && w.pathTo(halfedge, point) < length;
}

/// Moves the near end of an interval away from a vertex as far as the path over it wins
/// (trimming.h). False: nothing is left.
bool trim(Vec2 root, double lead, double& gap) {
  const Contest<double> at = contest(root.x, root.y, lead);
  if (!(at.slope > 0)) return false;
  gap = larger(gap, at.excess / at.slope);
  return true;
}

}  // namespace

Propagation::Propagation(const Unfolding& unfolding, double bucketWidth)
    : unfolding_(&unfolding),
      kernel_(crossingKernels().front()),
      widthInEdges_(bucketWidth),
      queue_(bucketWidth * unfolding.meanEdgeLength()),
      distance_(unfolding.vertexCount(), kInfinity),
      reach_(unfolding.vertexCount()),
      arrival_(unfolding.vertexCount()),
      spread_(unfolding.vertexCount()),
      lists_(unfolding.halfedgeCount()) {}

/// Small components beside large ones would otherwise lie in one bucket as a whole.
double Propagation::bucketWidth() const {
  constexpr double kFarShorter = 1.0 / 16;
  double edge = unfolding_->meanEdgeLength();
  for (const SurfacePoint& source : sources_) {
    const double own =
        unfolding_->meanEdgeLengthAround(unfolding_->crossing(unfolding_->home(source)).from());
    if (own < kFarShorter * unfolding_->meanEdgeLength()) edge = lesser(edge, own);
  }
  return widthInEdges_ * edge;
}

void Propagation::clear() {
  constexpr std::size_t kAhead = 12;
  queue_.clear();
  for (std::size_t i = 0; i < reached_.size(); ++i) {
    if (i + kAhead < reached_.size()) prefetch(&arrival_[reached_[i + kAhead]]);
    const Index v = reached_[i];
    distance_[v] = kInfinity;
    reach_[v] = Reach{};
    arrival_[v] = Arrival{};
  }
  lists_.clear();
  pool_.reset();
  reached_.clear();
  open_.clear();
  origins_.clear();
  created_ = crossed_ = 0;
  passed_ = 0;
  keptBeyond_ = kInfinity;
  gaveUp_ = false;
}

/// Prefetches the memory that the next items of the queue need, since they follow one another on
/// the front, not in memory: early what belongs to an item, later what that refers to.
void Propagation::lookAhead() const {
  constexpr std::size_t kFar = 4, kNear = 2;
  if (const Index item = queue_.ahead(kFar, kNoIndex); item != kNoIndex) {
    if ((item & kVertexItem) != 0) {
      unfolding_->prefetchVertex(item & ~kVertexItem);
      prefetch(&arrival_[item & ~kVertexItem]);
    } else {
      unfolding_->prefetchCrossing(item);
      lists_.prefetchWord(item);
    }
  }
  if (const Index item = queue_.ahead(kNear, kNoIndex); item != kNoIndex) {
    if ((item & kVertexItem) != 0) {
      unfolding_->prefetchFan(item & ~kVertexItem);
    } else {
      const Crossing c = unfolding_->crossing(item);
      for (const Index vertex : {c.from(), c.to(), c.apexVertex()}) prefetch(&distance_[vertex]);
      for (const Index twin : {c.leftTwin(), c.rightTwin()}) {
        if (twin != kNoIndex) lists_.prefetchWord(twin);
      }
      constexpr std::size_t kHeaders = 6;  // a run's own, and as much of its windows
      if (const WindowRun* run = lists_[item].newest) prefetch(run, kHeaders);
    }
  }
}

void Propagation::startFrom(Index source) {
  const SurfacePoint& point = sources_[source];
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex: {
      Arrival* arrival = reach(point.element, 0);
      if (arrival == nullptr) return;  // a second source at the same vertex
      arrival->way = Arrival::Way::Source;
      arrival->before = source;
      break;
    }
    case SurfacePoint::Kind::OnEdge:
      startWithinFace(source, point.element);
      if (const Index t = unfolding_->twin(point.element); t != kNoIndex)
        startWithinFace(source, t);
      break;
    case SurfacePoint::Kind::InFace:
      startWithinFace(source, unfolding_->home(point));
      break;
  }
}

void Propagation::startWithinFace(Index source, Index halfedge) {
  const Vec2 place = *unfolding_->placeIn(halfedge, sources_[source]);
  const Index face = faceOfSide(halfedge);
  origins_.push_back({face, unfolding_->toFrame(halfedge, 3 * face, place), source});
  for (const Index side : {halfedge, Unfolding::next(halfedge), Unfolding::previous(halfedge)}) {
    const Vec2 p = unfolding_->toFrame(halfedge, side, place);
    const double distance = norm(p);
    if (Arrival* arrival = reach(unfolding_->crossing(side).from(), distance)) {
      arrival->way = Arrival::Way::Straight;
      arrival->before = source;
      arrival->corner = side;
      arrival->towards = (1 / distance) * p;
    }
  }
  for (const Index side : {halfedge, Unfolding::next(halfedge), Unfolding::previous(halfedge)}) {
    const Vec2 p = unfolding_->toFrame(halfedge, side, place);
    if (p.y > 0 && unfolding_->twin(side) != kNoIndex) {
      send(unfolding_->twin(side), unfolding_->toTwin(side, p), 0, 0, 0);
    }
  }
}

/// A path of this length reaches a vertex; where it is the best so far, the arrival to fill in.
Arrival* Propagation::reach(Index vertex, double distance) {
  if (!(distance < distance_[vertex] * (1 - kRounding))) return nullptr;
  if (goal_ != nullptr && !goal_->isInReachOf(vertex, distance)) return nullptr;
  if (std::isinf(distance_[vertex])) {
    reached_.push_back(vertex);
    if (keep_ == Keep::Front) open_.push_back(vertex);
  }
  distance_[vertex] = distance;
  reach_[vertex].spread = false;
  if (unfolding_->passable(vertex)) awaitSettling(vertex);
  return &arrival_[vertex];
}

void Propagation::awaitSettling(Index vertex) {
  reach_[vertex].settled = false;
  queue_.push(queue_.bucketOf(distance_[vertex]), vertex | kVertexItem);
}

/// The direction from which the best path comes in, whether the vertex is settled or not.
double Propagation::directionOfArrival(const Arrival& arrival) const {
  if (arrival.way != Arrival::Way::Window) {
    return unfolding_->directionOf(arrival.corner, arrival.towards);
  }
  const Index h = arrival.bundle.halfedge;
  return unfolding_->directionOf(Unfolding::previous(h),
                                 unfolding_->toPrevious(h, arrival.bundle.root));
}

/// A path of this length that is not the best reaches a vertex. Where it ties with the best one and
/// comes in a little beside it, paths go on from there as well. `direction()` is where it comes in.
template <class Direction>
void Propagation::tie(Index vertex, double distance, Direction direction) {
  if (!(distance <= tied(distance_[vertex])) || !unfolding_->saddle(vertex)) return;
  const Arrival& arrival = arrival_[vertex];
  // Nothing ties with a source, or where paths do not go on towards the goal.
  if (arrival.way == Arrival::Way::Source || arrival.way == Arrival::Way::None) return;
  double beside = direction() - directionOfArrival(arrival);
  if (!unfolding_->boundary(vertex)) {
    const double total = unfolding_->totalAngle(vertex);
    if (beside > total / 2) beside -= total;
    if (beside < -total / 2) beside += total;
  }
  if (std::fabs(beside) > kBeside) return;
  Spread spread = spreadAt(vertex);
  if (beside < spread.clockwise - kFanOverlap) {
    spread.clockwise = beside;
  } else if (beside > spread.counterclockwise + kFanOverlap) {
    spread.counterclockwise = beside;
  } else {
    return;
  }
  spread_[vertex] = spread;
  reach_[vertex].spread = true;
  if (reach_[vertex].settled) awaitSettling(vertex);
}

/// A path goes from the start of a halfedge along it.
void Propagation::reachAlong(Index halfedge) {
  const Crossing c = unfolding_->crossing(halfedge);
  const double distance = distance_[c.from()] + c.length();
  Arrival* arrival = reach(c.to(), distance);
  if (arrival == nullptr) {
    tie(c.to(), distance, [&] { return unfolding_->directionBack(halfedge); });
    return;
  }
  arrival->way = Arrival::Way::Edge;
  arrival->before = c.from();
  const Index twin = unfolding_->twin(halfedge), next = Unfolding::next(halfedge);
  // At the far end the edge is a halfedge of its own, or, along a boundary, the left side of the
  // last.
  arrival->corner = twin != kNoIndex ? twin : next;
  arrival->towards = twin != kNoIndex ? Vec2{1, 0} : unfolding_->crossing(next).left();
}

/// A path goes from the end of a halfedge, which lies on a boundary, along it to its start.
void Propagation::reachAgainst(Index halfedge) {
  const Crossing c = unfolding_->crossing(halfedge);
  const double distance = distance_[c.to()] + c.length();
  Arrival* arrival = reach(c.from(), distance);
  if (arrival == nullptr) {
    tie(c.from(), distance, [&] { return unfolding_->direction(halfedge); });
    return;
  }
  arrival->way = Arrival::Way::Edge;
  arrival->before = c.to();
  arrival->corner = halfedge;
  arrival->towards = {1, 0};
}

/// A run that has been filled in goes to a halfedge.
void Propagation::receive(Index halfedge, WindowRun* run, double nearest) {
  WindowList& list = lists_.open(halfedge);
  run->older = list.newest;
  run->begin = list.count;
  list.newest = run;
  list.count += run->count;
  created_ += run->count;
  const std::uint32_t bucket = queue_.bucketOf(nearest);
  if (bucket < list.bucket) {
    list.bucket = bucket;
    queue_.push(bucket, halfedge);
  }
}

CrossingResult Propagation::crossFace(Index halfedge) {
  const Crossing c = unfolding_->crossing(halfedge);
  WindowList& list = lists_.opened(halfedge);  // valid until windows are delivered
  const std::uint32_t first = list.entered, pending = list.count - first;
  list.entered = list.count;
  list.bucket = WindowList::kNotQueued;
  crossed_ += pending;

  float farthest = 0;
  if (keep_ == Keep::Front) {
    farthest = static_cast<float>(lesser(list.farthest, roundedUp(farthestBehind(c))));
    list.farthest = farthest;
  }
  std::uint32_t remaining = pending;
  for (const WindowRun* run = list.newest; remaining > 0; run = run->older) {
    remaining -= run->count;
    WindowPool::crossed(run, farthest);
  }
  if (gone(list)) return {0, 0, kInfinity, kInfinity, kInfinity, -1, 0, 0, false, false};

  const auto reserve = [&](WindowPool::Side side, Index twin) {
    return takesWindows(twin) ? pool_.reserve(side, pending) : nullptr;
  };
  WindowRun* const left = reserve(WindowPool::Side::Left, c.leftTwin());
  WindowRun* const right = reserve(WindowPool::Side::Right, c.rightTwin());
  const CrossingResult result = kernel_({c, list.newest, first, pending, distance_[c.from()],
                                         distance_[c.to()], distance_[c.apexVertex()]},
                                        left, right);
  if (result.apexEnd > 0) {
    list.apexBegin = std::min(list.apexBegin, first + result.apexBegin);
    list.apexEnd = first + result.apexEnd;
    std::uint8_t& windows = reach_[c.apexVertex()].windows;
    windows = static_cast<std::uint8_t>(
        std::min<std::uint32_t>(windows + result.apexEnd - result.apexBegin, Reach::kMany));
  }
  const auto deliver = [&](WindowPool::Side side, WindowRun* run, std::uint32_t windows, Index twin,
                           double nearest) {
    if (windows == 0) return;
    if (goal_ != nullptr && !goal_->isInReach(twin, nearest)) return;
    pool_.commit(side, run, windows, keep_ != Keep::Nothing);
    receive(twin, run, nearest);
  };
  deliver(WindowPool::Side::Left, left, result.leftCount, c.leftTwin(), result.leftNearest);
  deliver(WindowPool::Side::Right, right, result.rightCount, c.rightTwin(), result.rightNearest);
  if (result.apexEnd > 0) reachByWindows(halfedge, first, result);
  return result;
}

/// Some of the windows that have crossed a face reach the corner opposite.
void Propagation::reachByWindows(Index halfedge, std::uint32_t first,
                                 const CrossingResult& result) {
  const Crossing c = unfolding_->crossing(halfedge);
  const std::uint32_t begin = first + result.apexBegin, end = first + result.apexEnd;
  // A window that is nearer by rounding alone is no better arrival, but one that ties.
  std::uint32_t best = end;
  if (result.apexWindow >= 0) {
    if (Arrival* arrival = reach(c.apexVertex(), result.distanceApex)) {
      best = first + static_cast<std::uint32_t>(result.apexWindow);
      const Window w = window(halfedge, best);
      arrival->way = Arrival::Way::Window;
      arrival->bundle = {halfedge, w.root, w.sigma};
    }
  }
  if (best == begin && end == begin + 1) return;  // nothing else to tie with it
  const double longest = tied(distance_[c.apexVertex()]);
  if (std::isinf(longest)) return;
  // Windows are in the processor's cache here, and the vertex need not be.
  if (!hasNearRoot(lists_[halfedge], begin, end, best, c.apex(), longest)) return;
  if (!unfolding_->saddle(c.apexVertex())) return;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Window w = window(halfedge, i);
    const double distance = w.distanceTo(c.apex());
    if (distance > longest || !w.covers(c.length(), c.apex())) continue;
    tie(c.apexVertex(), distance, [&] {
      return unfolding_->directionOf(Unfolding::previous(halfedge),
                                     unfolding_->toPrevious(halfedge, w.root));
    });
  }
}

/// A single window begins at a halfedge; trimmed by the ends of it like any other.
void Propagation::send(Index halfedge, Vec2 root, double sigma, double gapFrom, double gapTo) {
  if (!takesWindows(halfedge)) return;
  const Crossing c = unfolding_->crossing(halfedge);
  if (!trim(root, distance_[c.from()] - sigma, gapFrom)) return;
  if (!trim({c.length() - root.x, root.y}, distance_[c.to()] - sigma, gapTo)) return;
  if (!(gapFrom + gapTo < c.length() * (1 - kSliver))) return;
  const double nearest = Window{root, sigma, gapFrom, gapTo}.nearest(c.length());
  if (goal_ != nullptr && !goal_->isInReach(halfedge, nearest)) return;
  WindowRun* run = pool_.reserve(WindowPool::Side::Left, 1);
  const double fields[WindowRun::kFields] = {root.x, root.y, sigma, gapFrom, gapTo};
  for (std::size_t i = 0; i < WindowRun::kFields; ++i) run->fields()[i * run->stride] = fields[i];
  pool_.commit(WindowPool::Side::Left, run, 1, true);
  receive(halfedge, run, nearest);
}

/// The best path to a vertex is known: note its direction and send windows into all directions in
/// which a path can go on straight.
void Propagation::settle(Index vertex) {
  Arrival& arrival = arrival_[vertex];
  reach_[vertex].settled = true;
  if (arrival.way == Arrival::Way::Source) {
    const Index first = unfolding_->outgoing(vertex);
    sendAround(first, nullptr, unfolding_->turnRight(first), nullptr);
    return;
  }
  if (arrival.way == Arrival::Way::Window) {
    const Index h = arrival.bundle.halfedge;
    arrival.corner = Unfolding::previous(h);
    arrival.towards = normalized(unfolding_->toPrevious(h, arrival.bundle.root));
  }
  // Along a boundary, a flat vertex sends the path on too: no window need see past it.
  if (unfolding_->saddle(vertex) ||
      (unfolding_->boundary(vertex) && unfolding_->passable(vertex))) {
    fanBehind(vertex);
  }
}

/// Sends windows from a vertex into the directions that leave π or more to the path that comes in.
void Propagation::fanBehind(Index vertex) {
  Arrival& arrival = arrival_[vertex];
  const Vec2 onwards = -1 * arrival.towards;
  const Spread spread = spreadAt(vertex);

  const std::span<const Index> fan = unfolding_->fan(vertex);
  const std::size_t last = fan.size() - 1;
  const bool open = unfolding_->boundary(vertex);
  std::size_t arrived = 0;
  while (fan[arrived] != arrival.corner) ++arrived;

  // The ray that leaves π on its right: going round to the left, from face to face, until one holds
  // it. The vector is turned along, so that the angles add up by themselves.
  std::size_t at = arrived;
  Index leftFace = kNoIndex;
  Vec2 leftRay = turnedBack(onwards, {1, kFanOverlap - spread.clockwise});
  do {
    leftRay = turnedBack(leftRay, unfolding_->left(fan[at]));
    if (at == last && open) {
      if (leftRay.x > 0 && std::fabs(leftRay.y) <= kFlatAngle) {
        reachAgainst(Unfolding::previous(fan[at]));  // along the boundary
      }
      leftFace = kNoIndex;
      break;
    }
    at = at == last ? 0 : at + 1;
    leftFace = fan[at];
  } while (cross(leftRay, unfolding_->left(fan[at])) < 0);
  if (leftFace != kNoIndex) unfolding_->prefetchCrossing(leftFace);

  // The ray that leaves π on its left, in the same way.
  at = arrived;
  Index rightFace = kNoIndex;
  Vec2 rightRay = turned(onwards, {1, kFanOverlap + spread.counterclockwise});
  do {
    if (at == 0 && open) {
      if (rightRay.x > 0 && std::fabs(rightRay.y) <= kFlatAngle) reachAlong(fan[0]);
      rightFace = kNoIndex;
      break;
    }
    at = at == 0 ? last : at - 1;
    rightFace = fan[at];
    rightRay = turned(rightRay, unfolding_->left(fan[at]));
  } while (rightRay.y < 0);

  if (open) {
    // Between the incoming path and the boundary on either side.
    if (leftFace != kNoIndex) sendAround(leftFace, &leftRay, kNoIndex, nullptr);
    if (rightFace != kNoIndex) {
      sendAround(unfolding_->outgoing(vertex), nullptr, rightFace, &rightRay);
    }
    return;
  }
  arrival.onwardsFrom = leftFace;
  arrival.onwardsTo = rightFace;
  sendAround(leftFace, &leftRay, rightFace, &rightRay);
}

/// Sends windows through the faces of a vertex from `first`, from ray `low` on, round to `last`, up
/// to ray `high`; kNoIndex: as far as the boundary.
void Propagation::sendAround(Index first, const Vec2* low, Index last, const Vec2* high) {
  for (Index h = first; h != kNoIndex; h = unfolding_->turnLeft(h)) {
    sendThrough(h, h == first ? low : nullptr, h == last ? high : nullptr);
    if (h == last) return;
  }
}

/// Sends a window from the vertex where a halfedge starts through its face, between two rays given
/// in its frame; null: the side of the face.
void Propagation::sendThrough(Index halfedge, const Vec2* low, const Vec2* high) {
  const Crossing c = unfolding_->crossing(halfedge);
  // A ray that the overlap has moved beyond a side of the face takes that side along.
  const bool fromSide = low == nullptr || low->y <= 0;
  const bool toSide = high == nullptr || cross(*high, c.left()) <= 0;
  if (fromSide) reachAlong(halfedge);
  if (c.leftTwin() == kNoIndex) {
    if (toSide) reachAgainst(Unfolding::previous(halfedge));
  } else if (high != nullptr && toSide) {
    reachAlong(c.leftTwin());
  }
  if (c.rightTwin() == kNoIndex) return;

  // A ray divides the opposite side in the ratio of the two triangles' areas.
  const auto share = [&](Vec2 ray) {  // from the end of the halfedge
    const double nearArea = c.length() * ray.y, farArea = cross(ray, c.apex());
    return Vec2{nearArea / (nearArea + farArea), farArea / (nearArea + farArea)};
  };
  const double gapTo = fromSide ? 0 : c.rightLength() * share(*low).x;
  const double gapFrom = toSide ? 0 : c.rightLength() * share(*high).y;
  const Pair<double> root = rootBeyond(c.length(), 0.0, c.right().x, c.right().y);
  send(c.rightTwin(), {c.rightLength() - root.x, root.y}, distance_[c.from()], gapFrom, gapTo);
}

void Propagation::entered(Index halfedge, std::vector<Window>& windows, std::size_t known) const {
  windows.resize(enteredCount(halfedge));
  if (windows.size() <= known) return;
  for (const WindowRun* run = lists_[halfedge].newest; run != nullptr; run = run->older) {
    if (run->begin >= windows.size()) continue;  // pending
    if (run->begin + run->count <= known) break;
    for (std::uint32_t i = 0; i < run->count; ++i) windows[run->begin + i] = run->window(i);
  }
}

PathEnd Propagation::pathTo(Index halfedge, Vec2 point) const {
  PathEnd best;
  const Index face = faceOfSide(halfedge);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing c = unfolding_->crossing(h);
    const Vec2 p = unfolding_->toFrame(halfedge, h, point);
    const double overCorner = distance_[c.from()] + norm(p);
    if (overCorner < best.distance) best = {overCorner, {}, c.from(), kNoIndex};
  }
  for (const Origin& origin : origins_) {
    if (origin.face != face) continue;
    const double distance = norm(unfolding_->toFrame(halfedge, 3 * face, point) - origin.place);
    if (distance < best.distance) best = {distance, {}, kNoIndex, origin.source};
  }
  // At a corner itself windows that reach it tie: the corner knows best whence.
  best.distance *= 1 - kRounding;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing c = unfolding_->crossing(h);
    const Vec2 p = unfolding_->toFrame(halfedge, h, point);
    eachEntered(h, [&](const Window& w) {
      if (w.distanceTo(p) > best.distance || !w.covers(c.length(), p)) return;
      const double distance = w.pathTo(c.length(), p);
      // Among windows that tie, the first one counts.
      if (distance < best.distance || (distance == best.distance && best.bundle.halfedge == h)) {
        best = {distance, {h, w.root, w.sigma}, kNoIndex, kNoIndex};
      }
    });
  }
  return best;
}

bool Propagation::isNearer(Index halfedge, Vec2 point, double length, WindowNumber window) const {
  if (window.number >= enteredCount(window.halfedge)) return false;
  return reaches(lists_[window.halfedge].window(window.number),
                 unfolding_->crossing(window.halfedge).length(),
                 unfolding_->toFrame(halfedge, window.halfedge, point), length);
}

bool Propagation::findNearer(Index halfedge, Vec2 point, double length, WindowNumber& by) const {
  const Index face = faceOfSide(halfedge);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Vec2 p = unfolding_->toFrame(halfedge, h, point);
    if (distance_[unfolding_->crossing(h).from()] + norm(p) < length) return true;
    const double whole = unfolding_->crossing(h).length();
    if (findEntered(h, [&](const Window& w, std::uint32_t number) {
          by = {h, number};
          return reaches(w, whole, p, length);
        })) {
      return true;
    }
  }
  for (const Origin& origin : origins_) {
    if (origin.face == face &&
        norm(unfolding_->toFrame(halfedge, 3 * face, point) - origin.place) < length) {
      return true;
    }
  }
  return false;
}

/// No point of the face is farther than this, as its corners show.
double Propagation::farthestBehind(const Crossing& c) const {
  return lesser(lesser(distance_[c.from()] + larger(c.length(), c.leftLength()),
                       distance_[c.to()] + larger(c.length(), c.rightLength())),
                distance_[c.apexVertex()] + larger(c.leftLength(), c.rightLength()));
}

/// Forgets the windows of faces that the front has passed.
void Propagation::forgetPassed() {
  // Points nearer than some vertex whose distance is final cannot be the farthest point either.
  double known = 0;
  std::size_t kept = 0;
  for (const Index v : open_) {
    if (distance_[v] <= queue_.frontier()) {
      known = larger(known, distance_[v]);
    } else {
      open_[kept++] = v;
    }
  }
  open_.resize(kept);
  known = lesser(known, keptBeyond_);
  passed_ = std::max(passed_, roundedDown(known));
  if (keep_ == Keep::Front) lists_.forget(passed_);
  if (keep_ != Keep::Everything) {
    pool_.forget(keep_ == Keep::Front ? passed_ : std::numeric_limits<float>::infinity());
  }
}

std::size_t Propagation::memoryBytes() const {
  return pool_.memoryBytes() + queue_.memoryBytes() + distance_.capacity() * sizeof(double) +
         arrival_.capacity() * sizeof(Arrival) + spread_.capacity() * sizeof(Spread) +
         reach_.capacity() * sizeof(Reach) + lists_.memoryBytes() +
         (reached_.capacity() + open_.capacity()) * sizeof(Index);
}

bool Propagation::passesStraight(Index vertex, double leaving) const {
  if (!settled(vertex)) return false;
  return isSource(vertex) ||
         unfolding_->straight(vertex, arrivalDirection(vertex), leaving, spreadAt(vertex));
}

}  // namespace girth::geodesic
