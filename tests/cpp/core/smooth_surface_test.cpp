// Smoothing: wrinkles go, the shape stays.
#include "girth/smooth_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "girth/girth_field.h"
#include "girth/study/surface_changes.h"
#include "mesh/vector.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth {
namespace {

/// The root mean square of how far vertices are from the unit sphere about the origin.
double roughness(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Vertex v : mesh.vertices()) sum += std::pow(norm(mesh.position(v)) - 1, 2);
  return std::sqrt(sum / mesh.vertexCount());
}

TEST(SmoothSurface, TakesNoiseAwayAndLeavesTheSize) {
  const SurfaceMesh sphere = test::icosphere(4).mesh();
  const auto noisy = study::withNoise(sphere, 0.5, 3);
  ASSERT_TRUE(noisy.ok());
  const auto smooth = smoothSurface(noisy.value(), 3);
  ASSERT_TRUE(smooth.ok());
  EXPECT_LT(roughness(smooth.value()), 0.6 * roughness(noisy.value()));
  EXPECT_GT(noisy.value().area(), 1.05 * sphere.area());
  EXPECT_NEAR(smooth.value().area(), sphere.area(), 0.02 * sphere.area());
}

TEST(SmoothSurface, LeavesATubeAsThickAsItIs) {
  const SurfaceMesh tube = test::prism(test::regularPolygon(12, 0.5), 20, 40).mesh();
  const auto smooth = smoothSurface(tube, 10);
  ASSERT_TRUE(smooth.ok());
  const Vec3 middle{0, 0, 10};
  for (const Vertex v : tube.vertices()) {
    const Vec3 before = tube.position(v), after = smooth.value().position(v);
    if (std::fabs(before.z - middle.z) > 3) continue;
    EXPECT_NEAR(std::hypot(after.x, after.y), std::hypot(before.x, before.y), 0.02);
  }
}

TEST(SmoothSurface, WinsTheGirthBack) {
  const SurfaceMesh tube = test::prism(test::regularPolygon(16, 0.4), 12, 24).mesh();
  const auto noisy = study::withNoise(tube, 0.5, 1);
  ASSERT_TRUE(noisy.ok());
  const auto smooth = smoothSurface(noisy.value(), 3);
  ASSERT_TRUE(smooth.ok());
  const auto difference = [&, plain = girthField(tube)](const SurfaceMesh& mesh) {
    const GirthField field = girthField(mesh);
    double sum = 0;
    for (const Vertex v : mesh.vertices()) sum += std::fabs(field.values[v] - plain.values[v]);
    return sum / mesh.vertexCount();
  };
  EXPECT_LT(difference(smooth.value()), 0.5 * difference(noisy.value()));
}

TEST(SmoothSurface, BoundariesKeepToThemselves) {
  // A box without its lid, and rough: its rim stays in its plane.
  test::Shape tray = test::box(1, 1, 1, 6, 6, 6);
  std::vector<Index> open;
  for (std::size_t f = 0; f < tray.triangles.size(); f += 3) {
    const auto isLid = [&](Index v) { return tray.positions[3 * v + 2] == 1; };
    const auto* face = &tray.triangles[f];
    if (isLid(face[0]) && isLid(face[1]) && isLid(face[2])) continue;
    open.insert(open.end(), face, face + 3);
  }
  tray.triangles = open;
  tray = test::withoutLoneVertices(tray);
  for (std::size_t v = 0; v < tray.positions.size() / 3; ++v) {
    double& z = tray.positions[3 * v + 2];
    if (z != 1) z += v % 2 == 0 ? 0.05 : -0.05;
  }
  const auto smooth = smoothSurface(tray.mesh(OpenEdges::Boundary), 20);
  ASSERT_TRUE(smooth.ok());
  Index onRim = 0;
  for (const Vertex v : smooth.value().vertices()) {
    if (!smooth.value().isBoundary(v)) continue;
    EXPECT_EQ(smooth.value().position(v).z, 1);
    ++onRim;
  }
  EXPECT_EQ(onRim, 24u);
}

TEST(SmoothSurface, NoStepsAreTheSurfaceItself) {
  const SurfaceMesh mesh = test::perturbed(test::torus(2, 0.7, 20, 10), 0.2, 1).mesh();
  const auto same = smoothSurface(mesh, 0);
  ASSERT_TRUE(same.ok());
  EXPECT_EQ(same.value().vertexCount(), mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(same.value().position(v).x, mesh.position(v).x);
    EXPECT_EQ(same.value().position(v).y, mesh.position(v).y);
    EXPECT_EQ(same.value().position(v).z, mesh.position(v).z);
  }
  for (const Face f : mesh.faces()) {
    EXPECT_EQ(same.value().faceVertices(f), mesh.faceVertices(f));
  }
}

TEST(SmoothSurface, GoesWithScale) {
  const test::Shape shape = test::perturbed(test::torus(2, 0.7, 20, 10), 0.2, 1);
  test::Shape large = shape;
  for (double& x : large.positions) x *= 1024;
  const auto small = smoothSurface(shape.mesh(), 5), scaled = smoothSurface(large.mesh(), 5);
  ASSERT_TRUE(small.ok() && scaled.ok());
  for (const Vertex v : small.value().vertices()) {
    EXPECT_EQ(scaled.value().position(v).x, 1024 * small.value().position(v).x);
  }
}

TEST(SmoothSurface, SaysHowFarItIsAndStops) {
  const SurfaceMesh mesh = test::torus(2, 0.7, 20, 10).mesh();
  std::vector<double> shares;
  std::atomic<bool> cancel{false};
  const ExecutionContext context{1, &cancel, [&](double share) { shares.push_back(share); }};
  ASSERT_TRUE(smoothSurface(mesh, 4, context).ok());
  EXPECT_EQ(shares, (std::vector<double>{0.25, 0.5, 0.75, 1}));
  cancel = true;
  EXPECT_EQ(smoothSurface(mesh, 4, context).error().code, ErrorCode::Cancelled);
}

TEST(SmoothSurface, Refuses) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  EXPECT_TRUE(smoothSurface(mesh, kMostSmoothing).ok());
  EXPECT_EQ(smoothSurface(mesh, kMostSmoothing + 1).error().code, ErrorCode::InvalidOption);
  // A sheet folded in two: up and down along its boundary, all that it has across the fold goes.
  test::Shape sheet;
  sheet.positions = {1, 1, 0, 0, -1, 0, -1, 1, 0, 0, -1, 0};
  sheet.triangles = {0, 1, 2, 0, 2, 3};
  const auto smooth = smoothSurface(sheet.mesh(OpenEdges::Boundary), 1);
  ASSERT_FALSE(smooth.ok());
  EXPECT_EQ(smooth.error().code, ErrorCode::DegenerateFace);
  EXPECT_FALSE(smooth.error().hint.empty());
}

}  // namespace
}  // namespace girth
