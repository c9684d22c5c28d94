// Deliberately apart from the engine: its own windows, frames, queue, pairs and farthest point, all
// in the plainest form, so that agreement of the two means something.

#include "girth/study/naive_girth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <vector>

#include "mesh/angles.h"
#include "mesh/check_vertex.h"

namespace girth::study {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Lengths are compared up to this share.
constexpr double kTie = 1e-12;
/// Lines that miss a point by less than this share of their length meet it.
constexpr double kTolerance = 1e-12;
/// Places on an edge are known to this share of its length.
constexpr double kPlace = 1e-14;
/// So near to a convex vertex, as a share of the loop and of the edge that it crosses, no midpoint
/// is looked for: the line may pass it on the other side.
constexpr double kShunned = 4e-12;
/// The farthest point is bisected to this.
constexpr double kBisection = 2e-10;
/// Lengths that differ by less than this share are equal but for rounding, and their paths come in
/// beside one another by less than this angle.
constexpr double kRounding = 1e-14, kBeside = 1e-5;
/// Paths that leave a gap narrower than π by this leave no gap of π.
constexpr double kGap = 1e-4;
/// So near to a vertex, as a share of the distance, a point is next to it.
constexpr double kNearVertex = 1e-9;
/// So many windows take about 1 GB, and so many pairs of them a few seconds.
constexpr std::size_t kMostWindows = std::size_t{1} << 23, kMostPairs = std::size_t{1} << 28;
/// A vertex is convex if so much or more is missing to a full angle.
constexpr double kFlat = 1e-12;

struct Point {
  double x, y;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
double dotOf(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double crossOf(Point a, Point b) { return a.x * b.y - a.y * b.x; }
double lengthOf(Point a) { return std::sqrt(dotOf(a, a)); }

/// Shortest-path candidates that arrive at a halfedge from below and enter its face above. The
/// halfedge lies on the x axis from 0 to its length; the root has y < 0; the window is [b0, b1].
struct NaiveWindow {
  Index halfedge;
  Point root;
  double sigma, b0, b1;
};

class NaiveGirth {
 public:
  NaiveGirth(const SurfaceMesh& mesh, Index source, const ExecutionContext& context)
      : mesh_(mesh),
        context_(context),
        source_(source),
        distance_(mesh.vertexCount(), kInfinity),
        arrival_(mesh.vertexCount()),
        onHalfedge_(mesh.halfedgeCount()) {}

  Result<GirthValue> compute() {
    propagate();
    if (windows_.size() > kMostWindows) {
      return makeError(ErrorCode::LimitExceeded, source_,
                       "the naive method keeps more than 2^23 windows of this vertex");
    }
    if (pairs() > kMostPairs) {
      return makeError(ErrorCode::LimitExceeded, source_,
                       "the naive method tries more than 2^28 pairs of windows of this vertex");
    }
    testEdges();
    testWindowPairs();
    if (context_.cancelled()) return makeError(ErrorCode::Cancelled, source_, "cancelled");
    // A loop whose midpoint is the farthest point of a sphere is the antipodal case.
    const double farthestVertex = *std::max_element(
        distance_.begin(), distance_.end(),
        [](double a, double b) { return (std::isinf(a) ? -1 : a) < (std::isinf(b) ? -1 : b); });
    const Index component = mesh_.componentOf(Vertex(source_));
    const bool sphere = mesh_.genus(component) == 0 && mesh_.boundaryCount(component) < 2;
    if (best_ < kInfinity && (!sphere || best_ / 2 < farthestVertex * (1 - 1e-9))) {
      return GirthValue{best_, LoopKind::Loop};
    }
    const double farthest = farthestDistance(farthestVertex);
    if (best_ / 2 < farthest * (1 - 1e-9)) return GirthValue{best_, LoopKind::Loop};
    return GirthValue{2 * farthest, LoopKind::Antipodal};
  }

 private:
  // --- The plane of a halfedge
  // -------------------------------------------------------------------------

  /// The vertex opposite a halfedge, in the halfedge's plane.
  Point apex(Index h) const {
    const double side = mesh_.length(SurfaceMesh::previous(Halfedge(h))),
                 angle = mesh_.cornerAngle(Halfedge(h));
    return {side * std::cos(angle), side * std::sin(angle)};
  }
  Index apexVertex(Index h) const { return mesh_.from(SurfaceMesh::previous(Halfedge(h))); }

  /// The angle on both sides together of a straight line through a vertex: a boundary has one side.
  double straightAngle(Index v) const { return mesh_.isBoundary(Vertex(v)) ? kPi : 2 * kPi; }

  // --- Step 1: the distance field, all windows kept
  // ----------------------------------------------------

  struct Event {
    double distance;
    Index vertex;        // a vertex is reached, or ...
    std::size_t window;  // ... a window
    bool operator<(const Event& other) const { return distance > other.distance; }
  };

  void propagate() {
    distance_[source_] = 0;
    leaveVertex(source_, 0, mesh_.totalAngle(Vertex(source_)));
    while (!queue_.empty() && !context_.cancelled() && windows_.size() <= kMostWindows) {
      const Event event = queue_.top();
      queue_.pop();
      if (event.vertex == kNoIndex) {
        const NaiveWindow window = windows_[event.window];
        if (!dominated(window)) advance(window);
      } else if (event.distance == distance_[event.vertex]) {
        const Index v = event.vertex;
        const double total = mesh_.totalAngle(Vertex(v));
        const double first = arrival_[v].least + kPi - kTolerance;
        const double last = arrival_[v].most - kPi + kTolerance;
        if (mesh_.isBoundary(Vertex(v))) {
          leaveVertex(v, first, total - first + kTolerance);
          leaveVertex(v, -kTolerance, last + kTolerance);
        } else {
          leaveVertex(v, first, last + total - first);
        }
      }
    }
  }

  /// Whether a path over an end of the edge is shorter than the window everywhere (Xin and Wang
  /// 2009).
  bool dominated(const NaiveWindow& w) const {
    const double length = mesh_.length(Halfedge(w.halfedge));
    const auto along = [&](double b) { return w.sigma + lengthOf(Point{b, 0} - w.root); };
    const double slack = 1 - 1e-12;
    return distance_[mesh_.from(Halfedge(w.halfedge))] + w.b1 < along(w.b1) * slack ||
           distance_[mesh_.to(Halfedge(w.halfedge))] + length - w.b0 < along(w.b0) * slack;
  }

  void keep(const NaiveWindow& w) {
    if (w.halfedge == kNoIndex) return;  // a boundary: nothing goes on
    if (!(w.b1 - w.b0 > 1e-13 * mesh_.length(Halfedge(w.halfedge)))) return;
    const double x = std::clamp(w.root.x, w.b0, w.b1);
    onHalfedge_[w.halfedge].push_back(windows_.size());
    queue_.push({w.sigma + lengthOf(Point{x, 0} - w.root), kNoIndex, windows_.size()});
    windows_.push_back(w);
  }

  /// Directions from which shortest paths arrive at a vertex. Paths that tie but for rounding have
  /// no shortest one that can be told.
  struct Arrival {
    double least{0}, most{0};
  };

  void reach(Index v, double distance, double direction) {
    if (!(distance < distance_[v] * (1 + kRounding))) return;
    Arrival& arrival = arrival_[v];
    if (distance < distance_[v] * (1 - kRounding)) {
      arrival = {direction, direction};
    } else {
      const double round = mesh_.isBoundary(Vertex(v)) ? 0 : mesh_.totalAngle(Vertex(v));
      bool isBeside = false;
      for (const double turn : {0.0, round, -round}) {
        const double other = direction + turn;
        const bool less = other < arrival.least - kTolerance && other > arrival.least - kBeside;
        const bool more = other > arrival.most + kTolerance && other < arrival.most + kBeside;
        if (less) arrival.least = other;
        if (more) arrival.most = other;
        isBeside = isBeside || less || more;
      }
      if (!isBeside) return;
    }
    distance_[v] = std::min(distance, distance_[v]);
    if (mesh_.totalAngle(Vertex(v)) >= straightAngle(v) - kFlat) queue_.push({distance_[v], v, 0});
  }

  /// Continues a window through its face, onto the two other sides.
  void advance(const NaiveWindow& w) {
    const Index h = w.halfedge;
    const Point o = apex(h), end{mesh_.length(Halfedge(h)), 0};
    const Point rayLeft = Point{w.b0, 0} - w.root, rayRight = Point{w.b1, 0} - w.root;
    const Point toApex = o - w.root;
    const double slack = 1e-12 * mesh_.length(Halfedge(h)) * lengthOf(toApex);
    const bool apexLeft = crossOf(rayLeft, toApex) > slack;     // the apex lies left of the window
    const bool apexRight = crossOf(rayRight, toApex) < -slack;  // right of it

    if (!apexLeft && !apexRight) {
      reach(apexVertex(h), w.sigma + lengthOf(toApex), directionAtApex(w));
    }
    if (!apexLeft) {  // something reaches the left side, seen from outside: from the start to the
                      // apex
      const double length = mesh_.length(SurfaceMesh::previous(Halfedge(h)));
      const Point u = (1 / length) * o;
      const auto hit = [&](Point ray) { return crossOf(w.root, ray) / crossOf(u, ray); };
      keep({mesh_.twin(SurfaceMesh::previous(Halfedge(h))),
            {dotOf(w.root, u), crossOf(u, w.root)},
            w.sigma,
            std::max(0.0, hit(rayLeft)),
            apexRight ? std::min(length, hit(rayRight)) : length});
    }
    if (!apexRight) {  // the right side: from the apex to the end
      const double length = mesh_.length(SurfaceMesh::next(Halfedge(h)));
      const Point u = (1 / length) * (end - o), r = w.root - o;
      const auto hit = [&](Point ray) { return crossOf(r, ray) / crossOf(u, ray); };
      keep({mesh_.twin(SurfaceMesh::next(Halfedge(h))),
            {dotOf(r, u), crossOf(u, r)},
            w.sigma,
            apexLeft ? std::max(0.0, hit(rayLeft)) : 0,
            std::min(length, hit(rayRight))});
    }
  }

  /// The direction in which a window's path comes in at the vertex opposite.
  double directionAtApex(const NaiveWindow& w) const {
    const Point toStart = -1 * apex(w.halfedge), toRoot = w.root - apex(w.halfedge);
    return directionOf(SurfaceMesh::previous(Halfedge(w.halfedge))) +
           std::atan2(crossOf(toStart, toRoot), dotOf(toStart, toRoot));
  }

  /// Angle at its start between a halfedge and the first one of that vertex.
  double directionOf(Index halfedge) const {
    double angle = 0;
    for (Halfedge h = mesh_.outgoing(mesh_.from(Halfedge(halfedge))); h != halfedge;
         h = mesh_.twin(SurfaceMesh::previous(h))) {
      angle += mesh_.cornerAngle(h);
    }
    return angle;
  }

  /// The direction at its end, where it leads back.
  double directionBack(Index halfedge) const {
    const Halfedge twin = mesh_.twin(Halfedge(halfedge));
    return twin == kNoIndex ? mesh_.totalAngle(mesh_.to(Halfedge(halfedge))) : directionOf(twin);
  }

  /// Windows from a vertex into the directions [start, start + width]. Round a vertex inside, but
  /// not at a boundary, the directions come again after the total angle.
  void leaveVertex(Index v, double start, double width) {
    const double total = mesh_.totalAngle(Vertex(v)),
                 round = mesh_.isBoundary(Vertex(v)) ? kInfinity : total;
    Halfedge h = mesh_.outgoing(Vertex(v));
    double corner = 0;  // direction of h
    do {
      const double opening = mesh_.cornerAngle(h);
      for (const double turn : {0.0, round, -round}) {
        const double low = std::max(start + turn - corner, 0.0);
        const double high = std::min(start + width + turn - corner, opening);
        if (low > high) continue;
        const Halfedge across = SurfaceMesh::next(h);
        if (low <= 0) {
          reach(mesh_.to(h), distance_[v] + mesh_.length(h), directionBack(h));
        }
        const Halfedge last = SurfaceMesh::previous(h);
        if (mesh_.twin(last) == kNoIndex &&
            high > opening - kTolerance) {  // along the far boundary
          reach(mesh_.from(last), distance_[v] + mesh_.length(last), directionOf(last));
        }
        // Law of sines in the face: where a ray meets the opposite side, from the end of h.
        const double length = mesh_.length(across), beta = mesh_.cornerAngle(across);
        const auto hit = [&](double angle) {
          if (angle <= 0) return 0.0;
          if (angle >= opening) return length;
          return std::min(length, mesh_.length(h) * std::sin(angle) / std::sin(angle + beta));
        };
        const Point root = apex(across);
        keep({mesh_.twin(across),
              {length - root.x, -root.y},
              distance_[v],
              length - hit(high),
              length - hit(low)});
      }
      corner += opening;
      h = mesh_.twin(SurfaceMesh::previous(h));
    } while (h != kNoIndex && h != mesh_.outgoing(Vertex(v)));
  }

  /// Where the line from a root to a point meets the halfedge between them. A point that is not
  /// above the root has its own place along the halfedge.
  static double meets(Point root, Point q) {
    const Point ray = q - root;
    return ray.y > 0 ? root.x - root.y * ray.x / ray.y : q.x;
  }

  /// Whether a line from the root, along `ray`, that meets the halfedge at x passes through a
  /// window. A line may miss it by a small angle at the root.
  bool passes(const NaiveWindow& w, double x, Point ray) const {
    const double oblique = ray.y > 0 ? lengthOf(ray) / ray.y : 1;
    const double slack = kTolerance * oblique * lengthOf(Point{x, 0} - w.root) +
                         kPlace * mesh_.length(Halfedge(w.halfedge));
    return x >= w.b0 - slack && x <= w.b1 + slack;
  }

  /// Length of a window's path to a point of its face; infinite where it covers that not.
  double lengthTo(const NaiveWindow& w, Point q) const {
    const double x = meets(w.root, q);
    if (!passes(w, x, q - w.root)) return kInfinity;
    // Beside the window only the way round its end is a path.
    const Point turn{std::clamp(x, w.b0, w.b1), 0};
    return w.sigma + lengthOf(turn - w.root) + lengthOf(q - turn);
  }

  /// Where that path comes from: the root, or the vertex round which it bends.
  Point comesFrom(const NaiveWindow& w, Point q) const {
    const double x = meets(w.root, q), length = mesh_.length(Halfedge(w.halfedge));
    if (w.b0 == 0 && x < 0) return {0, 0};
    return w.b1 == length && x > length ? Point{length, 0} : w.root;
  }

  /// Visits the paths to a point of a face, in the plane of a halfedge of that face, that are
  /// shorter than `longest`: their lengths, and the vectors from the point back along them, in the
  /// plane of the halfedge turned by `angle`.
  template <class Visit>
  void eachPathTo(Index halfedge, Point q, const double& longest, Visit visit) const {
    Index h = halfedge;
    double angle = 0;
    for (int side = 0; side < 3; ++side) {
      const double overCorner = distance_[mesh_.from(Halfedge(h))] + lengthOf(q);
      if (overCorner < longest) visit(overCorner, -1 * q, angle);
      for (const std::size_t i : onHalfedge_[h]) {
        const NaiveWindow& w = windows_[i];
        const double length = lengthTo(w, q);
        if (length < longest) visit(length, comesFrom(w, q) - q, angle);
      }
      // On to the plane of the next side.
      const Point o = apex(h), end{mesh_.length(Halfedge(h)), 0};
      const double length = mesh_.length(SurfaceMesh::next(Halfedge(h)));
      const Point u = (1 / length) * (o - end);
      q = {dotOf(q - end, u), crossOf(u, q - end)};
      angle += kPi - mesh_.cornerAngle(SurfaceMesh::next(Halfedge(h)));
      h = SurfaceMesh::next(Halfedge(h));
    }
  }

  /// Exact distance of a point of a face, in the plane of a halfedge of that face.
  double distanceAt(Index halfedge, Point q) const {
    double best = kInfinity;
    eachPathTo(halfedge, q, best, [&](double length, Point, double) { best = length; });
    return best;
  }

  /// Whether the paths that reach a point of a face within a length leave no gap of π: the frontier
  /// vanishes there.
  bool closesUpon(Index halfedge, Point q, double reach) const {
    std::vector<double> directions;
    eachPathTo(halfedge, q, reach, [&](double, Point back, double angle) {
      directions.push_back(std::remainder(std::atan2(back.y, back.x) + angle, 2 * kPi));
    });
    Index h = halfedge;
    double angle = 0;
    for (int side = 0; side < 3; ++side) {
      const double length = mesh_.length(Halfedge(h));
      if (lengthOf(q) < kNearVertex * reach) {
        return closesUponVertex(mesh_.from(Halfedge(h)), reach + lengthOf(q));
      }
      // Nothing can go on across a boundary.
      if (mesh_.twin(Halfedge(h)) == kNoIndex && q.y < kTolerance * (length + reach)) {
        directions.push_back(std::remainder(angle - kPi / 2, 2 * kPi));
      }
      const Point o = apex(h), end{length, 0};
      const Point u = (1 / lengthOf(o - end)) * (o - end);
      q = {dotOf(q - end, u), crossOf(u, q - end)};
      angle += kPi - mesh_.cornerAngle(SurfaceMesh::next(Halfedge(h)));
      h = SurfaceMesh::next(Halfedge(h));
    }
    return leaveNoGap(std::move(directions), 2 * kPi);
  }

  bool closesUponVertex(Vertex v, double reach) const {
    std::vector<double> directions;
    const auto along = [&](Index neighbour, double length, double direction, double back) {
      if (distance_[neighbour] + length <= reach && passesStraight(neighbour, back)) {
        directions.push_back(direction);
      }
    };
    Halfedge h = mesh_.outgoing(v);
    do {
      along(mesh_.to(h), mesh_.length(h), directionOf(h), directionBack(h));
      const Index opposite = SurfaceMesh::next(h);
      for (const std::size_t i : onHalfedge_[opposite]) {
        if (lengthTo(windows_[i], apex(opposite)) <= reach) {
          directions.push_back(directionAtApex(windows_[i]));
        }
      }
      const Halfedge last = SurfaceMesh::previous(h);
      h = mesh_.twin(last);
      if (h == kNoIndex) {
        along(mesh_.from(last), mesh_.length(last), mesh_.totalAngle(v), directionOf(last));
      }
    } while (h != kNoIndex && h != mesh_.outgoing(v));
    if (!mesh_.isBoundary(v)) return leaveNoGap(std::move(directions), mesh_.totalAngle(v));
    // Outside the surface nothing goes on.
    for (const double outside : {-kPi / 2, mesh_.totalAngle(v) + kPi / 2}) {
      directions.push_back(outside);
    }
    return leaveNoGap(std::move(directions), mesh_.totalAngle(v) + kPi);
  }

  /// Whether directions, which come again after the whole angle, leave no gap of π between them.
  static bool leaveNoGap(std::vector<double> directions, double whole) {
    std::sort(directions.begin(), directions.end());
    double widest = directions.front() + whole - directions.back();
    for (std::size_t i = 1; i < directions.size(); ++i) {
      widest = std::max(widest, directions[i] - directions[i - 1]);
    }
    return widest < kPi - kGap;
  }

  // --- Step 2: loops along an edge
  // ---------------------------------------------------------------------

  bool passesStraight(Index v, double leaving) const {
    if (v == source_) return true;
    const double total = mesh_.totalAngle(Vertex(v));
    const auto [least, most] = arrival_[v];
    const double widest = std::max(leaving - least, most - leaving);
    const double narrowest = leaving > most ? leaving - most : least - leaving;
    if (widest < kPi - kTolerance) return false;
    return mesh_.isBoundary(Vertex(v)) || total - narrowest >= kPi - kTolerance;
  }

  void testEdges() {
    for (const Halfedge h : mesh_.halfedges()) {
      const Vertex a = mesh_.from(h), b = mesh_.to(h);
      if ((a > b && mesh_.twin(h) != kNoIndex) || std::isinf(distance_[a])) continue;
      if (!passesStraight(a, directionOf(h)) || !passesStraight(b, directionBack(h))) continue;
      const double along = (mesh_.length(h) + distance_[b] - distance_[a]) / 2;
      accept(h, {along, 0}, distance_[a] + mesh_.length(h) + distance_[b]);
    }
  }

  // --- Step 3: loops across an edge
  // --------------------------------------------------------------------

  /// How many pairs testWindowPairs tries.
  std::size_t pairs() const {
    std::size_t count = 0;
    for (const Halfedge h : mesh_.halfedges()) {
      if (mesh_.from(h) > mesh_.to(h) || mesh_.twin(h) == kNoIndex) continue;
      count += onHalfedge_[h].size() * onHalfedge_[mesh_.twin(h)].size();
    }
    return count;
  }

  void testWindowPairs() {
    for (const Halfedge h : mesh_.halfedges()) {
      if (mesh_.from(h) > mesh_.to(h) || mesh_.twin(h) == kNoIndex) continue;
      const double length = mesh_.length(h);
      for (const std::size_t i : onHalfedge_[h]) {
        for (const std::size_t j : onHalfedge_[mesh_.twin(h)]) {
          const NaiveWindow& up = windows_[i];
          const NaiveWindow& down = windows_[j];
          const Point top{length - down.root.x, -down.root.y};  // the other root, in the plane of h
          const Point line = top - up.root;
          if (!(line.y > 0)) continue;
          const double x = meets(up.root, top);
          const double whole = lengthOf(line), slack = kTolerance * (length + whole);
          if (!passes(up, x, line) || !passes(down, length - x, line)) continue;
          double toMidpoint = (whole + down.sigma - up.sigma) / 2;
          if (toMidpoint < -slack || toMidpoint > whole + slack) continue;
          toMidpoint = std::clamp(toMidpoint, 0.0, whole);  // at a root but for rounding
          const Point q = up.root + (toMidpoint / whole) * line;
          if (q.y >= 0) {
            accept(h, q, up.sigma + whole + down.sigma);
          } else {
            accept(mesh_.twin(h), {length - q.x, -q.y}, up.sigma + whole + down.sigma);
          }
        }
      }
    }
  }

  /// A straight loop is the answer if its midpoint lies in this face, both halves are shortest, and
  /// none is shorter.
  void accept(Index halfedge, Point midpoint, double length) {
    if (length >= best_ || !inFace(halfedge, midpoint)) return;
    // No geodesic passes a convex vertex, only lines beside it.
    const Point corners[] = {{0, 0}, {mesh_.length(Halfedge(halfedge)), 0}, apex(halfedge)};
    Halfedge out(halfedge);
    for (const Point corner : corners) {
      const Vertex v = mesh_.from(out);
      const double missing = straightAngle(v) - mesh_.totalAngle(v);
      const double near = std::min(kShunned * (length + mesh_.length(Halfedge(halfedge))),
                                   missing / 8 * shortestEdge(v));
      if (missing > kFlat && lengthOf(midpoint - corner) < near) return;
      out = SurfaceMesh::next(out);
    }
    if (distanceAt(halfedge, midpoint) < length / 2 * (1 - kTie)) return;
    if (!closesUpon(halfedge, midpoint, length / 2 * (1 + kTie))) best_ = length;
  }

  double shortestEdge(Vertex v) const {
    double shortest = kInfinity;
    Halfedge h = mesh_.outgoing(v);
    do {
      shortest = std::min({shortest, mesh_.length(h), mesh_.length(SurfaceMesh::previous(h))});
      h = mesh_.twin(SurfaceMesh::previous(h));
    } while (h != kNoIndex && h != mesh_.outgoing(v));
    return shortest;
  }

  bool inFace(Index h, Point q) const {
    const Point o = apex(h), end{mesh_.length(Halfedge(h)), 0};
    const double slack = kTolerance * mesh_.length(Halfedge(h));
    return q.y >= -slack && crossOf(o - end, q - end) >= -slack * lengthOf(o - end) &&
           crossOf(-1 * o, q - o) >= -slack * lengthOf(o);
  }

  // --- No loop: the farthest point
  // ---------------------------------------------------------------------

  /// The maximum of the distance, by bisecting triangles: within one, the distance rises by no more
  /// than its radius above that of its centre.
  double farthestDistance(double atLeast) {
    struct Cell {
      double bound;
      Index halfedge;
      Point a, b, c;
      bool operator<(const Cell& other) const { return bound < other.bound; }
    };
    std::priority_queue<Cell> cells;
    const auto add = [&](Index h, Point a, Point b, Point c) {
      const Point centre = (1.0 / 3) * (a + b + c);
      const double d = distanceAt(h, centre);
      if (std::isinf(d)) return;
      const double radius =
          std::max({lengthOf(a - centre), lengthOf(b - centre), lengthOf(c - centre)});
      atLeast = std::max(atLeast, d);
      if (d + radius > atLeast * (1 + kBisection)) cells.push({d + radius, h, a, b, c});
    };
    for (const Face f : mesh_.faces()) {
      add(3 * f, {0, 0}, {mesh_.length(Halfedge(3 * f)), 0}, apex(3 * f));
    }
    while (!cells.empty() && cells.top().bound > atLeast * (1 + kBisection) &&
           !context_.cancelled()) {
      const Cell cell = cells.top();
      cells.pop();
      const Point ab = 0.5 * (cell.a + cell.b), bc = 0.5 * (cell.b + cell.c),
                  ca = 0.5 * (cell.c + cell.a);
      add(cell.halfedge, cell.a, ab, ca);
      add(cell.halfedge, ab, cell.b, bc);
      add(cell.halfedge, ca, bc, cell.c);
      add(cell.halfedge, ab, bc, ca);
    }
    return atLeast;
  }

  const SurfaceMesh& mesh_;
  const ExecutionContext& context_;
  Index source_;
  std::vector<double> distance_;  // by vertex
  std::vector<Arrival> arrival_;
  std::vector<NaiveWindow> windows_;
  std::vector<std::vector<std::size_t>> onHalfedge_;
  std::priority_queue<Event> queue_;
  double best_{kInfinity};
};

}  // namespace

Result<GirthValue> naiveGirth(const SurfaceMesh& mesh, Vertex vertex,
                              const ExecutionContext& context) {
  if (auto error = checkVertex(mesh, vertex)) return *std::move(error);
  return NaiveGirth(mesh, vertex, context).compute();
}

VertexFunction<GirthValue> naiveGirthFunction(const SurfaceMesh& mesh) {
  return {[&mesh](const ExecutionContext& context) -> VertexEvaluator<GirthValue> {
    return [&mesh, own = context.ofOneThread()](Vertex v) { return naiveGirth(mesh, v, own); };
  }};
}

GirthField naiveGirthField(const SurfaceMesh& mesh, const ExecutionContext& context,
                           const std::function<void(const GirthPartial&)>& onPartial) {
  return girthFieldOf(evaluateAll(mesh, naiveGirthFunction(mesh), context, onPartial));
}

}  // namespace girth::study
