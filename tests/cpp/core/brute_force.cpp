#include "brute_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace girth::test {

namespace {

constexpr long double kWholePi = 3.14159265358979323846264338327950288L;
/// Rounding, as a share of an edge: lines that pass the end of an interval so nearly pass it.
constexpr long double kTouched = 1e-15L;
/// As a share of a loop's length: so near to a vertex its midpoint is looked at as if it lay there.
constexpr long double kAtVertex = 1e-8L;
/// Directions that differ by less are one.
constexpr long double kSameDirection = 1e-4L;
/// A vertex that misses more than this to a full angle is convex beyond all rounding.
constexpr long double kSurelyConvex = 1e-6L;

}  // namespace

BruteForce::BruteForce(const SurfaceMesh& mesh, Index source, double longest, std::size_t limit)
    : mesh_(mesh),
      source_(source),
      longest_(longest),
      limit_(limit),
      conesOfFace_(mesh.faceCount()) {
  measure();
  arrivals_.push_back({source, 0, 0, kNone, kNone});
  leave(0, 0, totals_[source]);
  while (!todo_.empty() && complete_) {
    const std::size_t cone = todo_.back();
    todo_.pop_back();
    grow(cone);
  }
}

/// Lengths and angles.
void BruteForce::measure() {
  const auto vector = [&](Halfedge h) {
    const Vec3 a = mesh_.position(mesh_.from(h)), b = mesh_.position(mesh_.to(h));
    return std::array<Real, 3>{Real(b.x) - a.x, Real(b.y) - a.y, Real(b.z) - a.z};
  };
  const auto dot = [](const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  lengths_.resize(mesh_.halfedgeCount());
  angles_.resize(mesh_.halfedgeCount());
  totals_.resize(mesh_.vertexCount(), 0);
  for (const Halfedge h : mesh_.halfedges()) {
    const auto u = vector(h), back = vector(SurfaceMesh::previous(h));
    const std::array<Real, 3> v{-back[0], -back[1], -back[2]};
    const std::array<Real, 3> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                     u[0] * v[1] - u[1] * v[0]};
    lengths_[h] = std::sqrt(dot(u, u));
    angles_[h] = std::atan2(std::sqrt(dot(normal, normal)), dot(u, v));
    totals_[mesh_.from(h)] += angles_[h];
  }
}

BruteForce::Point BruteForce::apex(Index h) const {
  const Real side = lengths_[SurfaceMesh::previous(Halfedge(h))];
  return {side * std::cos(angles_[h]), side * std::sin(angles_[h])};
}

BruteForce::Real BruteForce::directionOf(Index halfedge) const {
  Real angle = 0;
  Halfedge h = mesh_.outgoing(mesh_.from(Halfedge(halfedge)));
  for (; h != halfedge; h = mesh_.twin(SurfaceMesh::previous(h))) angle += angles_[h];
  return angle;
}

// All directions strictly between start and start + width: a cone for each corner, a path for each
// edge.
void BruteForce::leave(std::size_t arrival, Real start, Real width) {
  const Index v = arrivals_[arrival].vertex;
  const Real sigma = arrivals_[arrival].length, total = totals_[v];
  const bool all = arrival == 0;
  Halfedge h = mesh_.outgoing(Vertex(v));
  Real corner = 0;
  do {
    const Real opening = angles_[h];
    for (int turn = -2; turn <= 2; ++turn) {
      const Real from = start + turn * total - corner;
      if ((all || mesh_.isBoundary(Vertex(v))) && turn != 0) continue;
      if (all || (from < 0 && from + width > 0)) {
        const Halfedge twin = mesh_.twin(h);
        const Real back = twin == kNoIndex ? totals_[mesh_.to(h)] : directionOf(twin);
        arrive(mesh_.to(h), sigma + lengths_[h], back, kNone, arrival);
      }
      const Halfedge last = SurfaceMesh::previous(h);
      if (mesh_.twin(last) == kNoIndex &&
          (all || (from < opening && from + width > opening))) {  // the boundary on the far side
        arrive(mesh_.from(last), sigma + lengths_[last], 0, kNone, arrival);
      }
      const Real low = all ? 0 : std::max(from, Real{0});
      const Real high = all ? opening : std::min(from + width, opening);
      if (low >= high) continue;
      const Halfedge across = SurfaceMesh::next(h);
      if (mesh_.twin(across) == kNoIndex) continue;
      const Point root = apex(across);
      const Real length = lengths_[across];
      // Rays from the corner, turned from the side of h, onto the x axis on which `across` lies.
      const auto hit = [&](Real angle) {
        const Real heading = std::atan2(-root.y, -root.x) + angle;  // towards the start of `across`
        return root.x - root.y * std::cos(heading) / std::sin(heading);
      };
      const Real b0 = low <= 0 ? 0 : hit(low), b1 = high >= opening ? length : hit(high);
      cones_.push_back({mesh_.twin(across),
                        {length - root.x, -root.y},
                        sigma,
                        length - b1,
                        length - b0,
                        kNone,
                        arrival});
      todo_.push_back(cones_.size() - 1);
    }
    corner += opening;
    h = mesh_.twin(SurfaceMesh::previous(Halfedge(h)));
  } while (h != kNoIndex && h != mesh_.outgoing(Vertex(v)));
}

