// Repair of topology: isosurfaces with small handles and tunnels at random, plates, boundaries, and
// bad input.
#include "girth/remove_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <set>

#include "isosurface.h"
#include "lathe.h"
#include "mesh/vector.h"
#include "shapes.h"
#include "small_handles.h"
#include "tubes.h"

namespace girth {
namespace {

using test::volumeOf;

TEST(RemoveHandles, ofIsosurfacesTakesTheSmallOnesAlone) {
  // In the second the triangulation of least area of a cap crosses the surface beside it.
  for (const std::uint64_t seed : {1u, 29u}) test::expectSmallHandlesRemoved(seed);
}

/// The distance of the farthest vertex from the origin.
double reachOf(const SurfaceMesh& mesh) {
  double reach = 0;
  for (const Vertex v : mesh.vertices()) reach = std::max(reach, norm(mesh.position(v)));
  return reach;
}

/// A ball of radius 1 with an arch, half a ring that stands out of it.
SurfaceMesh ballWithArch(double ring, double tube, int cells) {
  return test::isosurface(
             [&](const Vec3& p) {
               return std::min(norm(p) - 1,
                               test::torusDistance(p, {1, 0, 0}, {0, 1, 0}, ring, tube));
             },
             1.8, cells)
      .mesh();
}

TEST(RemoveHandles, dropsASmallHandle) {
  for (const double tube : {0.08, 0.11}) {
    SCOPED_TRACE(tube);
    const SurfaceMesh mesh = ballWithArch(0.35, tube, 46);
    ASSERT_EQ(mesh.genus(0), 1u);
    const HandleRemoval made = removeHandles(mesh, 1.1, {4}).value();
    EXPECT_EQ(made.genusAfter, 0u);
    EXPECT_EQ(made.crossingFaces, 0u);
    ASSERT_EQ(made.droppedAreas.size(), 1u);
    // About half of the ring's area.
    EXPECT_NEAR(made.droppedAreas[0], 2 * M_PI * M_PI * 0.35 * tube, 0.3 * made.droppedAreas[0]);
    EXPECT_EQ(made.account()[0].droppedArea, made.droppedAreas[0]);
    EXPECT_EQ(made.mesh.componentCount(), 1u);
    // No horn is left: the ball is nearly what it was.
    EXPECT_LT(reachOf(made.mesh), 1 + 0.5 * tube);
    EXPECT_NEAR(volumeOf(made.mesh), 4 * M_PI / 3, 0.02);
  }
}

TEST(RemoveHandles, cutsALargeHandle) {
  const SurfaceMesh mesh = ballWithArch(0.5, 0.2, 30);
  const HandleRemoval made = removeHandles(mesh, 2, {4}).value();
  EXPECT_EQ(made.genusAfter, 0u);
  ASSERT_EQ(made.droppedAreas.size(), 1u);
  EXPECT_EQ(made.droppedAreas[0], 0);
  EXPECT_GT(reachOf(made.mesh), 1.3);
}

TEST(RemoveHandles, dropsOneHandleAndCutsTheOther) {
  const SurfaceMesh mesh =
      test::isosurface(
          [](const Vec3& p) {
            const double large = test::torusDistance(p, {-1, 0, 0}, {0, 1, 0}, 0.5, 0.2);
            const double small = test::torusDistance(p, {1, 0, 0}, {0, 1, 0}, 0.35, 0.1);
            return std::min({norm(p) - 1, large, small});
          },
          1.8, 46)
          .mesh();
  ASSERT_EQ(mesh.genus(0), 2u);
  const HandleRemoval made = removeHandles(mesh, 2, {4}).value();
  EXPECT_EQ(made.genusAfter, 0u);
  ASSERT_EQ(made.removed.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(made.droppedAreas[i] > 0, made.removed[i].centre.x > 0);
  }
  double right = 0;
  for (const Vertex v : made.mesh.vertices()) right = std::max(right, made.mesh.position(v).x);
  EXPECT_LT(right, 1.05);
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
  // Each bar is more than a tenth of the surface: it is cut. The rims of a cut are drawn back, and
  // the volume shrinks.
  EXPECT_EQ(all.droppedAreas, (std::vector<double>{0, 0}));
  EXPECT_LT(volumeOf(all.mesh), volume);
  EXPECT_GT(volumeOf(all.mesh), 0.9 * volume);
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

/// Whether an edge of one face passes through the inside of another, by plain arithmetic: for
/// shapes in which nothing is nearly touched.
bool crossesItself(const SurfaceMesh& mesh) {
  const auto passes = [](const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                         const Vec3& c) {
    const Vec3 normal = cross(b - a, c - a);
    const double above = dot(normal, p - a), below = dot(normal, q - a);
    if (above * below >= 0) return false;
    const Vec3 at = p + (above / (above - below)) * (q - p);
    return dot(normal, cross(b - a, at - a)) > 0 && dot(normal, cross(c - b, at - b)) > 0 &&
           dot(normal, cross(a - c, at - c)) > 0;
  };
  for (const Halfedge h : mesh.halfedges()) {
    for (const Face f : mesh.faces()) {
      const auto corners = mesh.faceVertices(f);
      if (passes(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(corners[0]),
                 mesh.position(corners[1]), mesh.position(corners[2]))) {
        return true;
      }
    }
  }
  return false;
}

/// A plate of thickness 2 with a hole of width 1, and in the hole a box that is not tied to it: the
/// loop round the hole, of length 4, is shorter than that round the material.
SurfaceMesh plateRound(const Vec3& low, const Vec3& high) {
  test::Shape shape = test::subdivided(test::plate(1));
  for (std::size_t i = 2; i < shape.positions.size(); i += 3) shape.positions[i] *= 4;
  const test::Shape box = test::box(high.x - low.x, high.y - low.y, high.z - low.z, 1, 1, 1);
  const Index before = shape.vertexCount();
  for (Index v = 0; v < box.vertexCount(); ++v) {
    shape.add(low.x + box.positions[3 * v], low.y + box.positions[3 * v + 1],
              low.z + box.positions[3 * v + 2]);
  }
  for (const Index v : box.triangles) shape.triangles.push_back(before + v);
  return shape.mesh();
}

TEST(RemoveHandles, drawsRimsBackLessWhereTheyWouldCrossSomething) {
  // Nothing in the way: films at a quarter of the way, at both sides.
  const auto filmsOf = [](const HandleRemoval& made) {
    std::set<double> heights;
    for (const Vertex v : made.mesh.vertices()) {
      const Vec3& p = made.mesh.position(v);
      if (p.z > 0.01 && p.z < 1.99 && p.x > 0.9 && p.x < 2.1 && p.y > 0.9 && p.y < 2.1 &&
          made.mesh.componentOf(v) == 0) {
        heights.insert(p.z);
      }
    }
    return heights;
  };
  const HandleRemoval plain = removeHandles(plateRound({1.4, 1.4, 3}, {1.6, 1.6, 4}), 5).value();
  ASSERT_EQ(plain.genusAfter, 0u);
  EXPECT_EQ(plain.removed[0].kind, HandleKind::Tunnel);
  EXPECT_EQ(plain.crossingFaces, 0u);
  EXPECT_FALSE(crossesItself(plain.mesh));
  const double quarter = *filmsOf(plain).rbegin();
  EXPECT_GT(quarter, 1.1);
  // A box where that film would be.
  const SurfaceMesh narrow = plateRound({1.4, 1.4, quarter - 0.08}, {1.6, 1.6, quarter + 0.3});
  const HandleRemoval made = removeHandles(narrow, 5).value();
  EXPECT_EQ(made.genusAfter, 0u);
  EXPECT_EQ(made.crossingFaces, 0u);
  EXPECT_FALSE(crossesItself(made.mesh));
  EXPECT_LT(*filmsOf(made).rbegin(), quarter - 0.08);
  // The other film stays where it was.
  EXPECT_EQ(*filmsOf(made).begin(), *filmsOf(plain).begin());
}

TEST(RemoveHandles, saysWhereThereIsNoRoom) {
  // A needle through the hole.
  const SurfaceMesh mesh = plateRound({1.4, 1.45, -1}, {1.6, 1.55, 3});
  ASSERT_FALSE(crossesItself(mesh));
  const HandleRemoval made = removeHandles(mesh, 5).value();
  EXPECT_EQ(made.genusAfter, 0u);
  EXPECT_TRUE(crossesItself(made.mesh));
  EXPECT_GT(made.crossingFaces, 0u);
  // Faces that crossed before, away from the cut, are no affair of the repair.
  const SurfaceMesh twice = plateRound({-0.5, -0.5, 0.5}, {0.5, 0.5, 2.5});
  ASSERT_TRUE(crossesItself(twice));
  EXPECT_EQ(removeHandles(twice, 5).value().crossingFaces, 0u);
}

TEST(RemoveHandles, leavesBoundaryCurves) {
  test::Shape shape = test::torus(3, 1, 12, 8);
  shape.triangles.erase(shape.triangles.begin(), shape.triangles.begin() + 3);
  const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
  const HandleRemoval made = removeHandles(mesh, 100).value();
  EXPECT_EQ(made.genusAfter, 0u);
  EXPECT_EQ(made.mesh.boundaryCount(0), 1u);
}

TEST(RemoveHandles, cutsTheOnlyShortOneWhereverItIs) {
  for (const Index narrow : {3, 36, 77, 90}) {
    const SurfaceMesh mesh = test::wavyRing(narrow, 8).mesh();
    const double shortest = test::polygonLength(0.8, 8);
    const HandleRemoval cut = removeHandles(mesh, 1.01 * shortest, {2}).value();
    EXPECT_EQ(cut.genusAfter, 0u) << narrow;
    ASSERT_EQ(cut.removed.size(), 1u);
    EXPECT_NEAR(cut.removed[0].length, shortest, 1e-9);
    // All are cut along the shortest loop, also where longer ones are asked for.
    for (const double upTo : {7.0, std::numeric_limits<double>::infinity()}) {
      const HandleRemoval wide = removeHandles(mesh, upTo, {2}).value();
      ASSERT_EQ(wide.removed.size(), 1u);
      EXPECT_NEAR(wide.removed[0].length, shortest, 1e-9);
      EXPECT_EQ(wide.removed[0].mayBeShorterBy, 0);
    }
    const HandleRemoval kept = removeHandles(mesh, 0.99 * shortest, {2}).value();
    EXPECT_EQ(kept.genusAfter, 1u);
    EXPECT_EQ(kept.provenLength, 0.99 * shortest);
    // Without a proof, what is left is known to be no shorter than this.
    const HandleRemoval unproven = removeHandles(mesh, 0.99 * shortest, {2, 0}).value();
    EXPECT_LT(unproven.provenLength, 0.99 * shortest);
  }
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
