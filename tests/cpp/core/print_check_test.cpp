// The print check: thirty shapes whose walls and gaps are known, tubes, and what is refused.
#include "girth/print_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "girth/girth_field.h"
#include "girth/prepare_surface.h"
#include "mesh/angles.h"
#include "print_shapes.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Shape;

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// With the fields that the limits need.
PrintCheck check(const SurfaceMesh& mesh, const PrintLimits& limits,
                 const ExecutionContext& context = {}) {
  std::vector<double> girth, thickness;
  if (limits.tubeDiameter > 0) girth = girthField(mesh).values;
  if (limits.wallThickness > 0) thickness = medialThickness(mesh).value().values;
  auto found = checkPrint(mesh, {girth, thickness}, limits, {}, context);
  EXPECT_TRUE(found.ok()) << (found.ok() ? "" : found.error().message);
  if (!found.ok()) return {};
  EXPECT_TRUE(found.value().complete);
  return std::move(found).value();
}

PrintLimits walls(double least) { return {0, least, 0}; }
PrintLimits gaps(double least) { return {0, 0, least}; }

TEST(PrintCheck, OfShapesWithKnownWallsPassesUpToTheTruthAndNoFurther) {
  const std::vector<test::PrintShape> shapes = test::printShapes();
  EXPECT_GE(shapes.size(), 30u);
  for (const test::PrintShape& s : shapes) {
    const SurfaceMesh mesh = s.shape.mesh();
    // Just above the truth it never passes; edges of 60° or more are creases.
    const PrintCheck above = check(mesh, walls(s.wall * 1.0001 + 1e-4));
    EXPECT_FALSE(above.places.empty() && (s.wall > 0 || above.creases.empty())) << s.name;
    const double reads = s.reads > 0 ? s.reads : s.wall;
    if (reads == 0) continue;  // a sharp edge: nothing is thin enough to pass
    const PrintCheck passes = check(mesh, walls(reads * (1 - s.tolerance)));
    EXPECT_TRUE(passes.places.empty())
        << s.name << " reads " << (passes.places.empty() ? 0 : passes.places[0].least);
    const PrintCheck fails = check(mesh, walls(1.01 * s.wall));
    ASSERT_FALSE(fails.places.empty()) << s.name;
    EXPECT_LE(fails.places[0].least, s.wall * (1 + 1e-9)) << s.name;
    EXPECT_GE(fails.places[0].least, reads * (1 - s.tolerance)) << s.name;
    EXPECT_GE(fails.passingScale, 1.01 * (1 - 1e-6)) << s.name;
    EXPECT_LE(fails.passingScale, 1.01 * s.wall / (reads * (1 - s.tolerance)) + 1e-6) << s.name;
    EXPECT_GT(fails.failingShare, 0) << s.name;
    EXPECT_LE(fails.failingShare, 1) << s.name;
  }
}

TEST(PrintCheck, OfShapesWithKnownGaps) {
  for (const test::PrintShape& s : test::printShapes()) {
    const SurfaceMesh mesh = s.shape.mesh();
    if (std::isinf(s.gap)) {
      const PrintCheck none = check(mesh, gaps(0.05));
      if (s.name != "two cubes that touch") {
        EXPECT_TRUE(none.places.empty())
            << s.name << " reads " << (none.places.empty() ? 0 : none.places[0].least);
      }
      continue;
    }
    EXPECT_TRUE(check(mesh, gaps(s.gap * (1 - 1e-3))).places.empty()) << s.name;
    const PrintCheck fails = check(mesh, gaps(1.001 * s.gap));
    ASSERT_FALSE(fails.places.empty()) << s.name;
    EXPECT_EQ(fails.places[0].kind, WeakKind::Gap);
    EXPECT_NEAR(fails.places[0].least, s.gap, 1e-3 * s.gap) << s.name;
  }
}