void BruteForce::arrive(Index vertex, Real length, Real direction, std::size_t cone,
                        std::size_t before) {
  if (length > longest_) return;
  arrivals_.push_back({vertex, length, direction, cone, before});
  const Real total = totals_[vertex];
  if (!mesh_.isBoundary(Vertex(vertex))) {
    if (total > 2 * kWholePi)
      leave(arrivals_.size() - 1, direction + kWholePi, total - 2 * kWholePi);
    return;
  }
  // Up to the boundaries and along them.
  const std::size_t number = arrivals_.size() - 1;
  if (direction + kWholePi < total) leave(number, direction + kWholePi, total - direction);
  if (direction - kWholePi > 0) leave(number, -kWholePi, direction);
}

void BruteForce::grow(std::size_t number) {
  if (cones_.size() > limit_) {
    complete_ = false;
    return;
  }
  const Cone cone = cones_[number];
  const Real nearest = std::clamp(cone.root.x, cone.b0, cone.b1) - cone.root.x;
  if (cone.sigma + std::hypot(nearest, cone.root.y) > longest_) return;
  const Index h = cone.halfedge;
  conesOfFace_[SurfaceMesh::faceOf(Halfedge(h))].push_back(number);

  const Point o = apex(h);
  const Real length = lengths_[h];
  // Where the line from the root to the apex crosses the halfedge decides who goes where.
  const Real split = cone.root.x - cone.root.y * (o.x - cone.root.x) / (o.y - cone.root.y);
  if (split > cone.b0 - kTouched * length && split < cone.b1 + kTouched * length) {
    const Real back = std::atan2(-o.y, -o.x);  // from the apex to the start of h
    const Real towards = std::atan2(cone.root.y - o.y, cone.root.x - o.x);
    arrive(mesh_.from(SurfaceMesh::previous(Halfedge(h))),
           cone.sigma + std::hypot(o.x - cone.root.x, o.y - cone.root.y),
           directionOf(SurfaceMesh::previous(Halfedge(h))) + (towards - back), number, kNone);
  }
  // Child through the side from A to B (in the plane of h), seen from outside: B is its start.
  const auto child = [&](Index side, Point start, Real sideLength, Point end, Real low, Real high) {
    if (mesh_.twin(Halfedge(side)) == kNoIndex) return;
    const Point u{(end.x - start.x) / sideLength, (end.y - start.y) / sideLength};
    const auto hit = [&](Real x) {  // the ray over x on the halfedge, along the side from its start
      const Real dx = x - cone.root.x, dy = -cone.root.y;
      return ((x - start.x) * dy - (0 - start.y) * dx) / (u.x * dy - u.y * dx);
    };
    const Real rx = cone.root.x - start.x, ry = cone.root.y - start.y;
    const Real t0 = std::clamp(hit(low), Real{0}, sideLength),
               t1 = std::clamp(hit(high), Real{0}, sideLength);
    if (t1 <= t0) return;
    cones_.push_back({mesh_.twin(Halfedge(side)),
                      {rx * u.x + ry * u.y, u.x * ry - u.y * rx},
                      cone.sigma,
                      t0,
                      t1,
                      number,
                      kNone});
    todo_.push_back(cones_.size() - 1);
  };
  const Halfedge left = SurfaceMesh::previous(Halfedge(h)), right = SurfaceMesh::next(Halfedge(h));
  if (cone.b0 < split) child(left, {0, 0}, lengths_[left], o, cone.b0, std::min(cone.b1, split));
  if (cone.b1 > split) {
    child(right, o, lengths_[right], {length, 0}, std::max(cone.b0, split), cone.b1);
  }
}

BruteForce::Real BruteForce::distanceInPlaneOf(Index halfedge, Point point) const {
  Real best = std::numeric_limits<Real>::infinity();
  eachPathTo(halfedge, point, [&](Real length, Point) { best = std::min(best, length); });
  return best;
}

double BruteForce::distanceTo(Index face, double x, double y) const {
  return static_cast<double>(distanceInPlaneOf(3 * face, {x, y}));
}

