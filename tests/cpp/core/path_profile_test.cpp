// The girth along paths: tubes and cones of known girth, places in order, and bad input.
#include "girth/path_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "girth/geodesic_solver.h"
#include "lathe.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using Stations = std::vector<PathStation>;

std::vector<SurfacePoint> shortestPath(const SurfaceMesh& mesh, const SurfacePoint& from,
                                       const SurfacePoint& to) {
  return GeodesicSolver(mesh).path(from, to).value().points;
}

Stations along(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& path,
               const PathProfileOptions& options = {}) {
  const auto stations = girthAlong(mesh, path, options);
  EXPECT_TRUE(stations.ok()) << (stations.ok() ? "" : stations.error().text());
  return stations.ok() ? stations.value() : Stations{};
}

/// In order, from the first point to the last, each where its distance states, with the girth
/// there.
void expectConsistent(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& path,
                      const Stations& stations) {
  ASSERT_FALSE(stations.empty());
  EXPECT_EQ(stations.front().distance, 0);
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    length += norm(positionOf(mesh, path[i + 1]) - positionOf(mesh, path[i]));
  }
  EXPECT_NEAR(stations.back().distance, length, 1e-9 * length);
  GirthSolver solver(mesh);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const PathStation& station = stations[i];
    EXPECT_EQ(station.girth, solver.value(station.point).value().length);
    if (i == 0) continue;
    const double step = station.distance - stations[i - 1].distance;
    EXPECT_GT(step, 0);
    EXPECT_LE(norm(positionOf(mesh, station.point) - positionOf(mesh, stations[i - 1].point)),
              step + 1e-9 * length);
  }
}

TEST(PathProfile, ofATubeIsItsPerimeter) {
  constexpr Index kSides = 6, kRings = 10;
  const SurfaceMesh mesh = test::prism(test::regularPolygon(kSides, 1), 20, kRings).mesh();
  // Straight on along the edges, and round the tube.
  for (const Index turn : {0u, 2u}) {
    const auto path = shortestPath(mesh, SurfacePoint::atVertex(Vertex(3 * kSides)),
                                   SurfacePoint::atVertex(Vertex(7 * kSides + turn)));
    const Stations stations = along(mesh, path);
    expectConsistent(mesh, path, stations);
    EXPECT_GE(stations.size(), 100u);
    for (const PathStation& station : stations) {
      EXPECT_NEAR(station.girth, kSides, 1e-9);
      EXPECT_EQ(station.kind, LoopKind::Loop);
    }
  }
}

TEST(PathProfile, ofAConeGrowsWithTheDistanceFromItsApex) {
  constexpr Index kSides = 7;
  const double angle = 2.1;  // at the apex, of all faces: less than π
  const SurfaceMesh mesh = test::pyramid(kSides, angle, 8).mesh();
  const Vec3 apex = mesh.position(Vertex(0));
  // From ring 2 to ring 5, along an edge and across faces.
  for (const Index turn : {0u, 1u, 2u}) {
    const auto path = shortestPath(mesh, SurfacePoint::atVertex(Vertex(1 + kSides)),
                                   SurfacePoint::atVertex(Vertex(1 + 4 * kSides + turn)));
    const Stations stations = along(mesh, path, {37, true});
    expectConsistent(mesh, path, stations);
    for (const PathStation& station : stations) {
      const double distance = norm(positionOf(mesh, station.point) - apex);
      EXPECT_NEAR(station.girth, 2 * distance * std::sin(angle / 2), 1e-9);
    }
  }
}

TEST(PathProfile, samplesAndCrossings) {
  const SurfaceMesh mesh = test::box(1, 2, 3, 2, 2, 2).mesh();
  const SurfacePoint from = SurfacePoint::inFace(Face(0), {0.21, 0.33, 0.46});
  const SurfacePoint to = SurfacePoint::inFace(Face(mesh.faceCount() - 1), {0.2, 0.3, 0.5});
  const auto path = shortestPath(mesh, from, to);
  ASSERT_GT(path.size(), 3u);
  const Stations even = along(mesh, path, {11, false});
  expectConsistent(mesh, path, even);
  ASSERT_EQ(even.size(), 11u);
  for (std::size_t i = 0; i < even.size(); ++i) {
    EXPECT_NEAR(even[i].distance, even.back().distance * static_cast<double>(i) / 10, 1e-12);
  }
  const Stations crossings = along(mesh, path, {0, true});
  expectConsistent(mesh, path, crossings);
  EXPECT_EQ(crossings.size(), path.size());
  const Stations both = along(mesh, path, {11, true});
  expectConsistent(mesh, path, both);
  EXPECT_EQ(both.size(), even.size() + crossings.size() - 2);
  // A path of one point is one place, however many samples are wanted.
  EXPECT_EQ(along(mesh, {from}).size(), 1u);
  EXPECT_EQ(along(mesh, {from, from}, {5, false}).size(), 1u);
}

