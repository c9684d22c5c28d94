// The first saddle where it is known, and against the naive algorithm where it is not.

#include "first_saddle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "girth/girth.h"
#include "girth_proof.h"
#include "shapes.h"

namespace girth::test {
namespace {

FirstSaddle saddleOf(const SurfaceMesh& mesh, Index vertex, double limit, double spacing) {
  TextbookMmp textbook(mesh);
  textbook.propagate(SurfacePoint::atVertex(Vertex(vertex)), limit + spacing);
  return firstSaddle(mesh, textbook, limit, spacing);
}

void expectAt(const SurfaceMesh& mesh, Index vertex, double half, double share) {
  const FirstSaddle saddle = saddleOf(mesh, vertex, 1.2 * half, share * half);
  ASSERT_TRUE(saddle.value) << "vertex " << vertex;
  EXPECT_NEAR(*saddle.value, half, saddle.error) << "vertex " << vertex;
}

TEST(FirstSaddle, IsHalfOfThePerimeterOfATube) {
  const auto square = regularPolygon(4, 1, 2);
  expectAt(prism(square, 8, 16).mesh(), 8 * 8, 2, 0.03);
  expectAt(retriangulated(prism(square, 8, 16), 3).mesh(), 8 * 8 + 3, 2, 0.03);
  expectAt(prism(regularPolygon(3, 1), 6, 5).mesh(), 3 * 3, 1.5, 0.03);
}

TEST(FirstSaddle, GoesRoundTheTipOfACone) {
  for (const double theta : {0.6, 2.0}) {
    const SurfaceMesh mesh = pyramid(5, theta, 10).mesh();
    expectAt(mesh, 1 + 2 * 5, 0.3 * std::sin(theta / 2), 0.03);
  }
}

TEST(FirstSaddle, SeesTheCyclesOfHandles) {
  // On a thin torus the disk meets itself behind the tube; that cycle is never filled.
  const SurfaceMesh mesh = torus(8, 0.5, 12, 6).mesh();
  const double half = GirthSolver(mesh).value(Vertex(0)).value().length / 2;
  expectAt(mesh, 0, half, 0.03);
  const FirstSaddle saddle = saddleOf(mesh, 0, 100, half);
  ASSERT_TRUE(saddle.value);
  EXPECT_NEAR(*saddle.value, half, saddle.error);
}

TEST(FirstSaddle, IsNowhereOnARegularSphere) {
  for (const Shape& shape : {octasphere(0), octasphere(2), icosphere(1), tetrahedron()}) {
    const SurfaceMesh mesh = shape.mesh();
    const FirstSaddle saddle = saddleOf(mesh, 0, 100, 0.03);
    EXPECT_FALSE(saddle.value);
    EXPECT_NEAR(saddle.farthest, GirthSolver(mesh).value(Vertex(0)).value().length / 2,
                saddle.error);
  }
}

TEST(FirstSaddle, ProvesTheValuesOfSmallShapes) {
  int seen = 0, tested = 0;
  for (const Shape& shape :
       {perturbed(torus(2, 0.7, 12, 8), 0.3, 1), perturbed(plate(2), 0.2, 2),
        perturbed(box(1, 0.5, 4, 3, 2, 8), 0.2, 3), perturbed(icosphere(1), 0.3, 4), plate(1)}) {
    const SurfaceMesh mesh = shape.mesh();
    GirthSolver solver(mesh);
    TextbookMmp textbook(mesh);
    for (Index v = 0; v < mesh.vertexCount(); v += 11) {
      SCOPED_TRACE("vertex " + std::to_string(v));
      if (expectProven(mesh, textbook, solver.loop(Vertex(v)).value(), 0.03)) ++seen;
      ++tested;
    }
  }
  EXPECT_GT(seen, tested / 2);
}

}  // namespace
}  // namespace girth::test
