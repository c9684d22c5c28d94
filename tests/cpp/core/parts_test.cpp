// Tubes, plates and body: thresholds as the paper has them, regions that add up, weak places.
#include "girth/parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "analysis/otsu.h"
#include "girth/girth_field.h"
#include "girth/shape_diameter.h"
#include "girth/vertex_areas.h"
#include "mesh/angles.h"
#include "print_shapes.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Random;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Parts partsOf(const SurfaceMesh& mesh, const std::vector<double>& girth,
              const std::vector<double>& diameter, const PartOptions& options) {
  auto parts = findParts(mesh, girth, diameter, options);
  EXPECT_TRUE(parts.ok());
  return parts.ok() ? std::move(parts).value() : Parts{};
}

TEST(VertexAreas, AddUpToTheSurfaceAndFollowVoronoi) {
  for (const test::Shape& shape :
       {test::icosphere(2), test::perturbed(test::torus(3, 1, 24, 12), 0.4, 1), test::plate(2)}) {
    const SurfaceMesh mesh = shape.mesh();
    const std::vector<double> areas = vertexAreas(mesh);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), mesh.area(), 1e-10);
    for (const double area : areas) EXPECT_GT(area, 0);
  }
  // In a flat grid of right triangles each inner vertex owns one square.
  const SurfaceMesh mesh = test::box(4, 4, 4, 4, 4, 4).mesh();
  const std::vector<double> areas = vertexAreas(mesh);
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    const auto inner = [](double x) { return x > 0.5 && x < 3.5; };
    if (!inner(p.x) || !inner(p.y)) continue;
    EXPECT_NEAR(areas[v], 1, 1e-12);
  }
}

TEST(BestDivision, LiesBetweenTwoHeapsAndNotWithinOne) {
  Random random(1);
  std::vector<WeightedValue> two, one;
  for (int i = 0; i < 400; ++i) {
    two.push_back({(i % 2 == 0 ? 0 : 10) + random(), 1});
    one.push_back({random(), 1});
  }
  const auto division = bestDivision(two, 0.8);
  ASSERT_TRUE(division.has_value());
  EXPECT_GT(*division, 1);
  EXPECT_LT(*division, 10);
  EXPECT_FALSE(bestDivision(one, 0.8).has_value());
  EXPECT_TRUE(bestDivision(one, 0.7).has_value());
  EXPECT_FALSE(bestDivision({}, 0.8).has_value());
  EXPECT_FALSE(bestDivision({{1, 1}, {1, 2}}, 0.8).has_value());
}

TEST(Parts, ArePlainThresholds) {
  const SurfaceMesh mesh = test::icosphere(3).mesh();
  Random random(2);
  std::vector<double> girth, diameter;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    girth.push_back(random() < 0.05 ? kNone : random());
    diameter.push_back(random() < 0.05 ? kNone : random());
  }
  const Parts parts = partsOf(mesh, girth, diameter, {{0.5, 0.7}, 0});
  const std::vector<double> areas = vertexAreas(mesh);
  double total = 0;
  for (const Vertex v : mesh.vertices()) {
    const bool known = !std::isnan(girth[v]) && !std::isnan(diameter[v]);
    const PartKind expected = !known                 ? PartKind::Unknown
                              : !(diameter[v] < 0.7) ? PartKind::Body
                              : girth[v] < 0.5       ? PartKind::Tube
                                                     : PartKind::Plate;
    EXPECT_EQ(parts.kinds[v], expected);
    EXPECT_EQ(parts.parts[parts.partOf[v]].kind, expected);
  }
  std::size_t vertices = 0;
  for (std::size_t p = 0; p < parts.parts.size(); ++p) {
    const Part& part = parts.parts[p];
    EXPECT_LE(part.area, parts.parts[p == 0 ? 0 : p - 1].area);
    total += part.area;
    vertices += part.vertices.size();
    const std::set<Index> members(part.vertices.begin(), part.vertices.end());
    // No neighbour of the same kind is outside.
    for (const Halfedge h : mesh.halfedges()) {
      if (members.contains(mesh.from(h)) && parts.kinds[mesh.to(h)] == part.kind) {
        EXPECT_TRUE(members.contains(mesh.to(h)));
      }
    }
    if (part.kind == PartKind::Tube) {
      for (const Vertex v : part.vertices) EXPECT_GE(girth[v], girth[part.thinnest]);
      EXPECT_NEAR(part.equivalentRadius(), part.medianGirth / (2 * kPi), 1e-15);
    }
    EXPECT_EQ(part.thinnest == kNoIndex, part.kind == PartKind::Unknown);
  }
  EXPECT_EQ(vertices, mesh.vertexCount());
  EXPECT_NEAR(total, std::accumulate(areas.begin(), areas.end(), 0.0), 1e-10);
}

