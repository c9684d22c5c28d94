#include "geodesic/propagation.h"

#include <algorithm>

#include "geodesic/trimming.h"

namespace girth::geodesic {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Forgetting starts at so many bytes of windows: less fits into a core's own cache anyway.
constexpr std::size_t kRecycleFrom = std::size_t{1} << 20;

Vec2 normalized(Vec2 a) { return (1 / norm(a)) * a; }

/// Moves the near end of an interval away from a vertex as far as the path over it wins
/// (trimming.h). False: nothing is left.
bool trim(Vec2 root, double lead, double& gap) {
  const Contest<double> at = contest(root.x, root.y, lead);
  if (!(at.slope > 0)) return lead > 0 && at.excess <= 0;
  const double lost = at.excess / at.slope;
  if (lost > gap) gap = lost;
  return true;
}

}  // namespace

Propagation::Propagation(const Unfolding& unfolding, double bucketWidth)
    : unfolding_(&unfolding),
      kernel_(crossingKernel()),
      queue_(bucketWidth * unfolding.meanEdgeLength()),
      distance_(unfolding.vertexCount(), kInfinity),
      arrival_(unfolding.vertexCount()),
      lists_(unfolding.halfedgeCount()) {}

void Propagation::clear() {
  queue_.clear();
  for (const Index v : reached_) {
    distance_[v] = kInfinity;
    arrival_[v] = Arrival{};
  }
  for (const Index h : touched_) lists_[h] = WindowList{};
  pool_.reset();
  reached_.clear();
  touched_.clear();
  live_.clear();
  origins_.clear();
  created_ = crossed_ = 0;
  recycleAt_ = kRecycleFrom;
  gaveUp_ = false;
}

void Propagation::startFrom(Index source) {
  const SurfacePoint& point = sources_[source];
  switch (point.kind) {
    case SurfacePoint::Kind::Vertex: {
      Arrival* arrival = reach(point.element, 0);
      if (arrival == nullptr) return;  // a second source at the same vertex
      arrival->way = Arrival::Way::Source;
      arrival->before = source;
      break;
    }
    case SurfacePoint::Kind::Edge:
      startWithinFace(source, point.element);
      if (const Index t = unfolding_->twin(point.element); t != kNoIndex)
        startWithinFace(source, t);
      break;
    case SurfacePoint::Kind::Face:
      startWithinFace(source, unfolding_->home(point));
      break;
  }
}

