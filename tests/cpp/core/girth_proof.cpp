#include "girth_proof.h"

#include <gtest/gtest.h>

#include <cmath>

#include "first_saddle.h"
#include "loop_checks.h"

namespace girth::test {

namespace {

void expectNothingBeyond(double farthest, double half) {
  EXPECT_LE(farthest, half * (1 + 1e-9)) << "a point beyond the farthest one";
}

}  // namespace

bool expectProven(const SurfaceMesh& mesh, TextbookMmp& textbook, const GirthLoop& loop,
                  double share) {
  expectGeodesicLoop(mesh, loop);
  const double half = loop.length / 2, spacing = share * half;
  const double limit = half + 2 * spacing;
  textbook.propagate(loop.points.front(), limit + spacing);
  EXPECT_NEAR(textbook.distanceTo(loop.midpoint) / half, 1, 1e-9) << "the distance of the midpoint";
  const FirstSaddle saddle = firstSaddle(mesh, textbook, limit, spacing);
  if (saddle.value) {
    EXPECT_GE(*saddle.value, half - saddle.error) << "a saddle before the loop's half " << half;
  }
  if (loop.kind == LoopKind::Antipodal) expectNothingBeyond(saddle.farthest, half);
  return saddle.value && std::fabs(*saddle.value - half) <= saddle.error;
}

void expectNothingBeyond(const SurfaceMesh& mesh, TextbookMmp& textbook, const GirthLoop& loop) {
  const double half = loop.length / 2;
  textbook.propagate(loop.points.front());
  expectNothingBeyond(firstSaddle(mesh, textbook, 4 * half, 0.05 * half).farthest, half);
}

}  // namespace girth::test
