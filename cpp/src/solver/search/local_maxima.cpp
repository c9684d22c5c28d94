#include "solver/search/local_maxima.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "infinity.h"

namespace girth {

using geodesic::cross;
using geodesic::Crossing;
using geodesic::dot;
using geodesic::kTie;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

namespace {

/// Roots of which paths of one length are no farther apart than this share of it are one.
constexpr double kSameRoot = 1e-9;

/// A point lies in the triangle of three roots, up to this angle.
constexpr double kAngle = 1e-7;

double distanceAmong(const std::vector<Pseudosource>& sources, Vec2 q, double slack,
                     const Pseudosource*& nearest) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Pseudosource& source : sources) {
    const double there = source.distanceTo(q);
    if (there < distance && source.meetsDisk(q, slack)) {
      distance = there;
      nearest = &source;
    }
  }
  return distance;
}

bool isNearer(const std::vector<Pseudosource>& sources, Vec2 q, double distance) {
  for (const Pseudosource& source : sources) {
    if (source.distanceTo(q) < distance) return true;
  }
  return false;
}

/// Whether one of these sources sends a path of this length from a root to a point. Where two roots
/// and the point lie on one line, one whose paths do not come there meets others almost where the
/// right one does.
bool comesFrom(const Pseudosource& root, const std::vector<Pseudosource>& sources, Vec2 q,
               double length) {
  for (const Pseudosource& source : sources) {
    const double off = norm(source.root - root.root) + std::fabs(source.distanceTo(q) - length);
    if (off <= kSameRoot * length && source.meetsDisk(q, kSameRoot * length)) return true;
  }
  return false;
}

/// How far a point lies in a direction before all of a triangle: of a corner of it, before the
/// rest.
double before(Vec2 point, const std::array<Vec2, 3>& corners, Vec2 direction) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 corner : corners) {
    if (corner.x != point.x || corner.y != point.y) least = std::min(least, dot(corner, direction));
  }
  return least - dot(point, direction);
}

/// Whether there is a direction in which the distance from every source rises, in all of a triangle
/// but a corner that is a source itself. It is looked for from `direction` on, and turned towards
/// the rays that it leaves behind.
bool goOnTogether(const std::vector<Pseudosource>& sources, const std::array<Vec2, 3>& corners,
                  Vec2 direction) {
  constexpr int kMostTurns = 8;
  const Vec2 centre = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
  direction = (1 / norm(direction)) * direction;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const Pseudosource* behind = nullptr;
    double most = 0;
    for (const Pseudosource& source : sources) {
      const double by = -before(source.root, corners, direction);
      if (by < 0) continue;
      const Vec2 ray = centre - source.root;
      const double share = by / std::max(norm(ray), 1e-300);
      if (behind != nullptr && share <= most) continue;
      behind = &source;
      most = share;
    }
    if (behind == nullptr) return true;
    const Vec2 ray = centre - behind->root;
    const double length = norm(ray);
    if (!(length > 0)) return false;
    const Vec2 sum = direction + (1 / length) * ray;
    const double size = norm(sum);
    if (!(size > 1e-9)) return false;
    direction = (1 / size) * sum;
  }
  return false;
}

/// Whether the directions to three roots leave no gap of more than π.
bool isBetween(Vec2 a, Vec2 b, Vec2 c) {
  const double na = norm(a), nb = norm(b), nc = norm(c);
  const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  const double sab = kAngle * na * nb, sbc = kAngle * nb * nc, sca = kAngle * nc * na;
  return (ab >= -sab && bc >= -sbc && ca >= -sca) || (ab <= sab && bc <= sbc && ca <= sca);
}

}  // namespace

MaximaSearch::MaximaSearch(const Propagation& propagation)
    : propagation_(&propagation), pathOrder_(propagation) {
  const Unfolding& unfolding = propagation.unfolding();
  for (Index h = 0; h < unfolding.halfedgeCount(); ++h) {
    longestSide_ = std::max(longestSide_, unfolding.crossing(h).length());
  }
}

