// The girth function on shapes whose values are known, against the naive algorithm and against
// brute force.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "brute_force.h"
#include "geodesic/corridor.h"
#include "geodesic/unfolding.h"
#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "loop_checks.h"
#include "path_checks.h"
#include "shapes.h"
#include "solver/solver_factory.h"

namespace girth::test {
namespace {

void expectClose(double value, double expected, const std::string& where) {
  EXPECT_NEAR(value / expected, 1, 1e-9) << where;
}

std::string at(Index vertex) { return "vertex " + std::to_string(vertex); }

/// A triangulation as drawn and two at random.
std::vector<Shape> triangulations(const Shape& shape) {
  return {shape, retriangulated(shape, 1), retriangulated(shape, 2)};
}

// --- Closed forms (web/docs/definitions.md, section 2)

/// A band of vertices of a prism whose loop is its perimeter.
void expectPerimeter(const Shape& shape, Index first, Index last, double perimeter) {
  for (const Shape& s : triangulations(shape)) {
    const SurfaceMesh mesh = s.mesh();
    GirthSolver solver(mesh);
    for (Index v = first; v < last; ++v) {
      const GirthLoop loop = solver.loop(Vertex(v)).value();
      expectClose(loop.length, perimeter, at(v));
      EXPECT_EQ(loop.kind, LoopKind::Loop) << at(v);
      EXPECT_NEAR(loop.angle, M_PI, 1e-6) << at(v);
    }
  }
}

TEST(ClosedForm, PrismsHaveTheirPerimeter) {
  // Grids on purpose: the loop runs along mesh edges through flat vertices, and every window ends
  // on one.
  const auto square = regularPolygon(4, 1, 2);
  expectPerimeter(prism(square, 8, 16), 6 * 8, 11 * 8, 4);
  const auto triangle = regularPolygon(3, 1, 4);
  expectPerimeter(prism(triangle, 6, 20), 8 * 12, 13 * 12, 3);
  const auto hexagon = regularPolygon(6, 0.5, 1);
  expectPerimeter(prism(hexagon, 6, 9), 4 * 6, 6 * 6, 3);
}

TEST(ClosedForm, CylindersHaveTheirPerimeter) {
  expectPerimeter(prism(regularPolygon(40, 0.1), 6, 12), 5 * 40, 8 * 40, 4);  // caps of valence 40
}

TEST(ClosedForm, BoxesHaveTwiceTheSumOfTheirSides) {
  const Shape shape = box(1, 0.5, 6, 4, 2, 24);
  for (const Shape& s : triangulations(shape)) {
    const SurfaceMesh mesh = s.mesh();
    GirthSolver solver(mesh);
    int tested = 0;
    for (const Vertex v : mesh.vertices()) {
      if (std::fabs(mesh.position(v).z - 3) > 1) continue;
      expectClose(solver.value(v).value().length, 3, at(v));
      ++tested;
    }
    EXPECT_GT(tested, 100);
  }
}

TEST(ClosedForm, ANeckBetweenTwoNotches) {
  // Like an S from above. The loop round the neck runs down one notch's edge and up the other's,
  // between saddles that leave it exactly π on opposite sides: no window passes beside both, and
  // the edge lies at the very end of what each saddle sends out. Rounding decides on which side of
  // it the end is found.
  const std::vector<double> polygon = {1, -3, 3, -3, 3, 0, 0, 0, -1, 2, -3, 2, -3, -1, 0, -1};
  constexpr Index kNotch = 7, kOpposite = 3, kCorners = 8;
  Shape mirrored = prism(polygon, 1, 1);
  for (std::size_t i = 0; i < mirrored.positions.size(); i += 3) mirrored.positions[i] *= -1;
  for (std::size_t i = 0; i < mirrored.triangles.size(); i += 3) {
    std::swap(mirrored.triangles[i], mirrored.triangles[i + 1]);
  }
  for (const Shape& shape : {prism(polygon, 1, 1), mirrored}) {
    for (int turn = 0; turn < 20; ++turn) {
      const SurfaceMesh mesh = moved(shape, 1 + 0.1 * turn, 0.3 * turn, 0.1 * turn).mesh();
      GirthSolver solver(mesh);
      for (const Index corner : {kNotch, kOpposite}) {
        Index edge = 0;
        while (mesh.from(Halfedge(edge)) != corner || mesh.to(Halfedge(edge)) != corner + kCorners)
          ++edge;
        for (const double t : {0.2, 0.5, 0.83}) {
          const auto loop = solver.loop(SurfacePoint::onHalfedge(Halfedge(edge), t));
          expectClose(loop.value().length, 4 * (1 + 0.1 * turn), "turn " + std::to_string(turn));
        }
      }
    }
  }
}

TEST(ClosedForm, PyramidsAndConesBelowPi) {
  // 2 d sin(θ/2) at slant distance d from the apex, far from the base.
  for (const Index sides : {3u, 4u, 7u, 40u}) {
    for (const double theta : {0.6, 1.5, 2.2}) {
      const Index rings = 10;
      for (const Shape& s : triangulations(pyramid(sides, theta, rings))) {
        const SurfaceMesh mesh = s.mesh();
        GirthSolver solver(mesh);
        for (Index ring = 1; ring <= 4; ++ring) {
          // All corners of a ring are alike, and d is a share of the slant edge of length 1.
          const Index v = 1 + (ring - 1) * sides + ring % sides;
          const GirthValue girth = solver.value(Vertex(v)).value();
          expectClose(girth.length, 2 * (ring * 0.1) * std::sin(theta / 2), at(v));
          EXPECT_EQ(girth.kind, LoopKind::Loop);
        }
      }
    }
  }
}

TEST(ClosedForm, ToriHaveTheirMeridian) {
  // A thin torus of straight tubes, cut in mid-tube: the loop round the tube is the regular
  // polygon.
  const Index around = 12, across = 6;
  const double R = 8, r = 0.5;
  const Shape shape = torus(R, r, around, across);
  const SurfaceMesh mesh = shape.mesh();
  GirthSolver solver(mesh);
  for (const Vertex v : mesh.vertices()) {
    const GirthLoop loop = solver.loop(v).value();
    // The section itself is a polygon of sides 2 r sin(π/6) = r; no loop round the tube is longer
    // than it, and from the inner rim, whose section is a geodesic through saddle vertices, none is
    // shorter.
    EXPECT_LE(loop.length, across * r * (1 + 1e-12));
    EXPECT_EQ(loop.kind, LoopKind::Loop);
  }
}

TEST(ClosedForm, AFlatFoldedTorusHasItsShortestGeodesic) {
  // A frame of square tubes bent at right angles: away from the corners it is a square prism.
  const Shape shape = subdivided(subdivided(plate(1)));
  const SurfaceMesh mesh = shape.mesh();
  GirthSolver solver(mesh);
  int tested = 0;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (std::fabs(p.x - 1.5) > 0.3 || p.y > 1) continue;  // mid-side: a bar of 1 × 0.5
    expectClose(solver.value(v).value().length, 3, at(v));
    ++tested;
  }
  EXPECT_GT(tested, 10);
}

TEST(ClosedForm, RegularSpheresAreAntipodal) {
  for (const Shape& shape : {octasphere(0), octasphere(2), icosphere(0), icosphere(2)}) {
    const SurfaceMesh mesh = shape.mesh();
    GirthSolver solver(mesh);
    for (Index v = 0; v < mesh.vertexCount(); v += 5) {
      EXPECT_EQ(solver.value(Vertex(v)).value().kind, LoopKind::Antipodal) << at(v);
    }
  }
  const SurfaceMesh fine = octasphere(4).mesh();
  EXPECT_NEAR(GirthSolver(fine).value(Vertex(0)).value().length, 2 * M_PI, 0.02);
  // An octahedron of edge √2: from a corner to the opposite one, over two faces.
  const SurfaceMesh coarse = octasphere(0).mesh();
  expectClose(GirthSolver(coarse).value(Vertex(0)).value().length, 2 * std::sqrt(6.0), "corner");
}

TEST(ClosedForm, ACubeClosesUponTheOppositeCentre) {
  // From the centre of a face, four paths meet at the centre opposite: not a loop, though two by
  // two they are one.
  const SurfaceMesh mesh = box(1, 1, 1, 2, 2, 2).mesh();
  GirthSolver solver(mesh);
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    const int middles = (p.x == 0.5) + (p.y == 0.5) + (p.z == 0.5);
    if (middles != 2) continue;
    const GirthLoop loop = solver.loop(v).value();
    expectClose(loop.length, 4, at(v));
    EXPECT_EQ(loop.kind, LoopKind::Antipodal);
  }
}

