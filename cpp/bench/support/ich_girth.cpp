#include "support/ich_girth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <vector>

namespace girth::bench {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;
/// Lengths along an edge are compared up to this share of the edge.
constexpr double kLengthTolerance = 1e-12;
/// Angles are compared up to this, in radians.
constexpr double kAngleTolerance = 1e-9;

struct Point {
  double x, y;
};
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
double dotOf(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double crossOf(Point a, Point b) { return a.x * b.y - a.y * b.x; }
double lengthOf(Point a) { return std::sqrt(dotOf(a, a)); }

/// An interval window (r, l, e, [a, b]) of the paper, in the plane in which its halfedge lies on
/// the x axis from 0 to its length, the face that the window enters above, and the root r below.
struct Window {
  Point root;
  double sigma;     // l: distance of the root
  double b0, b1;    // [a, b]
  double farthest;  // greatest distance in the interval
  Index halfedge;
  Index rootVertex;
  /// The corner of the face left behind that the window passes by; kNoIndex for windows of a fan.
  Index passed;
  bool passedOnLeft;
  /// The next window in the list of the halfedge, or of the free ones.
  std::uint32_t next;
};

/// Windows and pseudosources wait in one queue; a pseudosource has no window.
struct Event {
  double distance;
  std::uint32_t window;
  Index vertex;
  bool operator<(const Event& other) const { return distance > other.distance; }
};

/// A heap that keeps its memory.
class EventQueue : public std::priority_queue<Event> {
 public:
  void clear() { c.clear(); }
};

}  // namespace

struct IchGirth::State {
  State(const SurfaceMesh& surface, IchFilter when)
      : mesh(surface),
        filter(when),
        apex(mesh.halfedgeCount()),
        direction(mesh.halfedgeCount()),
        reach(mesh.halfedgeCount()),
        distance(mesh.vertexCount(), kInfinity),
        arrival(mesh.vertexCount(), 0.0),
        angles(mesh.halfedgeCount()),
        listed(mesh.halfedgeCount(), kNoIndex) {
    for (const Halfedge h : mesh.halfedges()) {
      const double side = mesh.length(SurfaceMesh::previous(h)), angle = mesh.cornerAngle(h);
      apex[h] = {side * std::cos(angle), side * std::sin(angle)};
    }
    for (const Halfedge h : mesh.halfedges()) {
      const Halfedge t = mesh.twin(h);
      reach[h] =
          2 * std::max({mesh.length(SurfaceMesh::next(h)), mesh.length(SurfaceMesh::previous(h)),
                        mesh.length(SurfaceMesh::next(t)), mesh.length(SurfaceMesh::previous(t))});
    }
    for (const Vertex v : mesh.vertices()) {
      double angle = 0;
      Halfedge h = mesh.outgoing(v);
      do {
        direction[h] = angle;
        angle += mesh.cornerAngle(h);
        h = mesh.twin(SurfaceMesh::previous(h));
      } while (h != mesh.outgoing(v));
    }
  }

  Index apexVertex(Index h) const { return mesh.from(SurfaceMesh::previous(Halfedge(h))); }
  bool isPseudosource(Index v) const {
    return mesh.totalAngle(Vertex(v)) >= 2 * kPi - kAngleTolerance;
  }

  void start(Index source, bool loops) {
    withLoops = loops;
    filtersEarly = !loops || filter == IchFilter::AtCreation;
    for (const Index v : touchedVertices) distance[v] = kInfinity;
    for (const Index h : touchedAngles) angles[h] = {};
    for (const Index h : touchedLists) listed[h] = kNoIndex;
    touchedVertices.clear();
    touchedAngles.clear();
    touchedLists.clear();
    queue.clear();
    windows.clear();
    freeWindow = kNoIndex;
    best = kInfinity;
    processed = 0;
    distance[source] = 0;
    touchedVertices.push_back(source);
    leaveVertex(source, 0, mesh.totalAngle(Vertex(source)));
  }

  // --- Algorithm 2
  // ---------------------------------------------------------------------------------------

