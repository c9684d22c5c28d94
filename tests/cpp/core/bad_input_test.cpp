// Input that is wrong or extreme: a coded error or a value, in time.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <utility>
#include <vector>

#include "girth/girth.h"
#include "shapes.h"
#include "textbook_mmp.h"

namespace girth::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The code with which a shape is refused both as a closed surface and as one with boundary.
ErrorCode refusal(const Shape& shape) {
  const auto closed = SurfaceMesh::fromArrays(shape.positions, shape.triangles);
  const auto open = SurfaceMesh::fromArrays(shape.positions, shape.triangles, OpenEdges::Boundary);
  EXPECT_FALSE(closed.ok());
  EXPECT_FALSE(open.ok());
  if (closed.ok() || open.ok()) return ErrorCode::Internal;
  EXPECT_EQ(closed.error().code, open.error().code);
  EXPECT_GE(closed.error().element, 0);
  EXPECT_FALSE(closed.error().message.empty());
  return closed.error().code;
}

/// Fails the test if a piece of work takes longer. The processor's time counts: what else the
/// machine does has no part in it.
template <class Work>
void within(std::chrono::seconds limit, Work work) {
  const std::clock_t start = std::clock();
  work();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, static_cast<double>(limit.count()));
}

TEST(BadInput, MeshesAreRefusedWithTheirCode) {
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    Shape shape = octasphere(1);
    shape.positions[10] = bad;
    EXPECT_EQ(refusal(shape), ErrorCode::NonFinitePosition);
  }
  Shape shape = octasphere(1);  // an edge of length zero
  const Index a = shape.triangles[0], b = shape.triangles[1];
  for (Index k = 0; k < 3; ++k) shape.positions[3 * b + k] = shape.positions[3 * a + k];
  EXPECT_EQ(refusal(shape), ErrorCode::DegenerateFace);

  shape = octasphere(0);  // a face of no area: its corners in line
  for (Index k = 0; k < 3; ++k) {
    shape.positions[3 * shape.triangles[2] + k] = (shape.positions[3 * shape.triangles[0] + k] +
                                                   shape.positions[3 * shape.triangles[1] + k]) /
                                                  2;
  }
  EXPECT_EQ(refusal(shape), ErrorCode::DegenerateFace);

  shape = octasphere(0);  // a vertex twice in a face
  shape.triangles[4] = shape.triangles[3];
  EXPECT_EQ(refusal(shape), ErrorCode::DegenerateFace);

  shape = octasphere(0);
  shape.triangles[5] = shape.vertexCount();
  EXPECT_EQ(refusal(shape), ErrorCode::IndexOutOfRange);
}

TEST(BadInput, TheSmallestSurfaces) {
  const SurfaceMesh four = tetrahedron().mesh();
  for (Index v = 0; v < 4; ++v) {
    EXPECT_NEAR(GirthSolver(four).value(Vertex(v)).value().length, 4 * std::sqrt(8.0 / 3), 1e-12);
  }
  Shape triangle;  // one face, boundary all round
  triangle.positions = {0, 0, 0, 3, 0, 0, 0, 4, 0};
  triangle.triangles = {0, 1, 2};
  const SurfaceMesh one = triangle.mesh(OpenEdges::Boundary);
  GirthSolver solver(one);
  for (const auto& [vertex, farthest] : {std::pair(0u, 4.0), {1u, 5.0}, {2u, 5.0}}) {
    const GirthLoop loop = solver.loop(Vertex(vertex)).value();
    EXPECT_EQ(loop.kind, LoopKind::Antipodal);
    EXPECT_NEAR(loop.length, 2 * farthest, 1e-12);
  }
  const GirthLoop inside = solver.loop(SurfacePoint::inFace(Face(0), {0.5, 0.25, 0.25})).value();
  EXPECT_EQ(inside.kind, LoopKind::Antipodal);
  EXPECT_NEAR(inside.length, 2 * std::hypot(0.75, 3), 1e-12);  // to (0, 4) from (0.75, 1)
}

TEST(BadInput, CoordinatesOfAnySizeScaleTheValues) {
  const Shape shape = perturbed(torus(2, 0.7, 10, 6), 0.2, 1);
  const SurfaceMesh mesh = shape.mesh();
  for (const double scale : {1e-150, 1e150}) {
    const SurfaceMesh scaled = moved(shape, scale, 0, 0).mesh();
    const GirthField field = girthField(mesh), other = girthField(scaled);
    const auto distances =
        GeodesicSolver(mesh).distances(SurfacePoint::atVertex(Vertex(0))).value();
    const auto others = GeodesicSolver(scaled).distances(SurfacePoint::atVertex(Vertex(0))).value();
    for (const Vertex v : mesh.vertices()) {
      EXPECT_NEAR(other.values[v] / scale / field.values[v], 1, 1e-9);
      EXPECT_NEAR(others[v] / scale, distances[v], 1e-12);
    }
  }
  // Far from the origin, coordinates keep few digits; it is that surface that counts.
  const SurfaceMesh far = moved(box(1, 1, 4, 2, 2, 8), 1, 0, 1e9).mesh();
  const GirthField field = girthField(far);
  for (const double value : field.values) EXPECT_TRUE(value > 2 && value < 12) << value;
}