void Propagation::startWithinFace(Index source, Index halfedge) {
  const Vec2 place = *unfolding_->placeIn(halfedge, sources_[source]);
  const Index face = SurfaceMesh::faceOf(halfedge);
  origins_.push_back({face, unfolding_->toFrame(halfedge, 3 * face, place), source});
  for (const Index side : {halfedge, Unfolding::next(halfedge), Unfolding::previous(halfedge)}) {
    const Vec2 p = unfolding_->toFrame(halfedge, side, place);
    const double distance = norm(p);
    if (Arrival* arrival = reach(unfolding_->crossing(side).from, distance)) {
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
  if (std::isinf(distance_[vertex])) reached_.push_back(vertex);
  distance_[vertex] = distance;
  Arrival& arrival = arrival_[vertex];
  arrival.settled = false;
  if (unfolding_->passable(vertex)) queue_.push(queue_.bucketOf(distance), vertex | kVertexItem);
  return &arrival;
}

/// A path goes from the start of a halfedge along it.
void Propagation::reachAlong(Index halfedge) {
  const Crossing& c = unfolding_->crossing(halfedge);
  Arrival* arrival = reach(c.to, distance_[c.from] + c.length);
  if (arrival == nullptr) return;
  arrival->way = Arrival::Way::Edge;
  arrival->before = c.from;
  const Index twin = unfolding_->twin(halfedge), next = Unfolding::next(halfedge);
  // At the far end the edge is a halfedge of its own, or, along a wall, the left side of the last.
  arrival->corner = twin != kNoIndex ? twin : next;
  arrival->towards = twin != kNoIndex ? Vec2{1, 0} : unfolding_->crossing(next).left;
}

/// A path goes from the end of a halfedge, which lies on a wall, along it to its start.
void Propagation::reachAgainst(Index halfedge) {
  const Crossing& c = unfolding_->crossing(halfedge);
  Arrival* arrival = reach(c.from, distance_[c.to] + c.length);
  if (arrival == nullptr) return;
  arrival->way = Arrival::Way::Edge;
  arrival->before = c.to;
  arrival->corner = halfedge;
  arrival->towards = {1, 0};
}

/// Room for so many windows at a halfedge, and what a vector store may write beyond them.
CrossingExit Propagation::exitTo(Index halfedge, std::uint32_t windows) {
  if (halfedge == kNoIndex) return {nullptr, 0};
  WindowList& list = lists_[halfedge];
  pool_.reserve(list, windows + kMostLanes - 1);
  return {list.data + list.count, list.capacity()};
}

/// So many windows have been written there.
void Propagation::receive(Index halfedge, std::uint32_t windows, double nearest) {
  if (halfedge == kNoIndex) return;
  WindowList& list = lists_[halfedge];
  if (windows == 0) {
    if (list.count == 0) pool_.release(list);
    return;
  }
  if (!list.touched) {
    list.touched = true;
    touched_.push_back(halfedge);
    if (keep_ == Keep::Front) live_.push_back(halfedge);
  }
  list.count += windows;
  created_ += windows;
  const std::uint32_t turn = queue_.bucketOf(nearest);
  if (turn < list.turn) {
    list.turn = turn;
    queue_.push(turn, halfedge);
  }
}

CrossingResult Propagation::crossFace(Index halfedge, WindowList& list) {
  const Crossing& c = unfolding_->crossing(halfedge);
  const std::uint32_t first = list.entered, waiting = list.count - first;
  list.entered = list.count;
  list.turn = WindowList::kNotQueued;
  crossed_ += waiting;
  const CrossingExit left = exitTo(c.leftTwin, waiting);
  const CrossingExit right = exitTo(c.rightTwin, waiting);
  const CrossingResult result =
      kernel_({&c, list.data + first, list.capacity(), waiting, distance_[c.from], distance_[c.to],
               distance_[c.apexVertex]},
              left, right);
  receive(c.leftTwin, result.leftCount, result.leftNearest);
  receive(c.rightTwin, result.rightCount, result.rightNearest);
  if (result.apexEnd > 0) {
    list.apexBegin = std::min(list.apexBegin, first + result.apexBegin);
    list.apexEnd = first + result.apexEnd;
  }
  if (result.apexWindow >= 0) {
    if (Arrival* arrival = reach(c.apexVertex, result.distanceApex)) {
      const Window w = list.window(first + static_cast<std::uint32_t>(result.apexWindow));
      arrival->way = Arrival::Way::Window;
      arrival->bundle = {halfedge, w.root, w.sigma};
    }
  }
  return result;
}

/// A single window begins at a halfedge; trimmed by the ends of it like any other.
void Propagation::send(Index halfedge, Vec2 root, double sigma, double gapFrom, double gapTo) {
  const Crossing& c = unfolding_->crossing(halfedge);
  if (!trim(root, distance_[c.from] - sigma, gapFrom)) return;
  if (!trim({c.length - root.x, root.y}, distance_[c.to] - sigma, gapTo)) return;
  if (!(gapFrom + gapTo < c.length * (1 - kSliver))) return;
  const double aside = std::clamp(root.x, gapFrom, c.length - gapTo) - root.x;
  const double nearest = sigma + std::sqrt(aside * aside + root.y * root.y);
  const CrossingExit exit = exitTo(halfedge, 1);
  const double fields[5] = {root.x, root.y, sigma, gapFrom, gapTo};
  for (std::size_t i = 0; i < 5; ++i) exit.windows[i * exit.stride] = fields[i];
  receive(halfedge, 1, nearest);
}

/// The best path to a vertex is known: note its direction and send windows into all directions in
/// which a path can go on straight.
void Propagation::settle(Index vertex) {
  Arrival& arrival = arrival_[vertex];
  arrival.settled = true;
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
  // Along a wall, a flat vertex sends the path on too: no window need see past it.
  if (unfolding_->saddle(vertex) ||
      (unfolding_->boundary(vertex) && unfolding_->passable(vertex))) {
    fanBehind(vertex);
  }
}

/// Sends windows from a vertex into the directions that leave π or more to the path that comes in.
void Propagation::fanBehind(Index vertex) {
  const Arrival& arrival = arrival_[vertex];
  const Vec2 onwards = -1 * arrival.towards;

  // The ray that leaves π on its right: going round to the left, from face to face, until one holds
  // it. The vector is turned along, so that the corners add up by themselves.
  Index leftFace = arrival.corner;
  Vec2 leftRay = onwards;
  do {
    leftRay = turnedBack(leftRay, unfolding_->crossing(leftFace).left);
    const Index next = unfolding_->turnLeft(leftFace);
    if (next == kNoIndex && leftRay.x > 0 && std::fabs(leftRay.y) <= kFlatAngle) {
      reachAgainst(Unfolding::previous(leftFace));  // along the wall
    }
    leftFace = next;
  } while (leftFace != kNoIndex && cross(leftRay, unfolding_->crossing(leftFace).left) < 0);
  leftRay = turnedBack(leftRay, {1, kFanOverlap});

  // And the one that leaves π on its left.
  Index rightFace = arrival.corner;
  Vec2 rightRay = onwards;
  do {
    const Index next = unfolding_->turnRight(rightFace);
    if (next == kNoIndex) {
      if (rightRay.x > 0 && std::fabs(rightRay.y) <= kFlatAngle) reachAlong(rightFace);
    } else {
      rightRay = turned(rightRay, unfolding_->crossing(next).left);
    }
    rightFace = next;
  } while (rightFace != kNoIndex && rightRay.y < 0);
  rightRay = turned(rightRay, {1, kFanOverlap});

  if (unfolding_->boundary(vertex)) {
    // Between the incoming path and the wall on either side.
    if (leftFace != kNoIndex) sendAround(leftFace, &leftRay, kNoIndex, nullptr);
    if (rightFace != kNoIndex) {
      sendAround(unfolding_->outgoing(vertex), nullptr, rightFace, &rightRay);
    }
  } else if (leftFace == unfolding_->turnLeft(rightFace) &&
             unfolding_->totalAngle(vertex) - 2 * kPi < kStraight) {
    reachAlong(leftFace);  // hardly a saddle: both rays run along one edge
  } else {
    sendAround(leftFace, &leftRay, rightFace, &rightRay);
  }
}

/// Sends windows through the faces of a vertex from `first`, from ray `low` on, round to `last`, up
/// to ray `high`; kNoIndex: as far as the wall.
void Propagation::sendAround(Index first, const Vec2* low, Index last, const Vec2* high) {
  for (Index h = first; h != kNoIndex; h = unfolding_->turnLeft(h)) {
    sendThrough(h, h == first ? low : nullptr, h == last ? high : nullptr);
    if (h == last) return;
  }
}

/// Sends a window from the vertex where a halfedge starts through its face, between two rays given
/// in its frame; null: the side of the face.
void Propagation::sendThrough(Index halfedge, const Vec2* low, const Vec2* high) {
  const Crossing& c = unfolding_->crossing(halfedge);
  // A ray that the overlap has moved beyond a side of the face takes that side along.
  const bool fromSide = low == nullptr || low->y <= 0;
  const bool toSide = high == nullptr || cross(*high, c.left) <= 0;
  if (fromSide) reachAlong(halfedge);
  if (c.leftTwin == kNoIndex) {
    if (toSide) reachAgainst(Unfolding::previous(halfedge));
  } else if (high != nullptr && toSide) {
    reachAlong(c.leftTwin);
  }
  if (c.rightTwin == kNoIndex) return;

  // A ray divides the opposite side in the ratio of the two triangles' areas.
  const auto share = [&](Vec2 ray) {  // from the end of the halfedge
    const double nearArea = c.length * ray.y, farArea = cross(ray, c.apex);
    return Vec2{nearArea / (nearArea + farArea), farArea / (nearArea + farArea)};
  };
  const double gapTo = fromSide ? 0 : c.rightLength * share(*low).x;
  const double gapFrom = toSide ? 0 : c.rightLength * share(*high).y;
  const Pair<double> root = rootBeyond(c.length, 0.0, c.right.x, c.right.y);
  send(c.rightTwin, {c.rightLength - root.x, root.y}, distance_[c.from], gapFrom, gapTo);
}

PathEnd Propagation::pathTo(Index halfedge, Vec2 point) const {
  PathEnd best;
  const Index face = SurfaceMesh::faceOf(halfedge);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing& c = unfolding_->crossing(h);
    const Vec2 p = unfolding_->toFrame(halfedge, h, point);
    const double overCorner = distance_[c.from] + norm(p);
    if (overCorner < best.distance) best = {overCorner, {}, c.from, kNoIndex};
  }
  for (const Origin& origin : origins_) {
    if (origin.face != face) continue;
    const double distance = norm(unfolding_->toFrame(halfedge, 3 * face, point) - origin.place);
    if (distance < best.distance) best = {distance, {}, kNoIndex, origin.source};
  }
  // At a corner itself windows that reach it tie: the corner knows best whence.
  best.distance *= 1 - kRounding;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing& c = unfolding_->crossing(h);
    const Vec2 p = unfolding_->toFrame(halfedge, h, point);
    for (std::uint32_t i = 0; i < lists_[h].entered; ++i) {
      const Window w = lists_[h].window(i);
      const double distance = w.distanceTo(p);
      if (distance < best.distance && w.covers(c.length, p)) {
        best = {distance, {h, w.root, w.sigma}, kNoIndex, kNoIndex};
      }
    }
  }
  return best;
}