TEST(PrintCheck, NamesThePlaceAndWhatLiesAcross) {
  // The thinnest place of crossing grooves is where there is no vertex.
  for (const test::PrintShape& s : test::printShapes()) {
    if (s.name != "grooves that cross") continue;
    const SurfaceMesh mesh = s.shape.mesh();
    const PrintCheck found = check(mesh, walls(0.35));
    ASSERT_EQ(found.places.size(), 2u) << "on both sides";
    for (const WeakPlace& place : found.places) {
      EXPECT_EQ(place.kind, WeakKind::Wall);
      EXPECT_EQ(place.thinnest.vertex(), Vertex::none);
      EXPECT_GE(place.faces.size(), 2u);
      EXPECT_GE(place.vertices.size(), 4u) << "the corners of these";
      EXPECT_NEAR(place.least, 0.3, 1e-12);
      const Vec3 at = positionOf(mesh, place.thinnest);
      EXPECT_NEAR(at.x, 0, 1e-12);
      EXPECT_NEAR(at.y, 0, 1e-12);
      EXPECT_NEAR(std::fabs(at.z - place.opposite.z), 0.3, 1e-12);
    }
  }
}

TEST(PrintCheck, TheShareThatFailsIsThatOfTheThinPart) {
  // A step: 5 x 10 of its floor is 1 thick, on both sides. Below the step, at the distance x from
  // it, balls are x² + 1 wide.
  const SurfaceMesh mesh = test::blocks({0, 5, 10}, {0, 10}, {0, 1, 4}, [](int i, int, int k) {
                             return k == 0 || i == 0;
                           }).mesh();
  const PrintCheck found = check(mesh, walls(1.5));
  ASSERT_FALSE(found.places.empty());
  EXPECT_NEAR(found.failingShare * mesh.area(), 100 + 10 * std::sqrt(0.5), 2);
}

TEST(PrintCheck, ATubeIsAsThickAsItsSection) {
  // A flat bar has a girth by π of 3.18, and is 1 thick; a square one has 1.27 and 1.
  const SurfaceMesh flat = test::box(20, 4, 1, 20, 4, 1).mesh();
  const PrintCheck bar = check(flat, {3, 0, 0});
  ASSERT_FALSE(bar.places.empty());
  EXPECT_EQ(bar.places[0].kind, WeakKind::Tube);
  EXPECT_NEAR(bar.places[0].least, 1, 1e-9);
  // From here on it is so long round that it counts as a wall.
  EXPECT_TRUE(check(flat, {1.5, 0, 0}).places.empty());
  const SurfaceMesh square = test::box(20, 1, 1, 20, 1, 1).mesh();
  EXPECT_NEAR(check(square, {1.2, 0, 0}).places.at(0).least, 1, 1e-9);
  const SurfaceMesh rod = test::prism(test::regularPolygon(24, 2 * kPi / 24), 30, 30).mesh();
  EXPECT_TRUE(check(rod, {1.9, 0, 0}).places.empty());
  const PrintCheck thin = check(rod, {2.1, 0, 0});
  ASSERT_FALSE(thin.places.empty());
  EXPECT_NEAR(thin.places[0].least, 2, 0.02);
}

