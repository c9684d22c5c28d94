// Necks: surfaces of revolution with waists of known length and prominence, bands, tori,
// boundaries, random surfaces, and bad input.
#include "girth/necks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "girth/girth_field.h"
#include "lathe.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using test::lathe;
using test::polygonLength;
using test::Ring;
using test::Shape;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Necks necksOf(const SurfaceMesh& mesh, const NeckOptions& options = {}) {
  auto necks = findNecks(mesh, girthField(mesh).values, options);
  EXPECT_TRUE(necks.ok()) << (necks.ok() ? "" : necks.error().message);
  return necks.ok() ? std::move(necks).value() : Necks{};
}

double polylineLength(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    length += norm(positionOf(mesh, points[i + 1]) - positionOf(mesh, points[i]));
  }
  return length;
}

/// Checks rules that must hold for every neck.
void expectConsistent(const SurfaceMesh& mesh, const Necks& necks) {
  EXPECT_EQ(necks.unresolved, 0u);
  double shortest = kInfinity;
  for (const Neck& neck : necks.necks) shortest = std::min(shortest, neck.length);
  EXPECT_DOUBLE_EQ(necks.suggestedProminence, necks.necks.empty() ? 0 : shortest / 20);
  GirthSolver solver(mesh);
  for (const Neck& neck : necks.necks) {
    ASSERT_GE(neck.points.size(), 4u);
    EXPECT_EQ(norm(positionOf(mesh, neck.points.front()) - positionOf(mesh, neck.points.back())),
              0);
    EXPECT_NEAR(polylineLength(mesh, neck.points), neck.length, 1e-9 * neck.length);
    EXPECT_GE(neck.prominence, 0);
    EXPECT_GE(neck.width, 0);
    EXPECT_FALSE(neck.vertices.empty());
    EXPECT_TRUE(std::is_sorted(neck.vertices.begin(), neck.vertices.end()));
    EXPECT_LE(neck.area, neck.length * neck.length / (4 * kPi) * (1 + 1e-9));
    ASSERT_FALSE(neck.sides.empty());
    double area = 0;
    for (const CurveSide& side : neck.sides) area += side.area;
    if (mesh.componentCount() == 1) {
      EXPECT_NEAR(area, mesh.area(), 1e-9 * area);
    }
    if (!neck.measuresGirth) continue;
    for (const Vertex v : neck.vertices) {
      const GirthLoop loop = solver.loop(v).value();
      EXPECT_NEAR(loop.length, neck.length, 1e-9 * neck.length);
      EXPECT_GE(loop.angle, kPi - 1e-6) << v;
    }
    // From a point between vertices too, the girth is the neck.
    for (const SurfacePoint& point : neck.points) {
      EXPECT_LE(solver.value(point).value().length, neck.length * (1 + 1e-9));
    }
  }
}

/// Every vertex at which the loop of the girth is a closed geodesic, and stops there, lies on a
/// neck of that length.
void expectAllFound(const SurfaceMesh& mesh, const Necks& necks) {
  GirthSolver solver(mesh);
  for (const Vertex v : mesh.vertices()) {
    const GirthLoop loop = solver.loop(v).value();
    // With an angle of more than π, here on the smaller side, the loop cannot be moved off.
    if (loop.kind != LoopKind::Loop || loop.angle < kPi + 1e-6) continue;
    const bool isFound = std::any_of(necks.necks.begin(), necks.necks.end(), [&](const Neck& neck) {
      return std::fabs(neck.length - loop.length) <= 1e-9 * loop.length &&
             std::binary_search(neck.vertices.begin(), neck.vertices.end(), v);
    });
    EXPECT_TRUE(isFound) << "vertex " << v << ", length " << loop.length;
  }
}

