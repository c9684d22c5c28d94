// Changes of surfaces: what they leave alone, and what they change by how much.
#include "girth/study/surface_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "girth/remove_handles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth::study {
namespace {

ErrorCode codeOf(const Result<SurfaceMesh>& result) {
  return result.ok() ? ErrorCode::Internal : result.error().code;
}

TEST(SurfaceChanges, UnevenTrianglesLieOnTheSurface) {
  const SurfaceMesh box = test::box(6, 1, 1, 12, 2, 2).mesh();
  const auto uneven = remeshedUnevenly(box, 1200, 4);
  ASSERT_TRUE(uneven.ok());
  const SurfaceMesh& mesh = uneven.value();
  EXPECT_NEAR(mesh.faceCount(), 1200, 60);
  EXPECT_EQ(mesh.genus(0), 0u);
  EXPECT_NEAR(mesh.area(), box.area(), 1e-6 * box.area());
  // Shorter along the box than across it.
  double along = 0, across = 0;
  for (const Halfedge h : mesh.halfedges()) {
    const Vec3 side = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
    along += side.x * side.x;
    across += side.y * side.y + side.z * side.z;
  }
  const auto even = remeshedUnevenly(box, 1200, 1);
  ASSERT_TRUE(even.ok());
  EXPECT_LT(along, 0.25 * across);
  EXPECT_EQ(codeOf(remeshedUnevenly(box, 1200, 0.5)), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(remeshedUnevenly(box, 1200, std::numeric_limits<double>::quiet_NaN())),
            ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(remeshedUnevenly(box, 1, 2)), ErrorCode::InvalidOption);
}

TEST(SurfaceChanges, NoiseIsAsStrongAsItSays) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  const auto noisy = withNoise(mesh, 0.25, 7);
  ASSERT_TRUE(noisy.ok());
  const double most = 0.25 * mesh.meanEdgeLength();
  double greatest = 0, sum = 0;
  for (const Vertex v : mesh.vertices()) {
    const double distance = norm(noisy.value().position(v) - mesh.position(v));
    greatest = std::max(greatest, distance);
    sum += distance;
  }
  EXPECT_LE(greatest, most * (1 + 1e-9));
  EXPECT_GT(greatest, 0.99 * most);
  EXPECT_NEAR(sum / mesh.vertexCount(), most / 2, 0.02 * most);
  const auto again = withNoise(mesh, 0.25, 7), other = withNoise(mesh, 0.25, 8);
  ASSERT_TRUE(again.ok() && other.ok());
  EXPECT_EQ(again.value().position(Vertex(5)).x, noisy.value().position(Vertex(5)).x);
  EXPECT_NE(other.value().position(Vertex(5)).x, noisy.value().position(Vertex(5)).x);
  EXPECT_EQ(codeOf(withNoise(mesh, -0.1, 1)), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(withNoise(mesh, 4.1, 1)), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(withNoise(mesh, std::numeric_limits<double>::quiet_NaN(), 1)),
            ErrorCode::InvalidOption);
}

TEST(SurfaceChanges, HumpsRiseOutwards) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  HumpOptions options;
  options.humps = 3;
  const auto humped = withHumps(mesh, options);
  ASSERT_TRUE(humped.ok());
  const double radius = 0.1 * std::sqrt(mesh.area());
  double highest = 0;
  Index raised = 0;
  for (const Vertex v : mesh.vertices()) {
    const double rise = norm(humped.value().position(v)) - norm(mesh.position(v));
    EXPECT_GE(rise, -1e-12);
    highest = std::max(highest, rise);
    raised += rise > 1e-12 ? 1 : 0;
  }
  EXPECT_NEAR(highest, 0.25 * radius, 1e-6);
  // Three caps of that radius, of an area of some π radius² each.
  const double share = 3 * M_PI * radius * radius / mesh.area();
  EXPECT_NEAR(raised, share * mesh.vertexCount(), 0.2 * share * mesh.vertexCount());
  options.height = 0;
  EXPECT_EQ(codeOf(withHumps(mesh, options)), ErrorCode::InvalidOption);
}

