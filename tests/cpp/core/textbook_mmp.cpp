#include "textbook_mmp.h"

#include <algorithm>
#include <cmath>

namespace girth::test {

namespace {

using Real = long double;

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();
/// Parts of an edge narrower than this share of it are left to their neighbours; their paths then
/// go round the neighbour's end, longer by as little.
constexpr Real kNarrow = 16 * kEpsilon;
/// A window takes nothing from another, and a vertex nothing from a path, that is as short but for
/// this share.
constexpr Real kTie = 64 * kEpsilon;
/// Vertices are lit from unless they are convex by more than this angle. To light from more of them
/// than needed costs time only; flat ones, whatever their rounding, need it where rays end upon
/// them.
constexpr Real kConvex = 1e-6L;

/// The root of the sum of squares; long double has room enough for those of any double.
Real norm(Real x, Real y) { return std::sqrt(x * x + y * y); }

}  // namespace

TextbookMmp::TextbookMmp(const SurfaceMesh& mesh)
    : mesh_(mesh),
      apex_(mesh.halfedgeCount()),
      length_(mesh.halfedgeCount()),
      edgeOf_(mesh.halfedgeCount()),
      firstOutgoing_(mesh.vertexCount() + 1, 0),
      outgoing_(mesh.halfedgeCount()),
      sendsOn_(mesh.vertexCount()),
      distance_(mesh.vertexCount(), kInfinity) {
  const Index halfedges = mesh.halfedgeCount();
  std::vector<Real> angle(mesh.vertexCount(), 0);
  std::vector<bool> onBoundary(mesh.vertexCount(), false);
  for (Index h = 0; h < halfedges; ++h) {
    const Vec3 &a = mesh.position(mesh.from(Halfedge(h))), &b = mesh.position(mesh.to(Halfedge(h))),
               &c = mesh.position(mesh.from(SurfaceMesh::previous(Halfedge(h))));
    const auto to = [&](const Vec3& p) {
      return std::array<Real, 3>{static_cast<Real>(p.x) - a.x, static_cast<Real>(p.y) - a.y,
                                 static_cast<Real>(p.z) - a.z};
    };
    const auto u = to(b), v = to(c);
    const Real cross =
        std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    const Real dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    length_[h] = std::hypot(u[0], u[1], u[2]);
    apex_[h] = {dot / length_[h], cross / length_[h]};
    angle[mesh.from(Halfedge(h))] += std::atan2(cross, dot);
    const Halfedge twin = mesh.twin(Halfedge(h));
    if (twin == kNoIndex)
      onBoundary[mesh.from(Halfedge(h))] = onBoundary[mesh.to(Halfedge(h))] = true;
    if (twin == kNoIndex || h < twin) {
      edgeOf_[h] = static_cast<Index>(halfedgeOf_.size());
      halfedgeOf_.push_back(h);
    } else {
      edgeOf_[h] = edgeOf_[twin];
    }
    ++firstOutgoing_[mesh.from(Halfedge(h)) + 1];
  }
  for (const Vertex v : mesh.vertices()) {
    firstOutgoing_[v + 1] += firstOutgoing_[v];
    sendsOn_[v] = onBoundary[v] || angle[v] > 2 * std::acos(Real(-1)) - kConvex;
  }
  std::vector<Index> next(firstOutgoing_.begin(), firstOutgoing_.end() - 1);
  for (Index h = 0; h < halfedges; ++h) outgoing_[next[mesh.from(Halfedge(h))]++] = h;
  onEdge_.resize(halfedgeOf_.size());
}

void TextbookMmp::propagate(const SurfacePoint& source, double radius) {
  for (const Index e : touchedEdges_) onEdge_[e].clear();
  for (const Index v : touchedVertices_) distance_[v] = kInfinity;
  touchedEdges_.clear();
  touchedVertices_.clear();
  windows_.clear();
  sourceInPlane_.clear();
  queue_ = {};

  const auto& weights = source.weights;
  switch (source.kind) {
    case SurfacePoint::Kind::AtVertex:
      lower(source.element, 0);
      break;
    case SurfacePoint::Kind::OnEdge: {
      const Index h = source.element, twin = mesh_.twin(Halfedge(h));
      const Real x = static_cast<Real>(weights[1]) * length_[h];
      insertAlong(h, x, 0);
      leaveInside(SurfaceMesh::faceOf(Halfedge(h)), inPlaneOfFirst(h, {x, 0}));
      if (twin != kNoIndex) {
        leaveInside(SurfaceMesh::faceOf(Halfedge(twin)), inPlaneOfFirst(twin, {length_[h] - x, 0}));
      }
      break;
    }
    case SurfacePoint::Kind::InFace: {
      const Index h = 3 * source.element;
      const Real w1 = weights[1], w2 = weights[2];
      leaveInside(source.element, {w1 * length_[h] + w2 * apex(h).x, w2 * apex(h).y});
      break;
    }
  }
  bool first = source.kind == SurfacePoint::Kind::AtVertex;
  while (!queue_.empty() && queue_.top().distance <= radius) {
    const Event event = queue_.top();
    queue_.pop();
    if (event.vertex == kNoIndex) {
      Window& window = windows_[event.window];
      if (window.dead || window.done) continue;
      window.done = true;
      handOn(event.window);
    } else if (event.distance == distance_[event.vertex]) {
      const bool sendsOn = sendsOn_[event.vertex];
      if (first) sendsOn_[event.vertex] = true;
      leaveVertex(event.vertex);
      if (first) sendsOn_[event.vertex] = sendsOn;
      first = false;
    }
  }
}

void TextbookMmp::lower(Index vertex, Real distance) {
  // Not for the sake of rounding: all that depends on the vertex would be done again.
  if (!(distance < distance_[vertex] * (1 - kTie)) && distance_[vertex] < kInfinity) return;
  if (distance_[vertex] == kInfinity) touchedVertices_.push_back(vertex);
  distance_[vertex] = distance;
  queue_.push({distance, vertex, 0});
}

void TextbookMmp::leaveVertex(Index vertex) {
  const Real distance = distance_[vertex];
  for (Index i = firstOutgoing_[vertex]; i < firstOutgoing_[vertex + 1]; ++i) {
    const Index out = outgoing_[i], in = SurfaceMesh::previous(Halfedge(out));
    insertAlong(out, 0, distance);
    if (mesh_.twin(Halfedge(in)) == kNoIndex) insertAlong(in, length_[in], distance);
    const Halfedge opposite = SurfaceMesh::next(Halfedge(out));
    if (sendsOn_[vertex]) {
      insertThrough(opposite, 0, length_[opposite], apex(opposite), distance);
    }
  }
}

/// From a point inside a face or on its rim to all of its sides.
void TextbookMmp::leaveInside(Index face, Point point) {
  sourceInPlane_.emplace_back(face, point);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    insertThrough(h, 0, length_[h], point, 0);
    point = inPlaneOfNext(h, point);
  }
}