/// The girth at the middle of a belly's side as far as it depends on the frustum between the belly
/// and a narrower ring, which is a part of a pyramid: the loop is straight in the unfolded pyramid.
double girthOverFrustum(const Ring& belly, const Ring& waist, Index sides) {
  const double slope = (belly.z - waist.z) / (belly.radius - waist.radius);
  const double apexDistance = belly.radius * std::sqrt(1 + slope * slope);
  const double half = std::asin(belly.radius * std::sin(kPi / sides) / apexDistance);
  const double loop = 2 * apexDistance * std::cos(half) * std::sin(sides * half);
  // It stays within the frustum.
  EXPECT_GT(apexDistance * std::cos(half) * std::cos(sides * half),
            waist.radius * std::sqrt(1 + slope * slope));
  return loop;
}

/// Bellies and waists in turns. Both slopes of a belly are the same, so that the girth is greatest
/// on its ring.
const std::vector<Ring> kWaists{{0, 1.8}, {4, 1},      {8.8, 2.2}, {14.8, 0.7},
                                {20, 2},  {23.2, 1.2}, {25, 1.9}};

TEST(Necks, waistsOfKnownLengthAndProminence) {
  constexpr Index kSides = 8;
  const std::vector<Ring>& rings = kWaists;
  const SurfaceMesh mesh = lathe(rings, kSides).mesh();
  const Necks found = necksOf(mesh);
  expectConsistent(mesh, found);
  expectAllFound(mesh, found);
  ASSERT_EQ(found.necks.size(), 3u);
  const auto height = [&](std::size_t belly) {
    return std::min(girthOverFrustum(rings[belly], rings[belly - 1], kSides),
                    girthOverFrustum(rings[belly], rings[belly + 1], kSides));
  };
  // The narrowest first: from it no narrower one can be reached. The girth is least where a belly's
  // side has its middle, and not at a vertex.
  struct Expected {
    std::size_t ring;
    double prominence;
  };
  std::vector<Expected> expected{{1, height(2) - polygonLength(1, kSides)},
                                 {5, height(4) - polygonLength(1.2, kSides)}};
  std::sort(expected.begin(), expected.end(),
            [](const Expected& a, const Expected& b) { return a.prominence > b.prominence; });
  expected.insert(expected.begin(), {3, kInfinity});
  for (std::size_t i = 0; i < 3; ++i) {
    const Neck& neck = found.necks[i];
    const Ring& ring = rings[expected[i].ring];
    EXPECT_NEAR(neck.length, polygonLength(ring.radius, kSides), 1e-9 * neck.length);
    if (i == 0) {
      EXPECT_EQ(neck.prominence, kInfinity);
    } else {
      EXPECT_NEAR(neck.prominence, expected[i].prominence, 1e-9);
    }
    EXPECT_EQ(neck.width, 0);
    EXPECT_EQ(neck.vertices.size(), kSides);
    EXPECT_EQ(neck.vertices[0], expected[i].ring * kSides);
    EXPECT_TRUE(neck.measuresGirth);
    EXPECT_FALSE(neck.touchesBoundary);
    EXPECT_LT(norm(neck.centre - Vec3{0, 0, ring.z}), 1e-9);
    EXPECT_NEAR(std::fabs(neck.normal.z), 1, 1e-9);
    EXPECT_NEAR(neck.area, kSides / 2.0 * ring.radius * ring.radius * std::sin(2 * kPi / kSides),
                1e-9);
    EXPECT_LT(neck.radius, ring.radius);
    EXPECT_GT(neck.radius, ring.radius * std::cos(kPi / kSides));
  }
}

/// The greatest girth on the way from one waist over a belly to another, half-way between corners.
double greatestGirth(const SurfaceMesh& mesh, const std::vector<Ring>& rings, Index sides,
                     std::size_t from, std::size_t to) {
  GirthSolver solver(mesh);
  double greatest = 0;
  for (std::size_t ring = from; ring < to; ++ring) {
    for (int i = 0; i <= 100; ++i) {
      // In the trapezoid between two rings, whose faces are its two halves.
      const double t = i / 100.0, ratio = rings[ring + 1].radius / rings[ring].radius;
      const auto face = Face(static_cast<Index>(2 * ring * sides));
      const SurfacePoint point =
          t * (1 + ratio) <= 1
              ? SurfacePoint::inFace(face, {(1 - t + ratio * t) / 2, (1 - t - ratio * t) / 2, t})
              : SurfacePoint::inFace(Face(face + 1),
                                     {1 - t, (t + (1 - t) / ratio) / 2, (t - (1 - t) / ratio) / 2});
      greatest = std::max(greatest, solver.value(point).value().length);
    }
  }
  return greatest;
}

