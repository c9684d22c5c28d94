// One surface in more triangles.
#include "girth/subdivide_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "girth/girth_solver.h"

namespace girth::test {
namespace {

PreparedSurface prepared(const TriangleSoup& soup) {
  auto surface = prepareSurface(soup);
  EXPECT_TRUE(surface.ok());
  return std::move(surface).value();
}

/// A prism over a square of side 1, as long as wished, in 12 faces.
TriangleSoup beam(double length) {
  return {
      {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, length, 1, 0, length, 1, 1, length, 0, 1, length},
      {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
       1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7}};
}

TEST(SubdivideSurface, hasAsManyFacesAsWantedOnAnySurface) {
  // A closed one, one with a boundary, and one whose faces are needles.
  const TriangleSoup sheet{{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}};
  for (const TriangleSoup& soup : {beam(1), beam(1000), sheet}) {
    const PreparedSurface coarse = prepared(soup);
    for (const Index faces : {1u, 13u, 114u, 3000u}) {
      const auto fine = subdivideSurface(prepared(soup), faces);
      ASSERT_TRUE(fine.ok()) << fine.error().message;
      const PreparedSurface& surface = fine.value();
      EXPECT_GE(surface.mesh.faceCount(), std::max(faces, coarse.mesh.faceCount()));
      EXPECT_LE(surface.mesh.faceCount(), std::max(faces + 1, coarse.mesh.faceCount()));
      EXPECT_NEAR(surface.mesh.area(), coarse.mesh.area(), 1e-12 * coarse.mesh.area());
      EXPECT_EQ(surface.mesh.genus(0), coarse.mesh.genus(0));
      EXPECT_EQ(surface.mesh.boundaryCount(0), coarse.mesh.boundaryCount(0));
      ASSERT_EQ(surface.inputOfVertex.size(), surface.mesh.vertexCount());
      ASSERT_EQ(surface.inputOfFace.size(), surface.mesh.faceCount());
      for (const Vertex v : coarse.mesh.vertices()) {
        EXPECT_EQ(surface.inputOfVertex[v], coarse.inputOfVertex[v]);
        EXPECT_EQ(surface.mesh.position(v).x, coarse.mesh.position(v).x);
      }
      for (Index v = coarse.mesh.vertexCount(); v < surface.mesh.vertexCount(); ++v) {
        EXPECT_EQ(surface.inputOfVertex[v], kNoIndex);
      }
    }
  }
}

TEST(SubdivideSurface, facesCoverTheirTriangleOfTheInput) {
  const TriangleSoup soup = beam(3);
  const auto fine = subdivideSurface(prepared(soup), 200);
  ASSERT_TRUE(fine.ok());
  const SurfaceMesh coarse = prepared(soup).mesh;
  std::vector<double> covered(soup.triangles.size() / 3);
  for (const Face f : fine.value().mesh.faces()) {
    covered[fine.value().inputOfFace[f]] += fine.value().mesh.area(f);
  }
  for (const Face f : coarse.faces()) EXPECT_NEAR(covered[f], coarse.area(f), 1e-12);
}

TEST(SubdivideSurface, theGirthStays) {
  const TriangleSoup soup = beam(10);
  const SurfaceMesh coarse = prepared(soup).mesh;
  const auto fine = subdivideSurface(prepared(soup), 500);
  ASSERT_TRUE(fine.ok());
  GirthSolver before(coarse), after(fine.value().mesh);
  for (const Vertex v : coarse.vertices()) {
    const double girth = before.value(v).value().length;
    EXPECT_NEAR(after.value(v).value().length, girth, 1e-9 * girth);
  }
}

TEST(SubdivideSurface, stopsAtOnce) {
  std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  const auto stopped = subdivideSurface(prepared(beam(1)), 100'000, context);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth::test