TEST(Parts, OfARodAndASlab) {
  // A long rod is tube throughout, a flat box plate on its faces, at their suggested thresholds.
  const SurfaceMesh rod = test::prism(test::regularPolygon(24, 2 * kPi / 24), 30, 30).mesh();
  const SurfaceMesh slab = test::box(20, 20, 0.5, 10, 10, 1).mesh();
  for (const SurfaceMesh* mesh : {&rod, &slab}) {
    const std::vector<double> girth = girthField(*mesh).values;
    const auto diameter = shapeDiameter(*mesh);
    ASSERT_TRUE(diameter.ok());
    const PartThresholds thresholds = suggestedThresholds(*mesh, girth, diameter.value().values);
    const Parts parts = partsOf(*mesh, girth, diameter.value().values, {thresholds, 0});
    ASSERT_FALSE(parts.parts.empty());
    EXPECT_EQ(parts.parts[0].kind, mesh == &rod ? PartKind::Tube : PartKind::Plate);
    // The two faces of the slab, less their rims, are a part each.
    EXPECT_GT(parts.parts[0].area, (mesh == &rod ? 0.6 : 0.35) * mesh->area());
    if (mesh == &rod) {
      EXPECT_NEAR(parts.parts[0].equivalentRadius(), 1, 0.01);
    } else {
      EXPECT_NEAR(parts.parts[0].medianShapeDiameter, 0.52, 0.01);
    }
  }
}

TEST(Parts, WhereTheGirthIsNotDividedTheWidthOfABarDecides) {
  // One shape diameter throughout, and girths spread evenly over those of rods, bars and plates.
  const SurfaceMesh mesh = test::icosphere(3).mesh();
  std::vector<double> girth, diameter(mesh.vertexCount(), 0.5);
  for (const Vertex v : mesh.vertices()) {
    girth.push_back(1.5 * std::pow(4, static_cast<double>(v) / mesh.vertexCount()));
  }
  const PartThresholds thresholds = suggestedThresholds(mesh, girth, diameter);
  EXPECT_NEAR(thresholds.girth, kPi, 1e-12) << "2 pi times the shape diameter";
  EXPECT_GT(thresholds.shapeDiameter, 0.5);
}

TEST(Parts, SmoothingTakesSpecksAway) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  Random random(3);
  std::vector<double> girth(mesh.vertexCount(), 1), diameter(mesh.vertexCount(), 0.1);
  for (Index i = 0; i < 40; ++i) girth[random.below(mesh.vertexCount())] = 9;
  const PartThresholds thresholds{5, 1};
  const std::size_t plain = partsOf(mesh, girth, diameter, {thresholds, 0}).parts.size();
  EXPECT_GT(plain, 20u);
  EXPECT_LT(partsOf(mesh, girth, diameter, {thresholds, 3}).parts.size(), 4u);
  // As little as the vertex's own vote: nothing changes.
  EXPECT_EQ(partsOf(mesh, girth, diameter, {thresholds, 1}).parts.size(), plain);
}

TEST(Parts, BadInputIsRefused) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  const std::vector<double> field(4, 1), few(3, 1);
  EXPECT_FALSE(findParts(mesh, few, field, {}).ok());
  EXPECT_FALSE(findParts(mesh, field, few, {}).ok());
  EXPECT_FALSE(findParts(mesh, field, field, {{-1, 1}, 0}).ok());
  EXPECT_FALSE(findParts(mesh, field, field, {{1, kNone}, 0}).ok());
  EXPECT_FALSE(findParts(mesh, field, field, {{1, 1}, -1}).ok());
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(findParts(mesh, field, field, {{infinite, infinite}, 0}).ok());
  // Nothing known at all.
  const std::vector<double> unknown(4, kNone);
  EXPECT_EQ(partsOf(mesh, unknown, unknown, {}).parts[0].kind, PartKind::Unknown);
  EXPECT_EQ(suggestedThresholds(mesh, unknown, unknown).girth, 0);
}

TEST(Parts, OfBodiesThatCrossAreInsideOneAnotherOrHaveNoVolume) {
  const test::Shape ball = test::icosphere(2);
  const SurfaceMesh crossing = test::together(ball, test::moved(ball, 1, 0.5, 0.6)).mesh();
  const SurfaceMesh nested = test::together(ball, test::moved(ball, 0.5, 0, 0)).mesh();
  const SurfaceMesh flat = test::box(2, 2, 1e-12, 6, 6, 1).mesh();
  for (const SurfaceMesh* mesh : {&crossing, &nested, &flat}) {
    const std::vector<double> girth = girthField(*mesh).values;
    const auto diameter = shapeDiameter(*mesh);
    ASSERT_TRUE(diameter.ok());
    for (const double value : diameter.value().values) EXPECT_FALSE(value <= 0);
    const PartThresholds thresholds = suggestedThresholds(*mesh, girth, diameter.value().values);
    const Parts parts = partsOf(*mesh, girth, diameter.value().values, {thresholds, 0});
    EXPECT_GE(parts.parts.size(), mesh->componentCount());
  }
}

}  // namespace
}  // namespace girth
