// Repair of topology: isosurfaces with small handles and tunnels at random, plates, boundaries, and
// bad input.
#include "girth/remove_handles.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "isosurface.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

double volumeOf(const SurfaceMesh& mesh) {
  double volume = 0;
  for (const Face f : mesh.faces()) {
    const auto corners = mesh.faceVertices(f);
    volume += dot(mesh.position(corners[0]),
                  cross(mesh.position(corners[1]), mesh.position(corners[2]))) /
              6;
  }
  return volume;
}

/// A solid torus of radii 1 and 0.45, on which small rings stand, and in which small rings are
/// missing, each half-way in the surface: arches and worm holes. All of them lie apart.
SurfaceMesh withSmallHandles(std::uint64_t seed, Index arches, Index holes) {
  constexpr double kRing = 0.22, kTube = 0.09;
  test::Random random(seed);
  const Index count = arches + holes;
  std::vector<Vec3> centres, axes;
  for (Index i = 0; i < count; ++i) {
    const double u = 2 * M_PI * (i + 0.5 * random()) / count, v = M_PI * (random() - 0.5);
    const Vec3 outwards{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
    centres.push_back(Vec3{std::cos(u), std::sin(u), 0} + 0.45 * outwards);
    const Vec3 along{-std::sin(u), std::cos(u), 0};
    const Vec3 across = cross(outwards, along);
    const double turn = M_PI * random();
    axes.push_back(std::cos(turn) * along + std::sin(turn) * across);
  }
  return test::isosurface(
             [&](const Vec3& p) {
               double value = test::torusDistance(p, {0, 0, 0}, {0, 0, 1}, 1, 0.45);
               for (Index i = 0; i < count; ++i) {
                 const double ring = test::torusDistance(p, centres[i], axes[i], kRing, kTube);
                 value = i < arches ? std::min(value, ring) : std::max(value, -ring);
               }
               return value;
             },
             1.75, 46)
      .mesh();
}

/// Shorter than the true loops, longer than those of the small rings.
constexpr double kShort = 1.2;

TEST(RemoveHandles, ofIsosurfacesTakesTheSmallOnesAlone) {
  for (const std::uint64_t seed : {1u, 2u}) {
    SCOPED_TRACE(seed);
    const SurfaceMesh mesh = withSmallHandles(seed, 2, 2);
    ASSERT_EQ(mesh.componentCount(), 1u);
    ASSERT_EQ(mesh.genus(0), 5u);
    const auto removal = removeHandles(mesh, kShort, {4});
    ASSERT_TRUE(removal.ok()) << removal.error().message;
    const HandleRemoval& made = removal.value();
    EXPECT_EQ(made.genusBefore, 5u);
    EXPECT_EQ(made.genusAfter, 1u);
    EXPECT_EQ(made.removed.size(), 4u);
    EXPECT_EQ(made.mesh.componentCount(), 1u);
    EXPECT_EQ(made.mesh.boundaryCount(0), 0u);
    EXPECT_NEAR(volumeOf(made.mesh), volumeOf(mesh), 1e-3 * volumeOf(mesh));
    // The true handle is what it was.
    const Handles left = findHandles(made.mesh, {4}).value();
    ASSERT_EQ(left.handles.size(), 2u);
    for (const Handle& handle : left.handles) EXPECT_GT(handle.length, 2);
    // Nothing more to do.
    const HandleRemoval again = removeHandles(made.mesh, kShort, {4}).value();
    EXPECT_TRUE(again.removed.empty());
    EXPECT_EQ(again.mesh.faceCount(), made.mesh.faceCount());
  }
}

TEST(RemoveHandles, cutsHandlesOrClosesTunnelsByTheirLengths) {
  // Bars of length 3 round, holes of length 4.
  const SurfaceMesh mesh = test::subdivided(test::plate(1, 2)).mesh();
  const double volume = volumeOf(mesh);
  const HandleRemoval none = removeHandles(mesh, 3).value();
  EXPECT_TRUE(none.removed.empty());
  EXPECT_EQ(none.genusAfter, 2u);
  const HandleRemoval all = removeHandles(mesh, std::numeric_limits<double>::infinity()).value();
  EXPECT_EQ(all.genusAfter, 0u);
  EXPECT_EQ(all.removed.size(), 2u);
  for (const Handle& handle : all.removed) EXPECT_EQ(handle.kind, HandleKind::Handle);
  EXPECT_EQ(all.mesh.componentCount(), 1u);
  // What has been taken away is what the rims were drawn back by.
  EXPECT_LT(volumeOf(all.mesh), volume);
  EXPECT_GT(volumeOf(all.mesh), 0.8 * volume);
}

TEST(RemoveHandles, drawsTheTwoSidesOfACutApart) {
  const SurfaceMesh mesh = test::subdivided(test::plate(1)).mesh();
  const HandleRemoval made = removeHandles(mesh, 3.5).value();
  ASSERT_EQ(made.removed.size(), 1u);
  for (const Vertex a : made.mesh.vertices()) {
    for (const Vertex b : made.mesh.vertices()) {
      if (a < b) {
        EXPECT_GT(norm(made.mesh.position(a) - made.mesh.position(b)), 0.1);
      }
    }
  }
  // Off the cut all stays in its place.
  Index kept = 0;
  for (const Vertex v : mesh.vertices()) {
    for (const Vertex w : made.mesh.vertices()) {
      kept += norm(mesh.position(v) - made.mesh.position(w)) == 0 ? 1 : 0;
    }
  }
  EXPECT_GE(kept, mesh.vertexCount() - 8);
}

TEST(RemoveHandles, leavesBoundaryCurves) {
  test::Shape shape = test::torus(3, 1, 12, 8);
  shape.triangles.erase(shape.triangles.begin(), shape.triangles.begin() + 3);
  const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
  const HandleRemoval made = removeHandles(mesh, 100).value();
  EXPECT_EQ(made.genusAfter, 0u);
  EXPECT_EQ(made.mesh.boundaryCount(0), 1u);
}

TEST(RemoveHandles, badInput) {
  const SurfaceMesh mesh = test::torus(3, 1, 8, 6).mesh();
  for (const double length : {-1.0, std::nan("")}) {
    EXPECT_EQ(removeHandles(mesh, length).error().code, ErrorCode::InvalidOption);
  }
  EXPECT_EQ(removeHandles(mesh, 1, {0}).error().code, ErrorCode::InvalidOption);
  EXPECT_TRUE(removeHandles(mesh, 0).value().removed.empty());
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(removeHandles(mesh, 1, {}, {0, &cancel, {}}).error().code, ErrorCode::Cancelled);
  double last = 0;
  ExecutionContext context;
  context.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  EXPECT_TRUE(removeHandles(mesh, 100, {}, context).ok());
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace girth