/// Continues a window through the face beyond its edge.
void TextbookMmp::handOn(WindowId id) {
  const Window w = windows_[id];
  if (w.through == kNoIndex) return;
  const Halfedge h = mesh_.twin(Halfedge(w.through));
  if (h == kNoIndex) return;
  // In the plane of h, the root below.
  const bool forward = h == halfedgeOf_[w.edge];
  const Real length = length_[h];
  const Real from = forward ? w.from : length - w.to, to = forward ? w.to : length - w.from;
  const Point root{forward ? w.x : length - w.x, -w.y}, o = apex(h);
  lower(mesh_.from(SurfaceMesh::previous(Halfedge(h))), beyond(w, root, from, to, o));
  if (!(w.y > 0)) return;  // the rays run along the edge

  // The ray to the apex parts those that meet the left side from those that meet the right one.
  const Real split = root.x + (o.x - root.x) * w.y / (w.y + o.y);
  const Halfedge left = SurfaceMesh::previous(Halfedge(h)), right = SurfaceMesh::next(Halfedge(h));
  // Where a ray over x on the edge meets the left side, measured from the start of h; and the right
  // one, measured from the end of h, which is the same with left and right exchanged.
  const auto meets = [&](Real x, Real rootX, Real apexX, Real side) {
    const Real t = x * side * w.y / (apexX * w.y - o.y * (x - rootX));
    return t < 0 ? 0 : t < side ? t : side;
  };
  const auto child = [&](Index side, Real t0, Real t1) {
    const Point start = side == left ? o : Point{length, 0}, end = side == left ? Point{} : o;
    const Real ux = (end.x - start.x) / length_[side], uy = (end.y - start.y) / length_[side];
    const Real rx = root.x - start.x, ry = root.y - start.y;
    const Real height = std::max(Real(0), ux * ry - uy * rx);
    insertThrough(side, t0, t1, {rx * ux + ry * uy, height}, w.sigma);
  };
  if (from < split) {
    const Real side = length_[left];
    const Real low = meets(from, root.x, o.x, side);
    const Real high = to < split ? meets(to, root.x, o.x, side) : side;
    child(left, side - high, side - low);
  }
  if (to > split) {
    const Real side = length_[right];
    const Real low = meets(length - to, length - root.x, length - o.x, side);
    const Real high =
        from > split ? meets(length - from, length - root.x, length - o.x, side) : side;
    child(right, low, high);
  }
}