  /// Without loops it is the plain propagation of distances.
  void run() {
    while (!queue.empty()) {
      const Event event = queue.top();
      if (withLoops && event.distance > best / 2) return;  // 4.3.1: R_g is the event's distance
      queue.pop();
      if (event.window == kNoIndex) {
        if (event.distance != distance[event.vertex]) continue;  // reached by a shorter way since
        ++processed;
        if (withLoops) testEdges(event.vertex);
        leaveVertex(event.vertex, arrival[event.vertex] + kPi - kAngleTolerance,
                    mesh.totalAngle(Vertex(event.vertex)) - 2 * kPi + 2 * kAngleTolerance);
        continue;
      }
      const Window window = windows[event.window];
      if (!withLoops) recycle(event.window);
      if (filtersEarly ? isUseless(window) : isOutdated(window)) continue;
      ++processed;
      if (withLoops) testPairs(window, event.distance);
      if (filtersEarly || !isUseless(window)) propagate(window);
    }
  }

  /// Lemma 4.1: loops along an edge between the pseudosource v and a neighbour not farther away.
  void testEdges(Index v) {
    const Halfedge first = mesh.outgoing(Vertex(v));
    Index h = first;
    do {
      const Vertex other = mesh.to(Halfedge(h));
      if (distance[other] <= distance[v]) {
        const double length = distance[v] + mesh.length(Halfedge(h)) + distance[other];
        if (length < best && isStraight(v, direction[h]) &&
            isStraight(other, direction[mesh.twin(Halfedge(h))])) {
          best = length;
        }
      }
      h = mesh.twin(SurfaceMesh::previous(Halfedge(h)));
    } while (h != first);
  }

  /// Whether the shortest path to v and a continuation leave an angle of π on both sides.
  bool isStraight(Index v, double outgoing) const {
    if (distance[v] == 0) return true;  // the source: the loop may turn there
    const double total = mesh.totalAngle(Vertex(v));
    double turn = std::fmod(std::abs(outgoing - arrival[v]), total);
    turn = std::min(turn, total - turn);
    return turn >= kPi - kAngleTolerance;
  }

  /// Lemma 4.2: the popped window against those on the reverse halfedge. `nearest` is its least
  /// distance.
  void testPairs(const Window& w, double nearest) {
    const Halfedge reverse = mesh.twin(Halfedge(w.halfedge));
    const double length = mesh.length(Halfedge(w.halfedge));
    std::uint32_t* link = &listed[reverse];
    while (*link != kNoIndex) {
      const std::uint32_t other = *link;
      const Window& o = windows[other];
      if (o.farthest + reach[w.halfedge] < nearest) {  // condition 1: far behind the frontier
        *link = o.next;
        recycle(other);
        continue;
      }
      link = &windows[other].next;
      const Point root{length - o.root.x, -o.root.y};
      const double x =
          w.root.x - w.root.y * (root.x - w.root.x) / (root.y - w.root.y);  // condition 2
      const double slack = kLengthTolerance * length;
      if (x < std::max(w.b0, length - o.b1) - slack || x > std::min(w.b1, length - o.b0) + slack) {
        continue;
      }
      best = std::min(best, w.sigma + o.sigma + lengthOf(root - w.root));  // condition 3
    }
  }

  // --- Improved Chen–Han
  // ---------------------------------------------------------------------------------

  /// Whether the window's pseudosource has been reached by a shorter way since.
  bool isOutdated(const Window& w) const { return w.sigma != distance[w.rootVertex]; }

  /// Whether no path through the window is shortest: it is outdated, or a path over a vertex of the
  /// face left behind is shorter everywhere (Xin and Wang 2009, section 3.2).
  bool isUseless(const Window& w) const {
    if (isOutdated(w)) return true;
    const double length = mesh.length(Halfedge(w.halfedge));
    const double d0 = w.sigma + lengthOf(Point{w.b0, 0} - w.root);
    const double d1 = w.sigma + lengthOf(Point{w.b1, 0} - w.root);
    if (distance[mesh.from(Halfedge(w.halfedge))] + w.b1 < d1 * (1 - kLengthTolerance)) return true;
    if (distance[mesh.to(Halfedge(w.halfedge))] + (length - w.b0) < d0 * (1 - kLengthTolerance))
      return true;
    if (w.passed == kNoIndex) return false;
    const Halfedge t = mesh.twin(Halfedge(w.halfedge));
    const Point corner{length - apex[t].x, -apex[t].y};
    const double far = w.passedOnLeft ? w.b1 : w.b0;
    return distance[w.passed] + lengthOf(Point{far, 0} - corner) <
           (w.passedOnLeft ? d1 : d0) * (1 - kLengthTolerance);
  }