TEST(ClosedForm, ARegularTetrahedronClosesUponTheOppositeFace) {
  // Straight lines run into its convex corners and back, but they are no geodesics.
  const SurfaceMesh mesh = tetrahedron().mesh();
  const GirthLoop loop = GirthSolver(mesh).loop(Vertex(0)).value();
  expectClose(loop.length, 2 * std::sqrt(8.0) * std::sqrt(3.0) / 2 * 4 / 3, at(0));
  EXPECT_EQ(loop.kind, LoopKind::Antipodal);
}

// --- Against the naive algorithm, and the loop's own properties

class AgainstNaive : public testing::TestWithParam<int> {};

Shape shapeOf(int number) {
  switch (number) {
    case 0:
      return tetrahedron();
    case 1:
      return subdivided(subdivided(tetrahedron()));
    case 2:
      return prism(regularPolygon(4, 1, 3), 3, 9);
    case 3:
      return prism(regularPolygon(3, 1, 2), 4, 10);
    case 4:
      return prism(regularPolygon(20, 0.1), 1.5, 4);
    case 5:
      return pyramid(5, 2.0, 6);
    case 6:
      return pyramid(3, 1.0, 1);  // valence 3
    case 7:
      return pyramid(40, 2.5, 3);  // valence 40
    case 8:
      return box(1, 1, 1, 3, 3, 3);
    case 9:
      return box(1, 0.5, 4, 4, 2, 16);
    case 10:
      return torus(2, 0.7, 12, 8);
    case 11:
      return torus(2, 0.7, 3, 3);
    case 12:
      return octasphere(2);
    case 13:
      return icosphere(1);
    case 14:
      return plate(1);
    case 15:
      return plate(2);
    case 16:
      return subdivided(plate(1));
    case 17:
      return box(1, 1, 0.001, 4, 4, 1);  // a leaf
    case 18:
      return box(1, 0.01, 0.013, 20, 1, 1);  // a wire of needles
    default:
      return box(1, 1, 1, 1, 1, 1);
  }
}
constexpr int kShapes = 20;