/// A window whose paths come through the face of `halfedge`, in whose plane everything is given.
void TextbookMmp::insertThrough(Index halfedge, Real from, Real to, Point root, Real sigma) {
  const Index edge = edgeOf_[halfedge];
  const Real length = length_[halfedge];
  if (halfedge == halfedgeOf_[edge]) {
    insert({from, to, root.x, root.y, sigma, edge, halfedge, false, false});
  } else {
    insert(
        {length - to, length - from, length - root.x, root.y, sigma, edge, halfedge, false, false});
  }
}

/// Paths along an edge from a point of it. They go nowhere else, but rule out longer ones.
void TextbookMmp::insertAlong(Index halfedge, Real root, Real sigma) {
  const Index edge = edgeOf_[halfedge];
  const Real length = length_[halfedge];
  insert({0, length, halfedge == halfedgeOf_[edge] ? root : length - root, 0, sigma, edge, kNoIndex,
          true, false});
}

Real TextbookMmp::along(const Window& w, Real x) { return w.sigma + norm(x - w.x, w.y); }

Real TextbookMmp::beyond(const Window& w, Point root, Real from, Real to, Point target) {
  const Real rise = target.y - root.y;
  const Real x = rise > 0 ? root.x - (target.x - root.x) * root.y / rise : target.x;
  if (x >= from && x <= to) return w.sigma + norm(target.x - root.x, rise);
  const Real end = x < from ? from : to;
  return w.sigma + norm(end - root.x, root.y) + norm(target.x - end, target.y);
}

/// Where the distances of two windows may be equal: σa + |x − ra| = σb + |x − rb|, squared twice.
/// Some solutions are those of another sign of a root; they do no harm.
void TextbookMmp::crossings(const Window& a, const Window& b, Real from, Real to,
                            std::vector<Real>& cuts) {
  cuts.clear();
  const auto take = [&](Real x) {
    // One step towards the very root, since squares have lost digits.
    for (int i = 0; i < 2; ++i) {
      const Real da = norm(x - a.x, a.y), db = norm(x - b.x, b.y);
      const Real slope = (x - a.x) / da - (x - b.x) / db;
      const Real step = (a.sigma + da - b.sigma - db) / slope;
      if (std::fabs(step) < 1e-6L * (to - from)) x -= step;
    }
    if (x > from && x < to) cuts.push_back(x);
  };
  const Real s = b.sigma - a.sigma, d = a.x - b.x;
  // With x counted from b's foot:  k − 2 d x = 2 s |x − rb|.
  const Real k = d * d + a.y * a.y - b.y * b.y - s * s;
  if (s == 0) {
    if (d != 0) take(b.x + k / (2 * d));
    return;
  }
  const Real p = 4 * (d * d - s * s), q = -2 * k * d, r = k * k - 4 * s * s * b.y * b.y;
  const Real discriminant = std::max(Real(0), q * q - p * r);
  const Real t = -q - std::copysign(std::sqrt(discriminant), q);
  if (t != 0) take(b.x + r / t);
  if (p != 0) take(b.x + t / p);
  std::sort(cuts.begin(), cuts.end());
}

TextbookMmp::WindowId TextbookMmp::add(Window window) {
  windows_.push_back(window);
  const auto id = static_cast<WindowId>(windows_.size() - 1);
  if (!window.done) {
    queue_.push({along(window, std::clamp(window.x, window.from, window.to)), kNoIndex, id});
  }
  return id;
}

/// Lays a window into the lower envelope of its edge.
void TextbookMmp::insert(const Window& w) {
  const Index h = halfedgeOf_[w.edge];
  const Real length = length_[h];
  if (!(w.to >= w.from)) return;
  lower(mesh_.from(Halfedge(h)), along(w, w.from) + w.from);
  lower(mesh_.to(Halfedge(h)), along(w, w.to) + length - w.to);
  const Real narrow = kNarrow * length;
  if (!(w.to - w.from > narrow)) return;

  // The nearest window at each place. The number of the new window is not given yet.
  constexpr auto kNew = static_cast<WindowId>(-1);
  std::vector<WindowId>& onEdge = onEdge_[w.edge];
  parts_.clear();
  bool taken = false;
  const auto part = [&](Real from, Real to, WindowId owner) {
    if (!(to > from)) return;
    if (!parts_.empty() && parts_.back().owner == owner && parts_.back().to == from) {
      parts_.back().to = to;
    } else {
      parts_.push_back({from, to, owner});
    }
    taken = taken || (owner == kNew && parts_.back().to - parts_.back().from > narrow);
  };
  Real reached = w.from;  // how far the new window has been gone through
  for (const WindowId id : onEdge) {
    const Window& u = windows_[id];
    const Real from = std::max(u.from, w.from), to = std::min(u.to, w.to);
    if (u.from >= w.to) {
      part(reached, w.to, kNew);
      reached = w.to;
    }
    if (!(to > from)) {
      part(u.from, u.to, id);
      continue;
    }
    part(reached, from, kNew);
    part(u.from, from, id);
    crossings(w, u, from, to, cuts_);
    cuts_.push_back(to);
    Real start = from;
    for (const Real end : cuts_) {
      const Real middle = (start + end) / 2, old = along(u, middle);
      part(start, end, along(w, middle) < old * (1 - kTie) ? kNew : id);
      start = end;
    }
    part(to, u.to, id);
    reached = to;
  }
  part(reached, w.to, kNew);
  if (!taken) return;

  if (onEdge.empty()) touchedEdges_.push_back(w.edge);
  for (const WindowId id : onEdge) windows_[id].dead = true;
  list_.clear();
  for (const Part& p : parts_) {
    if (!(p.to - p.from > narrow)) continue;
    Window window = p.owner == kNew ? w : windows_[p.owner];
    window.from = p.from;
    window.to = p.to;
    window.dead = false;
    if (p.owner != kNew && windows_[p.owner].dead) {
      windows_[p.owner] = window;  // its first part keeps the number
      list_.push_back(p.owner);
    } else {
      list_.push_back(add(window));
    }
  }
  onEdge = list_;
}