  void push(Window w) {
    const double length = mesh.length(Halfedge(w.halfedge));
    w.b0 = std::max(w.b0, 0.0);
    w.b1 = std::min(w.b1, length);
    if (!(w.b1 - w.b0 > kLengthTolerance * length)) return;
    if (filtersEarly && isUseless(w)) return;
    const double nearest = w.sigma + lengthOf(Point{std::clamp(w.root.x, w.b0, w.b1), 0} - w.root);
    w.farthest =
        w.sigma + std::max(lengthOf(Point{w.b0, 0} - w.root), lengthOf(Point{w.b1, 0} - w.root));
    std::uint32_t slot = freeWindow;
    if (slot != kNoIndex) {
      freeWindow = windows[slot].next;
      windows[slot] = w;
    } else {
      slot = static_cast<std::uint32_t>(windows.size());
      windows.push_back(w);
    }
    queue.push({nearest, slot, kNoIndex});
    if (withLoops) list(slot);
  }

  void recycle(std::uint32_t slot) {
    windows[slot].next = freeWindow;
    freeWindow = slot;
  }

  void list(std::uint32_t slot) {
    const Index h = windows[slot].halfedge;
    if (listed[h] == kNoIndex) touchedLists.push_back(h);
    windows[slot].next = listed[h];
    listed[h] = slot;
  }

  /// A vertex is reached over `way`; `angle` is the direction in which the path arrives, looking
  /// back.
  template <class Angle>
  void reachVertex(Index v, double way, Angle angle) {
    if (!(way < distance[v])) return;
    if (distance[v] == kInfinity) touchedVertices.push_back(v);
    distance[v] = way;
    if (!isPseudosource(v)) return;
    arrival[v] = angle();
    queue.push({way, kNoIndex, v});
  }

  /// The children of a window on the two other sides of the face that it enters.
  void propagate(const Window& w) {
    const Index h = w.halfedge, left = SurfaceMesh::previous(Halfedge(h)),
                right = SurfaceMesh::next(Halfedge(h));
    const Point o = apex[h], toApex = o - w.root;
    const Point rayLeft = Point{w.b0, 0} - w.root, rayRight = Point{w.b1, 0} - w.root;
    const double slack = kLengthTolerance * mesh.length(Halfedge(h)) * lengthOf(toApex);
    const bool apexIsLeft = crossOf(rayLeft, toApex) > slack;
    const bool apexIsRight = crossOf(rayRight, toApex) < -slack;
    bool goesLeft = !apexIsLeft, goesRight = !apexIsRight;

    if (goesLeft && goesRight) {  // the apex is in sight
      const double way = w.sigma + lengthOf(toApex);
      const double entry = w.root.x - w.root.y * toApex.x / toApex.y;
      Angle& angle = angles[h];
      if (way < angle.distance) {  // one angle, one split
        if (angle.distance == kInfinity) touchedAngles.push_back(h);
        angle = {way, entry};
        reachVertex(apexVertex(h), way, [&] {
          const Point toStart = -1 * o, toRoot = w.root - o;
          return direction[left] + std::atan2(crossOf(toStart, toRoot), dotOf(toStart, toRoot));
        });
      } else {
        goesLeft = entry < angle.entry;
        goesRight = !goesLeft;
      }
    }
    if (goesLeft) {
      const double length = mesh.length(Halfedge(left));
      const Point u = (1 / length) * o;
      const auto hit = [&](Point ray) { return crossOf(w.root, ray) / crossOf(u, ray); };
      push({{dotOf(w.root, u), crossOf(u, w.root)},
            w.sigma,
            hit(rayLeft),
            apexIsRight ? hit(rayRight) : length,
            0,
            mesh.twin(Halfedge(left)),
            w.rootVertex,
            mesh.to(Halfedge(h)),
            false,
            kNoIndex});
    }
    if (goesRight) {
      const double length = mesh.length(Halfedge(right));
      const Point u = (1 / length) * (Point{mesh.length(Halfedge(h)), 0} - o), r = w.root - o;
      const auto hit = [&](Point ray) { return crossOf(r, ray) / crossOf(u, ray); };
      push({{dotOf(r, u), crossOf(u, r)},
            w.sigma,
            apexIsLeft ? hit(rayLeft) : 0,
            hit(rayRight),
            0,
            mesh.twin(Halfedge(right)),
            w.rootVertex,
            mesh.from(Halfedge(h)),
            true,
            kNoIndex});
    }
  }

