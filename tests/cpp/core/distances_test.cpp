// Distances between pairs of points, where they are known.

#include "girth/distances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh/vector.h"
#include "print_shapes.h"
#include "shapes.h"

namespace girth {
namespace {

/// Two boxes of 2 by 3 by 4, one of them 10 away.
SurfaceMesh twoBoxes() {
  return test::blocks({0, 2, 10, 12}, {0, 3}, {0, 4}, [](int i, int, int) { return i != 1; })
      .mesh();
}

SurfacePoint corner(const SurfaceMesh& mesh, const Vec3& place) {
  for (const Vertex v : mesh.vertices()) {
    if (norm(mesh.position(v) - place) == 0) return SurfacePoint::atVertex(v);
  }
  ADD_FAILURE() << "no vertex there";
  return {};
}

TEST(Distances, OfABoxAreThoseOfItsUnfolding) {
  const SurfaceMesh mesh = twoBoxes();
  const SurfacePoint low = corner(mesh, {0, 0, 0});
  const SurfacePoint other = corner(mesh, {12, 3, 4});
  DistancesOptions wanted{{{low, corner(mesh, {2, 3, 4})},
                           {low, corner(mesh, {2, 0, 0})},
                           {low, other},
                           {other, other}},
                          true};
  const auto found = findDistances(mesh, wanted);
  ASSERT_TRUE(found);
  const std::vector<Distance>& all = found.value().distances;
  ASSERT_EQ(all.size(), 4u);
  // The shortest way over two sides of a box: its longest edge beside the sum of the others.
  EXPECT_NEAR(all[0].length, std::sqrt(41.0), 1e-12);
  EXPECT_NEAR(all[0].straight, std::sqrt(29.0), 1e-12);
  double length = 0;
  for (std::size_t i = 1; i < all[0].points.size(); ++i) {
    length += norm(positionOf(mesh, all[0].points[i]) - positionOf(mesh, all[0].points[i - 1]));
  }
  EXPECT_NEAR(length, all[0].length, 1e-12);
  EXPECT_NEAR(all[1].length, 2, 1e-12);
  EXPECT_TRUE(std::isinf(all[2].length));
  EXPECT_TRUE(all[2].points.empty());
  EXPECT_EQ(all[3].length, 0);
  wanted.paths = false;
  for (const Distance& one : findDistances(mesh, wanted).value().distances) {
    EXPECT_TRUE(one.points.empty());
  }
}

TEST(Distances, AreTheSameForAnyNumberOfThreads) {
  const SurfaceMesh mesh = twoBoxes();
  DistancesOptions wanted;
  for (const Vertex v : mesh.vertices()) {
    wanted.pairs.push_back({SurfacePoint::atVertex(v), corner(mesh, {0, 0, 0})});
    wanted.pairs.push_back({SurfacePoint::inFace(Face(v % mesh.faceCount()), {0.2, 0.3, 0.5}),
                            SurfacePoint::atVertex(v)});
  }
  const auto one = findDistances(mesh, wanted, {1, nullptr, {}});
  const auto four = findDistances(mesh, wanted, {4, nullptr, {}});
  ASSERT_TRUE(one && four);
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i) {
    EXPECT_EQ(one.value().distances[i].length, four.value().distances[i].length);
  }
}

TEST(Distances, RefusePointsThatAreNoneOfTheSurface) {
  const SurfaceMesh mesh = twoBoxes();
  const SurfacePoint there = SurfacePoint::atVertex(Vertex(0));
  const auto beyond = findDistances(
      mesh, {{{there, there}, {there, SurfacePoint::atVertex(Vertex(1'000'000))}}, false});
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, ErrorCode::VertexOutOfRange);
  const auto unweighted =
      findDistances(mesh, {{{SurfacePoint::inFace(Face(0), {1, 1, 1}), there}}, false});
  ASSERT_FALSE(unweighted);
  EXPECT_EQ(unweighted.error().code, ErrorCode::InvalidPoint);
}

}  // namespace
}  // namespace girth