/// Visits the paths to a point of the face: their lengths, and the corner or root that they come
/// straight from, in the plane of the halfedge.
template <class Visit>
void BruteForce::eachPathTo(Index halfedge, Point point, Visit visit) const {
  const Index face = halfedge / 3;
  Index h = halfedge;
  Point q = point;
  // From the plane of h back to that of `halfedge`.
  const auto inFirstPlane = [&](Point p) {
    for (Index k = h; k != halfedge; k = SurfaceMesh::next(Halfedge(k))) p = inPlaneOfNext(k, p);
    return p;
  };
  do {
    for (const Arrival& arrival : arrivals_) {
      if (arrival.vertex == mesh_.from(Halfedge(h))) {
        visit(arrival.length + std::hypot(q.x, q.y), inFirstPlane({0, 0}));
      }
    }
    for (const std::size_t i : conesOfFace_[face]) {
      const Cone& cone = cones_[i];
      if (cone.halfedge != h) continue;
      const Real at = cone.root.x - cone.root.y * (q.x - cone.root.x) / (q.y - cone.root.y);
      const Real slack = kTouched * lengths_[h];
      if (at < cone.b0 - slack || at > cone.b1 + slack) continue;
      visit(cone.sigma + std::hypot(q.x - cone.root.x, q.y - cone.root.y), inFirstPlane(cone.root));
    }
    q = inPlaneOfNext(h, q);
    h = SurfaceMesh::next(Halfedge(h));
  } while (h != halfedge);
}

BruteForce::Point BruteForce::inPlaneOfNext(Index h, Point q) const {
  const Point o = apex(h);
  const Real length = lengths_[h], next = lengths_[SurfaceMesh::next(Halfedge(h))];
  const Real ux = (o.x - length) / next, uy = o.y / next;
  return {(q.x - length) * ux + q.y * uy, ux * q.y - uy * (q.x - length)};
}

double BruteForce::distanceTo(const SurfacePoint& point) const {
  if (point.kind == SurfacePoint::Kind::AtVertex) {
    Real best = std::numeric_limits<Real>::infinity();
    for (const Arrival& arrival : arrivals_) {
      if (arrival.vertex == point.element) best = std::min(best, arrival.length);
    }
    return static_cast<double>(best);
  }
  const Index h = point.kind == SurfacePoint::Kind::InFace ? 3 * point.element : point.element;
  const Point o = apex(h);
  const Real across = point.kind == SurfacePoint::Kind::InFace ? point.weights[2] : 0;
  return static_cast<double>(
      distanceInPlaneOf(h, {point.weights[1] * lengths_[h] + across * o.x, across * o.y}));
}

/// The point at a given length along a loop that returns to the source.
BruteForce::Place BruteForce::placeAlong(const Arrival& loop, Real length) const {
  Arrival arrival = loop;
  for (;;) {
    if (arrival.cone == kNone) {  // along an edge from the vertex before
      const Arrival& before = arrivals_[arrival.before];
      if (length >= before.length) {
        Halfedge h = mesh_.outgoing(Vertex(before.vertex));
        while (mesh_.to(h) != arrival.vertex) {
          const Halfedge left = SurfaceMesh::previous(h);
          h = mesh_.twin(left);
          // Along the boundary on the far side.
          if (h == kNoIndex) return {left, {arrival.length - length, 0}};
        }
        return {h, {length - before.length, 0}};
      }
      arrival = before;
      continue;
    }
    // Backwards through the cones: the line from the root to `end` lies in the plane of each.
    std::size_t number = arrival.cone;
    Point end = apex(cones_[number].halfedge);
    for (;;) {
      const Cone& cone = cones_[number];
      const Real dx = end.x - cone.root.x, dy = end.y - cone.root.y;
      const Real crossing = cone.root.x - cone.root.y * dx / dy;
      const Real atCrossing = cone.sigma + std::hypot(crossing - cone.root.x, cone.root.y);
      if (length >= atCrossing) {
        const Real share = (length - cone.sigma) / std::hypot(dx, dy);
        return {cone.halfedge, {cone.root.x + share * dx, cone.root.y + share * dy}};
      }
      if (cone.parent == kNone) {
        // The line starts at a vertex; in the face before the halfedge, nothing is in the way.
        const Arrival& start = arrivals_[cone.arrival];
        if (length < start.length) {
          arrival = start;
          break;
        }
        const Halfedge twin = mesh_.twin(Halfedge(cone.halfedge));
        const Real share = (length - cone.sigma) / (atCrossing - cone.sigma);
        const Real side = lengths_[twin];
        const Point from{side - cone.root.x, -cone.root.y}, to{side - crossing, 0};
        return {twin, {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}};
      }
      // The crossing in the plane of the parent: the apex side it lies on.
      const Cone& parent = cones_[cone.parent];
      const Halfedge twin = mesh_.twin(Halfedge(cone.halfedge));
      const Real t = (lengths_[twin] - crossing) / lengths_[twin];
      const Point o = apex(parent.halfedge);
      const Point right{lengths_[parent.halfedge], 0};
      const Point a = twin == SurfaceMesh::next(Halfedge(parent.halfedge)) ? right : o;
      const Point b = twin == SurfaceMesh::next(Halfedge(parent.halfedge)) ? o : Point{0, 0};
      end = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      number = cone.parent;
    }
  }
}

