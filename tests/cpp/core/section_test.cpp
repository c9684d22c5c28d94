// Plane sections of bodies whose sections are known.

#include "girth/section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/convex_hull.h"
#include "analysis/inscribed_circle.h"
#include "girth/landmarks.h"
#include "lathe.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "print_shapes.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth {
namespace {

constexpr double kExact = 1e-12;

Section cut(const SurfaceMesh& mesh, const Vec3& normal, double offset) {
  return findSection(mesh, normal, offset).value();
}

void expectNear(double value, double expected) {
  EXPECT_NEAR(value, expected, kExact * std::max(1.0, std::fabs(expected)));
}

void expectAt(const Vec3& place, const Vec3& expected) {
  EXPECT_NEAR(norm(place - expected), 0, kExact * std::max(1.0, norm(expected)));
}

/// A U of bars of width 1, 4 high and 3 wide, 2 deep.
test::Shape letterU() {
  return test::blocks({0, 1, 2, 3}, {0, 1, 4}, {0, 2},
                      [](int i, int j, int) { return i != 1 || j != 1; });
}

TEST(Section, OfPrismsIsTheirPolygon) {
  for (const Index sides : {3u, 4u, 7u, 40u}) {
    const double side = 0.7, apothem = side / 2 / std::tan(kPi / sides);
    const SurfaceMesh mesh = test::prism(test::regularPolygon(sides, side), 2, 3).mesh();
    for (const double height : {1e-9, 0.3, 2.0 / 3, 1.0, 1.999}) {
      const Section found = cut(mesh, {0, 0, 2}, height);
      ASSERT_EQ(found.curves.size(), 1u);
      const SectionCurve& curve = found.curves[0];
      EXPECT_TRUE(curve.closed);
      EXPECT_FALSE(curve.hole);
      expectNear(curve.perimeter, sides * side);
      expectNear(curve.tape, sides * side);
      expectNear(curve.area, sides * side * apothem / 2);
      expectNear(curve.equivalentDiameter, 2 * std::sqrt(curve.area / kPi));
      expectNear(curve.leastWidth,
                 sides % 2 == 0 ? 2 * apothem : apothem * (1 + 1 / std::cos(kPi / sides)));
      expectNear(found.area, curve.area);
      expectNear(found.normal.z, 1);
    }
  }
}

TEST(Section, PlanesThroughVerticesEdgesAndFaces) {
  const SurfaceMesh box = test::box(2, 3, 4, 2, 3, 4).mesh();
  for (const double height : {1.0, 2.0, 3.0, 1.5}) {
    const Section found = cut(box, {0, 0, 1}, height);
    ASSERT_EQ(found.curves.size(), 1u);
    expectNear(found.perimeter, 10);
    expectNear(found.area, 6);
    expectAt(found.curves[0].centre, {1, 1.5, height});
    expectNear(found.curves[0].leastWidth, 2);
    expectNear(found.curves[0].greatestWidth, std::sqrt(13));
  }
  // The lid lies in the plane, and the body goes on below it.
  expectNear(cut(box, {0, 0, 1}, 4).area, 6);
  expectNear(cut(box, {0, 0, -1}, 0).area, 6);
  EXPECT_TRUE(cut(box, {0, 0, 1}, 0).curves.empty());
  EXPECT_TRUE(cut(box, {0, 0, 1}, 4.001).curves.empty());
  EXPECT_TRUE(cut(box, {0, 0, 1}, -1e300).curves.empty());
  // Through two opposite edges: through vertices and along edges alone.
  const Section slanted = cut(box, {3, 2, 0}, 6 / std::sqrt(13));
  ASSERT_EQ(slanted.curves.size(), 1u);
  expectNear(slanted.area, 4 * std::sqrt(13));
  expectNear(slanted.perimeter, 8 + 2 * std::sqrt(13));
  // It touches a corner: nothing, or a single point, which is no curve.
  EXPECT_TRUE(cut(box, {1, 1, 1}, 0).curves.empty());
  EXPECT_TRUE(cut(box, {1, 1, 1}, 9 / std::sqrt(3)).curves.empty());
}

TEST(Section, ATapeSpansHollows) {
  const SurfaceMesh mesh = letterU().mesh();
  const Section across = cut(mesh, {0, 0, 1}, 1);
  ASSERT_EQ(across.curves.size(), 1u);
  expectNear(across.perimeter, 20);
  expectNear(across.tape, 14);
  expectNear(across.area, 9);
  expectAt(across.curves[0].centre, {1.5, (3 * 0.5 + 2 * 3 * 2.5) / 9, 1});
  expectNear(across.curves[0].leastWidth, 3);
  expectNear(across.curves[0].greatestWidth, 5);
  // Two arms: two curves, and one tape round both.
  const Section arms = cut(mesh, {0, 1, 0}, 2.5);
  ASSERT_EQ(arms.curves.size(), 2u);
  for (const SectionCurve& arm : arms.curves) {
    expectNear(arm.perimeter, 6);
    expectNear(arm.area, 2);
    EXPECT_EQ(arm.component, 0u);
  }
  expectNear(arms.tape, 10);
  expectNear(arms.area, 4);
}

TEST(Section, HolesAreTakenAway) {
  // A box with a cavity: two components, and where the plane meets the cavity, a hole.
  const SurfaceMesh hollow =
      test::blocks({0, 1, 3, 10}, {0, 2, 5, 10}, {0, 4, 6, 10}, [](int i, int j, int k) {
        return i != 1 || j != 1 || k != 1;
      }).mesh();
  ASSERT_EQ(hollow.componentCount(), 2u);
  const Section found = cut(hollow, {0, 0, 1}, 5);
  ASSERT_EQ(found.curves.size(), 2u);
  const SectionCurve &outer = found.curves[found.curves[0].hole ? 1 : 0],
                     &hole = found.curves[found.curves[0].hole ? 0 : 1];
  EXPECT_FALSE(outer.hole);
  ASSERT_TRUE(hole.hole);
  EXPECT_NE(outer.component, hole.component);
  expectNear(outer.area, 94);
  expectNear(hole.area, 6);
  expectNear(found.area, 94);
  expectAt(outer.centre, {(500 - 6 * 2) / 94.0, (500 - 6 * 3.5) / 94, 5});
  // Across a torus: an annulus; through its axis: two discs.
  const SurfaceMesh ring = test::torus(3, 1, 24, 12).mesh();
  const Section annulus = cut(ring, {0, 0, 1}, 1e-3);
  ASSERT_EQ(annulus.curves.size(), 2u);
  EXPECT_EQ(annulus.curves[0].hole + annulus.curves[1].hole, 1);
  const Section discs = cut(ring, {1, 0, 0}, 0);
  ASSERT_EQ(discs.curves.size(), 2u);
  for (const SectionCurve& disc : discs.curves) {
    EXPECT_FALSE(disc.hole);
    expectNear(disc.area, 3);  // a regular polygon of twelve corners at distance 1
  }
  // A body inside another is no hole: its surface looks outwards.
  const SurfaceMesh nested = test::together(test::box(4, 4, 4, 1, 1, 1),
                                            test::shifted(test::box(1, 1, 1, 1, 1, 1), 1, 1, 1))
                                 .mesh();
  const Section both = cut(nested, {0, 0, 1}, 1.5);
  ASSERT_EQ(both.curves.size(), 2u);
  EXPECT_FALSE(both.curves[0].hole || both.curves[1].hole);
  expectNear(both.area, 17);
  // Turned over as a whole, the cavity is a hole all the same.
  const Section turned =
      cut(test::turnedOver([] {
            return test::blocks({0, 1, 3, 10}, {0, 2, 5, 10}, {0, 4, 6, 10},
                                [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; });
          }())
              .mesh(),
          {0, 0, 1}, 5);
  EXPECT_EQ(turned.curves[0].hole + turned.curves[1].hole, 1);
  expectNear(turned.area, 94);
}

TEST(Section, OpenCurvesEndAtTheBoundary) {
  const SurfaceMesh tube = test::lathe({{0, 1}, {3, 1}}, 8, false).mesh(OpenEdges::Boundary);
  const Section along = cut(tube, {1, 0, 0}, 0.1);
  ASSERT_EQ(along.curves.size(), 2u);
  for (const SectionCurve& curve : along.curves) {
    EXPECT_FALSE(curve.closed);
    expectNear(curve.perimeter, 3);
    expectNear(curve.tape, 6);
    EXPECT_EQ(curve.area, 0);
    expectNear(curve.centre.z, 1.5);
  }
  EXPECT_TRUE(cut(tube, {0, 0, 1}, 1.5).curves[0].closed);
}

TEST(Section, OfConesShrinkWithTheHeight) {
  const SurfaceMesh cone = test::lathe({{0, 2}, {4, 1}}, 9).mesh();
  const double corner = 2 * std::sin(kPi / 9);
  for (const double height : {1e-9, 1.0, 3.999}) {
    expectNear(cut(cone, {0, 0, 1}, height).perimeter, 9 * corner * (2 - height / 4));
  }
}

TEST(Section, TheSameInEveryPlaceAndTriangulation) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const test::Shape shape = letterU();
    const double angle = 0.3 + static_cast<double>(seed), shift = 100.0 * static_cast<double>(seed);
    const SurfaceMesh moved =
        test::moved(test::retriangulated(shape, seed), 3, angle, shift).mesh();
    // The normal z and the point (0, 0, 1), moved likewise.
    const auto image = [&](const Vec3& p) {
      const double c = std::cos(angle), s = std::sin(angle);
      const Vec3 q{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
      return Vec3{3 * q.x + shift, 3 * (c * q.y - s * q.z) - 2 * shift,
                  3 * (s * q.y + c * q.z) + shift / 3};
    };
    const Vec3 base = image({0, 0, 1}), normal = image({0, 0, 2}) - base;
    const Section found = cut(moved, normal, dot(normal, base) / norm(normal));
    ASSERT_EQ(found.curves.size(), 1u);
    EXPECT_NEAR(found.perimeter, 60, 1e-9);
    EXPECT_NEAR(found.tape, 42, 1e-9);
    EXPECT_NEAR(found.area, 81, 1e-9);
  }
}

