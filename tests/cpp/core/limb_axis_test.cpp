// Axes of limbs: tubes and cones whose loops are known in closed form.
#include "girth/limb_axis.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "girth/girth_field.h"
#include "girth/limbs.h"
#include "girth/tips.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

/// The limb that the only tip, or the first one, ends.
Limb limbOf(const SurfaceMesh& mesh, const Vertex apex, Index stations) {
  Tip tip;
  tip.apex = apex;
  return findLimbs(mesh, girthField(mesh).values, std::span(&tip, 1), {stations})
      .value()
      .limbs.at(0);
}

TEST(LimbAxis, ofATubeIsItsAxisOfRevolution) {
  // A long regular tube: away from its ends every loop is the perimeter, flat, round its axis.
  constexpr Index kSides = 8, kRings = 24;
  constexpr double kLength = 24;
  const SurfaceMesh mesh = test::prism(test::regularPolygon(kSides, 1), kLength, kRings).mesh();
  // The middle of the cap at 0.
  Vertex apex;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (p.z == 0 && std::hypot(p.x, p.y) < 1e-9) apex = v;
  }
  const Limb limb = limbOf(mesh, apex, 48);
  const auto found = limbAxis(mesh, limb.profile);
  ASSERT_TRUE(found.ok()) << found.error().text();
  const std::vector<AxisStation>& axis = found.value();
  ASSERT_GT(axis.size(), 20u);
  const double area = 0.25 * kSides / std::tan(kPi / kSides);
  std::size_t whole = 0;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const AxisStation& station = axis[i];
    if (station.centre.z < 2 || station.centre.z > kLength - 5) continue;
    ++whole;
    EXPECT_NEAR(station.girth, kSides, 1e-9);
    EXPECT_NEAR(station.area, area, 1e-9);
    EXPECT_NEAR(station.centre.x, 0, 1e-9);
    EXPECT_NEAR(station.centre.y, 0, 1e-9);
    for (const SurfacePoint& point : station.points) {
      EXPECT_NEAR(positionOf(mesh, point).z, station.centre.z, 1e-9);
    }
    // Along the axis as far as its points are apart.
    EXPECT_NEAR(station.distance - axis[i - 1].distance, norm(station.centre - axis[i - 1].centre),
                1e-12);
  }
  EXPECT_GT(whole, 10u);
  // No way back: it is as long as its ends are apart.
  EXPECT_NEAR(axis.back().distance, norm(axis.back().centre - axis.front().centre), 0.05 * kLength);
}

TEST(LimbAxis, ofAConeGrowsWithTheDistanceFromItsApex) {
  // Cut open, a cone of angle a is flat, and the loop at distance t from the apex the straight line
  // across: 2 t sin(a / 2).
  constexpr double kAngle = 0.5;
  constexpr Index kSides = 9;
  const SurfaceMesh mesh = test::pyramid(kSides, kAngle, 12).mesh();
  const Limb limb = limbOf(mesh, Vertex(0), 32);
  const auto axis = limbAxis(mesh, limb.profile).value();
  ASSERT_GT(axis.size(), 10u);
  const Vec3 apex = mesh.position(Vertex(0));
  // The direction of the axis, from the apex down to the middle of the base.
  Vec3 base;
  for (const Vertex v : mesh.vertices()) base = base + mesh.position(v);
  const Vec3 mean = (1.0 / mesh.vertexCount()) * base;
  const Vec3 down = (1 / norm(mean - apex)) * (mean - apex);
  std::size_t looked = 0;
  for (const AxisStation& station : axis) {
    const double t = norm(positionOf(mesh, station.points.front()) - apex);
    if (t > 0.8) continue;  // over the rim at the base
    ++looked;
    EXPECT_NEAR(station.girth, 2 * t * std::sin(kAngle / 2), 1e-9);
    // Similar loops have similar middles: off the axis by a share of t that depends on the place of
    // the base alone, and no more than the cone is wide.
    const Vec3 middle = station.centre - apex;
    const double depth = dot(middle, down);
    EXPECT_GT(depth, 0.9 * t * std::cos(kAngle / 2) * std::cos(kAngle / (2 * kPi)));
    EXPECT_LT(norm(middle - depth * down), t * kAngle / (2 * kPi));
  }
  EXPECT_GT(looked, 8u);
  for (std::size_t i = 1; i < axis.size(); ++i) EXPECT_GT(axis[i].distance, axis[i - 1].distance);
}

TEST(LimbAxis, ofStationsWithoutALoopHasNoPoint) {
  const SurfaceMesh mesh = test::prism(test::regularPolygon(6, 1), 20, 10).mesh();
  GirthProfile profile(3);
  for (GirthStation& station : profile) {
    station.least = std::numeric_limits<double>::quiet_NaN();
  }
  EXPECT_TRUE(limbAxis(mesh, profile).value().empty());
  EXPECT_TRUE(limbAxis(mesh, {}).value().empty());
  // Twice the same place is one point.
  profile[0].least = profile[2].least = 6;
  profile[0].place = profile[2].place = SurfacePoint::atVertex(Vertex(5 * 6));
  EXPECT_EQ(limbAxis(mesh, profile).value().size(), 1u);
}

TEST(LimbAxis, sameForAnyNumberOfThreadsAndBadInput) {
  const SurfaceMesh mesh = test::prism(test::regularPolygon(6, 1), 20, 20).mesh();
  GirthProfile profile;
  for (Index ring = 4; ring < 17; ++ring) {
    profile.push_back({1.0 * ring, 6, 6, 6, SurfacePoint::atVertex(Vertex(ring * 6 + 1))});
  }
  const auto one = limbAxis(mesh, profile, {1, nullptr, {}}).value();
  const auto three = limbAxis(mesh, profile, {3, nullptr, {}}).value();
  ASSERT_EQ(one.size(), profile.size());
  // Straight on from ring to ring.
  EXPECT_NEAR(one.back().distance, 12, 1e-9);
  EXPECT_NEAR(one.back().along, 4 + 12, 1e-9);
  ASSERT_EQ(three.size(), one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].girth, three[i].girth);
    EXPECT_EQ(one[i].distance, three[i].distance);
    EXPECT_EQ(one[i].centre.z, three[i].centre.z);
  }
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(limbAxis(mesh, profile, {1, &cancel, {}}).error().code, ErrorCode::Cancelled);
  profile[0].place = SurfacePoint::atVertex(Vertex(mesh.vertexCount()));
  EXPECT_EQ(limbAxis(mesh, profile).error().code, ErrorCode::VertexOutOfRange);
}

}  // namespace
}  // namespace girth
