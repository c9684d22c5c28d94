#include "geodesic/path_tracing.h"

#include <algorithm>
#include <array>

#include "geodesic/trimming.h"

namespace girth::geodesic {

namespace {

/// A point of a halfedge at distance t from its start; a vertex where it lies within kTouch of one.
SurfacePoint pointOfEdge(const Unfolding& unfolding, Index halfedge, double t) {
  const Crossing c = unfolding.crossing(halfedge);
  if (t <= kTouch * c.length()) return SurfacePoint::atVertex(Vertex(c.from()));
  if (t >= c.length() * (1 - kTouch)) return SurfacePoint::atVertex(Vertex(c.to()));
  const Index twin = unfolding.twin(halfedge);
  if (twin < halfedge) return SurfacePoint::onHalfedge(Halfedge(twin), 1 - t / c.length());
  return SurfacePoint::onHalfedge(Halfedge(halfedge), t / c.length());
}

/// Appends a point unless the path stands there already.
void append(std::vector<SurfacePoint>& path, const SurfacePoint& point) {
  if (path.empty() || !samePoint(path.back(), point)) path.push_back(point);
}

SurfacePoint sourcePoint(const Propagation& propagation, Index source) {
  return endOfPath(propagation.unfolding(), propagation.source(source));
}

/// A bundle and where its window lies on the halfedge.
struct Passage {
  Bundle bundle;
  double low, high;
};

/// How far the straight line from the root of a window to a point above its halfedge passes beside
/// the window.
double missBy(const Window& w, double length, Vec2 point) {
  const double rise = point.y - w.root.y;
  const double t = w.root.x - (point.x - w.root.x) * w.root.y / rise;
  return std::max({0.0, w.gapFrom - t, t - (length - w.gapTo)});
}

/// The window of a bundle that sees a point best: windows of one root may differ in the way they
/// pass a flat vertex.
Passage passageTo(const Propagation& propagation, const Bundle& bundle, Vec2 point) {
  const double length = propagation.unfolding().crossing(bundle.halfedge).length();
  Passage best{bundle, 0, length};
  double bestMiss = std::numeric_limits<double>::infinity();
  propagation.eachEntered(bundle.halfedge, [&](const Window& w) {
    if (w.sigma != bundle.sigma || w.root.x != bundle.root.x || w.root.y != bundle.root.y) return;
    const double miss = missBy(w, length, point);
    // Among windows that see it alike, the first one counts.
    if (miss <= bestMiss && std::isfinite(miss)) {
      bestMiss = miss;
      best = {bundle, w.gapFrom, length - w.gapTo};
    }
  });
  return best;
}

/// The passage that continues as `bundle` through the point `crossing` of its halfedge, in the face
/// behind; no halfedge if the bundle begins there.
Passage passageBefore(const Propagation& propagation, const Bundle& bundle, double crossing) {
  const Unfolding& unfolding = propagation.unfolding();
  const Index behind = unfolding.twin(bundle.halfedge);
  const Vec2 point{unfolding.crossing(behind).length() - crossing, 0};
  Passage best{{}, 0, 0};
  double bestMiss = std::numeric_limits<double>::infinity();
  for (const Index side : {Unfolding::next(behind), Unfolding::previous(behind)}) {
    const Crossing c = unfolding.crossing(side);
    const bool throughLeft = c.leftTwin() == bundle.halfedge;
    const Vec2 p = unfolding.toFrame(behind, side, point);
    propagation.eachEntered(side, [&](const Window& w) {
      if (w.sigma != bundle.sigma) return;
      Pair<double> root =
          throughLeft ? rootBeyond(w.root.x, w.root.y, c.left().x, c.left().y)
                      : rootBeyond(c.length() - w.root.x, w.root.y, c.right().x, c.right().y);
      if (!throughLeft) root.x = c.rightLength() - root.x;
      if (root.x != bundle.root.x || root.y != bundle.root.y) return;
      const double miss = missBy(w, c.length(), p);
      const bool isSameSide = best.bundle.halfedge == side;
      if (miss < bestMiss || (miss == bestMiss && isSameSide)) {
        bestMiss = miss;
        best = {{side, w.root, w.sigma}, w.gapFrom, c.length() - w.gapTo};
      }
    });
  }
  return best;
}

}  // namespace

SurfacePoint endOfPath(const Unfolding& unfolding, const SurfacePoint& point) {
  if (point.kind != SurfacePoint::Kind::OnEdge) return point;
  return pointOfEdge(unfolding, point.element,
                     point.weights[1] * unfolding.crossing(point.element).length());
}

bool samePoint(const SurfacePoint& a, const SurfacePoint& b) {
  return a.kind == b.kind && a.element == b.element &&
         std::fabs(a.weights[0] - b.weights[0]) <= kTouch &&
         std::fabs(a.weights[1] - b.weights[1]) <= kTouch;
}

void traceBundle(const Propagation& propagation, Bundle bundle, Vec2 point,
                 std::vector<SurfacePoint>& path) {
  const Unfolding& unfolding = propagation.unfolding();
  for (Passage passage = passageTo(propagation, bundle, point);;) {
    bundle = passage.bundle;
    // Where the straight line from the root to the point crosses the halfedge.
    const double length = unfolding.crossing(bundle.halfedge).length();
    const double rise = point.y - bundle.root.y;
    const double t =
        rise > 0 ? bundle.root.x - (point.x - bundle.root.x) * bundle.root.y / rise : point.x;
    const double crossing = std::clamp(t, passage.low, std::max(passage.low, passage.high));
    append(path, pointOfEdge(unfolding, bundle.halfedge, crossing));

    passage = passageBefore(propagation, bundle, crossing);
    const Index behind = unfolding.twin(bundle.halfedge);
    if (passage.bundle.halfedge != kNoIndex) {
      point = unfolding.toFrame(behind, passage.bundle.halfedge, {length - crossing, 0});
      continue;
    }
    const Vec2 root = unfolding.toTwin(bundle.halfedge, bundle.root);
    for (const Propagation::Origin& origin : propagation.origins()) {
      if (bundle.sigma != 0 || origin.face != faceOfSide(behind)) continue;
      const Vec2 place = unfolding.toFrame(3 * origin.face, behind, origin.place);
      if (norm(place - root) > kTouch * length) continue;
      append(path, sourcePoint(propagation, origin.source));
      return;
    }
    traceVertex(propagation, unfolding.crossing(behind).apexVertex(), path);
    return;
  }
}

void traceVertex(const Propagation& propagation, Index vertex, std::vector<SurfacePoint>& path) {
  for (;;) {
    append(path, SurfacePoint::atVertex(Vertex(vertex)));
    const Arrival& arrival = propagation.arrival(vertex);
    switch (arrival.way) {
      case Arrival::Way::None:
      case Arrival::Way::Source:
        return;
      case Arrival::Way::Straight:
        append(path, sourcePoint(propagation, arrival.before));
        return;
      case Arrival::Way::Edge:
        vertex = arrival.before;
        break;
      case Arrival::Way::Window:
        traceBundle(propagation, arrival.bundle,
                    propagation.unfolding().crossing(arrival.bundle.halfedge).apex(), path);
        return;
    }
  }
}

void tracePath(const Propagation& propagation, const PathEnd& end, Index halfedge, Vec2 point,
               std::vector<SurfacePoint>& path) {
  const Index entry = end.bundle.halfedge;
  if (entry != kNoIndex) {
    traceBundle(propagation, end.bundle, propagation.unfolding().toFrame(halfedge, entry, point),
                path);
  } else if (end.corner != kNoIndex) {
    traceVertex(propagation, end.corner, path);
  } else {
    append(path, sourcePoint(propagation, end.source));
  }
}

SurfacePoint surfacePointAt(const Unfolding& unfolding, Index halfedge, Vec2 point) {
  const Index face = faceOfSide(halfedge);
  std::array<double, 3> weights{};
  double sum = 0;
  for (Index k = 0; k < 3; ++k) {
    const Index h = 3 * face + k;
    const Vec2 p = unfolding.toFrame(halfedge, h, point);
    const double length = unfolding.crossing(h).length();
    if (p.y <= kTouch * length) return pointOfEdge(unfolding, h, p.x);
    // Height over side k against the opposite corner's: the share of corner k + 2.
    weights[(k + 2) % 3] = p.y * length;
    sum += weights[(k + 2) % 3];
  }
  for (double& weight : weights) weight /= sum;
  return SurfacePoint::inFace(Face(face), weights);
}

}  // namespace girth::geodesic