/// Cavalieri: the areas of sections add up to the volume.
TEST(Section, AreasAddUpToTheVolume) {
  for (std::uint64_t seed = 1; seed < 8; ++seed) {
    const SurfaceMesh mesh = test::perturbed(test::icosphere(2), 0.3, seed).mesh();
    double volume = 0;
    for (const Face f : mesh.faces()) {
      const auto [a, b, c] = mesh.faceVertices(f);
      volume += dot(mesh.position(a), cross(mesh.position(b), mesh.position(c))) / 6;
    }
    const Vec3 normal{0.3, -0.5, 0.8};
    const HeightRange range = heightRange(mesh, normal).value();
    // Quadratic between the heights of vertices: Simpson's rule there is exact.
    const double length = norm(normal);
    std::vector<double> heights;
    for (const Vertex v : mesh.vertices())
      heights.push_back(dot(normal, mesh.position(v)) / length);
    std::sort(heights.begin(), heights.end());
    EXPECT_NEAR(range.low, heights.front(), 1e-15);
    EXPECT_NEAR(range.high, heights.back(), 1e-15);
    std::vector<double> offsets;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
      offsets.push_back(heights[i]);
      offsets.push_back((heights[i] + heights[i + 1]) / 2);
      offsets.push_back(heights[i + 1]);
    }
    const std::vector<Section> all = findSections(mesh, {normal, offsets}).value().sections;
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); i += 3) {
      sum +=
          (offsets[i + 2] - offsets[i]) / 6 * (all[i].area + 4 * all[i + 1].area + all[i + 2].area);
    }
    EXPECT_NEAR(sum, volume, 1e-9);
    // One by one, and on one thread, they are the same.
    for (std::size_t i = 0; i < all.size(); i += 17) {
      const Section alone = cut(mesh, normal, offsets[i]);
      EXPECT_EQ(alone.perimeter, all[i].perimeter);
      EXPECT_EQ(alone.tape, all[i].tape);
      EXPECT_EQ(alone.area, all[i].area);
    }
  }
}