TEST(SurfaceChanges, ABridgeIsAHandle) {
  const SurfaceMesh mesh = test::icosphere(2).mesh();
  const auto bridged = withBridge(mesh, Face(0), Face(mesh.faceCount() - 1));
  ASSERT_TRUE(bridged.ok()) << bridged.error().message;
  EXPECT_EQ(bridged.value().componentCount(), 1u);
  EXPECT_EQ(bridged.value().genus(0), 1u);
  EXPECT_EQ(bridged.value().boundaryCount(0), 0u);
  EXPECT_EQ(bridged.value().faceCount(), mesh.faceCount() + 4);
  EXPECT_EQ(codeOf(withBridge(mesh, Face(3), Face(3))), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(withBridge(mesh, Face(0), Face(mesh.faceCount()))), ErrorCode::InvalidOption);
}

TEST(SurfaceChanges, TinyHandlesAreShortAndApart) {
  const SurfaceMesh sphere = test::icosphere(4).mesh();
  const auto rough = withTinyHandles(sphere, 5);
  ASSERT_TRUE(rough.ok());
  EXPECT_EQ(rough.value().genus(0), 5u);
  EXPECT_EQ(rough.value().vertexCount(), sphere.vertexCount());
  EXPECT_EQ(rough.value().faceCount(), sphere.faceCount() + 20);
  const double length = kTinyLoop * sphere.meanEdgeLength();
  const auto removal = removeHandles(rough.value(), length);
  ASSERT_TRUE(removal.ok());
  EXPECT_EQ(removal.value().genusAfter, 0u);
  EXPECT_EQ(removal.value().removed.size(), 5u);
  EXPECT_EQ(codeOf(withTinyHandles(sphere, 100000)), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(withTinyHandles(test::box(1, 1, 1, 1, 1, 1).mesh(), 1)),
            ErrorCode::InvalidOption);
}

TEST(SurfaceChanges, PartsFaceEachOtherAcrossGaps) {
  const SurfaceMesh mesh = test::bentRod(12, 60).mesh();
  const auto places = facingPlaces(mesh, 1);
  ASSERT_TRUE(places.ok());
  ASSERT_EQ(places.value().size(), 1u);
  const auto [one, other] = places.value()[0];
  const auto bridged = withBridge(mesh, one, other);
  ASSERT_TRUE(bridged.ok());
  EXPECT_EQ(bridged.value().genus(0), 1u);
  const double gap = norm(mesh.position(Vertex(mesh.faceVertices(Face(one))[0])) -
                          mesh.position(Vertex(mesh.faceVertices(Face(other))[0])));
  EXPECT_LT(gap, 4);

  const auto none = facingPlaces(test::icosphere(3).mesh(), 2);
  ASSERT_TRUE(none.ok());
  EXPECT_TRUE(none.value().empty());
}

TEST(SurfaceChanges, SubdividedIsTheSameSurfaceInSmallerTriangles) {
  for (const test::Shape& shape : {test::torus(3, 1, 12, 8), test::plate(1)}) {
    const SurfaceMesh mesh = shape.mesh();
    const auto finer = subdivided(mesh);
    ASSERT_TRUE(finer.ok());
    const SurfaceMesh& fine = finer.value().mesh;
    EXPECT_EQ(fine.faceCount(), 4 * mesh.faceCount());
    ASSERT_EQ(fine.vertexCount(), mesh.vertexCount() + finer.value().between.size());
    EXPECT_EQ(fine.componentCount(), mesh.componentCount());
    EXPECT_EQ(fine.boundaryCount(0), mesh.boundaryCount(0));
    for (const Vertex v : mesh.vertices()) {
      EXPECT_EQ(norm(fine.position(v) - mesh.position(v)), 0);
    }
    for (Index v = mesh.vertexCount(); v < fine.vertexCount(); ++v) {
      const auto [a, b] = finer.value().between[v - mesh.vertexCount()];
      EXPECT_EQ(norm(fine.position(Vertex(v)) -
                     0.5 * (mesh.position(Vertex(a)) + mesh.position(Vertex(b)))),
                0);
    }
    for (const Face f : fine.faces()) {
      EXPECT_NEAR(fine.area(f), mesh.area(Face(f / 4)) / 4, 1e-12);
    }
  }
  // Boundaries stay boundaries.
  test::Shape patch;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) patch.add(x, y, 0);
  patch.face(0, 1, 2);
  patch.face(0, 2, 3);
  const auto open = subdivided(patch.mesh(OpenEdges::Boundary));
  ASSERT_TRUE(open.ok());
  EXPECT_EQ(open.value().mesh.boundaryCount(0), 1u);
  EXPECT_EQ(open.value().mesh.vertexCount(), 9u);
}

}  // namespace
}  // namespace girth::study
