// A loop whose base moves: as long as the loop at its base, convex on the way, never less than the
// girth.
#include "loops/tight/moved_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "girth/girth_solver.h"
#include "loops/cut/faces_of_points.h"
#include "mesh/vector.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth {
namespace {

constexpr int kPieces = 8;

using Side = loops::MovedLoop::Side;

/// Counts of ways from the bases of loops to corners of their faces: tried, followed along the way,
/// and with an end at which the loop was not less than the girth.
struct Counts {
  int tried{0}, followed{0}, noLess{0};
};
Counts expectConvex(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& bases) {
  const geodesic::Unfolding unfolding(mesh);
  GirthSolver solver(mesh);
  Counts counts;
  for (const SurfacePoint& base : bases) {
    const auto loop = solver.loop(base);
    EXPECT_TRUE(loop.ok());
    if (!loop || loop.value().kind != LoopKind::Loop) continue;
    const loops::MovedLoop moved(unfolding, loop.value().points);
    const Face face = loops::faceAt(mesh, base);
    const double length = loop.value().length, tolerance = 1e-9 * length;
    for (const Vertex to : mesh.faceVertices(face)) {
      const double way = norm(mesh.position(to) - positionOf(mesh, base));
      if (way == 0) continue;
      const SurfacePoint end = SurfacePoint::atVertex(to);
      double shortest = std::numeric_limits<double>::infinity();
      for (const Side side : {Side::Left, Side::Right}) {
        std::vector<double> lengths;
        for (int i = 0; i <= kPieces; ++i) {
          lengths.push_back(moved.lengthTowards(face, end, static_cast<double>(i) / kPieces, side));
        }
        if (!std::isfinite(lengths[0])) continue;
        EXPECT_NEAR(lengths[0], length, tolerance);
        for (std::size_t i = 1; i < kPieces; ++i) {
          EXPECT_LE(2 * lengths[i], lengths[i - 1] + lengths[i + 1] + tolerance);
        }
        // Both ends of the loop move as far.
        EXPECT_LE(std::fabs(lengths[kPieces] - length), 2 * way + tolerance);
        shortest = std::min(shortest, lengths[kPieces]);
      }
      EXPECT_EQ(moved.lengthAt(face, end), shortest);
      const auto there = solver.value(to);
      EXPECT_TRUE(there.ok());
      ++counts.tried;
      if (std::isfinite(shortest)) ++counts.followed;
      if (shortest >= there.value().length - tolerance) ++counts.noLess;
    }
  }
  return counts;
}

/// All vertices, points of sides and points of faces.
std::vector<SurfacePoint> someBases(const SurfaceMesh& mesh) {
  std::vector<SurfacePoint> bases;
  for (const Vertex v : mesh.vertices()) bases.push_back(SurfacePoint::atVertex(v));
  for (const Face f : mesh.faces()) {
    bases.push_back(SurfacePoint::onHalfedge(SurfaceMesh::side(f, f % 3), 0.3));
    bases.push_back(SurfacePoint::inFace(f, {0.5, 0.3, 0.2}));
  }
  return bases;
}

TEST(MovedLoop, isConvexAndNoLessThanTheGirthOnATorus) {
  const SurfaceMesh mesh = test::perturbed(test::torus(3, 1, 16, 8), 0.05, 1).mesh();
  const std::vector<SurfacePoint> bases = someBases(mesh);
  const Counts counts = expectConvex(mesh, bases);
  // The girth has no jumps here, and every loop is followed.
  EXPECT_GT(counts.tried, static_cast<int>(2 * bases.size()));
  EXPECT_EQ(counts.followed, counts.tried);
  EXPECT_EQ(counts.noLess, counts.tried);
}

TEST(MovedLoop, isConvexOnRandomSurfaces) {
  Counts all;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const test::RandomMesh random = test::randomMesh(seed);
    const SurfaceMesh mesh = random.shape.mesh(OpenEdges::Boundary);
    const Counts counts = expectConvex(mesh, someBases(mesh));
    all.tried += counts.tried;
    all.followed += counts.followed;
    all.noLess += counts.noLess;
  }
  EXPECT_GT(all.tried, 1000);
  // But at boundaries, and where the girth jumps.
  EXPECT_GT(all.followed, all.tried * 9 / 10);
  EXPECT_GT(all.noLess, all.tried * 9 / 10);
}

TEST(MovedLoop, roundABoxItKeepsItsLength) {
  // Parallel loops round a square prism are as long.
  const SurfaceMesh mesh = test::box(1, 1, 6, 1, 1, 6).mesh();
  GirthSolver solver(mesh);
  const geodesic::Unfolding unfolding(mesh);
  for (const Vertex v : mesh.vertices()) {
    if (std::fabs(mesh.position(v).z - 3) > 0.1) continue;
    const auto loop = solver.loop(v);
    ASSERT_TRUE(loop.ok());
    EXPECT_NEAR(loop.value().length, 4, 1e-9);
    const loops::MovedLoop moved(unfolding, loop.value().points);
    const Halfedge first = mesh.outgoing(v);
    Halfedge h = first;
    do {
      // Away from the loop, to the next ring.
      if (std::fabs(mesh.position(mesh.to(h)).z - 3) > 0.1) {
        const SurfacePoint point = SurfacePoint::atVertex(mesh.to(h));
        EXPECT_NEAR(moved.lengthAt(SurfaceMesh::faceOf(h), point), 4, 1e-9);
      }
      h = mesh.twin(SurfaceMesh::previous(h));
    } while (h != first);
  }
}

TEST(MovedLoop, withoutALoopNothingIsKnown) {
  const SurfaceMesh mesh = test::box(1, 1, 6, 1, 1, 6).mesh();
  const geodesic::Unfolding unfolding(mesh);
  const loops::MovedLoop none(unfolding, {});
  EXPECT_EQ(none.lengthAt(Face(0), SurfacePoint::inFace(Face(0), {1, 0, 0})),
            std::numeric_limits<double>::infinity());
  // Nor in a face that the base does not lie in.
  const auto loop = girthLoop(mesh, Vertex(0));
  ASSERT_TRUE(loop.ok());
  const loops::MovedLoop moved(unfolding, loop.value().points);
  for (const Face f : mesh.faces()) {
    const auto vertices = mesh.faceVertices(f);
    const bool isThere = std::find(vertices.begin(), vertices.end(), Vertex(0)) != vertices.end();
    if (isThere) continue;
    EXPECT_EQ(moved.lengthAt(f, SurfacePoint::inFace(f, {0.2, 0.3, 0.5})),
              std::numeric_limits<double>::infinity());
  }
}

}  // namespace
}  // namespace girth