TEST(Section, RefusesPlanesThatAreNone) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  EXPECT_EQ(findSection(mesh, {0, 0, 0}, 0).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(findSection(mesh, {0, 0, 1}, NAN).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(findSection(mesh, {0, INFINITY, 1}, 0).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(heightRange(mesh, {0, 0, NAN}).error().code, ErrorCode::InvalidOption);
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(
      findSections(mesh, {{0, 0, 1}, std::vector<double>(100, 0.1)}, {1, &cancel, {}}).error().code,
      ErrorCode::Cancelled);
  EXPECT_TRUE(findSections(mesh, {{0, 0, 1}, {}}).value().sections.empty());
}

TEST(ConvexHull, WidthsAreThoseOfAllDirections) {
  test::Random random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<Point2> points;
    const Index count = 3 + random.below(40);
    const bool isGrid = round % 3 == 0;
    for (Index i = 0; i < count; ++i) {
      points.push_back(isGrid ? Point2{double(random.below(4)), double(random.below(5))}
                              : Point2{random(), 3 * random()});
    }
    const std::vector<Point2> hull = convexHull(points);
    double greatest = 0, least = HUGE_VAL;
    for (const Point2& a : points) {
      for (const Point2& b : points) {
        greatest = std::max(greatest, std::hypot(a.x - b.x, a.y - b.y));
      }
    }
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
      double width = 0;
      for (const Point2& p : points) {
        width = std::max(width, cross(a, b, p) / std::hypot(a.x - b.x, a.y - b.y));
      }
      least = std::min(least, width);
    }
    const Widths widths = widthsOf(hull);
    EXPECT_NEAR(widths.greatest, greatest, 1e-12) << round;
    EXPECT_NEAR(widths.least, hull.size() < 3 ? 0 : least, 1e-12) << round;
  }
}

