// Surfaces with boundary: paths may run along it (web/docs/definitions.md, section 2). Closed
// forms.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "girth/girth.h"
#include "girth_proof.h"
#include "path_checks.h"
#include "random_meshes.h"

namespace girth::test {
namespace {

/// A flat grid of n × n unit squares, without those that `cut` names.
Shape patch(Index n, const std::function<bool(Index, Index)>& cut) {
  Shape shape;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) shape.add(i, j, 0);
  }
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      if (cut(i, j)) continue;
      const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      shape.face(a, b, c);
      shape.face(a, c, d);
    }
  }
  return withoutLoneVertices(shape);
}

/// A triangulation as drawn, one at random, and a finer one.
std::vector<Shape> triangulations(const Shape& shape) {
  return {shape, retriangulated(shape, 1), subdivided(shape)};
}

Index vertexAt(const SurfaceMesh& mesh, double x, double y) {
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (std::fabs(p.x - x) + std::fabs(p.y - y) < 1e-12) return v;
  }
  ADD_FAILURE() << "no vertex at " << x << ", " << y;
  return 0;
}

TEST(Boundaries, PathsGoRoundCorners) {
  // A square room of 6 with a square pillar of 2 in the middle, and one with a quarter missing.
  const auto pillar = [](Index i, Index j) { return i >= 2 && i < 4 && j >= 2 && j < 4; };
  const auto quarter = [](Index i, Index j) { return i >= 3 && j >= 3; };
  for (const Shape& shape : triangulations(patch(6, pillar))) {
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    TextbookMmp textbook(mesh);
    GeodesicSolver solver(mesh);
    const Index a = vertexAt(mesh, 3, 0), b = vertexAt(mesh, 3, 6);
    const double length = 2 * std::sqrt(5.0) + 2;
    textbook.propagate(SurfacePoint::atVertex(Vertex(a)));
    EXPECT_NEAR(textbook.distanceTo(SurfacePoint::atVertex(Vertex(b))), length, 1e-13);
    expectShortestPath(
        mesh,
        solver.path(SurfacePoint::atVertex(Vertex(a)), SurfacePoint::atVertex(Vertex(b))).value(),
        SurfacePoint::atVertex(Vertex(a)), SurfacePoint::atVertex(Vertex(b)), length);
  }
  for (const Shape& shape : triangulations(patch(6, quarter))) {
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    TextbookMmp textbook(mesh);
    const Index a = vertexAt(mesh, 6, 1), b = vertexAt(mesh, 1, 6);
    textbook.propagate(SurfacePoint::atVertex(Vertex(a)));
    EXPECT_NEAR(textbook.distanceTo(SurfacePoint::atVertex(Vertex(b))), 2 * std::sqrt(13.0), 1e-13);
    EXPECT_NEAR(textbook.distanceTo(SurfacePoint::atVertex(Vertex(vertexAt(mesh, 3, 6)))),
                std::sqrt(13.0) + 3, 1e-13);
    const auto distances =
        GeodesicSolver(mesh).distances(SurfacePoint::atVertex(Vertex(a))).value();
    EXPECT_NEAR(distances[b], 2 * std::sqrt(13.0), 1e-12);
    EXPECT_NEAR(distances[vertexAt(mesh, 3, 6)], std::sqrt(13.0) + 3, 1e-12);
  }
}

TEST(Boundaries, APatchHasItsFarthestPoint) {
  for (const Shape& shape : triangulations(patch(4, [](Index, Index) { return false; }))) {
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    GirthSolver solver(mesh);
    TextbookMmp textbook(mesh);
    for (const Vertex v : mesh.vertices()) {
      SCOPED_TRACE("vertex " + std::to_string(v));
      const Vec3& p = mesh.position(v);
      const GirthLoop loop = solver.loop(v).value();
      EXPECT_EQ(loop.kind, LoopKind::Antipodal);
      EXPECT_NEAR(loop.length, 2 * std::hypot(std::max(p.x, 4 - p.x), std::max(p.y, 4 - p.y)),
                  1e-12);
      expectProven(mesh, textbook, loop, 0.05);
    }
  }
}

TEST(Boundaries, ALoopGoesRoundAHole) {
  // From the axis of a square pillar of side 2: over both near corners, and they meet in the middle
  // of the far side, both along the boundary.
  const auto pillar = [](Index i, Index j) { return i >= 2 && i < 4 && j >= 2 && j < 4; };
  for (const Shape& shape : triangulations(patch(6, pillar))) {
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    GirthSolver solver(mesh);
    TextbookMmp textbook(mesh);
    for (const double y : {0.0, 1.0, 2.0}) {
      const GirthLoop loop = solver.loop(Vertex(vertexAt(mesh, 3, y))).value();
      EXPECT_EQ(loop.kind, LoopKind::Loop);
      EXPECT_NEAR(loop.length, 2 * (std::hypot(2 - y, 1) + 3), 1e-12);
      expectProven(mesh, textbook, loop, 0.03);
    }
  }
}

TEST(Boundaries, AnOpenTubeHasItsPerimeter) {
  const Index corners = 8;
  Shape tube = prism(regularPolygon(4, 1, 2), 6, 12);
  tube.triangles.resize(tube.triangles.size() - std::size_t{2} * corners * 3);  // no caps
  tube.positions.resize(tube.positions.size() - 6);
  for (const Shape& shape : triangulations(tube)) {
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    GirthSolver solver(mesh);
    TextbookMmp textbook(mesh);
    for (Index v = 0; v < 13 * corners; v += 3) {  // on its ends as well
      SCOPED_TRACE("vertex " + std::to_string(v));
      const GirthLoop loop = solver.loop(Vertex(v)).value();
      EXPECT_EQ(loop.kind, LoopKind::Loop);
      EXPECT_NEAR(loop.length, 4, 1e-12);
      EXPECT_NEAR(loop.angle, M_PI, 1e-6);
      expectProven(mesh, textbook, loop, 0.04);
    }
  }
}

TEST(Boundaries, TheFarthestPointMayLieOnOne) {
  // A wide pyramid without its base: the two ways round its tip meet in the middle of the side of
  // the rim opposite. In the plane: two slant lengths and half of the tip's angle between them.
  const Index sides = 5, rings = 10;
  const double tip = 5.5, slant = 0.9, height = std::cos(tip / 10);
  Shape open = pyramid(sides, tip, rings);
  open.triangles.resize(open.triangles.size() - std::size_t{3} * sides);
  open = withoutLoneVertices(open);
  const double farthest =
      std::sqrt(slant * slant + height * height - 2 * slant * height * std::cos(tip / 2));
  for (const Shape& shape :
       {open, retriangulated(open, 1), moved(open, 1, 0.3, 2), moved(open, 3.7, 0.4, 5)}) {
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    const double scale =
        mesh.length(Halfedge(0)) / open.mesh(OpenEdges::Boundary).length(Halfedge(0));
    GirthSolver solver(mesh);
    TextbookMmp textbook(mesh);
    for (const Vertex v : mesh.vertices()) {
      const Vec3 &p = mesh.position(v), &q = mesh.position(Vertex(0));
      const double away = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) / scale;
      if (std::fabs(away - slant) > 1e-12) continue;
      SCOPED_TRACE("vertex " + std::to_string(v));
      const GirthLoop loop = solver.loop(v).value();
      EXPECT_EQ(loop.kind, LoopKind::Antipodal);
      EXPECT_NEAR(loop.length / scale, 2 * farthest, 1e-11);
      expectProven(mesh, textbook, loop, 0.05);
    }
  }
}

}  // namespace
}  // namespace girth::test