TEST_P(AgainstNaive, AtEveryVertex) {
  const Shape drawn = shapeOf(GetParam());
  int number = 0;
  for (const Shape& shape :
       {drawn, retriangulated(drawn, 3), perturbed(drawn, 0.01, 4), perturbed(drawn, 0.15, 5)}) {
    SCOPED_TRACE("version " + std::to_string(number++));
    auto made = SurfaceMesh::fromArrays(shape.positions, shape.triangles);
    if (!made) continue;  // noise may flatten a needle; that is refused elsewhere
    const SurfaceMesh mesh = std::move(made).value();
    GirthSolver solver(mesh);
    for (const Vertex v : mesh.vertices()) {
      const GirthLoop loop = solver.loop(v).value();
      const GirthValue naive = study::naiveGirth(mesh, v).value();
      expectClose(loop.length, naive.length, at(v));
      EXPECT_EQ(loop.kind, naive.kind) << at(v);
      EXPECT_EQ(solver.value(Vertex(v)).value().length, loop.length) << at(v);
      expectGeodesicLoop(mesh, loop);
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, AgainstNaive, testing::Range(0, kShapes));

// --- Against brute force

class AgainstBruteForce : public testing::TestWithParam<int> {};

TEST_P(AgainstBruteForce, AtEveryVertex) {
  const std::vector<std::pair<Shape, double>> shapes = {
      {tetrahedron(), 0.1},
      {octasphere(1), 0.1},
      {prism(regularPolygon(4, 1, 2), 4, 8), 0.05},
      {torus(2, 0.7, 10, 6), 0.1},
      {plate(1), 0.1},
      {plate(2), 0.03},
      {box(1, 1, 1, 3, 3, 3), 0.1},
      {box(1, 0.5, 4, 3, 2, 8), 0.1},
      {pyramid(7, 2, 6), 0.05},
      {icosphere(1), 0.1}};
  const auto& [drawn, noise] = shapes[static_cast<std::size_t>(GetParam())];
  const SurfaceMesh mesh = perturbed(drawn, noise, 17).mesh();
  ASSERT_LT(mesh.faceCount(), 300u);
  GirthSolver solver(mesh);
  for (const Vertex v : mesh.vertices()) {
    const GirthLoop loop = solver.loop(v).value();
    const BruteForce all(mesh, v, loop.length * 1.02);
    ASSERT_TRUE(all.complete()) << at(v);
    // Both halves are shortest.
    expectClose(all.distanceTo(loop.midpoint), loop.length / 2, at(v));
    // No loop with shortest halves is shorter.
    const auto shortest = all.shortestLoop();
    if (loop.kind == LoopKind::Loop) {
      ASSERT_TRUE(shortest.has_value()) << at(v);
      expectClose(loop.length, *shortest, at(v));
    } else {
      EXPECT_GE(shortest.value_or(loop.length), loop.length * (1 - 1e-9)) << at(v);
      // Nothing is farther than the midpoint.
      for (const Face f : mesh.faces()) {
        EXPECT_LE(all.distanceTo(SurfacePoint::inFace(f, {1.0 / 3, 1.0 / 3, 1.0 / 3})),
                  loop.length / 2 * (1 + 1e-9));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, AgainstBruteForce, testing::Range(0, 10));

// --- What must not change the values

TEST(Invariance, ScaleAndMotion) {
  const Shape shape = perturbed(plate(2), 0.1, 6);
  const SurfaceMesh mesh = shape.mesh(), other = moved(shape, 37.5, 0.7, 100).mesh();
  GirthSolver solver(mesh), otherSolver(other);
  for (const Vertex v : mesh.vertices()) {
    const GirthValue a = solver.value(v).value(), b = otherSolver.value(v).value();
    expectClose(b.length, 37.5 * a.length, at(v));
    EXPECT_EQ(a.kind, b.kind);
  }
}

TEST(Invariance, PowersOfTwoKeepEveryBit) {
  const Shape shape = perturbed(octasphere(2), 0.2, 6);
  const SurfaceMesh mesh = shape.mesh(), other = moved(shape, 0x1p-300, 0, 0).mesh();
  GirthSolver solver(mesh), otherSolver(other);
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(otherSolver.value(v).value().length, 0x1p-300 * solver.value(v).value().length);
  }
}

TEST(Invariance, Numbering) {
  const Shape shape = perturbed(torus(2, 0.8, 12, 8), 0.2, 7);
  std::vector<Index> newNumber;
  const Shape renumbered = relabelled(shape, 8, newNumber);
  const SurfaceMesh mesh = shape.mesh(), other = renumbered.mesh();
  GirthSolver solver(mesh), otherSolver(other);
  for (const Vertex v : mesh.vertices()) {
    expectClose(otherSolver.value(Vertex(newNumber[v])).value().length,
                solver.value(v).value().length, at(v));
  }
}

TEST(Invariance, Subdivision) {
  for (const Shape& shape : {perturbed(torus(2, 0.8, 8, 6), 0.2, 9),
                             perturbed(box(1, 1, 3, 2, 2, 6), 0.1, 9), octasphere(1)}) {
    const SurfaceMesh mesh = shape.mesh(), finer = subdivided(shape).mesh();
    GirthSolver solver(mesh), finerSolver(finer);
    for (const Vertex v : mesh.vertices()) {
      const GirthLoop a = solver.loop(v).value(), b = finerSolver.loop(v).value();
      expectClose(b.length, a.length, at(v));
      expectGeodesicLoop(finer, b);
    }
  }
}

TEST(Solver, TakesShapesOfExtremeSize) {
  for (const double scale : {1e-150, 1e150}) {
    const SurfaceMesh mesh = moved(box(1, 0.5, 6, 4, 2, 24), scale, 0, 0).mesh();
    const Index v = 5 * 30;
    const double length = GirthSolver(mesh).value(Vertex(v)).value().length / scale;
    EXPECT_GT(length, 0.5);
    EXPECT_LT(length, 14);
  }
}

TEST(Solver, KeepsComponentsApart) {
  const Shape ring = torus(2, 0.5, 12, 6), sphere = moved(octasphere(1), 1, 0, 50);
  const Index first = ring.vertexCount();
  const SurfaceMesh mesh = together(ring, sphere).mesh(), alone = sphere.mesh();
  GirthSolver solver(mesh), aloneSolver(alone);
  for (Index v = 0; v < alone.vertexCount(); ++v) {
    expectClose(solver.value(Vertex(first + v)).value().length,
                aloneSolver.value(Vertex(v)).value().length, at(v));
  }
  EXPECT_EQ(solver.value(Vertex(0)).value().kind, LoopKind::Loop);
  EXPECT_EQ(solver.value(Vertex(first)).value().kind, LoopKind::Antipodal);
}

TEST(Solver, RefusesVerticesThatDoNotExist) {
  const SurfaceMesh mesh = tetrahedron().mesh();
  GirthSolver solver(mesh);
  EXPECT_EQ(solver.value(Vertex(4)).error().code, ErrorCode::VertexOutOfRange);
  EXPECT_EQ(solver.loop(Vertex(kNoIndex)).error().code, ErrorCode::VertexOutOfRange);
  EXPECT_EQ(study::naiveGirth(mesh, Vertex(4)).error().code, ErrorCode::VertexOutOfRange);
}

/// A surface so large that its loops are looked for a second time, along paths to their midpoints.
void expectLoopsInLittleMemory(const Shape& shape, Index stride) {
  const SurfaceMesh mesh = shape.mesh();
  ASSERT_GT(mesh.faceCount(), geodesic::kMostFacesKept);
  const auto unfolding = std::make_shared<const geodesic::Unfolding>(mesh);
  const std::vector<std::uint8_t> everywhere(mesh.faceCount(), 1);
  GirthSolver solver = SolverFactory::onUnfolding(unfolding);
  GirthSolver keepsAll = SolverFactory::onUnfolding(unfolding);
  for (Index v = 0; v < mesh.vertexCount(); v += stride) {
    const GirthLoop loop = solver.loop(Vertex(v)).value();
    const std::size_t bytes = solver.statistics().peakBytes;
    expectGeodesicLoop(mesh, loop);
    EXPECT_EQ(loop.length, solver.value(Vertex(v)).value().length) << at(v);
    const auto other = SolverFactory::loopWithin(keepsAll, SurfacePoint::atVertex(Vertex(v)),
                                                 everywhere.data(), {});
    ASSERT_TRUE(other) << at(v);
    EXPECT_EQ(loop.length, other->length) << at(v);
    ASSERT_EQ(loop.points.size(), other->points.size()) << at(v);
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      EXPECT_EQ(loop.points[i].element, other->points[i].element) << at(v);
      EXPECT_EQ(loop.points[i].weights, other->points[i].weights) << at(v);
    }
    EXPECT_LT(3 * bytes, keepsAll.statistics().peakBytes) << at(v);
  }
}

TEST(Solver, FindsLoopsOfLargeSurfacesInLittleMemory) {
  const Shape ring = torus(2, 0.7, 400, 140);
  expectLoopsInLittleMemory(perturbed(ring, 0.002, 1), 11'113);
  expectLoopsInLittleMemory(ring, 20'011);
}

/// Round, but nowhere like a sphere: no loops, and one point that is farthest.
Shape potato(Index levels) {
  Shape shape = icosphere(levels);
  for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
    double* const p = &shape.positions[i];
    const double radius = 1 + 0.12 * std::sin(3 * p[0] + 1) +
                          0.1 * std::sin(2.5 * p[1] + 2 * p[2]) + 0.05 * std::cos(4 * p[2] - p[0]);
    p[0] *= 1.3 * radius;
    p[1] *= 0.9 * radius;
    p[2] *= radius;
  }
  return shape;
}

TEST(Solver, GoesToTheFarthestPointOfLargeSurfacesInLittleMemory) {
  const SurfaceMesh mesh = potato(6).mesh();
  ASSERT_GT(mesh.faceCount(), geodesic::kMostFacesKept);
  GirthSolver solver(mesh);
  for (const Vertex v : {Vertex(1), Vertex(20'005)}) {
    const GirthValue value = solver.value(v).value();
    ASSERT_EQ(value.kind, LoopKind::Antipodal) << v;
    const GirthLoop loop = solver.loop(v).value();
    // All windows take 400 MB.
    EXPECT_LT(solver.statistics().peakBytes, 150e6) << v;
    EXPECT_EQ(loop.kind, LoopKind::Antipodal) << v;
    EXPECT_EQ(loop.length, value.length) << v;
    expectGeodesicLoop(mesh, loop);
  }
  std::atomic<bool> cancel{true};
  EXPECT_EQ(solver.loop(Vertex(1), {1, &cancel, {}}).error().code, ErrorCode::Cancelled);
}

TEST(Solver, FindsLastingLoopsOfLargeSurfacesInLittleMemory) {
  const SurfaceMesh mesh = perturbed(potato(6), 0.3, 2).mesh();
  GirthSolver solver(mesh);
  std::size_t others = 0;
  for (const Vertex v : {Vertex(1), Vertex(9'001), Vertex(30'002)}) {
    solver.setPersistence(0);
    const double first = solver.value(v).value().length;
    for (const double persistence : {0.002, 0.02}) {
      solver.setPersistence(persistence);
      const GirthValue value = solver.value(v).value();
      const GirthLoop loop = solver.loop(v).value();
      EXPECT_LT(solver.statistics().peakBytes, 150e6) << v;
      EXPECT_EQ(loop.kind, value.kind) << v;
      EXPECT_EQ(loop.length, value.length) << v;
      expectGeodesicLoop(mesh, loop);
      if (value.length > first) ++others;
    }
  }
  EXPECT_GT(others, 1u);
}

TEST(Solver, FindsBarcodesOfLargeSurfacesInLittleMemory) {
  std::size_t saddles = 0;
  for (const Shape& shape :
       {perturbed(potato(6), 0.3, 2), perturbed(torus(2, 0.7, 200, 90), 0.1, 1)}) {
    const SurfaceMesh mesh = shape.mesh();
    ASSERT_GT(mesh.faceCount(), geodesic::kMostFacesKept);
    GirthSolver solver(mesh);
    for (const Vertex v : {Vertex(1), Vertex(9'001)}) {
      BarcodeOptions options;
      options.maxSaddles = 6;
      const Barcode plain = solver.barcode(v, options).value();
      options.loops = true;
      const Barcode barcode = solver.barcode(v, options).value();
      EXPECT_LT(solver.statistics().peakBytes, 150e6) << v;
      ASSERT_EQ(barcode.bars.size(), plain.bars.size()) << v;
      ASSERT_EQ(barcode.loops.size(), plain.bars.size()) << v;
      EXPECT_EQ(barcode.rest.length, plain.rest.length) << v;
      for (std::size_t i = 0; i < barcode.bars.size(); ++i) {
        EXPECT_EQ(barcode.bars[i].birth, plain.bars[i].birth) << v;
        EXPECT_EQ(barcode.bars[i].death, plain.bars[i].death) << v;
        expectClose(barcode.loops[i].length, 2 * barcode.bars[i].birth, at(v));
        expectGeodesicLoop(mesh, barcode.loops[i]);
        ++saddles;
      }
    }
    std::atomic<bool> cancel{true};
    BarcodeOptions options;
    options.loops = true;
    EXPECT_EQ(solver.barcode(Vertex(1), options, {1, &cancel, {}}).error().code,
              ErrorCode::Cancelled);
  }
  EXPECT_GT(saddles, 3u);
}

TEST(Solver, FindsPathsOverLargeSurfacesInLittleMemory) {
  for (const Shape& shape : {potato(6), perturbed(torus(2, 0.7, 200, 90), 0.2, 1)}) {
    const SurfaceMesh mesh = shape.mesh();
    ASSERT_GT(mesh.faceCount(), geodesic::kMostFacesKept);
    GeodesicSolver solver(mesh);
    const SurfacePoint from = SurfacePoint::atVertex(Vertex(17));
    const std::vector<double> distances = solver.distances(from).value();
    for (const Index v : {Index{18}, mesh.vertexCount() / 2, mesh.vertexCount() - 1}) {
      const SurfacePoint to = SurfacePoint::atVertex(Vertex(v));
      const GeodesicPath path = solver.path(from, to).value();
      expectShortestPath(mesh, path, from, to, distances[v]);
      EXPECT_LT(solver.statistics().peakBytes, 40e6) << v;
    }
    std::atomic<bool> cancel{true};
    EXPECT_EQ(solver.path(from, SurfacePoint::atVertex(Vertex(9)), {1, &cancel, {}}).error().code,
              ErrorCode::Cancelled);
  }
}

TEST(Solver, FindsNoPathToAnotherComponentOfALargeSurface) {
  const Shape large = potato(6);
  const Index first = large.vertexCount();
  const SurfaceMesh mesh = together(large, tetrahedron()).mesh();
  const GeodesicPath path =
      GeodesicSolver(mesh)
          .path(SurfacePoint::atVertex(Vertex(first)), SurfacePoint::atVertex(Vertex(0)))
          .value();
  EXPECT_TRUE(std::isinf(path.length));
  EXPECT_TRUE(path.points.empty());
}

TEST(Solver, GivesUpOnceOnLargeSurfaces) {
  const SurfaceMesh mesh = torus(2, 0.7, 400, 140).mesh();
  GirthSolver solver(mesh);
  solver.setBudget(20'000);
  const GirthValue value = solver.value(Vertex(7)).value();
  const std::size_t windows = solver.statistics().windowsCrossed;
  const GirthLoop loop = solver.loop(Vertex(7)).value();
  EXPECT_EQ(loop.kind, LoopKind::Unresolved);
  EXPECT_TRUE(loop.points.empty());
  EXPECT_EQ(loop.length, value.length);
  EXPECT_EQ(loop.atMost, value.atMost);
  EXPECT_EQ(solver.statistics().windowsCrossed, windows);
}

TEST(Solver, NeighboursDifferByNoMoreThanTheyMustOutsideTips) {
  // |I(a) − I(b)| ≤ 2 |ab| wherever both see the same loop; on a torus everywhere.
  const SurfaceMesh mesh = torus(2, 0.5, 16, 8).mesh();
  GirthSolver solver(mesh);
  std::vector<double> girth(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) girth[v] = solver.value(v).value().length;
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_LE(std::fabs(girth[mesh.from(h)] - girth[mesh.to(h)]), 2 * mesh.length(h) * (1 + 1e-12));
  }
}

}  // namespace
}  // namespace girth::test
