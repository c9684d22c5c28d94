#include "geodesic/path_tracing.h"

namespace girth::geodesic {

namespace {

/// A point of a halfedge at distance t from its start; a vertex where it lies within kTouch of one.
SurfacePoint pointOfSide(const Unfolding& unfolding, Index halfedge, double t) {
  const Side& side = unfolding.side(halfedge);
  if (t <= kTouch * side.length) return SurfacePoint::atVertex(side.from);
  if (t >= side.length * (1 - kTouch)) {
    return SurfacePoint::atVertex(unfolding.side(SurfaceMesh::next(halfedge)).from);
  }
  if (side.twin < halfedge) return SurfacePoint::onHalfedge(side.twin, 1 - t / side.length);
  return SurfacePoint::onHalfedge(halfedge, t / side.length);
}

/// Appends a point unless the path stands there already.
void append(std::vector<SurfacePoint>& path, const SurfacePoint& point) {
  if (path.empty() || !samePoint(path.back(), point)) path.push_back(point);
}

}  // namespace

bool samePoint(const SurfacePoint& a, const SurfacePoint& b) {
  return a.kind == b.kind && a.element == b.element &&
         std::fabs(a.weights[0] - b.weights[0]) <= kTouch &&
         std::fabs(a.weights[1] - b.weights[1]) <= kTouch;
}

void traceFromWindow(const Propagation& propagation, Index window, Vec2 point,
                     std::vector<SurfacePoint>& path) {
  const Unfolding& unfolding = propagation.unfolding();
  for (;;) {
    const Window& w = propagation.window(window);
    const Side& side = unfolding.side(w.halfedge);
    // Where the straight line from the root to the point crosses the halfedge.
    const Vec2 ray = point - w.root;
    // A point on the halfedge itself, seen along it, is its own crossing.
    const double across = cross(side.direction, ray);
    const double t = across > 0 ? cross(w.root - side.start, ray) / across
                                : dot(side.direction, point - side.start);
    const double crossing = std::clamp(t, w.gapFrom, std::max(w.gapFrom, side.length - w.gapTo));
    append(path, pointOfSide(unfolding, w.halfedge, crossing));
    if (w.parent == kNoIndex) {
      traceFromVertex(propagation, w.rootVertex, path);
      return;
    }
    window = w.parent;
    point = unfolding.side(side.twin).at(side.length - crossing);
  }
}

void traceFromVertex(const Propagation& propagation, Index vertex,
                     std::vector<SurfacePoint>& path) {
  const Unfolding& unfolding = propagation.unfolding();
  for (;;) {
    append(path, SurfacePoint::atVertex(vertex));
    if (vertex == propagation.source()) return;
    const Arrival& arrival = propagation.arrival(vertex);
    if (!arrival.alongEdge) {
      const Index h = propagation.window(arrival.carrier).halfedge;
      traceFromWindow(propagation, arrival.carrier, unfolding.side(SurfaceMesh::previous(h)).start,
                      path);
      return;
    }
    vertex = unfolding.side(SurfaceMesh::next(arrival.carrier)).from;
  }
}

SurfacePoint surfacePointAt(const Unfolding& unfolding, Index face, Vec2 point) {
  std::array<double, 3> weights{};
  double sum = 0;
  for (Index k = 0; k < 3; ++k) {
    const Index h = 3 * face + k;
    const Side& side = unfolding.side(h);
    const double height = cross(side.direction, point - side.start);
    if (height <= kTouch * side.length) {
      return pointOfSide(unfolding, h, dot(side.direction, point - side.start));
    }
    // Height over side k against the opposite corner's: the share of corner k + 2.
    weights[(k + 2) % 3] = height * side.length;
    sum += weights[(k + 2) % 3];
  }
  for (double& weight : weights) weight /= sum;
  return SurfacePoint::inFace(face, weights);
}

}  // namespace girth::geodesic