  /// The fan of a source or pseudosource: windows into the directions [start, start + width].
  void leaveVertex(Index v, double begin, double width) {
    const double total = mesh.totalAngle(Vertex(v));
    const Halfedge first = mesh.outgoing(Vertex(v));
    Index h = first;
    do {
      const double opening = mesh.cornerAngle(Halfedge(h)), corner = direction[h];
      for (const double turn : {0.0, total, -total}) {
        const double low = std::max(begin + turn - corner, 0.0);
        const double high = std::min(begin + width + turn - corner, opening);
        if (low > high) continue;
        if (low <= 0) {
          reachVertex(mesh.to(Halfedge(h)), distance[v] + mesh.length(Halfedge(h)),
                      [&] { return direction[mesh.twin(Halfedge(h))]; });
        }
        // From the end of h along the opposite side, by the law of sines.
        const Halfedge across = SurfaceMesh::next(Halfedge(h));
        const double length = mesh.length(across), beta = mesh.cornerAngle(across);
        const auto hit = [&](double angle) {
          if (angle <= 0) return 0.0;
          if (angle >= opening) return length;
          return mesh.length(Halfedge(h)) * std::sin(angle) / std::sin(angle + beta);
        };
        push({{length - mesh.length(Halfedge(h)) * std::cos(beta),
               -mesh.length(Halfedge(h)) * std::sin(beta)},
              distance[v],
              length - hit(high),
              length - hit(low),
              0,
              mesh.twin(across),
              v,
              kNoIndex,
              false,
              kNoIndex});
      }
      h = mesh.twin(SurfaceMesh::previous(Halfedge(h)));
    } while (h != first);
  }

  const SurfaceMesh& mesh;
  IchFilter filter;

  // Data of the mesh, by halfedge: its apex in its plane; its direction at its start; the width of
  // condition 1.
  std::vector<Point> apex;
  std::vector<double> direction, reach;

  // Data of one call.
  std::vector<double> distance, arrival;  // by vertex
  struct Angle {
    double distance{kInfinity};  // the shortest way seen straight to the apex ...
    double entry{0};             // ... and where it crosses the halfedge
  };
  std::vector<Angle> angles;          // by halfedge
  std::vector<std::uint32_t> listed;  // by halfedge: its list of windows
  std::vector<Index> touchedVertices, touchedAngles, touchedLists;
  std::vector<Window> windows;
  std::uint32_t freeWindow{kNoIndex};
  EventQueue queue;
  bool withLoops{true}, filtersEarly{true};
  double best{kInfinity};
  std::size_t processed{0};
};

IchGirth::IchGirth(const SurfaceMesh& mesh, IchFilter filter)
    : state_(std::make_unique<State>(mesh, filter)) {}
IchGirth::~IchGirth() = default;

GirthValue IchGirth::value(Index vertex) {
  state_->start(vertex, true);
  state_->run();
  if (state_->best < kInfinity) return {state_->best, LoopKind::Loop};
  double farthest = 0;
  for (const Index v : state_->touchedVertices) farthest = std::max(farthest, state_->distance[v]);
  return {2 * farthest, LoopKind::Antipodal};
}

std::span<const double> IchGirth::distances(Index source) {
  state_->start(source, false);
  state_->run();
  return state_->distance;
}

std::size_t IchGirth::windowCount() const { return state_->processed; }

}  // namespace girth::bench