TEST(Necks, theGirthIsGreatestWithinFaces) {
  // Beside a belly with two slopes.
  constexpr Index kSides = 7;
  const std::vector<Ring> rings{{0, 1.8}, {4, 1}, {8, 2.2}, {12, 0.7}, {16, 2}};
  const SurfaceMesh mesh = lathe(rings, kSides).mesh();
  const Necks found = necksOf(mesh);
  ASSERT_EQ(found.necks.size(), 2u);
  const Neck& neck = found.necks[1];
  EXPECT_NEAR(neck.length + neck.prominence, greatestGirth(mesh, rings, kSides, 1, 3),
              1e-2 * neck.length);
}

TEST(Necks, ofAtLeastAProminence) {
  const SurfaceMesh mesh = lathe(kWaists, 6).mesh();
  const Necks all = necksOf(mesh);
  ASSERT_EQ(all.necks.size(), 3u);
  EXPECT_EQ(necksOf(mesh, {all.necks[1].prominence}).necks.size(), 2u);
  EXPECT_EQ(necksOf(mesh, {all.necks[1].prominence * (1 + 1e-9)}).necks.size(), 1u);
  EXPECT_EQ(necksOf(mesh, {kInfinity}).necks.size(), 1u);
}

TEST(Necks, aBarIsOneNeckAndItsMiddleIsGiven) {
  constexpr Index kSides = 5;
  const SurfaceMesh mesh =
      lathe({{0, 0.5}, {1, 2}, {3, 1}, {5.5, 1}, {7, 1}, {9, 2}, {10, 0.5}}, kSides).mesh();
  const Necks found = necksOf(mesh);
  expectConsistent(mesh, found);
  ASSERT_EQ(found.necks.size(), 1u);
  const Neck& neck = found.necks[0];
  EXPECT_NEAR(neck.length, polygonLength(1, kSides), 1e-9);
  EXPECT_NEAR(neck.width, 4, 1e-9);
  EXPECT_EQ(neck.vertices.size(), 2 * kSides);
  for (const SurfacePoint& point : neck.points) EXPECT_NEAR(positionOf(mesh, point).z, 5, 1e-9);
}

TEST(Necks, noneIsAnAnswer) {
  // Round things, a box, and a prism, whose loops slip off over the edges of its ends.
  for (const Shape& shape : {test::octasphere(2), test::box(1, 2, 3, 2, 2, 2),
                             test::prism(test::regularPolygon(6, 1), 5, 4), test::tetrahedron()}) {
    EXPECT_TRUE(necksOf(shape.mesh()).necks.empty());
  }
}

TEST(Necks, meridiansOfATorusAreNecksWithoutProminence) {
  constexpr Index kAround = 7, kAcross = 6;
  const SurfaceMesh mesh = test::torus(4, 1, kAround, kAcross).mesh();
  const Necks found = necksOf(mesh);
  expectConsistent(mesh, found);
  expectAllFound(mesh, found);
  ASSERT_EQ(found.necks.size(), kAround);
  for (const Neck& neck : found.necks) {
    EXPECT_NEAR(neck.length, found.necks[0].length, 1e-9);
    EXPECT_GT(neck.width, 0.1);
    EXPECT_EQ(neck.sides.size(), 1u);
  }
  EXPECT_EQ(found.necks[0].prominence, kInfinity);
  // Two neighbours have their innermost vertex in common.
  for (std::size_t i = 1; i < kAround; ++i) EXPECT_NEAR(found.necks[i].prominence, 0, 1e-9);
}

