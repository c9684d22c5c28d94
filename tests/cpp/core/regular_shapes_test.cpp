// Regular shapes with rounded coordinates: loops run along edges whose vertices are flat but for
// rounding, and their midpoints lie at vertices. One shape alone:
// core_tests --gtest_filter='Sample/RegularShapes.*/17'

#include <gtest/gtest.h>

#include <utility>

#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "regular_checks.h"
#include "regular_shapes.h"
#include "shapes.h"

namespace girth::test {
namespace {

/// An open tube of eight sides, turned, its coordinates rounded to nine decimals: the midpoint of
/// the loop along the rim lies 1e-9 beside a vertex.
Shape roundedTube() {
  Shape shape;
  shape.positions = {
      -26.262404544, -16.053793169, 3.682639335,  -25.943157229, -16.167877781, 2.996452559,
      -25.314657423, -15.911775293, 2.642636298,  -24.745071787, -15.43550707,  2.828451318,
      -24.568055864, -15.018064577, 3.4450497,    -24.887303178, -14.903979966, 4.131236476,
      -25.515802985, -15.160082453, 4.485052737,  -26.08538862,  -15.636350676, 4.299237718,
      -27.533805242, 11.882859156,  -7.854121669, -27.202545519, 11.50482435,   -8.431307184,
      -26.545045195, 11.123694699,  -8.521971125, -25.946459042, 10.962730783,  -8.073003784,
      -25.75743071,  11.116223081,  -7.347404142, -26.088690433, 11.494257887,  -6.770218626,
      -26.746190757, 11.875387539,  -6.679554685, -27.34477691,  12.036351454,  -7.128522026};
  for (Index i = 0; i < 8; ++i) {
    const Index j = (i + 1) % 8;
    shape.face(i, j, j + 8);
    shape.face(i, j + 8, i + 8);
  }
  return shape;
}

TEST(RegularTube, LoopAlongTheRimIsFound) {
  const SurfaceMesh mesh = roundedTube().mesh(OpenEdges::Boundary);
  constexpr double kRim = 6.083068826501638;
  const GirthValue exact = GirthSolver(mesh).value(Vertex(8)).value();
  EXPECT_EQ(exact.kind, LoopKind::Loop);
  EXPECT_NEAR(exact.length, kRim, 1e-12 * kRim);
  const GirthValue naive = study::naiveGirth(mesh, Vertex(8)).value();
  EXPECT_EQ(naive.kind, LoopKind::Loop);
  EXPECT_NEAR(naive.length, kRim, 1e-12 * kRim);
}

/// A rectangle of 1 by 2 covered twice, with vertices a little way from a corner on both sides of
/// it, and two vertices on either sheet.
Shape doubledRectangle(double beside, double x, double y) {
  Shape shape;
  for (const auto& [a, b] : {std::pair{0.0, 0.0},
                             {beside, 0.0},
                             {1.0, 0.0},
                             {1.0, 2.0},
                             {0.0, 2.0},
                             {0.0, 2 * beside}}) {
    shape.add(a, b, 0);
  }
  const Index rim = shape.vertexCount();
  for (const bool below : {false, true}) {
    const Index middle = shape.add(x, y, 0);
    for (Index i = 0; i < rim; ++i) {
      const Index j = (i + 1) % rim;
      shape.face(below ? j : i, below ? i : j, middle);
    }
  }
  return shape;
}

// Each corner is a cone of exactly π, round which lines just close up: through its apex, and so
// they are no loops. Rounding alone decides on which side of the apex they lie.
TEST(DoubledRectangle, LoopsGoRoundItAndNotRoundItsCorners) {
  for (const double beside : {0.1, 1e-3, 1e-5, 1e-6, 1e-7}) {
    for (const auto& [x, y] :
         {std::pair{0.5, 0.6}, {0.3, 0.7}, {0.1, 0.7}, {0.71, 0.55}, {0.4321, 0.5678}}) {
      const SurfaceMesh mesh = doubledRectangle(beside, x, y).mesh();
      for (const Vertex base : {Vertex(6), Vertex(7)}) {
        SCOPED_TRACE(testing::Message() << beside << " " << x << " " << y);
        const GirthValue exact = GirthSolver(mesh).value(base).value();
        EXPECT_EQ(exact.kind, LoopKind::Loop);
        EXPECT_NEAR(exact.length, 2, 1e-12);
        const GirthValue naive = study::naiveGirth(mesh, base).value();
        EXPECT_NEAR(naive.length, 2, 1e-12);
      }
    }
  }
}

class RegularShapes : public testing::TestWithParam<int> {};

TEST_P(RegularShapes, AreExact) {
  expectExactOnRegularShape(static_cast<std::uint64_t>(GetParam()), 2);
}

TEST_P(RegularShapes, CarryTheRest) {
  expectTheRestOnRegularShape(static_cast<std::uint64_t>(GetParam()), 4);
}

INSTANTIATE_TEST_SUITE_P(Sample, RegularShapes, testing::Range(0, 60));
INSTANTIATE_TEST_SUITE_P(Unions, RegularShapes,
                         testing::Range(int{kFirstUnion}, int{kFirstUnion} + 12));
// Each of these found a fault once: a straight line beyond the end of a window that ends at a
// vertex is shorter than every path (10, 17, 174, 320, 764); a point beside a boundary has arrivals
// from outside (815); paths to a vertex tie, and the loop goes on from the one that was not noted
// (35, 421 in both methods); a loop that bends at a vertex by less than rounding misplaces its
// midpoint (1153, 1893); a line beside a window by 1e-10 does (1689); lines close by a corner
// (1221). With the rest: a saddle at a vertex is listed as several, or not at all (11, 19, 73, 83,
// 95); curves are pushed off a vertex and back (35, 42, 47, 51). A path
// that bends round a window's end comes from there (5287, 8014); the enumeration cannot follow
// lines that run along edges (4707, 4734). A midpoint beyond a side of its face is nearer there
// over a third path (11114). A straight line past the end of a window refutes the loop (1558,
// 15842). A path arrives beside the first side of a face, and its direction was moved onto it, but
// the windows went on along the path: a crack (19165).
INSTANTIATE_TEST_SUITE_P(OnceFailed, RegularShapes,
                         testing::Values(73, 83, 95, 174, 320, 421, 764, 815, 1153, 1221, 1689,
                                         1893, 11114, 1558, 15842, 19165));

class RegularShapesEverywhere : public testing::TestWithParam<int> {};

TEST_P(RegularShapesEverywhere, CarryTheRest) {
  expectTheRestOnRegularShape(static_cast<std::uint64_t>(GetParam()), 1000);
}

// Faults at single vertices: a maximum of rounding beside a saddle (103, 258), a third path to its
// midpoint that ties (13250), a face whose first corner is beyond the frontier (14060), and a path
// along the first direction of a vertex, which rounding has arrive at its total angle (14130).
// Paths that meet in a face before they reach a corner of it (6400), a loop along a boundary that
// passes a corner of it by 1e-8 (5750), and a saddle that rounding puts beside its edge (18000).
INSTANTIATE_TEST_SUITE_P(OnceFailed, RegularShapesEverywhere,
                         testing::Values(103, 258, 13250, 14060, 14130, 5750, 6400, 18000));

}  // namespace
}  // namespace girth::test