TEST(PrintCheck, SectionsHaveTheLeastWidthOfTheirHull) {
  const SurfaceMesh triangle = test::prism(test::regularPolygon(3, 2, 4), 20, 20).mesh();
  const SurfaceMesh hexagon = test::prism(test::regularPolygon(6, 2, 4), 40, 40).mesh();
  const auto widthAt = [](const SurfaceMesh& mesh, double z) {
    for (const Vertex v : mesh.vertices()) {
      if (std::fabs(mesh.position(v).z - z) > 1e-9) continue;
      return sectionWidth(mesh, girthLoop(mesh, v).value());
    }
    return 0.0;
  };
  EXPECT_NEAR(widthAt(triangle, 10), std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(widthAt(hexagon, 20), 2 * std::sqrt(3.0), 1e-9);
  const SurfaceMesh ball = test::icosphere(2).mesh();
  const GirthLoop outAndBack = girthLoop(ball, Vertex(0)).value();
  ASSERT_EQ(outAndBack.kind, LoopKind::Antipodal);
  EXPECT_EQ(sectionWidth(ball, outAndBack), 0);
}

TEST(PrintCheck, FromThePassingScaleOnNothingFails) {
  const Shape shape = test::box(3, 2, 0.5, 6, 4, 1);
  const PrintLimits limits{1.7, 0.8, 0};
  const auto scaled = [&](double scale) {
    Shape copy = shape;
    for (double& coordinate : copy.positions) coordinate *= scale;
    return check(copy.mesh(), limits);
  };
  const PrintCheck found = scaled(1);
  ASSERT_GT(found.passingScale, 1);
  EXPECT_GT(found.failingShare, 0);
  EXPECT_TRUE(scaled(1.001 * found.passingScale).places.empty());
  EXPECT_FALSE(scaled(0.999 * found.passingScale).places.empty());
  const PrintCheck passes = scaled(4);
  EXPECT_TRUE(passes.places.empty());
  EXPECT_LE(passes.passingScale, 1);
  EXPECT_TRUE(scaled(4.001 * passes.passingScale).places.empty());
}

TEST(PrintCheck, NoWallIsToldWhereItIsATube) {
  const SurfaceMesh mesh = test::box(20, 1, 1, 20, 1, 1).mesh();
  const PrintCheck found = check(mesh, {2, 2, 0});
  ASSERT_FALSE(found.places.empty());
  EXPECT_EQ(found.places[0].kind, WeakKind::Tube);
  std::vector<Index> told(mesh.vertexCount(), 0);
  for (const WeakPlace& place : found.places) {
    for (const Vertex v : place.vertices) ++told[v];
  }
  EXPECT_LE(*std::max_element(told.begin(), told.end()), 1u);
}

TEST(PrintCheck, ALimitThatIsTheThicknessPassesInSinglePrecision) {
  Shape plate = test::box(30, 20, 1.1, 3, 2, 1);
  for (double& x : plate.positions) x = static_cast<float>(x + 7.3);
  EXPECT_TRUE(check(plate.mesh(), walls(1.1)).places.empty());
  EXPECT_FALSE(check(plate.mesh(), walls(1.10001)).places.empty());
}

TEST(PrintCheck, ThreadsDoNotMatterAndProgressNeverFalls) {
  const SurfaceMesh mesh = test::perturbed(test::torus(3, 0.6, 48, 24), 0.2, 9).mesh();
  const PrintLimits limits{1.2, 1, 5};
  const PrintCheck expected = check(mesh, limits);
  ASSERT_FALSE(expected.places.empty());
  for (const unsigned threads : {1u, 2u, 5u}) {
    double last = 0;
    ExecutionContext context;
    context.threads = threads;
    context.onProgress = [&](double fraction) {
      EXPECT_GE(fraction, last);
      last = fraction;
    };
    const PrintCheck found = check(mesh, limits, context);
    EXPECT_EQ(last, 1);
    EXPECT_EQ(found.passingScale, expected.passingScale);
    EXPECT_EQ(found.failingShare, expected.failingShare);
    ASSERT_EQ(found.places.size(), expected.places.size());
    for (std::size_t i = 0; i < found.places.size(); ++i) {
      EXPECT_EQ(found.places[i].least, expected.places[i].least);
      EXPECT_EQ(found.places[i].area, expected.places[i].area);
      EXPECT_EQ(found.places[i].vertices, expected.places[i].vertices);
      EXPECT_EQ(found.places[i].opposite.x, expected.places[i].opposite.x);
    }
  }
}

TEST(PrintCheck, StopsWhenTold) {
  const SurfaceMesh mesh = test::icosphere(3).mesh();
  const std::vector<double> girth = girthField(mesh).values,
                            thickness = medialThickness(mesh).value().values;
  const std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  for (const PrintLimits& limits : {PrintLimits{3, 0, 0}, walls(1), gaps(1)}) {
    const auto found = checkPrint(mesh, {girth, thickness}, limits, {}, context);
    ASSERT_TRUE(found.ok());
    EXPECT_FALSE(found.value().complete);
  }
}

TEST(PrintCheck, BadInputIsRefused) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  const std::vector<double> field(4, 1), few(3, 1);
  const auto code = [&](const PrintFields& fields, const PrintLimits& limits,
                        const ThicknessOptions& options = {}) {
    const auto found = checkPrint(mesh, fields, limits, options);
    return found.ok() ? std::string("ok") : std::string(toString(found.error().code));
  };
  EXPECT_EQ(code({field, field}, {-1, 0, 0}), "USAGE");
  EXPECT_EQ(code({field, field}, {0, kNoValue, 0}), "USAGE");
  EXPECT_EQ(code({field, field}, {0, 0, -1}), "USAGE");
  EXPECT_EQ(code({few, field}, {1, 1, 0}), "USAGE");
  EXPECT_EQ(code({field, few}, {1, 1, 0}), "USAGE");
  EXPECT_EQ(code({}, {1, 0, 0}), "USAGE");
  EXPECT_EQ(code({field, field}, {1, 1, 0}, {2, {}}), "USAGE");
  EXPECT_EQ(code({field, field}, {1, 1, 1}), "ok");
  EXPECT_EQ(code({}, {0, 0, 1}), "ok");
  EXPECT_EQ(code({}, {}), "ok");
  EXPECT_EQ(checkPrint(mesh, {}, {}).value().passingScale, 0);
}

