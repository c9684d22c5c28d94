// Orientations that rounding would decide wrongly, and triangles that meet or just do not.
#include "mesh/crossing_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "mesh/orientation.h"
#include "shapes.h"

namespace girth {
namespace {

__extension__ using Wide = __int128;

/// The orientation from whole numbers, without rounding.
int wholeOrientation(const std::array<std::array<std::int64_t, 3>, 4>& p) {
  std::array<std::array<Wide, 3>, 3> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) m[i][k] = Wide{p[i][k]} - p[3][k];
  }
  const Wide sum = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                   m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                   m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

TEST(Orientation, isThatOfWholeNumbersHoweverFlat) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<std::int64_t> large(-(1 << 30), 1 << 30), small(-2, 2);
  int flat = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::array<std::array<std::int64_t, 3>, 4> p;
    std::array<Vec3, 4> q;
    for (std::size_t k = 0; k < 3; ++k) {
      // The last point lies within two units of the plane of the others.
      for (std::size_t n = 0; n < 3; ++n) p[n][k] = large(random) / 4;
      p[3][k] = p[0][k] + p[1][k] - p[2][k] + (i % 3 == 0 ? 0 : small(random));
    }
    for (std::size_t n = 0; n < 4; ++n) {
      q[n] = {static_cast<double>(p[n][0]), static_cast<double>(p[n][1]),
              static_cast<double>(p[n][2])};
    }
    const int expected = wholeOrientation(p);
    flat += expected == 0 ? 1 : 0;
    ASSERT_EQ(orientation(q[0], q[1], q[2], q[3]), expected) << i;
    ASSERT_EQ(orientation(q[1], q[0], q[2], q[3]), -expected) << i;
  }
  EXPECT_GT(flat, 6000);
}

TEST(Orientation, ofPointsThatDifferByTheLastBit) {
  const Vec3 a{0.1, 0.1, 0.3}, b{0.7, 0.1, 0.3}, c{0.1, 0.7, 0.3};
  const double up = std::nextafter(0.3, 1), down = std::nextafter(0.3, 0);
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.2, 0.3}), 0);
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.2, up}), -1);
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.2, down}), 1);
}

TEST(CrossingFaces, trianglesMeetOrJustDoNot) {
  const Triangle3 flat{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  const double above = std::nextafter(0.0, 1) * 1e300;
  const auto meets = [&](const Triangle3& other, std::size_t shared = 0) {
    const bool is = trianglesMeet(flat, other, shared);
    EXPECT_EQ(trianglesMeet(other, flat, shared), is);
    return is;
  };
  EXPECT_TRUE(meets({{{0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0}}}));
  EXPECT_FALSE(meets({{{0.5, 0.5, above}, {0.5, 0.5, 1}, {3, 3, 1}}}));
  EXPECT_TRUE(meets({{{0.5, 0.5, 0}, {0.5, 0.5, 1}, {3, 3, 1}}}));  // touches
  EXPECT_FALSE(meets({{{3, 3, -1}, {3, 3, 1}, {4, 4, 0}}}));
  // In one plane: across, inside, and beside.
  EXPECT_TRUE(meets({{{-1, 0.5, 0}, {3, 0.5, 0}, {3, 0.6, 0}}}));
  EXPECT_TRUE(meets({{{0.2, 0.2, 0}, {0.4, 0.2, 0}, {0.2, 0.4, 0}}}));
  EXPECT_FALSE(meets({{{2, 2, 0}, {3, 2, 0}, {2, 3, 0}}}));
  // With a corner in common: fans and folds.
  EXPECT_FALSE(meets({{{0, 0, 0}, {-1, 0, 1}, {0, -1, 1}}}, 1));
  EXPECT_TRUE(meets({{{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}}, 1));
  EXPECT_TRUE(meets({{{0, 0, 0}, {0.5, 0.5, 0}, {0.2, 0.5, 0}}}, 1));
  // With an edge in common: only one that lies on the other meets it elsewhere.
  EXPECT_FALSE(meets({{{0, 0, 0}, {2, 0, 0}, {0, 1, 1}}}, 2));
  EXPECT_FALSE(meets({{{0, 0, 0}, {2, 0, 0}, {0, -1, 0}}}, 2));
  EXPECT_TRUE(meets({{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}}, 2));
}

TEST(CrossingFaces, areThoseOfTwoBoxesThatCross) {
  const auto boxes = [](double shift) {
    test::Shape shape = test::box(1, 1, 1, 2, 2, 2);
    const test::Shape other = test::box(1, 1, 1, 2, 2, 2);
    const Index before = shape.vertexCount();
    for (Index v = 0; v < before; ++v) {
      shape.add(other.positions[3 * v] + shift, other.positions[3 * v + 1] + 0.17,
                other.positions[3 * v + 2] + 0.21);
    }
    for (const Index v : other.triangles) shape.triangles.push_back(before + v);
    return shape.mesh();
  };
  const auto crossings = [](const SurfaceMesh& mesh) {
    std::vector<Face> faces;
    for (const Face f : mesh.faces()) faces.push_back(f);
    return crossingFaces(mesh, faces);
  };
  EXPECT_TRUE(crossings(boxes(1.5)).empty());
  const auto pairs = crossings(boxes(0.6));
  EXPECT_FALSE(pairs.empty());
  for (const auto& [f, g] : pairs) {
    EXPECT_LT(f, 48u);
    EXPECT_GE(g, 48u);
  }
  // Asked for one face, those with it.
  const std::array one{pairs.front().first};
  for (const auto& [f, g] : crossingFaces(boxes(0.6), one)) {
    EXPECT_EQ(f, pairs.front().first);
    EXPECT_GE(g, 48u);
  }
}

}  // namespace
}  // namespace girth