TextbookMmp::Point TextbookMmp::inPlaneOfNext(Index h, Point q) const {
  const Point o = apex(h);
  const Real next = length_[SurfaceMesh::next(Halfedge(h))];
  const Real ux = (o.x - length_[h]) / next, uy = o.y / next;
  return {(q.x - length_[h]) * ux + q.y * uy, ux * q.y - uy * (q.x - length_[h])};
}

TextbookMmp::Point TextbookMmp::inPlaneOfFirst(Index h, Point q) const {
  for (; h % 3 != 0; h = SurfaceMesh::next(Halfedge(h))) q = inPlaneOfNext(h, q);
  return q;
}

double TextbookMmp::distanceTo(const SurfacePoint& point) const {
  const auto& weights = point.weights;
  if (point.kind == SurfacePoint::Kind::AtVertex) {
    return static_cast<double>(distance_[point.element]);
  }
  if (point.kind == SurfacePoint::Kind::InFace) {
    const Index h = 3 * point.element;
    const Real w1 = weights[1], w2 = weights[2];
    return static_cast<double>(
        distanceInPlane(point.element, {w1 * length_[h] + w2 * apex(h).x, w2 * apex(h).y}));
  }
  const Index h = point.element, edge = edgeOf_[h];
  const Real length = length_[h], t = static_cast<Real>(weights[1]) * length;
  const Real x = h == halfedgeOf_[edge] ? t : length - t;
  Real best = std::min(distance_[mesh_.from(Halfedge(h))] + t,
                       distance_[mesh_.to(Halfedge(h))] + length - t);
  for (const WindowId id : onEdge_[edge]) {
    const Window& w = windows_[id];
    const Real inside = std::clamp(x, w.from, w.to);
    best = std::min(best, along(w, inside) + std::fabs(x - inside));
  }
  return static_cast<double>(best);
}

double TextbookMmp::distanceTo(Index face, double x, double y) const {
  return static_cast<double>(distanceInPlane(face, {x, y}));
}

double TextbookMmp::leastOn(Index h) const {
  Real least = std::min(distance_[mesh_.from(Halfedge(h))], distance_[mesh_.to(Halfedge(h))]);
  for (const WindowId id : onEdge_[edgeOf_[h]]) {
    const Window& w = windows_[id];
    least = std::min(least, along(w, std::clamp(w.x, w.from, w.to)));
  }
  return static_cast<double>(least);
}

std::array<std::array<double, 2>, 3> TextbookMmp::corners(Index face) const {
  const Point o = apex(3 * face);
  return {{{0, 0},
           {static_cast<double>(length_[3 * face]), 0},
           {static_cast<double>(o.x), static_cast<double>(o.y)}}};
}

Real TextbookMmp::distanceInPlane(Index face, Point q) const {
  Real best = kInfinity;
  for (const auto& [sourceFace, source] : sourceInPlane_) {
    if (sourceFace == face) best = std::min(best, norm(q.x - source.x, q.y - source.y));
  }
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    best = std::min(best, distance_[mesh_.from(Halfedge(h))] + norm(q.x, q.y));
    const bool forward = h == halfedgeOf_[edgeOf_[h]];
    const Real length = length_[h];
    for (const WindowId id : onEdge_[edgeOf_[h]]) {
      const Window& w = windows_[id];
      if (w.through == h) continue;  // comes out of this face
      const Real from = forward ? w.from : length - w.to, to = forward ? w.to : length - w.from;
      best = std::min(best, beyond(w, {forward ? w.x : length - w.x, -w.y}, from, to, q));
    }
    q = inPlaneOfNext(h, q);
  }
  return best;
}

}  // namespace girth::test