TEST(PrintCheck, WallsPassOnlyWhereTheyWereMeasured) {
  const Shape box = test::box(2, 2, 1, 2, 2, 1);
  const SurfaceMesh body = box.mesh(), insideOut = test::turnedOver(box).mesh();
  const std::vector<double> measured(body.vertexCount(), 1), none(body.vertexCount(), kNoValue);
  std::vector<double> some = none;
  some[3] = 1;
  EXPECT_FALSE(whyNotChecked(body, {{}, measured}, {1, 1, 1}));
  EXPECT_FALSE(whyNotChecked(body, {{}, some}, {1, 1, 1}));
  const std::vector<std::pair<const SurfaceMesh*, const std::vector<double>*>> refused{
      {&body, &none}, {&insideOut, &none}, {&insideOut, &measured}};
  for (const auto& [mesh, thickness] : refused) {
    const auto error = whyNotChecked(*mesh, {{}, *thickness}, {0, 1, 0});
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::NoThickness);
    // Tubes are identified by the girth alone.
    EXPECT_FALSE(whyNotChecked(*mesh, {{}, *thickness}, {1, 0, 0}));
  }
  EXPECT_TRUE(whyNotChecked(insideOut, {}, {0, 0, 1}));
}

TEST(PrintCheck, OfAPlateWithHardlyAnyVolume) {
  const SurfaceMesh flat = test::box(2, 2, 1e-12, 6, 6, 1).mesh();
  EXPECT_FALSE(check(flat, walls(0.01)).places.empty());
  const Shape ball = test::icosphere(2);
  EXPECT_TRUE(
      check(test::together(ball, test::moved(ball, 0.5, 0, 0)).mesh(), walls(0.01)).places.empty());
}

/// A block of 20 x 20 x 10 with a triangle raised on it, or cut into it, by a height. Its angles
/// are 63°, 63° and 53°.
Shape blockWithLetter(double height) {
  Shape s;
  for (const double z : {0.0, 10.0}) {
    s.add(0, 0, z), s.add(20, 0, z), s.add(20, 20, z), s.add(0, 20, z);
  }
  for (const double z : {10.0, 10 + height}) s.add(6, 6, z), s.add(14, 6, z), s.add(10, 14, z);
  s.face(0, 2, 1), s.face(0, 3, 2);
  for (const Index i : {0u, 1u, 2u, 3u}) {
    const Index k = (i + 1) % 4;
    s.face(i, k, 4 + k), s.face(i, 4 + k, 4 + i);
  }
  s.face(4, 5, 9), s.face(4, 9, 8), s.face(5, 6, 9), s.face(9, 6, 10);
  s.face(10, 6, 7), s.face(10, 7, 8), s.face(8, 7, 4);
  for (const Index i : {0u, 1u, 2u}) {
    const Index k = (i + 1) % 3;
    s.face(8 + i, 8 + k, 11 + k), s.face(8 + i, 11 + k, 11 + i);
  }
  s.face(11, 12, 13);
  return s;
}

