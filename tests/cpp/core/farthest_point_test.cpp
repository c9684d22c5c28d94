// The farthest point: where many paths compete, and what it may cost.

#include "solver/search/farthest_point.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <span>

#include "core/shapes.h"
#include "solver/search/loop_search.h"

namespace girth::test {
namespace {

using geodesic::Keep;
using geodesic::Propagation;
using geodesic::Unfolding;

/// A triangle of length 1 and its underside, which a vertex near its middle parts into three.
Shape doubledNeedle(double width) {
  return {{0, 0, 0, 1, 0, 0, 0.3, width, 0, 0.5, width / 3, 0},
          {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}};
}

/// Spreads from a vertex over the whole surface, loops or none.
struct Spread {
  SurfaceMesh mesh;
  Unfolding unfolding{mesh};
  Propagation propagation{unfolding};

  Spread(const Shape& shape, Vertex from) : mesh(shape.mesh()) {
    struct Everywhere {
      bool enough(double) { return false; }
      bool interrupted() { return false; }
      void restart() {}
      void onCrossing(Index, std::uint32_t, const geodesic::CrossingResult&) {}
      void onVertex(Index) {}
      std::size_t effort() const { return 0; }
    } visitor;
    const SurfacePoint source = unfolding.fromMesh(SurfacePoint::atVertex(from));
    propagation.run(std::span(&source, 1), Keep::Everything, visitor);
  }
};

TEST(FarthestPoint, OfANeedleIsItsOtherEnd) {
  for (double width = 0.1; width > 5e-5; width /= 10) {
    const SurfaceMesh mesh = doubledNeedle(width).mesh();
    for (const Vertex end : {Vertex(0), Vertex(1)}) {
      GirthSolver solver(mesh);
      const GirthValue value = solver.value(end).value();
      EXPECT_NEAR(value.length, 2, 1e-12) << width;
      EXPECT_EQ(value.kind, LoopKind::Antipodal) << width;
    }
  }
}

TEST(FarthestPoint, CostsNoMoreThanThePathsToIt) {
  for (double width = 0.1; width > 1e-4; width /= 10) {
    const Spread spread(doubledNeedle(width), Vertex(1));
    const std::size_t windows = spread.propagation.windowsCrossed();
    EXPECT_TRUE(farthestPoint(spread.propagation, 4 * windows + 1000).complete) << width;
  }
  // All paths from the tip of a cone meet at the middle of its base.
  const Spread cone(pyramid(300, 1.0, 4), Vertex(0));
  EXPECT_TRUE(
      farthestPoint(cone.propagation, 50 * cone.propagation.windowsCrossed() + 1000).complete);
}

TEST(FarthestPoint, NoPointIsFarther) {
  for (const Shape& shape : {octasphere(3), box(1, 1, 3, 3, 3, 9), perturbed(plate(0), 0.2, 3),
                             perturbed(torus(2, 0.7, 24, 16), 0.3, 4), pyramid(40, 1.0, 3)}) {
    const Spread spread(shape, Vertex(0));
    const FarthestPoint farthest = farthestPoint(spread.propagation);
    ASSERT_TRUE(farthest.complete);
    EXPECT_NEAR(spread.propagation.pathTo(farthest.halfedge, farthest.point).distance,
                farthest.distance, 1e-9 * farthest.distance);
    EXPECT_LE(farthest.distance, farthest.atMost);
    double most = 0;
    constexpr int steps = 12;
    for (Index face = 0; face < spread.mesh.faceCount(); ++face) {
      const geodesic::Crossing c = spread.unfolding.crossing(3 * face);
      for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
          const double along = static_cast<double>(i) / steps, up = static_cast<double>(j) / steps;
          const geodesic::Vec2 q = along * geodesic::Vec2{c.length(), 0} + up * c.apex();
          most = std::max(most, spread.propagation.pathTo(3 * face, q).distance);
        }
      }
    }
    EXPECT_LE(most, farthest.distance * (1 + 1e-9));
    EXPECT_GE(most, farthest.distance * 0.9);
  }
}

TEST(FarthestPoint, WhatIsKnownWhenItIsGivenUpIsTrue) {
  const Spread spread(pyramid(40, 1.0, 3), Vertex(5));
  const FarthestPoint whole = farthestPoint(spread.propagation);
  for (const std::size_t work : {0u, 10u, 100u, 1000u}) {
    const FarthestPoint part = farthestPoint(spread.propagation, work);
    EXPECT_LE(part.distance, whole.distance * (1 + 1e-11));
    EXPECT_GE(part.atMost, whole.distance * (1 - 1e-11));
  }
  const std::atomic<bool> cancel{true};
  ExecutionContext stopped;
  stopped.cancel = &cancel;
  EXPECT_FALSE(farthestPoint(spread.propagation, std::size_t{1} << 40, stopped).complete);
}

}  // namespace
}  // namespace girth::test
