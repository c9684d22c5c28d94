#include "mesh_properties.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "girth_proof.h"
#include "path_checks.h"
#include "random_meshes.h"

namespace girth::test {

namespace {

std::string at(Index vertex) { return "vertex " + std::to_string(vertex); }

SurfacePoint anyPoint(const SurfaceMesh& mesh, Random& random) {
  switch (random.below(3)) {
    case 0:
      return SurfacePoint::atVertex(Vertex(random.below(mesh.vertexCount())));
    case 1:
      return SurfacePoint::onHalfedge(Halfedge(random.below(mesh.halfedgeCount())),
                                      0.02 + 0.96 * random());
    default: {
      const double a = 0.02 + 0.9 * random(), b = 0.01 + (0.98 - a) * random();
      return SurfacePoint::inFace(Face(random.below(mesh.faceCount())), {a, b, 1 - a - b});
    }
  }
}

std::string textOf(const SurfacePoint& point) {
  constexpr std::array<const char*, 3> kKinds = {"vertex ", "halfedge ", "face "};
  return kKinds[static_cast<std::size_t>(point.kind)] + std::to_string(point.element) + " at " +
         std::to_string(point.weights[1]) + ", " + std::to_string(point.weights[2]);
}

/// The values of one surface on another, whose vertices `newNumber` names; empty: they have the
/// same numbers.
void expectSame(const GirthField& values, const Shape& other, double scale,
                const std::vector<Index>& newNumber, const char* how) {
  if (!isSurface(other)) return;  // a plane may pass too near a vertex
  SCOPED_TRACE(how);
  const SurfaceMesh mesh = other.mesh(OpenEdges::Boundary);
  GirthSolver solver(mesh);
  for (std::size_t v = 0; v < values.values.size(); v += 3) {
    const Index number = newNumber.empty() ? static_cast<Index>(v) : newNumber[v];
    const GirthValue value = solver.value(Vertex(number)).value();
    EXPECT_NEAR(value.length / (scale * values.values[v]), 1, 1e-9) << at(static_cast<Index>(v));
  }
}

void expectDistances(const SurfaceMesh& mesh, Random& random) {
  GeodesicSolver solver(mesh);
  TextbookMmp textbook(mesh);
  const double rounding = 1e-12 * mesh.meanEdgeLength();
  for (int i = 0; i < 3; ++i) {
    const SurfacePoint source = anyPoint(mesh, random);
    SCOPED_TRACE("distances from " + textOf(source));
    textbook.propagate(source);
    const std::vector<double> distances = solver.distances(source).value();
    const double radius = 3 * random() * mesh.meanEdgeLength();
    const std::vector<double> near = solver.distances(source, radius).value();
    for (const Vertex v : mesh.vertices()) {
      const double expected = textbook.distanceTo(SurfacePoint::atVertex(v));
      EXPECT_NEAR(distances[v], expected, 1e-9 * expected + rounding) << at(v);
      if (expected < radius * (1 - 1e-9)) {
        EXPECT_NEAR(near[v], expected, 1e-9 * expected + rounding) << at(v);
      } else if (expected > radius * (1 + 1e-9)) {
        EXPECT_EQ(near[v], std::numeric_limits<double>::infinity()) << at(v);
      }
    }
    const SurfacePoint target = anyPoint(mesh, random);
    SCOPED_TRACE("path to " + textOf(target));
    expectShortestPath(mesh, solver.path(source, target).value(), source, target,
                       textbook.distanceTo(target));
  }
}

void expectLoopsAnywhere(const Shape& shape, const SurfaceMesh& mesh, Random& random) {
  GirthSolver solver(mesh);
  TextbookMmp textbook(mesh);
  for (int i = 0; i < 3; ++i) {
    const SurfacePoint point = anyPoint(mesh, random);
    if (point.kind == SurfacePoint::Kind::AtVertex) continue;
    SCOPED_TRACE("loop at " + textOf(point));
    const GirthLoop loop = solver.loop(point).value();
    EXPECT_EQ(solver.value(point).value().length, loop.length);
    expectProven(mesh, textbook, loop, 0.05);
    const Shape other = withVertexAt(shape, point);
    if (!isSurface(other)) continue;
    const SurfaceMesh withVertex = other.mesh(OpenEdges::Boundary);
    const GirthValue value = GirthSolver(withVertex).value(Vertex(mesh.vertexCount())).value();
    EXPECT_NEAR(value.length / loop.length, 1, 1e-9);
  }
}

}  // namespace

void expectProperties(std::uint64_t seed) {
  const RandomMesh made = randomMesh(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.history);
  const SurfaceMesh mesh = made.shape.mesh(OpenEdges::Boundary);
  ExecutionContext one, three;
  one.threads = 1;
  three.threads = 3;
  const GirthField exact = girthField(mesh, GirthMethod::Exact, one);
  const GirthField again = girthField(mesh, GirthMethod::Exact, three);

  GirthSolver solver(mesh);
  TextbookMmp textbook(mesh);
  for (Index v = mesh.vertexCount(); v-- > 0;) {
    EXPECT_EQ(again.values[v], exact.values[v]) << at(v);
    EXPECT_EQ(again.kinds[v], exact.kinds[v]) << at(v);
    const GirthLoop loop = solver.loop(Vertex(v)).value();
    EXPECT_EQ(loop.length, exact.values[v]) << at(v);
    EXPECT_EQ(loop.kind, exact.kinds[v]) << at(v);
    const GirthValue naive = study::naiveGirth(mesh, Vertex(v)).value();
    EXPECT_NEAR(exact.values[v] / naive.length, 1, 1e-9) << at(v) << ", naive " << naive.length;
    if (exact.kinds[v] != naive.kind) {
      // Right only where the loop's midpoint is the farthest point as well.
      SCOPED_TRACE(at(v) + ", loop and antipodal at once");
      expectNothingBeyond(mesh, textbook, loop);
    }
    if (v % 16 == 0 || (!made.closed && v % 6 == 0)) {
      SCOPED_TRACE(at(v));
      expectProven(mesh, textbook, loop, 0.05);
    }
  }
  Random random(seed);
  for (int i = 0; i < 3; ++i) random();  // seeds near each other begin alike
  expectDistances(mesh, random);
  expectLoopsAnywhere(made.shape, mesh, random);

  std::vector<Index> newNumber;
  const Shape renumbered = relabelled(made.shape, seed, newNumber);
  expectSame(exact, renumbered, 1, newNumber, "renumbered");
  expectSame(exact, moved(made.shape, 3.7, 0.3, 2), 3.7, {}, "moved");
  expectSame(exact, subdivided(made.shape), 1, {}, "subdivided");
  expectSame(exact, divided(made.shape, 0.2, 20, seed), 1, {}, "divided");
  expectSame(exact, reflected(made.shape, seed), 1, {}, "reflected");
}

}  // namespace girth::test