TEST(PrintCheck, LettersEndInCreasesAndPass) {
  const PrintCheck raised = check(blockWithLetter(1).mesh(), walls(0.8));
  EXPECT_TRUE(raised.passes());
  EXPECT_EQ(raised.passingScale, 1) << "of smaller ones nothing is known";
  ASSERT_EQ(raised.creases.size(), 1u) << "the letter's sides join its edges";
  const Crease& crease = raised.creases[0];
  EXPECT_EQ(crease.kind, CreaseKind::Crease);
  EXPECT_NEAR(crease.length, 3, 1e-9);
  EXPECT_EQ(crease.least, 0);
  EXPECT_GT(crease.area, 0);
  EXPECT_LT(crease.area, 32) << "each side of 8 in part";
  const SurfaceMesh cut = blockWithLetter(-1).mesh();
  const PrintCheck walled = check(cut, walls(0.8));
  EXPECT_TRUE(walled.passes());
  EXPECT_TRUE(walled.creases.empty());
  const PrintCheck free = check(cut, gaps(0.8));
  EXPECT_TRUE(free.passes()) << "what is between its corners is no gap";
  ASSERT_EQ(free.creases.size(), 1u);
  EXPECT_NEAR(free.creases[0].length, 3, 1e-9);
}

TEST(PrintCheck, AStrokeThinnerThanTheLimitFailsThoughItsCornersAreCreases) {
  const PrintCheck thin = check(blockWithLetter(-9.75).mesh(), walls(0.8));
  ASSERT_FALSE(thin.passes());
  EXPECT_NEAR(thin.places[0].least, 0.25, 1e-9);
  // All of it is thin, whatever the angles.
  Shape strut = test::prism(test::regularPolygon(3, 0.3), 20, 1);
  const PrintCheck bar = check(strut.mesh(), walls(0.8));
  EXPECT_FALSE(bar.passes());
  EXPECT_GT(bar.passingScale, 0.8 / (0.3 / std::sqrt(3.0)) * (1 - 1e-6)) << "its inner circle";
  for (double& x : strut.positions) x *= bar.passingScale;
  EXPECT_TRUE(std::isinf(bar.passingScale) || check(strut.mesh(), walls(0.8)).passes());
  EXPECT_FALSE(check(test::moved(test::tetrahedron(), 0.01, 0, 0).mesh(), walls(0.8)).passes());
}

TEST(PrintCheck, BladesFailAndPassAtNoScale) {
  for (const test::PrintShape& s : test::printShapes()) {
    if (s.name != "wedge" && s.name != "needle") continue;
    const PrintCheck found = check(s.shape.mesh(), walls(1e-4));
    EXPECT_FALSE(found.passes()) << s.name;
    EXPECT_TRUE(std::isinf(found.passingScale)) << s.name;
  }
}

/// A fin of 0.4 on a block, with a roof of some height.
Shape fin(double roof) {
  return test::prism({0, 0, 10, 0, 10, 5, 5.2, 5, 5.2, 8, 5, 8 + roof, 4.8, 8, 4.8, 5, 0, 5}, 10,
                     1);
}

TEST(PrintCheck, AFinWithASharpEdgeIsAsThickAsItself) {
  const SurfaceMesh blunt = fin(0.2 * std::sqrt(3.0)).mesh();  // 60°
  const PrintCheck fails = check(blunt, walls(0.8));
  ASSERT_FALSE(fails.passes());
  EXPECT_LE(fails.places[0].least, 0.4 + 1e-9);
  const PrintCheck passes = check(blunt, walls(0.2));
  EXPECT_TRUE(passes.passes());
  ASSERT_FALSE(passes.creases.empty());
  EXPECT_NEAR(passes.creases[0].length, 10, 1e-9);
  EXPECT_FALSE(check(fin(0.9).mesh(), walls(0.2)).passes()) << "its edge has 25°";
}

TEST(PrintCheck, WallsFailByTheirThickness) {
  for (const double thickness : {0.25, 0.35, 0.42, 0.5}) {
    const SurfaceMesh wall = test::box(10, thickness, 8, 1, 1, 1).mesh();
    const PrintCheck found = check(wall, walls(0.8));
    ASSERT_FALSE(found.passes());
    EXPECT_NEAR(found.places[0].least, thickness, 1e-12);
    EXPECT_NEAR(found.passingScale, 0.8 / thickness, 1e-9);
    EXPECT_TRUE(found.creases.empty());
    EXPECT_TRUE(check(wall, walls(thickness)).passes());
  }
}