TEST(Necks, aProminenceOfLessThanAThousandthIsNone) {
  // Rings of nearly the same length, one behind the other.
  constexpr Index kRings = 12;
  constexpr double kRise = 1e-4;
  std::vector<Ring> rings;
  for (Index i = 0; i < kRings; ++i) {
    rings.push_back({2.0 * i, 1 + (i % 2 == 0 ? 0 : kRise) + (i == 6 ? 0.05 : 0)});
  }
  rings.front().radius = rings.back().radius = 1.5;
  const SurfaceMesh mesh = lathe(rings, 8).mesh();
  const Necks found = necksOf(mesh);
  expectConsistent(mesh, found);
  // On both sides of the ring that stands out, and of several there one is as good as another.
  std::vector<double> prominences;
  for (const Neck& neck : found.necks) {
    if (neck.prominence > 0) prominences.push_back(neck.prominence / neck.length);
  }
  ASSERT_EQ(prominences.size(), 2u);
  EXPECT_EQ(prominences[0], kInfinity);
  EXPECT_NEAR(prominences[1], 0.05, 0.011);
  EXPECT_EQ(found.necks.size(), 4u);
}

TEST(Necks, longerThanTheGirthBesideAThinnerPart) {
  // A thin hole: round the ring's inside the way is shorter than round its tube, whose loops are
  // necks as well.
  const SurfaceMesh mesh = test::torus(1.3, 1, 12, 12).mesh();
  const Necks found = necksOf(mesh);
  expectConsistent(mesh, found);
  expectAllFound(mesh, found);
  ASSERT_GE(found.necks.size(), 2u);
  EXPECT_NEAR(found.necks[0].length, polygonLength(0.3, 12), 1e-9);
  EXPECT_EQ(found.necks[0].prominence, kInfinity);
  EXPECT_FALSE(std::all_of(found.necks.begin(), found.necks.end(),
                           [](const Neck& neck) { return neck.measuresGirth; }));
}

TEST(Necks, boundariesAndComponents) {
  // An open hourglass, and a funnel, whose narrow rim is a neck.
  Shape shape = lathe({{0, 2}, {3, 1}, {6, 2}}, 6, false);
  const Shape funnel = lathe({{10, 0.5}, {13, 2}}, 6, false);
  const Index before = shape.vertexCount();
  for (Index v = 0; v < funnel.vertexCount(); ++v) {
    shape.add(funnel.positions[3 * v], funnel.positions[3 * v + 1], funnel.positions[3 * v + 2]);
  }
  for (const Index v : funnel.triangles) shape.triangles.push_back(before + v);
  const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
  const Necks found = necksOf(mesh);
  expectConsistent(mesh, found);
  ASSERT_EQ(found.necks.size(), 2u);
  for (const Neck& neck : found.necks) {
    EXPECT_EQ(neck.prominence, kInfinity);  // each the narrowest of its component
    const bool isFunnel = neck.vertices[0] >= before;
    EXPECT_EQ(neck.touchesBoundary, isFunnel);
    EXPECT_NEAR(neck.length, polygonLength(isFunnel ? 0.5 : 1, 6), 1e-9);
  }
}

TEST(Necks, ofAnOpenTubeAreItsWholeLength) {
  const SurfaceMesh mesh =
      lathe({{0, 1}, {1, 1}, {2.5, 1}, {4, 1}}, 6, false).mesh(OpenEdges::Boundary);
  const Necks found = necksOf(mesh);
  expectConsistent(mesh, found);
  ASSERT_EQ(found.necks.size(), 1u);
  EXPECT_NEAR(found.necks[0].width, 4, 1e-9);
  EXPECT_TRUE(found.necks[0].touchesBoundary);
}