/// Whether a window of that number exists, and its path to a point, given in the frame of its
/// halfedge, is shorter than a length.
bool Propagation::sees(WindowNumber window, Vec2 point, double length) const {
  const WindowList& list = lists_[window.halfedge];
  if (window.number >= list.entered) return false;
  const Window w = list.window(window.number);
  const double rest = length - w.sigma;
  return rest > 0 && dot(point - w.root, point - w.root) < rest * rest &&
         w.covers(unfolding_->crossing(window.halfedge).length, point);
}

bool Propagation::isNearer(Index halfedge, Vec2 point, double length, WindowNumber window) const {
  return sees(window, unfolding_->toFrame(halfedge, window.halfedge, point), length);
}

bool Propagation::findNearer(Index halfedge, Vec2 point, double length, WindowNumber& by) const {
  const Index face = SurfaceMesh::faceOf(halfedge);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Vec2 p = unfolding_->toFrame(halfedge, h, point);
    if (distance_[unfolding_->crossing(h).from] + norm(p) < length) return true;
    for (std::uint32_t i = 0; i < lists_[h].entered; ++i) {
      if (!sees({h, i}, p, length)) continue;
      by = {h, i};
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

double Propagation::farthestWithin(Index face) const {
  double farthest = kInfinity;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing& c = unfolding_->crossing(h);
    farthest = std::min(farthest, distance_[c.from] + std::max(c.length, c.leftLength));
  }
  return farthest;
}

void Propagation::recycle() {
  // What is nearer than some vertex whose distance is final cannot be the farthest point either.
  double known = 0;
  for (const Index v : reached_) {
    if (distance_[v] <= queue_.frontier()) known = std::max(known, distance_[v]);
  }
  const auto passed = [&](Index face) { return farthestWithin(face) < known * (1 - kTie); };
  std::size_t kept = 0;
  for (const Index h : live_) {
    WindowList& list = lists_[h];
    if (list.entered == list.count && passed(SurfaceMesh::faceOf(h))) {
      pool_.release(list);
      list.released = true;
      list.touched = true;
    } else {
      live_[kept++] = h;
    }
  }
  live_.resize(kept);
  recycleAt_ = std::max(kRecycleFrom, 2 * pool_.bytesInUse());
}

std::size_t Propagation::memoryBytes() const {
  return pool_.memoryBytes() + queue_.memoryBytes() + distance_.capacity() * sizeof(double) +
         arrival_.capacity() * sizeof(Arrival) + lists_.capacity() * sizeof(WindowList) +
         (reached_.capacity() + touched_.capacity() + live_.capacity()) * sizeof(Index);
}

}  // namespace girth::geodesic