TEST(PathProfile, theLeastLiesBetweenStations) {
  // Along the edges of an hourglass, whose waist is passed after √(3² + 1²).
  const SurfaceMesh mesh = test::lathe({{0, 2}, {3, 1}, {7, 2.5}}, 12).mesh();
  const std::vector<SurfacePoint> ends{SurfacePoint::atVertex(Vertex(0)),
                                       SurfacePoint::atVertex(Vertex(24))};
  const auto path = shortestPathThrough(mesh, ends).value();
  const double waist = test::polygonLength(1, 12);
  for (const std::size_t samples : {4u, 7u, 50u}) {
    const auto stations = girthAlong(mesh, path, {samples, false}).value();
    const PathStation least = leastAlong(mesh, path, stations).value();
    EXPECT_NEAR(least.girth, waist, 1e-9 * waist);
    EXPECT_NEAR(least.distance, std::sqrt(10.0), 1e-8);
    EXPECT_EQ(least.kind, LoopKind::Loop);
  }
  EXPECT_FALSE(leastAlong(mesh, path, {}).ok());
}

TEST(PathProfile, pathsThroughPointsAreTheirPieces) {
  const SurfaceMesh mesh = test::perturbed(test::torus(4, 1, 9, 7), 0.1, 3).mesh();
  const std::vector<SurfacePoint> points{SurfacePoint::atVertex(Vertex(0)),
                                         SurfacePoint::inFace(Face(50), {0.2, 0.3, 0.5}),
                                         SurfacePoint::atVertex(Vertex(20))};
  std::vector<SurfacePoint> pieces = shortestPath(mesh, points[0], points[1]);
  const auto second = shortestPath(mesh, points[1], points[2]);
  pieces.insert(pieces.end(), second.begin(), second.end());
  const auto path = shortestPathThrough(mesh, points).value();
  ASSERT_EQ(path.size(), pieces.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(norm(positionOf(mesh, path[i]) - positionOf(mesh, pieces[i])), 0);
  }
  expectConsistent(mesh, path, along(mesh, path, {20, true}));
  // A point that is named twice is no detour.
  EXPECT_EQ(
      along(mesh, shortestPathThrough(mesh, std::vector{points[0], points[0]}).value()).size(), 1u);
  EXPECT_EQ(shortestPathThrough(mesh, std::vector{points[0]}).error().code, ErrorCode::Usage);
  EXPECT_EQ(
      shortestPathThrough(mesh, std::vector{points[0], SurfacePoint::atVertex(Vertex(99'999))})
          .error()
          .code,
      ErrorCode::VertexOutOfRange);
}

TEST(PathProfile, noPathLeadsToAnotherComponent) {
  const test::Shape box = test::box(1, 1, 1, 1, 1, 1);
  const Index first = box.vertexCount();
  const SurfaceMesh mesh = test::together(box, test::shifted(box, 5, 5, 5)).mesh();
  ASSERT_EQ(mesh.componentCount(), 2u);
  const SurfacePoint a = SurfacePoint::atVertex(Vertex(0)), b = SurfacePoint::atVertex(Vertex(1)),
                     c = SurfacePoint::atVertex(Vertex(first));
  const auto refused = shortestPathThrough(mesh, std::vector{a, b, c});
  EXPECT_EQ(refused.error().code, ErrorCode::InvalidPoint);
  EXPECT_EQ(refused.error().element, 2);
}

TEST(PathProfile, sameForAnyNumberOfThreads) {
  const SurfaceMesh mesh = test::perturbed(test::torus(4, 1, 9, 7), 0.1, 3).mesh();
  const auto path =
      shortestPath(mesh, SurfacePoint::atVertex(Vertex(0)), SurfacePoint::atVertex(Vertex(40)));
  const Stations one = girthAlong(mesh, path, {}, {1, nullptr, {}}).value();
  const Stations three = girthAlong(mesh, path, {}, {3, nullptr, {}}).value();
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].girth, three[i].girth);
}

TEST(PathProfile, badInput) {
  const SurfaceMesh mesh = test::box(1, 2, 3, 2, 2, 2).mesh();
  const SurfacePoint a = SurfacePoint::atVertex(Vertex(0));
  const std::vector<SurfacePoint> path =
      shortestPath(mesh, a, SurfacePoint::atVertex(Vertex(mesh.vertexCount() - 1)));
  const auto codeOf = [&](const std::vector<SurfacePoint>& points,
                          const PathProfileOptions& options) {
    return girthAlong(mesh, points, options).error().code;
  };
  EXPECT_EQ(codeOf({}, {}), ErrorCode::InvalidPoint);
  EXPECT_EQ(codeOf({a, SurfacePoint::atVertex(Vertex(99'999))}, {}), ErrorCode::InvalidPoint);
  EXPECT_EQ(girthAlong(mesh, std::vector{a, path.back()}).error().element, 1);
  EXPECT_EQ(codeOf({SurfacePoint::inFace(Face(0), {std::nan(""), 0, 1})}, {}),
            ErrorCode::InvalidPoint);
  EXPECT_EQ(codeOf(path, {1, true}), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(path, {0, false}), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(path, {static_cast<std::size_t>(-1), true}), ErrorCode::InvalidOption);
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(girthAlong(mesh, path, {}, {0, &cancel, {}}).error().code, ErrorCode::Cancelled);
  double last = 0;
  ExecutionContext context;
  context.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  EXPECT_TRUE(girthAlong(mesh, path, {}, context).ok());
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace girth
