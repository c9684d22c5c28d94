#include "loop_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geodesic/tolerances.h"
#include "mesh/vector.h"

namespace girth::test {

namespace {

/// Angles at a vertex, from its first halfedge round, at which a point of one of its faces may lie:
/// one, unless the faces meet there twice. Said by the elements, since folds lie on one another in
/// space.
std::vector<double> directionsTo(const SurfaceMesh& mesh, Index vertex, const SurfacePoint& point) {
  const Vec3 p = mesh.position(Vertex(vertex)), d = positionOf(mesh, point) - p;
  const Index twin =
      point.kind == SurfacePoint::Kind::OnEdge ? mesh.twin(Halfedge(point.element)) : kNoIndex;
  const auto isOn = [&](Index h) {
    return point.kind == SurfacePoint::Kind::OnEdge && (point.element == h || twin == h);
  };
  std::vector<double> directions;
  double start = 0;
  Halfedge h = mesh.outgoing(Vertex(vertex));
  do {
    const Halfedge in = SurfaceMesh::previous(h);
    const Vec3 a = mesh.position(mesh.to(h)) - p, b = mesh.position(mesh.from(in)) - p;
    const auto angle = [](const Vec3& u, const Vec3& v) {
      return std::atan2(norm(cross(u, v)), dot(u, v));
    };
    const bool atVertex = point.kind == SurfacePoint::Kind::AtVertex;
    if (isOn(h) || (atVertex && point.element == mesh.to(h))) {
      directions.push_back(start);
    } else if (isOn(SurfaceMesh::next(h)) || (point.kind == SurfacePoint::Kind::InFace &&
                                              point.element == SurfaceMesh::faceOf(h))) {
      directions.push_back(start + angle(a, d));
    } else if (isOn(in) || (atVertex && point.element == mesh.from(in))) {
      directions.push_back(start + angle(a, b));
    }
    start += angle(a, b);
    h = mesh.twin(in);
  } while (h != kNoIndex && h != mesh.outgoing(Vertex(vertex)));
  return directions;
}

/// How far from the loop a point of it may be drawn: a crossing within kTouch of the end of an edge
/// is drawn at the vertex there.
double drawnAside(const SurfaceMesh& mesh, const SurfacePoint& point) {
  if (point.kind != SurfacePoint::Kind::AtVertex) return 0;
  double longest = 0;
  Halfedge h = mesh.outgoing(point.vertex());
  do {
    const Halfedge in = SurfaceMesh::previous(h);
    longest = std::max({longest, mesh.length(h), mesh.length(in)});
    h = mesh.twin(in);
  } while (h != kNoIndex && h != mesh.outgoing(point.vertex()));
  return geodesic::kTouch * longest;
}

/// Least angle that two directions leave between them inside the surface, at best.
double straightnessAt(const SurfaceMesh& mesh, Index vertex, const SurfacePoint& before,
                      const SurfacePoint& after) {
  double best = -1;
  for (const double a : directionsTo(mesh, vertex, before)) {
    for (const double b : directionsTo(mesh, vertex, after)) {
      const double side = std::fabs(a - b), other = mesh.totalAngle(Vertex(vertex)) - side;
      best = std::max(best, mesh.isBoundary(Vertex(vertex)) ? side : std::min(side, other));
    }
  }
  return best;
}

}  // namespace

void expectGeodesicLoop(const SurfaceMesh& mesh, const GirthLoop& loop) {
  const Index base = loop.base.element;
  const std::vector<Vec3> points = polyline(mesh, loop);
  const std::size_t n = points.size();
  ASSERT_GE(n, 3u);
  for (const std::size_t end : {std::size_t{0}, n - 1}) {
    EXPECT_EQ(loop.points[end].kind, loop.base.kind);
    EXPECT_EQ(loop.points[end].element, loop.base.element);
  }

  double length = 0;
  for (std::size_t i = 1; i < n; ++i) length += norm(points[i] - points[i - 1]);
  EXPECT_NEAR(length / loop.length, 1, 1e-9) << "at " << base;

  // The midpoint: half-way along, and on a segment.
  const Vec3 q = positionOf(mesh, loop.midpoint);
  double along = 0, off = 1e300, at = 0;
  for (std::size_t i = 1; i < n; ++i) {
    const Vec3 d = points[i] - points[i - 1];
    const double segment = norm(d);
    const double t =
        segment > 0 ? std::clamp(dot(q - points[i - 1], d) / (segment * segment), 0.0, 1.0) : 0;
    const double away = norm(q - (points[i - 1] + t * d));
    if (away < off) {
      off = away;
      at = along + t * segment;
    }
    along += segment;
  }
  EXPECT_LT(off, 1e-8 * loop.length) << "at " << base;
  EXPECT_NEAR(at / loop.length, 0.5, 1e-8) << "at " << base;

  const bool thereAndBack = loop.kind == LoopKind::Antipodal;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (thereAndBack && 2 * i + 1 == n) continue;  // where it turns round
    const Vec3 in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    // Each half may be bent by kFanOverlap at a root, and miss the end of a window by kAim: this
    // turns a short step by more.
    const double aside = 2 * (geodesic::kFanOverlap + geodesic::kAim) * loop.length;
    const double slack = 1e-7 + aside / std::min(norm(in), norm(out)) +
                         drawnAside(mesh, loop.points[i - 1]) / norm(in) +
                         drawnAside(mesh, loop.points[i + 1]) / norm(out);
    const SurfacePoint& point = loop.points[i];
    if (point.kind == SurfacePoint::Kind::OnEdge) {
      const Vec3 edge = mesh.position(mesh.to(Halfedge(point.element))) -
                        mesh.position(mesh.from(Halfedge(point.element)));
      const double cosIn = dot(in, edge) / norm(in) / norm(edge);
      const double cosOut = dot(out, edge) / norm(out) / norm(edge);
      EXPECT_NEAR(cosIn, cosOut, slack) << "point " << i << " of the loop at " << base;
    } else if (point.kind == SurfacePoint::Kind::AtVertex && slack < 1e-3) {
      EXPECT_GE(straightnessAt(mesh, point.element, loop.points[i - 1], loop.points[i + 1]),
                M_PI - 1e-6 - slack)
          << "point " << i << " at " << base;
    } else {
      EXPECT_NE(point.kind, SurfacePoint::Kind::InFace) << "point " << i << " at " << base;
    }
  }
  EXPECT_GE(loop.angle, 0);
  double widest = M_PI;
  if (loop.base.kind == SurfacePoint::Kind::AtVertex) {  // at a boundary there is but one side
    widest = mesh.totalAngle(Vertex(base)) / (mesh.isBoundary(Vertex(base)) ? 1 : 2);
  }
  EXPECT_LE(loop.angle, widest + 1e-9);
}

}  // namespace girth::test