/// Whether paths arrive from more than two directions at a vertex that a loop's midpoint is next
/// to.
bool BruteForce::meetsOthers(Index vertex, Real reach) const {
  std::vector<Real> directions;
  for (const Arrival& arrival : arrivals_) {
    if (arrival.vertex == vertex && arrival.length <= reach)
      directions.push_back(arrival.direction);
  }
  std::sort(directions.begin(), directions.end());
  std::size_t groups = directions.empty() ? 0 : 1;
  for (std::size_t i = 1; i < directions.size(); ++i) {
    if (directions[i] - directions[i - 1] > kSameDirection) ++groups;
  }
  const bool wraps = groups > 1 && !mesh_.isBoundary(Vertex(vertex)) &&
                     directions.front() + totals_[vertex] - directions.back() <= kSameDirection;
  return groups - (wraps ? 1 : 0) > 2;
}

std::vector<BruteForce::Loop> BruteForce::loops() const {
  std::vector<Loop> loops;
  for (const Arrival& arrival : arrivals_) {
    if (arrival.vertex != source_ || !(arrival.length > 0)) continue;
    const Real half = arrival.length / 2;
    const Place middle = placeAlong(arrival, half);
    Loop loop{static_cast<double>(arrival.length), -1, -1, false};
    Index h = middle.halfedge;
    Point q = middle.point;
    Real shortest = std::numeric_limits<Real>::infinity(), other = shortest;
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh_.from(Halfedge(h));
      // A line that runs along edges cannot be followed back.
      loop.doubtful |= q.y < -kAtVertex * arrival.length;
      if (std::hypot(q.x, q.y) <= kAtVertex * arrival.length) {
        // Paths to a vertex may come through other faces alone.
        for (const Arrival& there : arrivals_) {
          if (there.vertex == v) shortest = std::min(shortest, there.length + std::hypot(q.x, q.y));
        }
        const Real missing = (mesh_.isBoundary(Vertex(v)) ? kWholePi : 2 * kWholePi) - totals_[v];
        loop.doubtful |= missing > kSurelyConvex;
        if (meetsOthers(v, half * (1 + 4 * kAtVertex))) loop.third = 0;
      }
      q = inPlaneOfNext(h, q);
      h = SurfaceMesh::next(Halfedge(h));
    }
    std::vector<std::pair<Real, Real>> paths;  // direction, length
    eachPathTo(middle.halfedge, middle.point, [&](Real length, Point from) {
      shortest = std::min(shortest, length);
      const Point back{from.x - middle.point.x, from.y - middle.point.y};
      // A vertex next to the midpoint has been looked at.
      if (std::hypot(back.x, back.y) <= kAtVertex * arrival.length) return;
      paths.emplace_back(std::atan2(back.y, back.x), length);
    });
    // A path as long as the halves is one of them; another comes from elsewhere.
    std::vector<Real> halves;
    for (const auto& [direction, length] : paths) {
      if (std::fabs(length / half - 1) < 1e-15L) halves.push_back(direction);
    }
    for (const auto& [direction, length] : paths) {
      const bool isHalf = std::any_of(halves.begin(), halves.end(), [&, d = direction](Real known) {
        const Real between = std::fabs(std::remainder(d - known, 2 * kWholePi));
        return between < kSameDirection;
      });
      if (!isHalf) other = std::min(other, length);
    }
    // Nor can one at whose midpoint not even its halves are found to arrive.
    loop.doubtful |= shortest > half * (1 + kAtVertex);
    loop.excess = static_cast<double>(1 - shortest / half);
    if (std::isfinite(other))
      loop.third = std::max(loop.third, static_cast<double>(1 - other / half));
    loops.push_back(loop);
  }
  std::sort(loops.begin(), loops.end(),
            [](const Loop& a, const Loop& b) { return a.length < b.length; });
  return loops;
}

std::optional<double> BruteForce::shortestLoop() const {
  for (const Loop& loop : loops()) {
    if (loop.excess <= 1e-9) return loop.length;
  }
  return std::nullopt;
}

}  // namespace girth::test
