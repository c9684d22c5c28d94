#include "solver/search/farthest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "infinity.h"
#include "solver/search/pseudosources.h"

namespace girth {

using geodesic::Crossing;
using geodesic::dot;
using geodesic::kTie;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

namespace {

/// The points of a line at which two sources are at one distance, as places along it.
/// `a`, `b`: the roots in a frame whose x axis is the line.
int meetingPlaces(Vec2 a, double sigmaA, Vec2 b, double sigmaB, std::array<double, 2>& places) {
  // With u = x − a.x, r = b.x − a.x, s = σ_b − σ_a:  √(u² + a.y²) = √((u − r)² + b.y²) + s.
  // Squared once:  2 r u + k = 2 s √(u² + a.y²)  with  k = s² + a.y² − b.y² − r²  (sign of s kept
  // by the test of the distance that follows); squared again: a quadratic in u.
  const double r = b.x - a.x, s = sigmaB - sigmaA;
  const double k = a.y * a.y - b.y * b.y - r * r + s * s;
  const double p = r * r - s * s, q = r * k / 2, c = k * k / 4 - s * s * a.y * a.y;
  // q² − p c, written so that equal sigmas, the usual case, leave exactly 0.
  const double quarter = k * k / 4 + p * a.y * a.y;
  if (quarter < 0) return 0;
  const double root = std::fabs(s) * std::sqrt(quarter);
  const double t = q >= 0 ? -q - root : -q + root;
  int count = 0;
  if (t != 0) places[count++] = a.x + c / t;
  if (p != 0) places[count++] = a.x + t / p;
  return count;
}

/// A search of cells: the most promising comes first; cells that cannot hold a farther point are
/// left out.
class Search {
 public:
  Search(const Propagation& propagation, FarthestPoint& best)
      : propagation_(propagation), best_(best), atLeast_(best.distance) {}

  /// A face to be searched, if its corners leave room for a farther point.
  void offer(Index face) {
    const double bound = propagation_.farthestWithin(face);
    if (bound > worthwhile()) push({bound, face, {}, {}, {}, Bound::Face});
  }

  /// False: the limit was met, or the work cancelled.
  bool run(std::size_t mostWork, const ExecutionContext& context) {
    const bool complete = searchCells(mostWork, context);
    if (sample_.distance > best_.distance * (1 + kTie)) best_ = sample_;
    return complete;
  }

  /// No point is farther than this, whether or not `run` came to its end.
  double atMost() const {
    const double rest = cells_.empty() ? 0 : cells_.front().bound;
    return std::max(best_.distance, rest);
  }

 private:
  /// Triples of so few sources are all tried.
  static constexpr std::size_t kFewSites = 8;
  /// More sources than these are not kept: some 60 MB.
  static constexpr std::size_t kMostKept = std::size_t{1} << 20;

  /// The reason for the bound of a cell.
  enum class Bound : std::uint8_t {
    Face,          ///< the corners of the face; its sources are yet to be found
    Radius,        ///< the distance of the middle, and the way from there
    Pseudosource,  ///< a source that sees the whole cell
  };

  /// A triangle of a face, in the frame of its first halfedge, with the sources that may be nearest
  /// to a point of it.
  struct Cell {
    double bound;  // the distance is nowhere greater
    Index face;
    std::array<Vec2, 3> corners;
    std::vector<Pseudosource> sources;
    Pseudosource nearest;  // to the middle, if it bounds the cell
    Bound from;
    bool operator<(const Cell& other) const { return bound < other.bound; }
  };

  /// The distance that a cell must exceed to be looked at: the maximum is no less, or a point
  /// there ties with the best.
  double worthwhile() const { return std::max(atLeast_, best_.distance * (1 + kTie)); }

  bool searchCells(std::size_t mostWork, const ExecutionContext& context) {
    while (!cells_.empty() && cells_.front().bound > worthwhile()) {
      if (work_ > mostWork || kept_ > kMostKept || context.cancelled()) return false;
      std::pop_heap(cells_.begin(), cells_.end());
      const Cell cell = std::move(cells_.back());
      cells_.pop_back();
      kept_ -= cell.sources.size();
      face_ = cell.face;
      if (cell.from == Bound::Face) {
        open(cell.face);
      } else {
        search(cell);
      }
    }
    return true;
  }

  void push(Cell cell) {
    kept_ += cell.sources.size();
    cells_.push_back(std::move(cell));
    std::push_heap(cells_.begin(), cells_.end());
  }

  void open(Index face) {
    std::vector<Pseudosource> sources;
    findPseudosources(propagation_, face, kInfinity, sources);
    add(cornersOf(propagation_.unfolding(), face), sources);
  }