/// Triangles, or tetrahedra, that have nothing to do with each other.
Shape scattered(Index count, const Shape& piece) {
  Shape shape;
  for (Index i = 0; i < count; ++i) {
    const Index first = shape.vertexCount();
    for (std::size_t k = 0; k < piece.positions.size(); ++k) {
      shape.positions.push_back(piece.positions[k] + (k % 3 == 0 ? 4.0 * i : 0));
    }
    for (const Index v : piece.triangles) shape.triangles.push_back(v + first);
  }
  return shape;
}

TEST(BadInput, AMillionTriangles) {
  Shape triangle;
  triangle.positions = {0, 0, 0, 3, 0, 0, 0, 4, 0};
  triangle.triangles = {0, 1, 2};
  const Index count = 1'000'000;
  const Shape shape = scattered(count, triangle);
  within(std::chrono::seconds(20), [&] {
    const auto refused = SurfaceMesh::fromArrays(shape.positions, shape.triangles);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::OpenEdge);
  });
  within(std::chrono::seconds(120), [&] {
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    EXPECT_EQ(mesh.componentCount(), count);
    const GirthField field = girthField(mesh);
    ASSERT_TRUE(field.complete());
    for (Index v = 0; v < mesh.vertexCount(); v += 997) {
      EXPECT_NEAR(field.values[v], v % 3 == 0 ? 8 : 10, 1e-7) << "vertex " << v;
      EXPECT_EQ(field.kinds[v], LoopKind::Antipodal);
    }
    const auto distances =
        GeodesicSolver(mesh).distances(SurfacePoint::atVertex(Vertex(3 * (count / 2)))).value();
    EXPECT_EQ(distances[0], kInfinity);
    EXPECT_NEAR(distances[3 * (count / 2) + 1], 3, 1e-7);
  });
}