bool MaximaSearch::find(double low, double high, std::size_t mostWork,
                        const std::atomic<bool>* cancel, std::vector<LocalMaximum>& maxima) {
  const Unfolding& unfolding = propagation_->unfolding();
  low_ = low;
  high_ = high;
  maxima_ = &maxima;
  work_ = 0;
  // Distances beyond the frontier are bounds, or unknown yet.
  const auto isNear = [&](Index v) {
    const double distance = propagation_->distance(v);
    return distance >= low - longestSide_ && std::isfinite(distance);
  };
  const auto goesOn = [&] {
    return work_ <= mostWork && !(cancel != nullptr && cancel->load(std::memory_order_relaxed));
  };
  for (const Index v : propagation_->reachedVertices()) {
    if (!isNear(v)) continue;
    if (!goesOn()) return false;
    const double distance = propagation_->distance(v);
    if (distance >= low && distance <= high) tryVertex(v);
    // Each face once, at its first corner that is near.
    for (const Index out : unfolding.fan(v)) {
      Index first = 3 * faceOfSide(out);
      while (first < out && !isNear(unfolding.crossing(first).from())) ++first;
      if (out == first && !tryFace(faceOfSide(out), mostWork)) return false;
    }
  }
  // In a long face paths can meet before they reach a corner.
  for (const Index h : propagation_->reachedHalfedges()) {
    if (!goesOn()) return false;
    const Index begin = 3 * faceOfSide(h);
    bool isFirst = propagation_->enteredCount(h) > 0;
    for (Index side = begin; side < begin + 3 && isFirst; ++side) {
      const bool isEarlier = side < h && propagation_->enteredCount(side) > 0;
      isFirst = !isEarlier && !isNear(unfolding.crossing(side).from());
    }
    if (isFirst && !tryFace(faceOfSide(h), mostWork)) return false;
  }
  return true;
}

void MaximaSearch::tryVertex(Index vertex) {
  const Unfolding& unfolding = propagation_->unfolding();
  ++work_;
  if (unfolding.boundary(vertex)) return;
  if (unfolding.passable(vertex) && propagation_->reachedOnce(vertex)) return;
  const double distance = propagation_->distance(vertex);
  const Index out = unfolding.outgoing(vertex);
  findArrivals(*propagation_, out, {0, 0}, distance * (1 + kTogether), arrivals_);
  work_ += arrivals_.paths.size();
  if (arrivals_.surround(kNoGap)) add(distance, vertex, out, {0, 0});
}

/// Whether paths to the corner at which a halfedge starts go on into its face.
bool MaximaSearch::sendsInto(Index out) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const Index corner = unfolding.crossing(out).from();
  if (!propagation_->settled(corner)) return false;
  if (unfolding.boundary(corner) || propagation_->isSource(corner)) return true;
  if (!unfolding.saddle(corner)) return false;
  const geodesic::Arrival& arrival = propagation_->arrival(corner);
  if (arrival.onwardsFrom == kNoIndex) return true;
  for (Index at = arrival.onwardsFrom; at != out; at = unfolding.turnLeft(at)) {
    if (at == arrival.onwardsTo || at == kNoIndex) return false;
  }
  return true;
}

/// Whether there is a direction in which all paths into the face go on, so that the distance rises
/// in that direction everywhere. Most faces are seen through so.
bool MaximaSearch::allFromOneSide(Index face) {
  const Unfolding& unfolding = propagation_->unfolding();
  const std::array<Vec2, 3> corners = cornersOf(unfolding, face);
  for (const Propagation::Origin& origin : propagation_->origins()) {
    if (origin.face == face) return false;
  }
  std::array<double, 3> at{};
  for (Index k = 0; k < 3; ++k) {
    at[k] = propagation_->distance(unfolding.crossing(3 * face + k).from());
  }
  // The gradient of the field that is linear in the face.
  const Vec2 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
  const double d1 = at[1] - at[0], d2 = at[2] - at[0];
  const Vec2 rising{d1 * e2.y - d2 * e1.y, d2 * e1.x - d1 * e2.x};
  const double least =
      std::min({dot(corners[0], rising), dot(corners[1], rising), dot(corners[2], rising)});
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Vec2 corner = corners[h - 3 * face];
    if (!(before(corner, corners, rising) > 0) && sendsInto(h)) return false;
    if (propagation_->enteredCount(h) == 0) continue;
    work_ += propagation_->enteredCount(h) / 4;
    const Vec2 x = unfolding.toFrame(h, 3 * face, {1, 0}) - corners[h - 3 * face];
    const double along = dot(x, rising), across = cross(x, rising);
    const double limit = least - dot(corners[h - 3 * face], rising);
    if (propagation_->findEntered(h, [&](const geodesic::Window& w, std::uint32_t) {
          return !(w.root.x * along + w.root.y * across < limit);
        })) {
      return false;
    }
  }
  return true;
}

