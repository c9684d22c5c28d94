// Segments: bodies that fall apart at their necks, shares of kinds that add up, and tips where they
// are.
#include "girth/segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "girth/girth_field.h"
#include "girth/level_curves.h"
#include "lathe.h"
#include "shapes.h"

namespace girth {
namespace {

using test::lathe;
using test::Ring;

/// A bottle: a wide body, a waist at z = 3, and a long thin tube.
test::Shape bottle() {
  return lathe({{0, 2}, {1, 2}, {2, 2}, {3, 0.5}, {4, 0.8}, {5, 0.8}, {6, 0.8}, {7, 0.8}}, 12);
}

Tip tipAt(Vertex apex) {
  Tip tip;
  tip.apex = apex;
  return tip;
}

/// The area of each kind, where every vertex has a third of its faces.
std::array<double, 4> areasOf(const SurfaceMesh& mesh, const std::vector<PartKind>& kinds) {
  std::array<double, 4> areas{};
  for (const Face f : mesh.faces()) {
    for (const Vertex v : mesh.faceVertices(f)) {
      areas[static_cast<std::size_t>(kinds[v])] += mesh.area(f) / 3;
    }
  }
  return areas;
}

TEST(Segments, aBottleIsABodyAndATube) {
  const SurfaceMesh mesh = bottle().mesh();
  const auto necks = findNecks(mesh, girthField(mesh).values, {0.5}).value().necks;
  ASSERT_EQ(necks.size(), 1u);
  EXPECT_NEAR(necks[0].length, test::polygonLength(0.5, 12), 1e-9);
  const CutAtNecks at = cutAtNecks(mesh, necks).value();
  EXPECT_TRUE(at.crossing.empty());
  const auto parts = componentsOf(at.cut.mesh);
  ASSERT_EQ(parts.size(), 2u);
  // By hand: the body to the waist, the tube beyond it, a plate in its lid.
  std::vector<PartKind> kinds;
  for (const Vertex v : mesh.vertices()) {
    const double z = mesh.position(v).z;
    kinds.push_back(z <= 3 ? PartKind::Body : z < 7 ? PartKind::Tube : PartKind::Plate);
  }
  const auto low = static_cast<Index>(mesh.vertexCount() - 2), high = low + 1;
  const std::vector<Tip> tips{tipAt(Vertex(high)), tipAt(Vertex(low)), tipAt(Vertex(7 * 12))};
  const auto segments = segmentsOf(mesh, at.cut, parts, kinds, tips);
  ASSERT_EQ(segments.size(), 2u);
  const std::size_t body = segments[0].area > segments[1].area ? 0 : 1;
  EXPECT_EQ(segments[body].kind(), PartKind::Body);
  EXPECT_EQ(segments[1 - body].kind(), PartKind::Tube);
  EXPECT_EQ(segments[body].tips, std::vector<Index>{1});
  EXPECT_EQ(segments[1 - body].tips, (std::vector<Index>{0, 2}));
  // The lower one is a frustum on a prism and its lid; all of it body.
  const double slant = std::hypot(1.0, 1.5 * std::cos(M_PI / 12));
  const double half = std::sin(M_PI / 12);  // half of a side, at radius 1
  const double area =
      12 * (2 * half * 2 * 2 + (2 + 0.5) * half * slant) + 12 * 2 * 2 * half * std::cos(M_PI / 12);
  EXPECT_NEAR(segments[body].area, area, 1e-9);
  EXPECT_NEAR(segments[body].kindAreas[0], area, 1e-9);
  // Beyond the waist faces reach from body to tube: a vertex has a third of each of them.
  EXPECT_GT(segments[1 - body].kindAreas[0], 0);
  const std::array<double, 4> whole = areasOf(mesh, kinds);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(segments[0].kindAreas[k] + segments[1].kindAreas[k], whole[k], 1e-9);
  }
}

TEST(Segments, sharesAddUpWhereFacesAreCut) {
  // Loops across the faces of an uneven surface, with kinds at random.
  const SurfaceMesh mesh = test::perturbed(bottle(), 0.2, 3).mesh();
  auto necks = findNecks(mesh, girthField(mesh).values).value().necks;
  ASSERT_FALSE(necks.empty());
  std::vector<PartKind> kinds;
  test::Random random(5);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    kinds.push_back(static_cast<PartKind>(std::min(3, static_cast<int>(4 * random()))));
  }
  const CutAtNecks at = cutAtNecks(mesh, necks).value();
  const auto parts = componentsOf(at.cut.mesh);
  EXPECT_GE(parts.size(), 2u);
  const auto segments = segmentsOf(mesh, at.cut, parts, kinds, {});
  const std::array<double, 4> whole = areasOf(mesh, kinds);
  std::array<double, 4> sums{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_NEAR(segments[i].area, parts[i].mesh.area(), 1e-12);
    double area = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      sums[k] += segments[i].kindAreas[k];
      area += segments[i].kindAreas[k];
    }
    EXPECT_NEAR(area, segments[i].area, 1e-9);
  }
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(sums[k], whole[k], 1e-9);
}

