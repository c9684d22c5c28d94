// Level curves: rings of known length, boundaries, vertices without a value, levels at vertices,
// and cuts along them.
#include "girth/level_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "girth/girth_field.h"
#include "lathe.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using test::lathe;
using test::Shape;

std::vector<double> heights(const SurfaceMesh& mesh) {
  std::vector<double> values;
  for (const Vertex v : mesh.vertices()) values.push_back(mesh.position(v).z);
  return values;
}

bool isClosed(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  return norm(positionOf(mesh, curve.front()) - positionOf(mesh, curve.back())) == 0;
}

TEST(LevelCurves, areRingsAtAHeight) {
  const SurfaceMesh mesh = lathe({{0, 1}, {2, 3}, {5, 1}}, 7).mesh();
  for (const double level : {0.3, 1.0, 4.9}) {
    const auto curves = levelCurves(mesh, heights(mesh), level).value();
    ASSERT_EQ(curves.size(), 1u);
    ASSERT_TRUE(isClosed(mesh, curves[0]));
    EXPECT_EQ(curves[0].size(), 15u);  // seven edges and seven diagonals
    double turned = 0;
    for (std::size_t i = 0; i + 1 < curves[0].size(); ++i) {
      const Vec3 a = positionOf(mesh, curves[0][i]), b = positionOf(mesh, curves[0][i + 1]);
      EXPECT_NEAR(a.z, level, 1e-12);
      turned += a.x * b.y - a.y * b.x;
    }
    // Lower values lie on the left, seen from outside: clockwise seen from above.
    EXPECT_LT(turned, 0);
    const auto cut = cutSurface(mesh, curves).value();
    ASSERT_EQ(cut.mesh.componentCount(), 2u);
    for (const Vertex v : cut.mesh.vertices()) {
      const double z = cut.mesh.position(v).z;
      EXPECT_EQ(cut.mesh.isBoundary(v), std::fabs(z - level) < 1e-9);
    }
    EXPECT_NEAR(cut.mesh.area(), mesh.area(), 1e-9 * mesh.area());
  }
  // A level at vertices cuts along their ring; one beyond all values is nowhere.
  const auto through = levelCurves(mesh, heights(mesh), 2).value();
  const auto cut = cutSurface(mesh, through).value();
  EXPECT_EQ(cut.mesh.componentCount(), 2u);
  EXPECT_EQ(cut.mesh.faceCount(), mesh.faceCount());
  EXPECT_TRUE(levelCurves(mesh, heights(mesh), -1).value().empty());
  EXPECT_TRUE(levelCurves(mesh, heights(mesh), 6).value().empty());
}

TEST(LevelCurves, endAtTheBoundaryAndBesideUnknownValues) {
  // A square sheet, cut from side to side.
  Shape sheet;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) sheet.add(x, y, 0);
  }
  for (Index y = 0; y < 3; ++y) {
    for (Index x = 0; x < 3; ++x) {
      const Index a = 4 * y + x;
      sheet.face(a, a + 1, a + 5);
      sheet.face(a, a + 5, a + 4);
    }
  }
  const SurfaceMesh mesh = sheet.mesh(OpenEdges::Boundary);
  std::vector<double> values;
  for (const Vertex v : mesh.vertices()) values.push_back(mesh.position(v).x);
  const auto across = levelCurves(mesh, values, 1.4).value();
  ASSERT_EQ(across.size(), 1u);
  EXPECT_FALSE(isClosed(mesh, across[0]));
  EXPECT_EQ(cutSurface(mesh, across).value().mesh.componentCount(), 2u);
  values[5] = std::nan("");
  const auto broken = levelCurves(mesh, values, 1.4).value();
  for (const SurfaceCurve& curve : broken) {
    EXPECT_FALSE(isClosed(mesh, curve));
    for (const SurfacePoint& point : curve) EXPECT_NEAR(positionOf(mesh, point).x, 1.4, 1e-12);
  }
  EXPECT_EQ(cutSurface(mesh, broken).value().mesh.componentCount(), 1u);
}

TEST(LevelCurves, ofTheGirthDivideBodies) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const SurfaceMesh mesh =
        test::perturbed(test::subdivided(lathe({{0, 1}, {2, 2}, {5, 1}, {8, 2}, {9, 1}}, 6)), 0.1,
                        seed)
            .mesh();
    const std::vector<double> girth = girthField(mesh).values;
    const double least = *std::min_element(girth.begin(), girth.end());
    const double greatest = *std::max_element(girth.begin(), girth.end());
    for (const double share : {0.1, 0.3, 0.5, 0.9}) {
      const double level = least + share * (greatest - least);
      const auto curves = levelCurves(mesh, girth, level).value();
      ASSERT_FALSE(curves.empty());
      const CutSurface cut = cutSurface(mesh, curves).value();
      // On either side of every cut: all vertices of a part are on one side of the level.
      std::vector<int> sides(cut.mesh.componentCount(), 0);
      for (const Vertex v : cut.mesh.vertices()) {
        const SurfacePoint& point = cut.points[v];
        if (point.kind != SurfacePoint::Kind::AtVertex) continue;
        int& side = sides[cut.mesh.componentOf(v)];
        const int own = girth[point.element] < level ? -1 : 1;
        EXPECT_TRUE(side == 0 || side == own);
        side = own;
      }
      EXPECT_NEAR(cut.mesh.area(), mesh.area(), 1e-9 * mesh.area());
    }
  }
}

TEST(LevelCurves, badInput) {
  const SurfaceMesh mesh = test::box(1, 2, 3, 1, 1, 1).mesh();
  const std::vector<double> values = heights(mesh);
  EXPECT_EQ(levelCurves(mesh, std::vector<double>(3), 1).error().code, ErrorCode::Usage);
  for (const double level : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(levelCurves(mesh, values, level).error().code, ErrorCode::InvalidOption);
  }
  std::vector<double> extremes = values;
  for (double& value : extremes) value = value > 1 ? 1e308 : -1e308;
  for (const SurfaceCurve& curve : levelCurves(mesh, extremes, 0).value()) {
    for (const SurfacePoint& point : curve) EXPECT_NEAR(point.weights[1], 0.5, 1e-12);
  }
  EXPECT_TRUE(
      levelCurves(mesh, std::vector<double>(values.size(), std::nan("")), 1).value().empty());
}

}  // namespace
}  // namespace girth