TEST(PrintCheck, OneThinSpotFailsHoweverSmall) {
  const std::vector<double> across{0, 5, 5.05, 10};
  const Shape pit = test::blocks(across, across, {0, 0.3, 2},
                                 [](int i, int j, int k) { return k == 0 || i != 1 || j != 1; });
  EXPECT_NEAR(check(pit.mesh(), walls(0.8)).places.at(0).least, 0.3, 1e-12);
  // Two grooves leave a hundredth, along a line; a neck as much, round a point.
  const Shape hinge = test::prism(
      {0, -2, 3, -2, 5, -0.005, 7, -2, 10, -2, 10, 2, 7, 2, 5, 0.005, 3, 2, 0, 2}, 10, 1);
  EXPECT_NEAR(check(hinge.mesh(), walls(0.8)).places.at(0).least, 0.01, 1e-9);
  const Shape neck = test::revolved({{0, 0}, {5, 0}, {0.005, 5}, {5, 10}, {0, 10}}, 32);
  EXPECT_LE(check(neck.mesh(), walls(0.8)).places.at(0).least, 0.01 + 1e-9);
}

TEST(PrintCheck, ALipOfRoundingPasses) {
  // A foot that stands out by 0.0003 and ends sharp, as united solids leave it.
  const SurfaceMesh foot =
      test::prism({0, 0, 9.5, 0, 10, 0.25, 9.9997, 0.25, 9.9997, 10, 0, 10}, 10, 1).mesh();
  const PrintCheck found = check(foot, walls(0.8));
  EXPECT_TRUE(found.passes());
  ASSERT_EQ(found.creases.size(), 1u);
  EXPECT_NEAR(found.creases[0].length, 10, 1e-9);
  // Longer, it is a blade.
  const SurfaceMesh blade =
      test::prism({0, 0, 9.5, 0, 10, 0.25, 9.7, 0.25, 9.7, 10, 0, 10}, 10, 1).mesh();
  EXPECT_FALSE(check(blade, walls(0.8)).passes());
}

TEST(PrintCheck, BodiesThatTouchPass) {
  const auto prepared = [](const Shape& shape) {
    return std::move(prepareSurface({shape.positions, shape.triangles}).value().mesh);
  };
  const Shape cube = test::box(10, 10, 10, 1, 1, 1);
  const SurfaceMesh alongAnEdge = prepared(test::together(cube, test::shifted(cube, 10, 10, 0)));
  const double rounding = 10 * std::ldexp(1.0, -24);
  const SurfaceMesh nearly = prepared(
      test::together(cube, test::shifted(test::box(4, 4, 4, 1, 1, 1), 3, 3, 10 + rounding)));
  for (const SurfaceMesh* mesh : {&alongAnEdge, &nearly}) {
    EXPECT_TRUE(check(*mesh, walls(0.8)).passes());
    EXPECT_TRUE(check(*mesh, gaps(0.8)).passes());
  }
  const PrintCheck touching = check(nearly, gaps(0.8));
  ASSERT_FALSE(touching.creases.empty());
  EXPECT_EQ(touching.creases[0].kind, CreaseKind::Rounding);
  EXPECT_FALSE(check(prepared(test::together(
                         cube, test::shifted(test::box(4, 4, 4, 1, 1, 1), 3, 3, 10.001))),
                     gaps(0.8))
                   .passes());
}

TEST(PrintCheck, NeedlesOnAThickBodyPass) {
  // One edge of a cube is a triangle 0.000001 wide, turned by rounding.
  Shape s;
  for (const double z : {0.0, 10.0}) {
    s.add(0, 0, z), s.add(10, 0, z), s.add(10, 10, z), s.add(0, 10, z);
  }
  const Index needle = s.add(5, 1e-6, 10 - 2e-6);
  s.face(0, 2, 1), s.face(0, 3, 2);
  for (const Index i : {0u, 1u, 2u, 3u}) {
    const Index k = (i + 1) % 4;
    s.face(i, k, 4 + k), s.face(i, 4 + k, 4 + i);
  }
  for (const Index i : {0u, 1u, 2u, 3u}) s.face(4 + i, 4 + (i + 1) % 4, needle);
  const PrintCheck found = check(s.mesh(), walls(0.8));
  EXPECT_TRUE(found.passes());
  ASSERT_FALSE(found.creases.empty());
  EXPECT_EQ(found.creases[0].kind, CreaseKind::Sliver);
}

}  // namespace
}  // namespace girth