/// The maxima within a face. False: that is more work than `mostWork`.
bool MaximaSearch::tryFace(Index face, std::size_t mostWork) {
  if (propagation_->farthestWithin(face) < low_) return true;
  ++work_;
  if (allFromOneSide(face)) return true;
  findPseudosources(*propagation_, face, kInfinity, sources_);
  work_ += sources_.size();
  // Other corners only bound distances from above.
  bounds_.clear();
  std::erase_if(sources_, [&](const Pseudosource& source) {
    if (source.corner == kNoIndex || sendsInto(3 * face + source.corner)) return false;
    bounds_.push_back(source);
    return true;
  });
  face_ = face;
  tried_.clear();
  cells_.clear();
  cells_.push_back({cornersOf(propagation_->unfolding(), face), sources_});
  while (!cells_.empty()) {
    if (work_ > mostWork) return false;
    Cell cell = std::move(cells_.back());
    cells_.pop_back();
    tryCell(std::move(cell));
  }
  return true;
}

void MaximaSearch::tryCell(Cell cell) {
  work_ += cell.sources.size();
  const std::array<Vec2, 3>& corners = cell.corners;
  const Vec2 centre = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
  double radius = 0;
  for (const Vec2 corner : corners) radius = std::max(radius, norm(corner - centre));
  const Pseudosource* nearest = nullptr;
  const double slack = kTie * high_, usual = std::isfinite(slack) ? slack : kTie * low_;
  double atCentre = distanceAmong(cell.sources, centre, usual, nearest);
  const bool isReached = nearest != nullptr;
  if (!isReached) {
    // The centre is beyond the frontier, or between two windows; paths reach the rest of the cell.
    double farthest = 0;
    for (const Pseudosource& source : cell.sources) {
      farthest = std::max(farthest, source.distanceTo(centre));
      if (nearest == nullptr || source.distanceTo(centre) < nearest->distanceTo(centre)) {
        nearest = &source;
      }
    }
    if (nearest == nullptr) return;
    atCentre = std::min(farthest, high_);
  }
  for (const Pseudosource& bound : bounds_) atCentre = std::min(atCentre, bound.distanceTo(centre));
  if (atCentre + radius < low_ || atCentre - radius > high_) return;

  // Paths that can be nearest somewhere in the cell.
  const double margin = radius * (1 + 1e-6) + kTie * atCentre;
  const Vec2 rising = centre - nearest->root;
  std::vector<Pseudosource>& sources = cell.sources;
  sources.erase(std::remove_if(sources.begin(), sources.end(),
                               [&](const Pseudosource& source) {
                                 return source.distanceTo(centre) > atCentre + 2 * margin ||
                                        !source.meetsDisk(centre, margin);
                               }),
                sources.end());
  if (goOnTogether(sources, corners, rising)) return;
  roots_.clear();
  if (differentRoots(sources, kTie * atCentre, kFewSources + cell.halvings, roots_)) {
    tryTriples(roots_, cell, centre, margin);
    return;
  }
  if (radius <= kTie * atCentre) {
    if (isReached) tryPoint(centre, atCentre);
    return;
  }
  std::size_t from = 0;
  double longest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = norm(corners[(k + 1) % 3] - corners[k]);
    if (length > longest) {
      longest = length;
      from = k;
    }
  }
  const std::size_t to = (from + 1) % 3;
  const Vec2 half = 0.5 * (corners[from] + corners[to]);
  ++cell.halvings;
  Cell other = cell;
  cell.corners[from] = half;
  other.corners[to] = half;
  cells_.push_back(std::move(cell));
  cells_.push_back(std::move(other));
}