TEST(Section, OfManyPlanesAreThoseOfEachWhateverTheirOrder) {
  const SurfaceMesh mesh = letterU().mesh();
  const std::vector<double> offsets{3.5, 0.5, 1, 0.5, 9, 0.25, 1, 2};
  const auto all = findSections(mesh, {{0, 1, 0}, offsets}, {3, nullptr, {}}).value().sections;
  ASSERT_EQ(all.size(), offsets.size());
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    const Section one = cut(mesh, {0, 1, 0}, offsets[k]);
    EXPECT_EQ(all[k].offset, offsets[k]);
    EXPECT_EQ(all[k].perimeter, one.perimeter);
    EXPECT_EQ(all[k].tape, one.tape);
    ASSERT_EQ(all[k].curves.size(), one.curves.size());
    for (std::size_t c = 0; c < one.curves.size(); ++c) {
      EXPECT_EQ(all[k].curves[c].points.size(), one.curves[c].points.size());
      EXPECT_EQ(all[k].curves[c].area, one.curves[c].area);
    }
  }
}

/// Boxes of widths 3, 1 and 2, one on the other, 2 deep.
SurfaceMesh steps() {
  return test::blocks({0, 1, 2, 3}, {0, 2}, {0, 1, 2, 3},
                      [](int i, int, int k) {
                        return i < (k == 0 ? 3 : k == 1 ? 1 : 2);
                      })
      .mesh();
}

TEST(Section, WidestAndNarrowestOfStepsAreThoseOfTheirBoxes) {
  const SurfaceMesh mesh = steps();
  const auto extreme = [&](double low, double high, SectionExtreme which) {
    return extremeSection(mesh, {{0, 0, 3}, which, low, high}).value();
  };
  for (const SectionMeasure measure : {SectionMeasure::Perimeter, SectionMeasure::Tape}) {
    const auto widest =
        extremeSection(mesh, {{0, 0, 1}, SectionExtreme::Widest, 0, 3, measure}).value();
    expectNear(widest.perimeter, 10);
    EXPECT_TRUE(widest.offset > 0 && widest.offset <= 1) << widest.offset;
  }
  const Section narrowest = extreme(0.5, 2.5, SectionExtreme::Narrowest);
  expectNear(narrowest.perimeter, 6);
  EXPECT_TRUE(narrowest.offset > 1 && narrowest.offset <= 2) << narrowest.offset;
  expectNear(extreme(2.5, 2.75, SectionExtreme::Narrowest).perimeter, 8);
  expectNear(extreme(2.5, 2.5, SectionExtreme::Widest).perimeter, 8);
  // Planes that miss the body are none of the narrowest.
  expectNear(extreme(2.5, 7, SectionExtreme::Narrowest).perimeter, 8);
}