TEST(BadInput, AHundredThousandTetrahedra) {
  const Shape shape = scattered(100'000, tetrahedron());
  within(std::chrono::seconds(60), [&] {
    const SurfaceMesh mesh = shape.mesh();
    const GirthField field = girthField(mesh);
    ASSERT_TRUE(field.complete());
    for (Index v = 0; v < mesh.vertexCount(); v += 101) {
      EXPECT_NEAR(field.values[v], 4 * std::sqrt(8.0 / 3), 1e-7) << "vertex " << v;
    }
  });
}

TEST(BadInput, PointsAndRadiiThatDoNotExist) {
  const SurfaceMesh mesh = box(1, 1, 1, 2, 2, 2).mesh();
  GeodesicSolver solver(mesh);
  GirthSolver girths(mesh);
  const SurfacePoint vertex = SurfacePoint::atVertex(Vertex(0));
  const Index vertices = mesh.vertexCount();
  for (const Index number : {vertices, kNoIndex}) {
    const SurfacePoint none = SurfacePoint::atVertex(Vertex(number));
    EXPECT_EQ(solver.distances(none).error().code, ErrorCode::VertexOutOfRange);
    EXPECT_EQ(solver.path(vertex, none).error().code, ErrorCode::VertexOutOfRange);
    EXPECT_EQ(solver.path(none, vertex).error().code, ErrorCode::VertexOutOfRange);
    EXPECT_EQ(girths.value(none).error().code, ErrorCode::VertexOutOfRange);
    EXPECT_EQ(girths.loop(Vertex(number)).error().code, ErrorCode::VertexOutOfRange);
  }
  for (const SurfacePoint& none :
       {SurfacePoint::onHalfedge(Halfedge(mesh.halfedgeCount()), 0.5),
        SurfacePoint::onHalfedge(Halfedge(0), -0.1), SurfacePoint::onHalfedge(Halfedge(0), kNaN),
        SurfacePoint::inFace(Face(mesh.faceCount()), {1, 0, 0}),
        SurfacePoint::inFace(Face(0), {kNaN, 0.5, 0.5}),
        SurfacePoint::inFace(Face(0), {2, -0.5, -0.5}),
        SurfacePoint::inFace(Face(0), {0.2, 0.2, 0.2}),
        SurfacePoint::inFace(Face(0), {kInfinity, 0, 0})}) {
    EXPECT_EQ(solver.distances(none).error().code, ErrorCode::InvalidPoint);
    EXPECT_EQ(solver.path(none, vertex).error().code, ErrorCode::InvalidPoint);
    EXPECT_EQ(solver.path(vertex, none).error().code, ErrorCode::InvalidPoint);
    EXPECT_EQ(girths.value(none).error().code, ErrorCode::InvalidPoint);
    EXPECT_EQ(girths.loop(none).error().code, ErrorCode::InvalidPoint);
  }
  for (const double radius : {-1.0, -kInfinity, kNaN}) {
    EXPECT_EQ(solver.distances(vertex, radius).error().code, ErrorCode::InvalidRadius);
  }
  // At the edge of what is allowed.
  const auto none = solver.distances(std::span<const SurfacePoint>()).value();
  for (const double distance : none) EXPECT_EQ(distance, kInfinity);
  const auto self = solver.distances(vertex, 0).value();
  for (Index v = 0; v < vertices; ++v) EXPECT_EQ(self[v], v == 0 ? 0 : kInfinity);
  const GeodesicPath still = solver.path(vertex, vertex).value();
  EXPECT_EQ(still.length, 0);
}

TEST(BadInput, PointsAtCornersAndOnSidesAreThoseCornersAndSides) {
  const SurfaceMesh mesh = perturbed(torus(2, 0.7, 10, 6), 0.2, 1).mesh();
  GirthSolver solver(mesh);
  for (Index f = 0; f < mesh.faceCount(); f += 7) {
    const Index h = 3 * f + 1, corner = mesh.from(Halfedge(h));
    const double atCorner = solver.value(Vertex(corner)).value().length;
    for (const SurfacePoint& same :
         {SurfacePoint::onHalfedge(Halfedge(h), 0), SurfacePoint::inFace(Face(f), {0, 1, 0}),
          SurfacePoint::onHalfedge(SurfaceMesh::previous(Halfedge(h)), 1)}) {
      EXPECT_NEAR(solver.value(same).value().length / atCorner, 1, 1e-9) << "face " << f;
    }
    const double onSide = solver.value(SurfacePoint::onHalfedge(Halfedge(h), 0.3)).value().length;
    for (const SurfacePoint& same : {SurfacePoint::onHalfedge(mesh.twin(Halfedge(h)), 0.7),
                                     SurfacePoint::inFace(Face(f), {0, 0.7, 0.3})}) {
      EXPECT_NEAR(solver.value(same).value().length / onSide, 1, 1e-9) << "face " << f;
    }
  }
}

TEST(BadInput, ABudgetEndsTheWork) {
  const SurfaceMesh mesh = perturbed(octasphere(4), 0.3, 1).mesh();
  GirthSolver girths(mesh);
  girths.setBudget(50);
  const auto value = girths.value(Vertex(0));
  ASSERT_TRUE(value.ok());
  EXPECT_EQ(value.value().kind, LoopKind::Unresolved);
  EXPECT_EQ(girths.loop(Vertex(0)).value().kind, LoopKind::Unresolved);
  girths.setBudget(1 << 26);
  EXPECT_NE(girths.value(Vertex(0)).value().kind, LoopKind::Unresolved);
  GeodesicSolver distances(mesh);
  distances.setBudget(50);
  EXPECT_EQ(distances.distances(SurfacePoint::atVertex(Vertex(0))).error().code,
            ErrorCode::LimitExceeded);
}

TEST(BadInput, allOfALargeSurfaceIsWithinTheBudget) {
  // A bumpy ball of 328,000 triangles takes more windows than a source of a girth may.
  Shape ball = icosphere(7);
  for (std::size_t i = 0; i < ball.positions.size(); i += 3) {
    double &x = ball.positions[i], &y = ball.positions[i + 1], &z = ball.positions[i + 2];
    const double r = 1 + 0.12 * std::sin(3 * x + 1) + 0.1 * std::sin(2.5 * y + 2 * z) +
                     0.05 * std::cos(4 * z - x);
    x *= 1.3 * r;
    y *= 0.9 * r;
    z *= r;
  }
  const SurfaceMesh mesh = ball.mesh();
  GeodesicSolver solver(mesh);
  const auto distances = solver.distances(SurfacePoint::atVertex(Vertex(0)));
  ASSERT_TRUE(distances) << distances.error().message;
  EXPECT_GT(solver.statistics().windowsCrossed, std::size_t{1} << 26);
  EXPECT_TRUE(std::all_of(distances.value().begin(), distances.value().end(),
                          [](double distance) { return std::isfinite(distance); }));
}

TEST(BadInput, WhatABudgetLeavesIsBoundedFromBothSides) {
  for (const Shape& shape : {perturbed(octasphere(3), 0.3, 1), box(1, 1, 4, 2, 2, 8),
                             perturbed(torus(3, 1, 16, 9), 0.2, 2), pyramid(40, 1, 3)}) {
    const SurfaceMesh mesh = shape.mesh();
    GirthSolver whole(mesh), poor(mesh);
    std::vector<SurfacePoint> points{SurfacePoint::inFace(Face(1), {0.2, 0.3, 0.5})};
    for (Index v = 0; v < mesh.vertexCount(); v += 11) {
      points.push_back(SurfacePoint::atVertex(Vertex(v)));
    }
    for (const SurfacePoint& point : points) {
      const GirthValue exact = whole.value(point).value();
      EXPECT_EQ(exact.atMost, exact.length);
      bool isResolved = false;
      for (std::size_t budget = 1; budget < 1u << 26 && !isResolved; budget *= 3) {
        poor.setBudget(budget);
        const GirthValue value = poor.value(point).value();
        const GirthLoop loop = poor.loop(point).value();
        isResolved = value.kind != LoopKind::Unresolved;
        for (const auto& [length, atMost] :
             {std::pair(value.length, value.atMost), std::pair(loop.length, loop.atMost)}) {
          EXPECT_LE(length, exact.length * (1 + 1e-12)) << "budget " << budget;
          EXPECT_GE(atMost, exact.length * (1 - 1e-12)) << "budget " << budget;
          EXPECT_LT(atMost, 20 * exact.length) << "budget " << budget;
        }
      }
      EXPECT_TRUE(isResolved);
    }
  }
}

TEST(BadInput, ABudgetEndsTheWorkAmongVeryShortEdges) {
  // The tip of a cone whose rings shrink: all of its small faces lie nearer to each other than most
  // edges are long, and are worked on together.
  Shape shape;
  constexpr Index around = 24, rings = 24;
  for (Index r = 0; r < rings; ++r) {
    for (Index i = 0; i < around; ++i) {
      const double radius = std::pow(0.4, r) * (1 + 0.3 * std::sin(7.0 * i + r));
      const double angle = 2 * M_PI * i / around;
      shape.add(radius * std::cos(angle), radius * std::sin(angle), 2 * radius);
    }
  }
  const Index tip = shape.add(0, 0, 0), base = shape.add(0, 0, 9);
  for (Index i = 0; i < around; ++i) {
    const Index j = (i + 1) % around;
    shape.face(base, i, j);
    for (Index r = 0; r + 1 < rings; ++r) {
      const Index a = r * around, b = a + around;
      shape.face(a + j, a + i, b + i);
      shape.face(a + j, b + i, b + j);
    }
    shape.face(tip, (rings - 1) * around + j, (rings - 1) * around + i);
  }
  const SurfaceMesh mesh = shape.mesh();
  GirthSolver solver(mesh);
  solver.setBudget(100);
  const auto value = solver.value(Vertex(tip));
  ASSERT_TRUE(value.ok());
  EXPECT_EQ(value.value().kind, LoopKind::Unresolved);
  EXPECT_LT(solver.statistics().windowsCrossed, 10'000u);
}

TEST(BadInput, TubesFarThinnerThanTheirEdgesAreLong) {
  // Before the first bucket of the queue ends, paths could wind round them a hundred thousand
  // times.
  for (const double side : {1e-3, 1e-5}) {
    const Shape tube = prism(regularPolygon(4, side), 1, 1);
    const SurfaceMesh mesh = tube.mesh();
    GirthSolver solver(mesh);
    for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
      if (mesh.length(Halfedge(h)) < 0.5) continue;
      const auto value = solver.value(SurfacePoint::onHalfedge(Halfedge(h), 0.4)).value();
      EXPECT_EQ(value.kind, LoopKind::Loop) << side;
      EXPECT_NEAR(value.length / side, 4, 1e-7) << side;
      EXPECT_LT(solver.statistics().windowsCrossed, 20'000u) << side;
      break;
    }
  }
}

TEST(BadInput, SmallComponentsCostNoMoreBesideLargeOnes) {
  const Shape small = moved(perturbed(torus(3, 1, 24, 12), 0.1, 1), 1e-6, 0, 3);
  Shape both = small;
  const Shape large = box(1, 1, 1, 12, 12, 12);
  for (std::size_t i = 0; i < large.positions.size(); ++i)
    both.positions.push_back(large.positions[i]);
  for (const Index v : large.triangles) both.triangles.push_back(v + small.vertexCount());
  const SurfaceMesh alone = small.mesh(), beside = both.mesh();
  GirthSolver one(alone), two(beside);
  for (Index v = 0; v < small.vertexCount(); v += 37) {
    const double length = one.value(Vertex(v)).value().length;
    EXPECT_NEAR(two.value(Vertex(v)).value().length / length, 1, 1e-9);
    EXPECT_LE(two.statistics().windowsCrossed, 2 * one.statistics().windowsCrossed + 100);
  }
}

}  // namespace
}  // namespace girth::test