void MaximaSearch::tryTriples(const std::vector<Pseudosource>& roots, const Cell& cell, Vec2 centre,
                              double radius) {
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        std::array<Vec2, 2> points;
        const int count = meetingPoints(roots[i], roots[j], roots[k], points);
        work_ += 4;
        for (int n = 0; n < count; ++n) {
          const Vec2 q = points[n];
          if (!(norm(q - centre) <= radius) ||
              !isBetween(roots[i].root - q, roots[j].root - q, roots[k].root - q)) {
            continue;
          }
          const double there = roots[i].distanceTo(q), slack = kTie * there;
          const Pseudosource* nearest = nullptr;
          const double distance = distanceAmong(cell.sources, q, slack, nearest);
          if (!(std::fabs(distance - there) <= slack)) continue;
          if (comesFrom(roots[i], cell.sources, q, there) &&
              comesFrom(roots[j], cell.sources, q, there) &&
              comesFrom(roots[k], cell.sources, q, there) && !isNearer(bounds_, q, there - slack)) {
            tryPoint(q, distance);
          }
        }
      }
    }
  }
}

/// A point of the face, at the distance that its sources give.
void MaximaSearch::tryPoint(Vec2 point, double distance) {
  if (!(distance >= low_ && distance <= high_)) return;
  const Unfolding& unfolding = propagation_->unfolding();
  const auto within = withinFace(*propagation_, face_, point);
  if (!within) return;
  for (Index h = 3 * face_; h < 3 * face_ + 3; ++h) {
    const Crossing c = unfolding.crossing(h);
    const Vec2 corner = unfolding.toFrame(h, 3 * face_, {0, 0});
    if (norm(*within - corner) <= kTogether * c.length()) return;  // a vertex: tried as one
  }
  for (const Vec2 known : tried_) {
    if (norm(known - *within) <= kTogether * distance) return;
  }
  tried_.push_back(*within);
  geodesic::WindowNumber nearer;
  if (propagation_->findNearer(3 * face_, *within, distance * (1 - kTogether / 10), nearer)) return;
  findArrivals(*propagation_, 3 * face_, *within, distance * (1 + kTogether), arrivals_);
  work_ += arrivals_.paths.size();
  if (arrivals_.open || !arrivals_.surround(kNoGap)) return;
  add(distance, kNoIndex, 3 * face_, *within);
}

/// A maximum, with the arrivals there.
void MaximaSearch::add(double distance, Index vertex, Index halfedge, Vec2 point) {
  const std::vector<PathArrival>& paths = arrivals_.paths;
  const std::size_t count = paths.size();
  // The widest gap, before path `first`; of the others, the one in the middle.
  const auto gapBefore = [&](std::size_t i) {
    return i > 0 ? paths[i].direction - paths[i - 1].direction
                 : paths[0].direction + arrivals_.total - paths[count - 1].direction;
  };
  std::size_t first = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (gapBefore(i) > gapBefore(first)) first = i;
  }
  const double middle = (arrivals_.total - gapBefore(first)) / 2;
  std::size_t best = first;
  double bestOff = std::numeric_limits<double>::infinity(), direction = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % count;
    if (k > 0) direction += gapBefore(i);
    if (std::fabs(direction - middle) >= bestOff) continue;
    bestOff = std::fabs(direction - middle);
    best = i;
  }
  const PathHalf& half = paths[best].half;
  maxima_->push_back({distance, vertex != kNoIndex ? pathOrder_.ofArrivalAt(vertex, half)
                                                   : pathOrder_.ofArrival(half, halfedge, point)});
}

std::size_t MaximaSearch::memoryBytes() const {
  return (sources_.capacity() + roots_.capacity()) * sizeof(Pseudosource) +
         cells_.capacity() * sizeof(Cell) + tried_.capacity() * sizeof(Vec2) +
         arrivals_.paths.capacity() * sizeof(PathArrival);
}

}  // namespace girth
