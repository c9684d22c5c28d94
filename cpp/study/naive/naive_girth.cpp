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
/// Lengths are compared, and ends of intervals met, up to this share.
constexpr double kTolerance = 1e-10;
/// The farthest point is bisected to this.
constexpr double kBisection = 2e-10;
/// Angles are compared up to this.
constexpr double kAngleTolerance = 1e-8;

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
        direction_(mesh.vertexCount(), 0.0),
        onHalfedge_(mesh.halfedgeCount()) {}

  Result<GirthValue> compute() {
    propagate();
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
    while (!queue_.empty() && !context_.cancelled()) {
      const Event event = queue_.top();
      queue_.pop();
      if (event.vertex == kNoIndex) {
        const NaiveWindow window = windows_[event.window];
        if (!dominated(window)) advance(window);
      } else if (event.distance == distance_[event.vertex]) {
        const Index v = event.vertex;
        const double total = mesh_.totalAngle(Vertex(v)), straight = direction_[v] + kPi;
        if (mesh_.isBoundary(Vertex(v))) {
          leaveVertex(v, straight - kTolerance, total - straight + 2 * kTolerance);
          leaveVertex(v, -kTolerance, straight - 2 * kPi + 2 * kTolerance);
        } else {
          leaveVertex(v, straight - kTolerance, total - 2 * kPi + 2 * kTolerance);
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

  void reach(Index v, double distance, double direction) {
    if (!(distance < distance_[v])) return;
    distance_[v] = distance;
    direction_[v] = direction;
    if (mesh_.totalAngle(Vertex(v)) >= straightAngle(v) - 1e-9) queue_.push({distance, v, 0});
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
      const Halfedge out = SurfaceMesh::previous(Halfedge(h));
      const Point toStart = -1 * o, toRoot = w.root - o;
      const double angle = std::atan2(crossOf(toStart, toRoot), dotOf(toStart, toRoot));
      reach(apexVertex(h), w.sigma + lengthOf(toApex), directionOf(out) + angle);
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
    if (!apexRight) {  // and the right side: from the apex to the end
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

  /// Angle at its start between a halfedge and the first one of that vertex.
  double directionOf(Index halfedge) const {
    double angle = 0;
    for (Halfedge h = mesh_.outgoing(mesh_.from(Halfedge(halfedge))); h != halfedge;
         h = mesh_.twin(SurfaceMesh::previous(h))) {
      angle += mesh_.cornerAngle(h);
    }
    return angle;
  }

  /// The same at its end, where it leads back.
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

  /// Exact distance of a point of a face, in the plane of a halfedge of that face.
  double distanceAt(Index halfedge, Point q) const {
    double best = kInfinity;
    Index h = halfedge;
    for (int side = 0; side < 3; ++side) {
      best = std::min(best, distance_[mesh_.from(Halfedge(h))] + lengthOf(q));
      for (const std::size_t i : onHalfedge_[h]) {
        const NaiveWindow& w = windows_[i];
        const Point ray = q - w.root;
        const double d = w.sigma + lengthOf(ray);
        if (d >= best) continue;
        const double x = ray.y > 0 ? w.root.x - w.root.y * ray.x / ray.y : q.x;
        const double slack = kTolerance * mesh_.length(Halfedge(h));
        if (x >= w.b0 - slack && x <= w.b1 + slack) best = d;
      }
      // On to the plane of the next side.
      const Point o = apex(h), end{mesh_.length(Halfedge(h)), 0};
      const double length = mesh_.length(SurfaceMesh::next(Halfedge(h)));
      const Point u = (1 / length) * (o - end);
      q = {dotOf(q - end, u), crossOf(u, q - end)};
      h = SurfaceMesh::next(Halfedge(h));
    }
    return best;
  }

  // --- Step 2: loops along an edge
  // ---------------------------------------------------------------------

  bool passesStraight(Index v, double leaving) const {
    if (v == source_) return true;
    const double total = mesh_.totalAngle(Vertex(v));
    const double between = std::fabs(direction_[v] - leaving);
    if (mesh_.isBoundary(Vertex(v))) return between >= kPi - kAngleTolerance;
    return between >= kPi - kAngleTolerance && total - between >= kPi - kAngleTolerance;
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

  void testWindowPairs() {
    for (const Halfedge h : mesh_.halfedges()) {
      if (mesh_.from(h) > mesh_.to(h) || mesh_.twin(h) == kNoIndex) continue;
      const double length = mesh_.length(h), slack = kTolerance * length;
      for (const std::size_t i : onHalfedge_[h]) {
        for (const std::size_t j : onHalfedge_[mesh_.twin(h)]) {
          const NaiveWindow& up = windows_[i];
          const NaiveWindow& down = windows_[j];
          const Point top{length - down.root.x, -down.root.y};  // the other root, in the plane of h
          const Point line = top - up.root;
          if (!(line.y > 0)) continue;
          const double x = up.root.x - up.root.y * line.x / line.y;
          if (x < up.b0 - slack || x > up.b1 + slack) continue;
          if (x < length - down.b1 - slack || x > length - down.b0 + slack) continue;
          const double whole = lengthOf(line);
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
    const Index vertices[] = {mesh_.from(Halfedge(halfedge)), mesh_.to(Halfedge(halfedge)),
                              apexVertex(halfedge)};
    for (int k = 0; k < 3; ++k) {
      if (mesh_.totalAngle(Vertex(vertices[k])) < straightAngle(vertices[k]) - kAngleTolerance &&
          lengthOf(midpoint - corners[k]) < 3 * kTolerance * mesh_.length(Halfedge(halfedge))) {
        return;
      }
    }
    if (distanceAt(halfedge, midpoint) >= length / 2 * (1 - kTolerance)) best_ = length;
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
  std::vector<double> distance_;   // of the vertices
  std::vector<double> direction_;  // from which their shortest path comes
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