  void search(const Cell& cell) {
    std::vector<Pseudosource> roots;
    if (differentRoots(cell.sources, kTie * best_.distance, kFewSites, roots)) {
      testTriples(roots, cell.sources);
      return;
    }
    // Many paths tie. Where the cell is so small that its middle is as far as any point of it, that
    // is the answer; otherwise it is halved.
    const Vec2 centre = middle(cell.corners);
    const double atCentre = distanceAmong(cell.sources, centre);
    if (cell.bound <= atCentre * (1 + kTie)) {
      accept(centre, atCentre);
      return;
    }
    const std::size_t from = sideToHalve(cell), to = (from + 1) % 3;
    const Vec2 half = 0.5 * (cell.corners[from] + cell.corners[to]);
    std::array<Vec2, 3> part = cell.corners;
    part[from] = half;
    add(part, cell.sources);
    part = cell.corners;
    part[to] = half;
    add(part, cell.sources);
  }

  static Vec2 middle(const std::array<Vec2, 3>& corners) {
    return (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
  }

  /// The side of a cell to be halved, which runs from this corner to the next: the longest; where a
  /// source bounds the cell, the longest in directions in which the distance from it changes.
  /// (Across a needle nothing does.)
  static std::size_t sideToHalve(const Cell& cell) {
    // How fast a convex function changes along a side shows at its ends.
    const auto change = [&](Vec2 corner, Vec2 side) {
      const Vec2 ray = corner - cell.nearest.root;
      const double length = norm(ray);
      return length > 0 ? std::fabs(dot(ray, side)) / length : norm(side);
    };
    std::size_t side = 0;
    double most = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 a = cell.corners[k], b = cell.corners[(k + 1) % 3];
      const double extent = cell.from == Bound::Pseudosource
                                ? std::max(change(a, b - a), change(b, b - a))
                                : norm(b - a);
      if (extent > most) {
        most = extent;
        side = k;
      }
    }
    return side;
  }

  void add(const std::array<Vec2, 3>& corners, const std::vector<Pseudosource>& sources) {
    const Vec2 centre = middle(corners);
    double radius = 0;
    for (const Vec2 corner : corners) radius = std::max(radius, norm(corner - centre));
    work_ += sources.size();
    const Pseudosource* nearest = nullptr;
    const double atCentre = distanceAmong(sources, centre, &nearest);
    if (atCentre > atLeast_ && std::isfinite(atCentre)) {
      atLeast_ = atCentre;
      sample_ = {atCentre, 3 * face_, centre};
    }
    if (atCentre + radius <= worthwhile()) return;
    const double slack = kTie * best_.distance;
    const double margin = radius * (1 + 1e-6) + slack;
    // The distance changes by no more than the way walked. The distance from one root is convex:
    // where its window covers the whole cell, it is nowhere farther than from the farthest corner.
    Cell cell{atCentre + radius, face_, corners, {}, {}, Bound::Radius};
    if (nearest != nullptr && std::all_of(corners.begin(), corners.end(), [&](Vec2 corner) {
          return nearest->meetsDisk(corner, slack);
        })) {
      double farthest = 0;
      for (const Vec2 corner : corners) farthest = std::max(farthest, nearest->distanceTo(corner));
      if (farthest < cell.bound) {
        cell.bound = farthest;
        cell.from = Bound::Pseudosource;
        cell.nearest = *nearest;
      }
    }
    if (cell.bound <= worthwhile()) return;
    for (const Pseudosource& source : sources) {
      if (source.distanceTo(centre) <= atCentre + 2 * margin && source.meetsDisk(centre, margin)) {
        cell.sources.push_back(source);
      }
    }
    push(std::move(cell));
  }

  /// Distance of a point from the sources that see it, and the nearest of these if asked for.
  double distanceAmong(const std::vector<Pseudosource>& sources, Vec2 q,
                       const Pseudosource** nearest = nullptr) const {
    double distance = std::numeric_limits<double>::infinity();
    for (const Pseudosource& source : sources) {
      const Vec2 ray = q - source.root;
      const double squared = dot(ray, ray), rest = distance - source.sigma;
      if (rest > 0 && squared < rest * rest && source.meetsDisk(q, kTie * best_.distance)) {
        distance = source.sigma + std::sqrt(squared);
        if (nearest != nullptr) *nearest = &source;
      }
    }
    return distance;
  }