TEST(Necks, ofUnevenSurfaces) {
  const std::vector<Ring> rings{{0, 1}, {1, 2}, {2.5, 1}, {4, 2}, {5, 0.8}, {6.5, 2}, {7, 1}};
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Shape shape = test::perturbed(test::subdivided(lathe(rings, 6)), 0.1, seed);
    const SurfaceMesh mesh = shape.mesh();
    const Necks found = necksOf(mesh);
    expectConsistent(mesh, found);
    expectAllFound(mesh, found);
    EXPECT_GE(found.necks.size(), 2u);
    // Necks stay in any numbering, and at any scale.
    std::vector<Index> number;
    const SurfaceMesh other = test::moved(test::relabelled(shape, seed, number), 3, 0.4, 2).mesh();
    const Necks again = necksOf(other);
    ASSERT_EQ(again.necks.size(), found.necks.size());
    for (std::size_t i = 0; i < found.necks.size(); ++i) {
      const Neck &a = found.necks[i], &b = again.necks[i];
      EXPECT_NEAR(b.length, 3 * a.length, 1e-9 * b.length);
      EXPECT_EQ(a.vertices.size(), b.vertices.size());
      if (a.prominence == kInfinity) continue;
      EXPECT_NEAR(b.prominence, 3 * a.prominence, 2e-2 * b.length);
    }
  }
}

TEST(Necks, sameForAnyNumberOfThreads) {
  const Shape shape = test::perturbed(lathe({{0, 1}, {1, 2}, {3, 1}, {5, 2}, {6, 1}}, 9), 0.1, 5);
  const SurfaceMesh mesh = shape.mesh();
  const std::vector<double> girth = girthField(mesh).values;
  const Necks one = findNecks(mesh, girth, {}, {1, nullptr, {}}).value();
  const Necks three = findNecks(mesh, girth, {}, {3, nullptr, {}}).value();
  ASSERT_EQ(one.necks.size(), three.necks.size());
  for (std::size_t i = 0; i < one.necks.size(); ++i) {
    EXPECT_EQ(one.necks[i].length, three.necks[i].length);
    EXPECT_EQ(one.necks[i].prominence, three.necks[i].prominence);
    EXPECT_EQ(one.necks[i].vertices, three.necks[i].vertices);
  }
}

TEST(Necks, areCancelledAtAnyTime) {
  const std::vector<Ring> rings{{0, 1}, {1, 2}, {2.5, 1}, {4, 2}, {5, 0.8}, {6.5, 2}, {7, 1}};
  const SurfaceMesh mesh = test::perturbed(test::subdivided(lathe(rings, 6)), 0.1, 1).mesh();
  const std::vector<double> girth = girthField(mesh).values;
  // While loops are drawn tight, and while prominences are searched for.
  for (const double share : {0.0, 0.3, 0.81}) {
    std::atomic<bool> cancel{false};
    ExecutionContext context{2, &cancel, {}};
    context.onProgress = [&](double fraction) {
      if (fraction >= share) cancel = true;
    };
    const auto found = findNecks(mesh, girth, {}, context);
    ASSERT_FALSE(found.ok()) << share;
    EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
  }
}

TEST(Necks, badInput) {
  const SurfaceMesh mesh = lathe({{0, 1}, {1, 2}, {3, 1}, {5, 2}, {6, 1}}, 5).mesh();
  const std::vector<double> girth = girthField(mesh).values;
  EXPECT_EQ(findNecks(mesh, std::vector<double>(3)).error().code, ErrorCode::Usage);
  for (const double prominence : {-1.0, -kInfinity, std::nan("")}) {
    EXPECT_EQ(findNecks(mesh, girth, {prominence}).error().code, ErrorCode::InvalidOption);
  }
  EXPECT_EQ(findNecks(mesh, girth, {0}).value().necks.size(), 1u);
  // Without values there are no loops.
  const std::vector<double> none(mesh.vertexCount(), std::nan(""));
  EXPECT_TRUE(findNecks(mesh, none).value().necks.empty());
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(findNecks(mesh, girth, {}, {0, &cancel, {}}).error().code, ErrorCode::Cancelled);
  double last = 0;
  ExecutionContext context;
  context.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  EXPECT_TRUE(findNecks(mesh, girth, {}, context).ok());
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace girth
