// Tubes: centrelines, what lies along them, narrowings and widenings.
#include "girth/tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "girth/girth_field.h"
#include "girth/necks.h"
#include "isosurface.h"
#include "shapes.h"

namespace girth::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Index kCorners = 48;

/// A line in the plane of x and z over [0, 1], and the radius of the tube round it.
struct Course {
  std::function<Vec3(double)> point;
  std::function<double(double)> radius;
  /// How far the middle of a section lies beside the line, along y.
  std::function<double(double)> aside = [](double) { return 0.0; };
};

Vec3 straight(double t) { return {0, 0, 20 * t}; }

/// Half a circle, 20 long.
Vec3 half(double t) { return {20 / kPi * std::cos(kPi * t), 0, 20 / kPi * std::sin(kPi * t)}; }

/// Regular polygons across a line, open or with flat caps.
Shape tubeAlong(const Course& course, Index along, bool isCapped) {
  Shape shape;
  constexpr double kStep = 1e-5;
  for (Index i = 0; i <= along; ++i) {
    const double t = static_cast<double>(i) / along;
    const Vec3 p = course.point(t), a = course.point(t - kStep), b = course.point(t + kStep);
    const double length = std::hypot(b.x - a.x, b.z - a.z);
    const double dx = (b.x - a.x) / length, dz = (b.z - a.z) / length;
    for (Index j = 0; j < kCorners; ++j) {
      const double angle = 2 * kPi * j / kCorners, r = course.radius(t);
      const double side = r * std::cos(angle);
      shape.add(p.x - side * dz, p.y + course.aside(t) + r * std::sin(angle), p.z + side * dx);
    }
  }
  const auto at = [](Index i, Index j) { return i * kCorners + j % kCorners; };
  for (Index i = 0; i < along; ++i) {
    for (Index j = 0; j < kCorners; ++j) {
      shape.face(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      shape.face(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  if (isCapped) {
    const Vec3 first = course.point(0), last = course.point(1);
    const Index below = shape.add(first.x, first.y, first.z);
    const Index above = shape.add(last.x, last.y, last.z);
    for (Index j = 0; j < kCorners; ++j) {
      shape.face(below, at(0, j + 1), at(0, j));
      shape.face(above, at(along, j), at(along, j + 1));
    }
  }
  return shape;
}

SurfaceMesh meshAlong(const Course& course, bool isCapped, Index along = 200) {
  return tubeAlong(course, along, isCapped)
      .mesh(isCapped ? OpenEdges::Refuse : OpenEdges::Boundary);
}

/// A dip by a share of the radius, or a rise where it is below 0, as a cosine.
double dip(double t, double middle, double share, double reach = 0.08) {
  const double x = std::fabs(t - middle) / reach;
  return x >= 1 ? 1 : 1 - share / 2 * (1 + std::cos(kPi * x));
}

double constant(double) { return 1; }

/// The diameter of a circle with the area of a regular polygon round a radius.
double diameterOf(double radius) {
  const double area = kCorners / 2.0 * std::sin(2 * kPi / kCorners) * radius * radius;
  return 2 * std::sqrt(area / kPi);
}

double polygonGirth(double radius) { return 2 * kCorners * radius * std::sin(kPi / kCorners); }

TEST(Tubes, straightOneIsExact) {
  const SurfaceMesh mesh = meshAlong({straight, constant}, false);
  const Tubes found = findTubes(mesh, {}).value();
  ASSERT_EQ(found.branches.size(), 1u);
  EXPECT_TRUE(found.others.empty());
  EXPECT_TRUE(found.places.empty());
  EXPECT_TRUE(found.branches[0].open);
  EXPECT_TRUE(mesh.isBoundary(found.branches[0].end));
  EXPECT_NEAR(found.branches[0].median, diameterOf(1), 1e-12);
  EXPECT_GT(found.branches[0].lastDistance, 19);
  ASSERT_GT(found.stations.size(), 60u);
  for (const TubeStation& station : found.stations) {
    EXPECT_NEAR(station.equivalentDiameter, diameterOf(1), 1e-12);
    EXPECT_NEAR(station.girth, polygonGirth(1), 1e-12);
    EXPECT_NEAR(station.perimeter, polygonGirth(1), 1e-12);
    EXPECT_NEAR(station.inscribedDiameter, 2 * std::cos(kPi / kCorners), 1e-11);
    EXPECT_NEAR(std::hypot(station.centre.x, station.centre.y), 0, 1e-12);
    EXPECT_NEAR(std::fabs(station.direction.z), 1, 1e-12);
    EXPECT_NEAR(station.curvature, 0, 1e-9);
    EXPECT_TRUE(std::isnan(station.torsion));
  }
}

TEST(Tubes, bentOneHasItsCurvature) {
  for (const bool isCapped : {false, true}) {
    const Tubes found = findTubes(meshAlong({half, constant}, isCapped), {}).value();
    ASSERT_EQ(found.branches.size(), 1u);
    EXPECT_EQ(found.branches[0].open, !isCapped);
    EXPECT_NEAR(found.branches[0].lastDistance, 20, 0.6);
    for (const TubeStation& station : found.stations) {
      if (station.distance < 2 || station.distance > 18) continue;
      EXPECT_NEAR(station.equivalentDiameter, diameterOf(1), 1e-4);
      EXPECT_NEAR(std::hypot(station.centre.x, station.centre.z), 20 / kPi, 2e-3);
      EXPECT_NEAR(station.curvature, kPi / 20, 2e-3);
      EXPECT_NEAR(station.torsion, 0, 1e-3);
    }
  }
}

/// Narrowings of 30, 50 and 70 per cent and a bulge of 60, one after the other.
TEST(Tubes, degreesAreThoseOfTheShape) {
  const auto taper = [](double t) { return 1.2 - 0.4 * t; };
  for (const auto& point : {straight, half}) {
    for (const bool isCapped : {false, true}) {
      for (const bool isTapered : {false, true}) {
        Course course{point, {}};
        course.radius = [&](double t) {
          return (isTapered ? taper(t) : 1) * dip(t, 0.2, 0.3) * dip(t, 0.4, 0.5) *
                 dip(t, 0.6, -0.6) * dip(t, 0.8, 0.7);
        };
        const Tubes found = findTubes(meshAlong(course, isCapped, 400), {}).value();
        ASSERT_EQ(found.places.size(), 4u);
        const bool isTurned = found.places[0].degreeByDiameter > 0.5;
        std::vector<double> degrees{0.3, 0.5, 0.6, 0.7};
        if (isTurned) std::reverse(degrees.begin(), degrees.end());
        for (std::size_t i = 0; i < 4; ++i) {
          const TubePlace& place = found.places[i];
          EXPECT_EQ(place.change, degrees[i] == 0.6 ? TubeChange::Widening : TubeChange::Narrowing);
          EXPECT_NEAR(place.degreeByDiameter, degrees[i], 0.01);
          const double share = place.equivalentDiameter / place.reference;
          EXPECT_NEAR(place.degreeByArea, std::fabs(1 - share * share), 1e-12);
          EXPECT_LT(place.beforeDistance, place.distance);
          EXPECT_GT(place.beyondDistance, place.distance);
          EXPECT_NEAR(place.length, 1.6, 0.05);
        }
      }
    }
  }
}

TEST(Tubes, narrowestPlaceIsTheNeck) {
  const Course course{straight, [](double t) { return dip(t, 0.5, 0.5); }};
  const SurfaceMesh mesh = meshAlong(course, true, 40);
  const Tubes found = findTubes(mesh, {}).value();
  ASSERT_EQ(found.places.size(), 1u);
  const Necks necks = findNecks(mesh, girthField(mesh).values).value();
  ASSERT_EQ(necks.necks.size(), 1u);
  EXPECT_NEAR(found.places[0].girth, necks.necks[0].length, 1e-9);
  EXPECT_NEAR(found.places[0].perimeter, necks.necks[0].length, 1e-6);
}

TEST(Tubes, excentricNarrowing) {
  Course course{straight, [](double t) { return dip(t, 0.5, 0.5); }};
  course.aside = [](double t) { return dip(t, 0.5, 1) - dip(t, 0.5, 0.5); };
  const Tubes found = findTubes(meshAlong(course, false), {}).value();
  ASSERT_EQ(found.places.size(), 1u);
  EXPECT_NEAR(found.places[0].degreeByDiameter, 0.5, 0.01);
}

TEST(Tubes, roughOneIsWithinThreePoints) {
  const Course course{straight, [](double t) { return dip(t, 0.5, 0.5, 0.1); }};
  const Shape shape = tubeAlong(course, 150, true);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Tubes found = findTubes(perturbed(shape, 0.5, seed).mesh(), {}).value();
    ASSERT_EQ(found.places.size(), 1u);
    EXPECT_NEAR(found.places[0].degreeByDiameter, 0.5, 0.03);
  }
}

TEST(Tubes, referencesAreTheSides) {
  const Course course{straight, [](double t) { return (1.2 - 0.4 * t) * dip(t, 0.5, 0.5); }};
  const SurfaceMesh mesh = meshAlong(course, false);
  TubesOptions options;
  options.ends = {SurfacePoint::atVertex(Vertex{0}),
                  SurfacePoint::atVertex(Vertex{mesh.vertexCount() - 1})};
  const auto placeBy = [&](TubeReference reference) {
    options.reference = reference;
    const Tubes found = findTubes(mesh, options).value();
    EXPECT_EQ(found.places.size(), 1u);
    return found.places.at(0);
  };
  const TubePlace taper = placeBy(TubeReference::Taper);
  EXPECT_GT(taper.beforeDiameter, taper.beyondDiameter);
  EXPECT_NEAR(taper.reference, diameterOf(1), 0.01);
  EXPECT_EQ(placeBy(TubeReference::Before).reference, taper.beforeDiameter);
  EXPECT_EQ(placeBy(TubeReference::Beyond).reference, taper.beyondDiameter);
  EXPECT_EQ(placeBy(TubeReference::Mean).reference,
            (taper.beforeDiameter + taper.beyondDiameter) / 2);
}

/// Distance from a segment, in the plane of x and z.
double fromSegment(const Vec3& p, double ax, double az, double bx, double bz) {
  const double dx = bx - ax, dz = bz - az;
  const double t = std::clamp(((p.x - ax) * dx + (p.z - az) * dz) / (dx * dx + dz * dz), 0.0, 1.0);
  return std::hypot(p.x - ax - t * dx, p.y, p.z - az - t * dz);
}

TEST(Tubes, branchesMeet) {
  const auto f = [](const Vec3& p) {
    return std::min({fromSegment(p, 0, -8, 0, 0) - 1.2, fromSegment(p, 0, 0, -6, 6) - 0.9,
                     fromSegment(p, 0, 0, 6, 6) - 0.7});
  };
  const SurfaceMesh mesh = isosurface(f, 10, 60).mesh();
  const Tubes found = findTubes(mesh, {}).value();
  ASSERT_EQ(found.branches.size(), 3u);
  EXPECT_EQ(found.branches[0].parent, kNoIndex);
  EXPECT_EQ(found.branches[1].parent, 0u);
  EXPECT_EQ(found.branches[2].parent, 0u);
  EXPECT_FALSE(found.branches[0].ends);
  std::vector<double> medians;
  for (const TubeBranch& branch : found.branches) {
    medians.push_back(branch.median / 2);
    EXPECT_LT(branch.firstDistance, branch.lastDistance);
    if (branch.parent == kNoIndex) continue;
    EXPECT_GT(branch.firstDistance, found.branches[branch.parent].lastDistance);
  }
  std::sort(medians.begin(), medians.end());
  EXPECT_NEAR(medians[0], 0.7, 0.05);
  EXPECT_NEAR(medians[1], 0.9, 0.05);
  EXPECT_NEAR(medians[2], 1.2, 0.05);
  for (std::size_t i = 1; i < found.stations.size(); ++i) {
    EXPECT_GE(found.stations[i].branch, found.stations[i - 1].branch);
  }
}

TEST(Tubes, oneEndIsWhereTheyBegin) {
  for (const bool isCapped : {false, true}) {
    const SurfaceMesh mesh = meshAlong({straight, constant}, isCapped, 60);
    TubesOptions options;
    options.girth = false;
    for (const Index end : {Index{3}, 60 * kCorners + 3}) {
      options.ends = {SurfacePoint::atVertex(Vertex{end})};
      const Tubes found = findTubes(mesh, options).value();
      ASSERT_EQ(found.branches.size(), 1u);
      const bool isLow = found.stations.front().centre.z < found.stations.back().centre.z;
      EXPECT_EQ(isLow, end == 3);
    }
  }
}

TEST(Tubes, whatIsNoTubeIsSaid) {
  const auto reasonOf = [](const SurfaceMesh& mesh) {
    const Tubes found = findTubes(mesh, {}).value();
    EXPECT_TRUE(found.branches.empty());
    EXPECT_TRUE(found.stations.empty());
    EXPECT_EQ(found.others.size(), 1u);
    return found.others.at(0).reason;
  };
  EXPECT_EQ(reasonOf(icosphere(3).mesh()), NoTube::Blunt);
  EXPECT_EQ(reasonOf(box(1, 1, 1, 8, 8, 8).mesh()), NoTube::Blunt);
  EXPECT_EQ(reasonOf(tetrahedron().mesh()), NoTube::Blunt);
  EXPECT_EQ(reasonOf(torus(6, 1, 24, 12).mesh()), NoTube::Handle);
  EXPECT_EQ(reasonOf(box(20, 10, 0.5, 40, 20, 2).mesh()), NoTube::Flat);
  Shape triangle;
  triangle.add(0, 0, 0);
  triangle.add(1, 0, 0);
  triangle.add(0, 1, 0);
  triangle.face(0, 1, 2);
  EXPECT_EQ(reasonOf(triangle.mesh(OpenEdges::Boundary)), NoTube::Blunt);
}

TEST(Tubes, componentsAreMeasuredOneByOne) {
  const Shape one = tubeAlong({straight, constant}, 60, true);
  const Shape all =
      together(together(one, shifted(icosphere(2), 30, 0, 0)), shifted(one, 60, 0, 0));
  const Tubes found = findTubes(all.mesh(), {}).value();
  ASSERT_EQ(found.branches.size(), 2u);
  EXPECT_EQ(found.branches[0].component, 0u);
  EXPECT_EQ(found.branches[1].component, 2u);
  ASSERT_EQ(found.others.size(), 1u);
  EXPECT_EQ(found.others[0].component, 1u);
  EXPECT_EQ(found.stations.back().branch, 1u);
  EXPECT_EQ(found.branches[1].endStation, found.stations.size());
}

TEST(Tubes, sameForAnyNumberOfThreads) {
  const Course course{half, [](double t) { return dip(t, 0.5, 0.5); }};
  const SurfaceMesh mesh = meshAlong(course, true, 60);
  const Tubes one = findTubes(mesh, {}, {1, nullptr, {}}).value();
  const Tubes three = findTubes(mesh, {}, {3, nullptr, {}}).value();
  ASSERT_EQ(one.stations.size(), three.stations.size());
  for (std::size_t i = 0; i < one.stations.size(); ++i) {
    EXPECT_EQ(one.stations[i].area, three.stations[i].area);
    EXPECT_EQ(one.stations[i].centre.x, three.stations[i].centre.x);
    EXPECT_EQ(std::isnan(one.stations[i].girth), std::isnan(three.stations[i].girth));
  }
  ASSERT_EQ(one.places.size(), 1u);
  EXPECT_EQ(one.places[0].distance, three.places.at(0).distance);
}

TEST(Tubes, sameInAnyPositionAndSize) {
  const Course course{half, [](double t) { return dip(t, 0.4, 0.5); }};
  const Shape shape = tubeAlong(course, 100, false);
  const Tubes one = findTubes(shape.mesh(OpenEdges::Boundary), {}).value();
  const Tubes other = findTubes(moved(shape, 1e3, 1.1, 500).mesh(OpenEdges::Boundary), {}).value();
  ASSERT_EQ(one.places.size(), 1u);
  ASSERT_EQ(other.places.size(), 1u);
  EXPECT_NEAR(other.places[0].degreeByDiameter, one.places[0].degreeByDiameter, 1e-6);
  EXPECT_NEAR(other.places[0].distance / 1e3, one.places[0].distance, 1e-4);
}

TEST(Tubes, spacingIsThatOfStations) {
  const SurfaceMesh mesh = meshAlong({straight, constant}, false, 60);
  TubesOptions options;
  options.spacing = 0.5;
  options.girth = false;
  const Tubes found = findTubes(mesh, options).value();
  for (std::size_t i = 1; i < found.stations.size(); ++i) {
    EXPECT_NEAR(found.stations[i].distance - found.stations[i - 1].distance, 0.5, 1e-6);
    EXPECT_TRUE(std::isnan(found.stations[i].girth));
  }
}

TEST(Tubes, wrongOptionsAreErrors) {
  const SurfaceMesh mesh = meshAlong({straight, constant}, false, 20);
  const auto codeOf = [&](const TubesOptions& options) {
    return findTubes(mesh, options).error().code;
  };
  TubesOptions options;
  options.spacing = -1;
  EXPECT_EQ(codeOf(options), ErrorCode::InvalidOption);
  options.spacing = 1e-9;
  EXPECT_EQ(codeOf(options), ErrorCode::InvalidOption);
  options = {};
  options.leastDegree = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOf(options), ErrorCode::InvalidOption);
  options = {};
  options.ends = {SurfacePoint::atVertex(Vertex{mesh.vertexCount()})};
  EXPECT_EQ(codeOf(options), ErrorCode::VertexOutOfRange);
  const std::atomic<bool> stop{true};
  EXPECT_EQ(findTubes(mesh, {}, {1, &stop, {}}).error().code, ErrorCode::Cancelled);
}

TEST(Tubes, words) {
  EXPECT_EQ(toString(TubeChange::Narrowing), "narrowing");
  EXPECT_EQ(toString(TubeChange::Widening), "widening");
  EXPECT_EQ(toString(TubeReference::Beyond), "beyond");
  EXPECT_EQ(toString(NoTube::Handle), "handle");
  EXPECT_EQ(toString(NoTube::Coarse), "coarse");
}

}  // namespace
}  // namespace girth::test
