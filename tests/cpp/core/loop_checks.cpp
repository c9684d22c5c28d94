#include "loop_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/vector.h"

namespace girth::test {

namespace {

/// Total angle at a vertex from its first halfedge round to the direction of a point in space that
/// lies in one of its faces; negative if it lies in none.
double directionTo(const SurfaceMesh& mesh, Index vertex, const Vec3& target) {
  const Vec3 d = target - mesh.position(vertex);
  double start = 0, best = -1, bestExcess = 1e-7;
  Index h = mesh.outgoing(vertex);
  do {
    const Vec3 a = mesh.position(mesh.to(h)) - mesh.position(vertex);
    const Vec3 b = mesh.position(mesh.from(SurfaceMesh::previous(h))) - mesh.position(vertex);
    const auto angle = [](const Vec3& u, const Vec3& v) {
      return std::atan2(norm(cross(u, v)), dot(u, v));
    };
    // Inside the corner, the angles to its two sides add up to the corner's own.
    const double excess = angle(a, d) + angle(d, b) - angle(a, b);
    if (excess < bestExcess) {
      bestExcess = excess;
      best = start + angle(a, d);
    }
    start += angle(a, b);
    h = mesh.twin(SurfaceMesh::previous(h));
  } while (h != kNoIndex && h != mesh.outgoing(vertex));
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
    // Rounding turns a short step by more.
    const double slack = 1e-7 + 1e-12 * loop.length / std::min(norm(in), norm(out));
    const SurfacePoint& point = loop.points[i];
    if (point.kind == SurfacePoint::Kind::Edge) {
      const Vec3 edge =
          mesh.position(mesh.to(point.element)) - mesh.position(mesh.from(point.element));
      const double cosIn = dot(in, edge) / norm(in) / norm(edge);
      const double cosOut = dot(out, edge) / norm(out) / norm(edge);
      EXPECT_NEAR(cosIn, cosOut, slack) << "point " << i << " of the loop at " << base;
    } else if (point.kind == SurfacePoint::Kind::Vertex && slack < 1e-3) {
      const double a = directionTo(mesh, point.element, points[i - 1]);
      const double b = directionTo(mesh, point.element, points[i + 1]);
      ASSERT_GE(a, 0) << "point " << i << " of the loop at " << base;
      ASSERT_GE(b, 0) << "point " << i << " of the loop at " << base;
      const double side = std::fabs(a - b), other = mesh.totalAngle(point.element) - side;
      EXPECT_GE(side, M_PI - 1e-6 - slack) << "point " << i << " at " << base;
      if (!mesh.isBoundary(point.element)) {
        EXPECT_GE(other, M_PI - 1e-6 - slack) << "point " << i << " at " << base;
      }
    } else {
      EXPECT_NE(point.kind, SurfacePoint::Kind::Face) << "point " << i << " at " << base;
    }
  }
  EXPECT_GE(loop.angle, 0);
  const bool vertex = loop.base.kind == SurfacePoint::Kind::Vertex;
  EXPECT_LE(loop.angle, (vertex ? mesh.totalAngle(loop.base.element) / 2 : M_PI) + 1e-9);
}

}  // namespace girth::test