/// Two bars of one square section, which lean to opposite sides: at height h they are at y = h and,
/// beside it, at y = -h.
SurfaceMesh crossedBars(double apart) {
  test::Shape shape;
  for (const double side : {1.0, -1.0}) {
    const Index first = shape.vertexCount();
    for (const double h : {-1.0, 1.0}) {
      const double x = side < 0 ? apart : 0, y = side * h;
      shape.add(x, y, h);
      shape.add(x + 1, y, h);
      shape.add(x + 1, y + 1, h);
      shape.add(x, y + 1, h);
    }
    for (const auto& [a, b, c, d] : std::vector<std::array<Index, 4>>{
             {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
      shape.face(first + a, first + b, first + c);
      shape.face(first + a, first + c, first + d);
    }
  }
  return shape.mesh();
}

TEST(Section, TheTapeIsNarrowestBetweenVertices) {
  constexpr double kApart = 3;
  const SurfaceMesh mesh = crossedBars(kApart);
  const auto tapeAt = [&](double h) { return 4 + 2 * std::hypot(kApart, 2 * h); };
  const auto extreme = [&](double low, double high, SectionExtreme which) {
    return extremeSection(mesh, {{0, 0, 1}, which, low, high, SectionMeasure::Tape}).value();
  };
  for (const double high : {0.5, 0.75, 1.0}) {
    const Section found = extreme(-0.875, high, SectionExtreme::Narrowest);
    expectNear(found.tape, tapeAt(0));
    EXPECT_NEAR(found.offset, 0, 1e-6);
  }
  expectNear(extreme(0.25, 0.75, SectionExtreme::Narrowest).tape, tapeAt(0.25));
  expectNear(extreme(-0.25, 0.75, SectionExtreme::Widest).tape, tapeAt(0.75));
}

TEST(Section, ExtremesOfNoRangeAreRefused) {
  const SurfaceMesh mesh = steps();
  const auto code = [&](const Vec3& normal, double low, double high) {
    const auto found = extremeSection(mesh, {normal, SectionExtreme::Widest, low, high});
    EXPECT_FALSE(found);
    return found.error().code;
  };
  EXPECT_EQ(code({0, 0, 0}, 0, 1), ErrorCode::InvalidOption);
  EXPECT_EQ(code({0, 0, 1}, 2, 1), ErrorCode::InvalidOption);
  EXPECT_EQ(code({0, 0, 1}, std::nan(""), 1), ErrorCode::InvalidOption);
  EXPECT_EQ(code({0, 0, 1}, 7, 9), ErrorCode::InvalidOption);
  const Error missed = extremeSection(mesh, {{0, 0, 1}, SectionExtreme::Narrowest, 7, 9}).error();
  EXPECT_NE(missed.hint.find("from 0 to 3"), std::string::npos) << missed.hint;
}

TEST(Section, ExtremesOfNoTypedRangeAreThoseOfTheWholeSurface) {
  expectNear(extremeSection(steps(), {{0, 0, 1}, SectionExtreme::Widest}).value().perimeter, 10);
  expectNear(extremeSection(steps(), {{0, 0, 1}, SectionExtreme::Narrowest}).value().perimeter, 6);
}

TEST(Section, AcrossATubeIsWhatItsGirthLoopGoesRound) {
  const SurfaceMesh tube = test::prism(test::regularPolygon(12, 0.5), 8, 16).mesh();
  const SurfacePoint middle = SurfacePoint::atVertex(Vertex(8 * 12 + 3));
  const Vec3 along = directionAlong(tube, middle).value();
  EXPECT_NEAR(std::fabs(along.z), 1, kExact);
  const double height = heightOf(tube, 5 * along, middle).value();
  EXPECT_NEAR(height, 4 * along.z, kExact);
  expectNear(cut(tube, along, height).perimeter, 6);
  EXPECT_FALSE(heightOf(tube, {0, 0, 0}, middle));
  EXPECT_EQ(directionAlong(tube, SurfacePoint::atVertex(Vertex(100'000))).error().code,
            ErrorCode::VertexOutOfRange);
}

TEST(Section, ThroughPointsOfATubeStraightAndAcross) {
  const SurfaceMesh tube = test::prism(test::regularPolygon(12, 0.5), 8, 16).mesh();
  const std::vector<SurfacePoint> points{SurfacePoint::atVertex(Vertex(8 * 12 + 3)),
                                         SurfacePoint::atVertex(Vertex(5 * 12 + 1))};
  for (const bool across : {false, true}) {
    const auto found = sectionsThrough(tube, {points, {0, 0, 2}, across}).value().sections;
    ASSERT_EQ(found.size(), 2u);
    for (const Section& section : found) expectNear(section.perimeter, 6);
    expectNear(std::fabs(found[0].offset), 4);
    expectNear(std::fabs(found[1].offset), 2.5);
  }
  const auto code = [&](const SurfacePoint& point, const Vec3& normal, bool across) {
    return sectionsThrough(tube, {{point}, normal, across}).error().code;
  };
  for (const bool across : {false, true}) {
    EXPECT_EQ(code(SurfacePoint::atVertex(Vertex(100'000)), {0, 0, 1}, across),
              ErrorCode::VertexOutOfRange);
    EXPECT_EQ(code(SurfacePoint::inFace(Face(0), {2, 0, 0}), {0, 0, 1}, across),
              ErrorCode::InvalidPoint);
  }
  EXPECT_EQ(code(points[0], {0, 0, 0}, false), ErrorCode::InvalidOption);
}

TEST(Section, InscribedCirclesAreThoseOfTheirPolygons) {
  const auto inscribed = [](const SurfaceMesh& mesh, const Vec3& normal, double offset) {
    return findSections(mesh, {normal, {offset}, true}).value().sections.at(0);
  };
  const SurfaceMesh box = test::box(2, 3, 4, 2, 3, 4).mesh();
  const SectionCurve flat = inscribed(box, {0, 0, 1}, 1).curves.at(0);
  expectNear(flat.inscribedDiameter, 2);
  EXPECT_NEAR(flat.inscribedCentre.x, 1, 1e-12);
  EXPECT_TRUE(std::isnan(cut(box, {0, 0, 1}, 1).curves.at(0).inscribedDiameter));
  // In a corner of the U: it touches two sides and the corner opposite.
  const SectionCurve hollow = inscribed(letterU().mesh(), {0, 0, 1}, 1).curves.at(0);
  expectNear(hollow.inscribedDiameter, 2 * (2 - std::sqrt(2.0)));
  // Between the square and the hole in it.
  const SurfaceMesh frame = test::blocks({0, 1, 3, 4}, {0, 1, 3, 4}, {0, 1}, [](int i, int j, int) {
                              return i != 1 || j != 1;
                            }).mesh();
  for (const SectionCurve& curve : inscribed(frame, {0, 0, 1}, 0.5).curves) {
    expectNear(curve.inscribedDiameter, curve.hole ? 2 : 2 * (2 - std::sqrt(2.0)));
  }
  const SurfaceMesh open = test::lathe({{0, 1}, {3, 1}}, 8, false).mesh(OpenEdges::Boundary);
  EXPECT_EQ(inscribed(open, {1, 0, 0}, 0.1).curves.at(0).inscribedDiameter, 0);
}

TEST(InscribedCircle, IsTheLargestOfManyCentres) {
  test::Random random(3);
  for (int round = 0; round < 30; ++round) {
    std::vector<Point2> star;
    const Index corners = 5 + random.below(40);
    for (Index i = 0; i < corners; ++i) {
      const double radius = 0.3 + random(), angle = 2 * kPi * i / corners;
      star.push_back({2 * radius * std::cos(angle), radius * std::sin(angle)});
    }
    const auto clearance = [&](const Point2& p) {
      double least = HUGE_VAL;
      for (std::size_t i = 0; i < star.size(); ++i) {
        const Point2 &a = star[i], &b = star[(i + 1) % star.size()];
        least = std::min(least, squareFromSegment({p.x, p.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0}));
      }
      return std::sqrt(least);
    };
    const InscribedCircle circle = inscribedCircle({star});
    EXPECT_NEAR(clearance(circle.centre), circle.radius, 1e-13) << round;
    // No centre in the star-shaped region is farther from its sides.
    for (int i = 0; i < 300; ++i) {
      const std::size_t k = random.below(corners);
      const Point2 &a = star[k], &b = star[(k + 1) % star.size()];
      const double share = random(), out = random();
      const Point2 p{out * (a.x + share * (b.x - a.x)), out * (a.y + share * (b.y - a.y))};
      EXPECT_LE(clearance(p), circle.radius * (1 + 1e-12)) << round;
    }
  }
}

TEST(InscribedCircle, OfPolygonsThatEncloseNothingIsNone) {
  EXPECT_EQ(inscribedCircle({}).radius, 0);
  EXPECT_EQ(inscribedCircle({{}}).radius, 0);
  EXPECT_EQ(inscribedCircle({{{1, 1}}}).radius, 0);
  EXPECT_LT(inscribedCircle({{{0, 0}, {1, 1}, {2, 2}}}).radius, 1e-9);
}

TEST(Section, CurvesLieOnTheLimbThatHoldsMostOfThem) {
  const SurfaceMesh mesh = letterU().mesh();
  std::vector<Limb> limbs(2);
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (p.y > 1) limbs[p.x < 1.5 ? 0 : 1].vertices.push_back(v);
  }
  Sections found = findSections(mesh, {{0, 1, 0}, {3.5, 0.25}}).value();
  placeOnLimbs(mesh, limbs, found);
  for (const SectionCurve& curve : found.sections[0].curves) {
    EXPECT_EQ(curve.limb, curve.centre.x < 1.5 ? 0u : 1u);
  }
  EXPECT_EQ(found.sections[1].curves.at(0).limb, kNoIndex);
  placeOnLimbs(mesh, {}, found);
  EXPECT_EQ(found.sections[0].curves.at(0).limb, kNoIndex);
}

TEST(Landmarks, AreMeasuredByTheirKinds) {
  const SurfaceMesh mesh = letterU().mesh();
  const SurfacePoint arm = SurfacePoint::atVertex(Vertex([&] {
    Index found = 0;
    for (const Vertex v : mesh.vertices()) {
      const Vec3& p = mesh.position(v);
      if (p.x == 0 && p.y == 4 && p.z == 0) found = v;
    }
    return found;
  }()));
  const auto measured = [&](const Landmark& landmark) {
    return measureLandmarks(mesh, {{landmark}, {0, 1, 0}}).value().measures.at(0);
  };
  expectNear(measured({"arm", arm, MeasureKind::Section}).length, 6);
  const Landmark all{"both", arm, MeasureKind::Tape, arm, false, true};
  expectNear(measured(all).length, 10);
  EXPECT_TRUE(measured(all).points.empty());
  expectNear(
      measured({"way", arm, MeasureKind::Distance, SurfacePoint::atVertex(arm.vertex())}).length,
      0);
  EXPECT_EQ(measured({"arm", arm, MeasureKind::Girth}).name, "arm");
  const auto refused = [&](const Landmark& landmark) {
    return measureLandmarks(mesh, {{landmark}, {0, 1, 0}}).error();
  };
  // A distance without another end.
  const Error none = refused({"neck", arm, MeasureKind::Distance});
  EXPECT_EQ(none.code, ErrorCode::VertexOutOfRange);
  EXPECT_EQ(none.message.rfind("neck: ", 0), 0u) << none.message;
  EXPECT_EQ(measureLandmarks(mesh, {{{"arm", arm, MeasureKind::Tape}}, {0, 0, 0}}).error().code,
            ErrorCode::InvalidOption);
  EXPECT_TRUE(measureLandmarks(mesh, {}).value().measures.empty());
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(measureLandmarks(mesh, {{all}}, {1, &cancel, {}}).error().code, ErrorCode::Cancelled);
}

TEST(Section, TheCurveThroughAPointIsThatOfItsBody) {
  const test::Shape small = test::box(1, 1, 2, 1, 1, 1), large = test::box(2, 2, 2, 1, 1, 1);
  const SurfaceMesh mesh = test::together(small, test::shifted(large, 5, 0, 0)).mesh();
  const Section section = cut(mesh, {0, 0, 1}, 1);
  ASSERT_EQ(section.curves.size(), 2u);
  const auto through = [&](const SurfacePoint& point) {
    return curveThrough(mesh, section, point)->perimeter;
  };
  expectNear(through(SurfacePoint::atVertex(Vertex(0))), 4);
  expectNear(through(SurfacePoint::atVertex(Vertex(small.vertexCount()))), 8);
  EXPECT_EQ(curveThrough(mesh, Section{}, SurfacePoint::atVertex(Vertex(0))), nullptr);
}

}  // namespace
}  // namespace girth