  /// `all`: of the cell, with every window of the roots.
  void testTriples(const std::vector<Pseudosource>& sources, const std::vector<Pseudosource>& all) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          std::array<Vec2, 2> points;
          const int count = meetingPoints(sources[i], sources[j], sources[k], points);
          for (int n = 0; n < count; ++n) test(points[n], sources[i], all);
        }
        testBoundaries(sources[i], sources[j], all);
      }
    }
  }

  /// On a boundary two paths are enough.
  void testBoundaries(const Pseudosource& a, const Pseudosource& b,
                      const std::vector<Pseudosource>& all) {
    const Unfolding& unfolding = propagation_.unfolding();
    for (Index h = 3 * face_; h < 3 * face_ + 3; ++h) {
      if (unfolding.twin(h) != kNoIndex) continue;
      std::array<double, 2> places;
      const int count = meetingPlaces(unfolding.toFrame(3 * face_, h, a.root), a.sigma,
                                      unfolding.toFrame(3 * face_, h, b.root), b.sigma, places);
      for (int n = 0; n < count; ++n) {
        if (std::isfinite(places[n])) test(unfolding.toFrame(h, 3 * face_, {places[n], 0}), a, all);
      }
    }
  }

  /// A point at which paths meet that come from this source and others.
  void test(Vec2 meeting, const Pseudosource& source, const std::vector<Pseudosource>& sources) {
    work_ += sources.size();
    // A point that ties with a vertex is that vertex, found again beside it.
    const double least = best_.distance * (1 + kTie), there = source.distanceTo(meeting);
    if (!(there > least)) return;
    const auto within = withinFace(propagation_, face_, meeting);
    if (!within) return;
    // The sources may be out of sight from there, or the point outside the part of the face where
    // no others count: what decides is the true distance; first, cheaply, a bound to it.
    const double distance = distanceAmong(sources, *within);
    if (!(distance > least) ||
        std::fabs(distance - there) > norm(*within - meeting) + kTie * distance) {
      return;
    }
    geodesic::WindowNumber nearer;
    if (propagation_.findNearer(3 * face_, *within, distance * (1 - kTie), nearer)) return;
    accept(*within, distance);
  }

  /// A point of the face at its true distance.
  void accept(Vec2 q, double distance) {
    if (!(distance > best_.distance * (1 + kTie))) return;
    best_ = {distance, 3 * face_, q};
    atLeast_ = std::max(atLeast_, distance * (1 - kTie));
  }

  const Propagation& propagation_;
  FarthestPoint& best_;
  std::vector<Cell> cells_;  // a heap, the most promising on top
  double atLeast_;           // the maximum is known to be no less
  FarthestPoint sample_;     // the farthest of the middles looked at
  Index face_{0};            // the face that is searched
  std::size_t work_{0};      // sources looked at
  std::size_t kept_{0};      // sources of all cells
};

}  // namespace

FarthestPoint farthestPoint(const Propagation& propagation, std::size_t mostWork,
                            const ExecutionContext& context) {
  const Unfolding& unfolding = propagation.unfolding();
  FarthestPoint best;
  for (const Index v : propagation.reachedVertices()) {
    if (propagation.distance(v) > best.distance) {
      best = {propagation.distance(v), unfolding.outgoing(v), {0, 0}};
    }
  }

  // Each face once, at its first corner.
  Search search(propagation, best);
  for (const Index v : propagation.reachedVertices()) {
    const Index start = unfolding.outgoing(v);
    for (Index out = start; out != kNoIndex;) {
      const Index face = faceOfSide(out);
      if (out == 3 * face) search.offer(face);
      out = unfolding.turnLeft(out);
      if (out == start) break;
    }
  }
  best.complete = search.run(mostWork, context);
  best.atMost = search.atMost();
  return best;
}

double noPointIsFarther(const Propagation& propagation) {
  const Unfolding& unfolding = propagation.unfolding();
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  std::vector<double> distance(unfolding.vertexCount(), kUnknown);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](Index vertex, double length) {
    if (!(length < distance[vertex])) return;
    distance[vertex] = length;
    queue.emplace(length, vertex);
  };
  for (const Index v : propagation.reachedVertices()) reach(v, propagation.distance(v));
  for (const Propagation::Origin& origin : propagation.origins()) {
    for (Index h = 3 * origin.face; h < 3 * origin.face + 3; ++h) {
      reach(unfolding.crossing(h).from(),
            norm(unfolding.toFrame(3 * origin.face, h, origin.place)));
    }
  }
  double farthest = 0;
  while (!queue.empty()) {
    const auto [length, vertex] = queue.top();
    queue.pop();
    if (length > distance[vertex]) continue;
    for (const Index h : unfolding.fan(vertex)) {
      const Crossing c = unfolding.crossing(h);
      reach(c.to(), length + c.length());
      reach(c.apexVertex(), length + c.leftLength());
    }
  }
  // From the corner that is best for it, no point of a face is beyond the longer of its two sides.
  for (Index h = 0; h < unfolding.halfedgeCount(); h += 3) {
    const Crossing c = unfolding.crossing(h);
    const double bound =
        std::min({distance[c.from()] + std::max(c.length(), c.leftLength()),
                  distance[c.to()] + std::max(c.length(), c.rightLength()),
                  distance[c.apexVertex()] + std::max(c.leftLength(), c.rightLength())});
    if (std::isfinite(bound)) farthest = std::max(farthest, bound);
  }
  return farthest;
}

}  // namespace girth