TEST(Segments, ofNecksThatCrossTheFirst) {
  // Sections of a box, given as necks: the second crosses the first, and the third does not.
  const SurfaceMesh mesh = test::box(2, 2, 2, 2, 2, 2).mesh();
  const auto section = [&](double Vec3::*axis, double level) {
    std::vector<double> values;
    for (const Vertex v : mesh.vertices()) values.push_back(mesh.position(v).*axis);
    const auto curves = levelCurves(mesh, values, level);
    EXPECT_TRUE(curves.ok());
    Neck neck;
    neck.points = curves.value().at(0);
    return neck;
  };
  const std::vector<Neck> necks{section(&Vec3::x, 0.3), section(&Vec3::y, 0.4),
                                section(&Vec3::x, 1.6)};
  const auto at = cutAtNecks(mesh, necks);
  ASSERT_TRUE(at.ok()) << at.error().text();
  EXPECT_EQ(at.value().crossing, std::vector<Index>{1});
  // Many necks: a plain look in order leaves out each that crosses one before it.
  std::vector<Neck> many;
  for (const double level : {0.3, 0.7, 1.2, 1.6}) {
    many.push_back(section(&Vec3::x, level));
    many.push_back(section(&Vec3::y, level + 0.13));
  }
  many.push_back(section(&Vec3::x, 1.9));
  EXPECT_EQ(cutAtNecks(mesh, many).value().crossing, (std::vector<Index>{1, 3, 5, 7}));
  const auto parts = componentsOf(at.value().cut.mesh);
  ASSERT_EQ(parts.size(), 3u);
  const std::vector<PartKind> kinds(mesh.vertexCount(), PartKind::Plate);
  const auto segments = segmentsOf(mesh, at.value().cut, parts, kinds, {});
  std::vector<double> areas;
  for (const Segment& segment : segments) {
    EXPECT_EQ(segment.kind(), PartKind::Plate);
    areas.push_back(segment.area);
  }
  std::sort(areas.begin(), areas.end());
  // Round the four long sides, and one end.
  EXPECT_NEAR(areas[0], 4 + 8 * 0.3, 1e-9);
  EXPECT_NEAR(areas[1], 4 + 8 * 0.4, 1e-9);
  EXPECT_NEAR(areas[2], 8 * 1.3, 1e-9);
}

TEST(Segments, aTipOnACutBelongsToTheFirstOfItsParts) {
  const SurfaceMesh mesh = bottle().mesh();
  const auto necks = findNecks(mesh, girthField(mesh).values, {0.5}).value().necks;
  ASSERT_EQ(necks.size(), 1u);
  const CutAtNecks at = cutAtNecks(mesh, necks).value();
  const auto parts = componentsOf(at.cut.mesh);
  const std::vector<PartKind> kinds(mesh.vertexCount(), PartKind::Body);
  const std::vector<Tip> tips{tipAt(necks[0].vertices[0])};
  const auto segments = segmentsOf(mesh, at.cut, parts, kinds, tips);
  EXPECT_EQ(segments[0].tips, std::vector<Index>{0});
  EXPECT_TRUE(segments[1].tips.empty());
}

TEST(Segments, ofNecksThatTouch) {
  // Round two faces of a box that have a vertex in common, given as necks.
  const SurfaceMesh mesh = test::box(2, 2, 2, 2, 2, 2).mesh();
  const Halfedge first = mesh.outgoing(Vertex(0));
  const Halfedge second = mesh.twin(SurfaceMesh::previous(first));
  std::vector<Neck> necks;
  for (const Halfedge h : {first, second}) {
    Neck neck;
    for (const Vertex v : mesh.faceVertices(SurfaceMesh::faceOf(h))) {
      neck.points.push_back(SurfacePoint::atVertex(v));
    }
    neck.points.push_back(neck.points.front());
    necks.push_back(neck);
  }
  const CutAtNecks at = cutAtNecks(mesh, necks).value();
  EXPECT_TRUE(at.crossing.empty());
  EXPECT_EQ(at.cut.mesh.componentCount(), 3u);
  const std::vector<PartKind> kinds(mesh.vertexCount(), PartKind::Body);
  double area = 0;
  for (const Segment& segment : segmentsOf(mesh, at.cut, componentsOf(at.cut.mesh), kinds, {})) {
    area += segment.area;
  }
  EXPECT_NEAR(area, 24, 1e-9);
}

TEST(Segments, withoutNecksThereIsOne) {
  const SurfaceMesh mesh = test::icosphere(1).mesh();
  const CutAtNecks at = cutAtNecks(mesh, {}).value();
  const auto parts = componentsOf(at.cut.mesh);
  ASSERT_EQ(parts.size(), 1u);
  const std::vector<PartKind> kinds(mesh.vertexCount(), PartKind::Unknown);
  EXPECT_EQ(segmentsOf(mesh, at.cut, parts, kinds, {})[0].kind(), PartKind::Unknown);
  const std::atomic<bool> cancel{true};
  const auto cancelled = cutAtNecks(mesh, {}, {1, &cancel, {}});
  ASSERT_FALSE(cancelled.ok());
  EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth
