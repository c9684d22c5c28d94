#include "mesh/flat_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "girth/girth_solver.h"
#include "girth/refined_girth.h"
#include "mesh/shifted_paths.h"
#include "mesh/vector.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth::test {
namespace {

LeanSurface leanOf(const SurfaceMesh& mesh, double rounding = kRoundedDoubles) {
  auto lean = withoutFlatVertices(mesh, rounding, {});
  EXPECT_TRUE(lean);
  return std::move(lean).value();
}

double boundaryLength(const SurfaceMesh& mesh) {
  double length = 0;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.twin(h) == Halfedge::none) length += mesh.length(h);
  }
  return length;
}

/// The farthest that a vertex lies from its place.
double farthestOff(const SurfaceMesh& mesh, const LeanSurface& lean) {
  double farthest = 0;
  for (const Vertex v : mesh.vertices()) {
    farthest = std::max(farthest, norm(positionOf(lean.mesh, lean.places[v]) - mesh.position(v)));
  }
  return farthest;
}

/// A surface with its coordinates rounded to single precision.
SurfaceMesh rounded(Shape shape) {
  // Far from the origin, where they are rounded more.
  for (double& x : shape.positions) x = static_cast<float>(x + 20);
  return shape.mesh(OpenEdges::Boundary);
}

TEST(FlatVertices, aDividedSurfaceBecomesWhatItWas) {
  Index before = 0, after = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomMesh random = randomMesh(seed);
    const SurfaceMesh coarse = random.shape.mesh(OpenEdges::Boundary);
    const SurfaceMesh fine = subdivided(subdivided(random.shape)).mesh(OpenEdges::Boundary);
    const LeanSurface lean = leanOf(fine);
    before += coarse.faceCount();
    after += lean.mesh.faceCount();
    EXPECT_EQ(lean.mesh.componentCount(), 1u);
    EXPECT_EQ(lean.mesh.genus(0), coarse.genus(0)) << random.history;
    EXPECT_EQ(lean.mesh.boundaryCount(0), coarse.boundaryCount(0)) << random.history;
    EXPECT_NEAR(lean.mesh.area(), coarse.area(), 1e-9 * coarse.area()) << random.history;
    EXPECT_NEAR(boundaryLength(lean.mesh), boundaryLength(coarse), 1e-9 * coarse.area())
        << random.history;
    ASSERT_EQ(lean.places.size(), fine.vertexCount());
    EXPECT_LE(farthestOff(fine, lean), 1e-9 * coarse.meanEdgeLength()) << random.history;
  }
  // Some needles stay divided.
  EXPECT_LE(after, before * 11 / 10);
}

TEST(FlatVertices, theGirthIsThatOfTheDividedSurface) {
  std::size_t flat = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const RandomMesh random = randomMesh(seed);
    const SurfaceMesh fine = subdivided(random.shape).mesh(OpenEdges::Boundary);
    const LeanSurface lean = leanOf(fine);
    GirthSolver onFine(fine), onLean(lean.mesh);
    for (Index v = 0; v < fine.vertexCount(); v += 3) {
      const auto exact = onFine.value(Vertex(v)), found = onLean.value(lean.places[v]);
      ASSERT_TRUE(exact && found);
      flat += lean.places[v].kind == SurfacePoint::Kind::AtVertex ? 0 : 1;
      EXPECT_NEAR(found.value().length, exact.value().length, 1e-9 * exact.value().length)
          << random.history << ", vertex " << v;
    }
  }
  EXPECT_GT(flat, 500u);
}

TEST(FlatVertices, coordinatesMayBeRoundedToSinglePrecision) {
  const Shape shape = perturbed(torus(3, 1, 24, 12), 0.1, 5);
  const SurfaceMesh fine = rounded(subdivided(subdivided(subdivided(shape))));
  const LeanSurface lean = leanOf(fine, kRoundedSingles);
  EXPECT_LE(lean.mesh.faceCount(), fine.faceCount() / 50);
  EXPECT_LE(farthestOff(fine, lean), 1e-5);
  GirthSolver onFine(fine), onLean(lean.mesh);
  const ShiftedPaths shifted(fine, lean);
  EXPECT_FALSE(shifted.isEmpty());
  double worst = 0, worstShifted = 0, sum = 0, sumShifted = 0;
  for (Index v = 0; v < fine.vertexCount(); v += 83) {
    const double exact = onFine.value(Vertex(v)).value().length;
    const GirthLoop loop = onLean.loop(lean.places[v]).value();
    const double plain = std::fabs(loop.length / exact - 1);
    const double length = loop.length + shifted.excess(Vertex(v), loop.points);
    const double left = std::fabs(length / exact - 1);
    worst = std::max(worst, plain);
    worstShifted = std::max(worstShifted, left);
    sum += plain;
    sumShifted += left;
  }
  // Differences that are left are squares of shifts, but where a path meets a crease next to its
  // base.
  EXPECT_LE(worst, 1e-5);
  EXPECT_LE(worstShifted, 2e-7);
  EXPECT_LE(sumShifted, 0.1 * sum);
}

TEST(FlatVertices, midpointsInDoublePrecisionAreNotShifted) {
  const SurfaceMesh fine = subdivided(perturbed(torus(3, 1, 24, 12), 0.1, 5)).mesh();
  EXPECT_TRUE(ShiftedPaths(fine, leanOf(fine)).isEmpty());
}

TEST(FlatVertices, whatIsBentAnywhereStays) {
  const SurfaceMesh sphere = icosphere(3).mesh();
  const LeanSurface lean = leanOf(sphere, kRoundedSingles);
  EXPECT_EQ(lean.mesh.faceCount(), sphere.faceCount());
  for (const Vertex v : sphere.vertices()) EXPECT_EQ(lean.places[v].vertex(), v);
}

TEST(FlatVertices, ofABoxAndAnOpenSheetTheCornersStay) {
  const SurfaceMesh closed = box(3, 2, 1, 12, 8, 4).mesh();
  EXPECT_LE(leanOf(closed).mesh.faceCount(), 24u);
  Shape sheet;
  constexpr Index kCells = 8;
  for (Index y = 0; y <= kCells; ++y) {
    for (Index x = 0; x <= kCells; ++x) sheet.add(x, y, 0.5 * y);
  }
  for (Index y = 0; y < kCells; ++y) {
    for (Index x = 0; x < kCells; ++x) {
      const Index a = y * (kCells + 1) + x, b = a + 1, c = a + kCells + 1, d = c + 1;
      sheet.face(a, b, d);
      sheet.face(a, d, c);
    }
  }
  const SurfaceMesh open = sheet.mesh(OpenEdges::Boundary);
  const LeanSurface lean = leanOf(open);
  EXPECT_LE(lean.mesh.faceCount(), 4u);
  EXPECT_NEAR(boundaryLength(lean.mesh), boundaryLength(open), 1e-12 * boundaryLength(open));
  EXPECT_NEAR(lean.mesh.area(), open.area(), 1e-12 * open.area());
}

TEST(FlatVertices, sizesWithoutMeasureAndCancelling) {
  for (const double scale : {1e-100, 1e-5, 1e5, 1e100}) {
    const SurfaceMesh mesh = moved(subdivided(tetrahedron()), scale, 0.3, 0).mesh();
    const bool isOrdinary = scale > 1e-60 && scale < 1e60;
    EXPECT_EQ(leanOf(mesh).mesh.faceCount(), isOrdinary ? 4u : 16u) << scale;
  }
  const std::atomic<bool> cancel{true};
  ExecutionContext stopped;
  stopped.cancel = &cancel;
  const SurfaceMesh large = subdivided(icosphere(4)).mesh();
  const auto lean = withoutFlatVertices(large, kRoundedDoubles, stopped);
  ASSERT_FALSE(lean);
  EXPECT_EQ(lean.error().code, ErrorCode::Cancelled);
}

TEST(RefinedGirth, flatVerticesAreLeftOutAndHaveTheirGirth) {
  // The coarse surface has few faces in one case, so that all is exact, and more in the other.
  for (const Index around : {18, 60}) {
    const Shape shape = perturbed(torus(3, 1, around, 24), 0.05, 3);
    const SurfaceMesh coarse = shape.mesh();
    const SurfaceMesh fine = subdivided(around == 18 ? subdivided(shape) : shape).mesh();
    RefinedOptions options;
    options.audit = 40;
    const auto refined = refinedGirth(fine, options);
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined.value().leanFaces, coarse.faceCount());
    EXPECT_EQ(refined.value().audit.vertices, 40u);
    EXPECT_GE(refined.value().audit.equal, 39u);
    GirthSolver solver(fine);
    std::size_t compared = 0, equal = 0;
    for (Index v = 0; v < fine.vertexCount(); v += 67) {
      const double exact = solver.value(Vertex(v)).value().length;
      const double value = refined.value().field.values[v];
      const bool isEqual = std::fabs(value - exact) <= 1e-9 * exact;
      ++compared;
      equal += isEqual ? 1 : 0;
      if (refined.value().states[v] == GirthState::Proved) {
        EXPECT_TRUE(isEqual) << v;
      }
    }
    EXPECT_GE(equal, compared * 99 / 100);
    if (around == 18) {
      EXPECT_EQ(refined.value().count(GirthState::Proved), fine.vertexCount());
    }
    // Any number of threads gives these bits.
    ExecutionContext three;
    three.threads = 3;
    const auto again = refinedGirth(fine, options, three);
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value().field.values, refined.value().field.values);
    EXPECT_EQ(again.value().states, refined.value().states);
  }
}

}  // namespace
}  // namespace girth::test
