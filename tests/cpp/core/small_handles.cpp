#include "small_handles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "girth/remove_handles.h"
#include "isosurface.h"
#include "mesh/crossing_faces.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth::test {
namespace {

/// Radii of the small rings.
constexpr double kRing = 0.22, kTube = 0.09;

/// A solid torus of radii 1 and 0.45, on which small rings stand, and in which small rings are
/// missing, each half-way in the surface: arches and worm holes. All of them lie apart.
SurfaceMesh withSmallHandles(std::uint64_t seed, Index arches, Index holes) {
  Random random(seed);
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
  return isosurface(
             [&](const Vec3& p) {
               double value = torusDistance(p, {0, 0, 0}, {0, 0, 1}, 1, 0.45);
               for (Index i = 0; i < count; ++i) {
                 const double ring = torusDistance(p, centres[i], axes[i], kRing, kTube);
                 value = i < arches ? std::min(value, ring) : std::max(value, -ring);
               }
               return value;
             },
             1.75, 46)
      .mesh();
}

/// Shorter than the true loops, longer than those of the small rings.
constexpr double kShort = 1.2;

}  // namespace

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

void expectSmallHandlesRemoved(std::uint64_t seed) {
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
  EXPECT_EQ(made.crossingFaces, 0u);
  const std::vector<Face> faces(made.mesh.faces().begin(), made.mesh.faces().end());
  EXPECT_TRUE(crossingFaces(made.mesh, faces).empty());
  EXPECT_EQ(made.mesh.componentCount(), 1u);
  EXPECT_EQ(made.mesh.boundaryCount(0), 0u);
  // Each dropped handle takes away half a ring, or the thin bar over a missing one; each filled
  // tunnel brings half a ring back.
  int dropped = 0, filled = 0;
  for (std::size_t i = 0; i < made.removed.size(); ++i) {
    if (!(made.droppedAreas[i] > 0)) continue;
    ++(made.removed[i].kind == HandleKind::Handle ? dropped : filled);
  }
  const double halfRing = M_PI * M_PI * kRing * kTube * kTube, slack = 1e-3 * volumeOf(mesh);
  EXPECT_GT(volumeOf(made.mesh), volumeOf(mesh) - dropped * halfRing - slack);
  EXPECT_LT(volumeOf(made.mesh), volumeOf(mesh) + filled * halfRing + slack);
  // The true handle is what it was.
  const Handles left = findHandles(made.mesh, {4, 0}).value();
  ASSERT_EQ(left.handles.size(), 2u);
  for (const Handle& handle : left.handles) EXPECT_GT(handle.length, 2);
  // Nothing more to do.
  const HandleRemoval again = removeHandles(made.mesh, kShort, {4}).value();
  EXPECT_TRUE(again.removed.empty());
  EXPECT_EQ(again.mesh.faceCount(), made.mesh.faceCount());
}

}  // namespace girth::test
