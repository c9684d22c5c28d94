// The medial thickness: shapes of known thickness, edges sharp and blunt, and bad input.
#include "girth/thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "descriptors/facing_surface.h"
#include "girth/shape_diameter.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Shape;

constexpr double kNever = std::numeric_limits<double>::infinity();

ThicknessField thicknessOf(const SurfaceMesh& mesh, const ThicknessOptions& options = {}) {
  auto field = medialThickness(mesh, options);
  EXPECT_TRUE(field.ok());
  return field.ok() ? std::move(field).value() : ThicknessField{};
}

/// The least thickness within the faces.
double leastInFaces(const SurfaceMesh& mesh, const ThicknessOptions& options = {}) {
  const FacingSurface surface(mesh, options);
  double least = kNever;
  for (const Face f : mesh.faces()) least = std::min(least, surface.inFace(f, least).diameter);
  return least;
}

double leastOf(const std::vector<double>& values) {
  double least = kNever;
  for (const double value : values) {
    if (value < least) least = value;
  }
  return least;
}

/// The triangle (0, 0), (length, 0), (length, length · tan angle), drawn out along z.
Shape wedge(double angle, double length, double width) {
  return test::prism({0, 0, length, 0, length, length * std::tan(angle)}, width, 1);
}

TEST(MedialThickness, OfPlatesIsExactEverywhere) {
  for (const double t : {0.01, 0.7, 3.0}) {
    for (const Shape& shape : {test::box(20, 20, t, 20, 20, 1), test::box(20, 20, t, 1, 1, 1),
                               test::moved(test::box(20, 20, t, 3, 7, 1), 1, 0.7, 5)}) {
      const SurfaceMesh mesh = shape.mesh();
      for (const double value : thicknessOf(mesh).values) EXPECT_NEAR(value, t, 1e-12);
      EXPECT_NEAR(leastInFaces(mesh), t, 1e-12);
    }
  }
}

TEST(MedialThickness, OfADiscIsNeverAboveTheTruth) {
  const SurfaceMesh mesh = test::prism(test::regularPolygon(64, 0.5), 0.7, 1).mesh();
  const double inFaces = leastInFaces(mesh);
  EXPECT_NEAR(inFaces, 0.7, 1e-12);
  EXPECT_NEAR(leastOf(thicknessOf(mesh).values), 0.7, 1e-12);
}

TEST(MedialThickness, OfACubeIsItsWidthAtItsEdgesToo) {
  for (const Index cells : {1u, 5u}) {
    const SurfaceMesh mesh = test::box(10, 10, 10, cells, cells, cells).mesh();
    for (const double value : thicknessOf(mesh).values) EXPECT_NEAR(value, 10, 1e-12);
    EXPECT_NEAR(leastInFaces(mesh), 10, 1e-12);
  }
}

TEST(MedialThickness, OfAWedgeFallsToNothingAtItsEdge) {
  const double angle = 0.2;
  const SurfaceMesh mesh = test::subdivided(test::subdivided(wedge(angle, 10, 10))).mesh();
  const ThicknessField field = thicknessOf(mesh);
  Index onSides = 0, atTip = 0;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    const double s = std::hypot(p.x, p.y);
    if (p.x < 1e-9) {
      EXPECT_EQ(field.values[v], 0);
      ++atTip;
    } else if (p.y < 1e-9 && s < 9 * std::cos(angle)) {
      // On the side y = 0, also at the caps, where it meets them squarely.
      EXPECT_NEAR(field.values[v], 2 * s * std::tan(angle / 2), 1e-12);
      ++onSides;
    }
  }
  EXPECT_GE(atTip, 5u);
  EXPECT_GE(onSides, 10u);
  EXPECT_EQ(leastInFaces(mesh), 0);
}

TEST(MedialThickness, KnowsSharpEdgesFromBluntOnes) {
  // Regular prisms: at an angle of 60° faces face each other, at 90° and more they do not.
  EXPECT_EQ(leastOf(thicknessOf(test::prism(test::regularPolygon(3, 5), 20, 4).mesh()).values), 0);
  const auto least = [](Index sides, const ThicknessOptions& options) {
    return leastInFaces(test::prism(test::regularPolygon(sides, 5), 20, 4).mesh(), options);
  };
  EXPECT_EQ(least(3, {}), 0);
  EXPECT_NEAR(least(4, {}), 5, 1e-12);
  // Sides of a hexagon two apart lie at 60°, beyond the one between: too small, never too large.
  EXPECT_NEAR(least(6, {}), 10 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(least(6, {1, ThicknessSide::Inside}), 5 * std::sqrt(3.0), 1e-12);
  // With a smaller angle nothing within the section faces a side of the triangle; its caps do.
  EXPECT_NEAR(least(3, {kPi / 4, ThicknessSide::Inside}), 20, 1e-12);
  // A tetrahedron's edges have 70.5°.
  EXPECT_EQ(leastOf(thicknessOf(test::tetrahedron().mesh()).values), 0);
  EXPECT_EQ(thicknessOf(test::tetrahedron().mesh(), {1.2, {}}).withoutValue, 4u);
}

TEST(MedialThickness, OfASphere) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  for (const double value : thicknessOf(mesh).values) EXPECT_NEAR(value, 2, 2e-3);
  EXPECT_NEAR(leastInFaces(mesh), 2, 4e-3);
  EXPECT_LE(leastInFaces(mesh), 2);
}

TEST(MedialThickness, OfARoundBarAndOfATorus) {
  const SurfaceMesh bar = test::prism(test::regularPolygon(128, 2 * kPi / 128), 20, 10).mesh();
  const ThicknessField field = thicknessOf(bar);
  for (const Vertex v : bar.vertices()) {
    const Vec3& p = bar.position(v);
    if (std::hypot(p.x, p.y) < 0.5) continue;  // on the caps
    EXPECT_NEAR(field.values[v], 2, 1e-3);
  }
  const double apothem = kPi / 128 / std::tan(kPi / 128);
  EXPECT_NEAR(leastInFaces(bar), 2 * apothem, 1e-12);
  const SurfaceMesh torus = test::torus(3, 0.5, 200, 100).mesh();
  for (const double value : thicknessOf(torus).values) EXPECT_NEAR(value, 1, 2e-3);
}

TEST(MedialThickness, FollowsScaleAndMotionAndThreadsDoNotMatter) {
  const Shape shape = test::perturbed(test::torus(3, 1, 48, 24), 0.2, 9);
  const ThicknessField field = thicknessOf(shape.mesh());
  EXPECT_EQ(thicknessOf(test::moved(shape, 2, 0, 0).mesh()).values.size(), field.values.size());
  const std::vector<double> twice = thicknessOf(test::moved(shape, 2, 0, 0).mesh()).values;
  const std::vector<double> turned = thicknessOf(test::moved(shape, 1, 0.7, 5).mesh()).values;
  for (std::size_t v = 0; v < field.values.size(); ++v) {
    EXPECT_NEAR(twice[v], 2 * field.values[v], 1e-12);
    EXPECT_NEAR(turned[v], field.values[v], 1e-12);
  }
  for (const double scale : {1e-50, 1e50}) {
    const std::vector<double> far = thicknessOf(test::moved(shape, scale, 0.7, 0).mesh()).values;
    for (std::size_t v = 0; v < far.size(); ++v) {
      EXPECT_NEAR(far[v] / scale, field.values[v], 1e-9);
    }
  }
  for (const unsigned threads : {1u, 2u, 5u}) {
    ExecutionContext context;
    context.threads = threads;
    const auto again = medialThickness(shape.mesh(), {}, context);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again.value().values, field.values);
    EXPECT_TRUE(again.value().complete);
  }
}

TEST(MedialThickness, VertexByVertexIsTheSame) {
  const SurfaceMesh mesh = test::perturbed(test::icosphere(2), 0.3, 4).mesh();
  const auto function = medialThicknessFunction(mesh);
  ASSERT_TRUE(function.ok());
  const VertexEvaluator<double> evaluate = function.value().evaluator({});
  const std::vector<double> values = thicknessOf(mesh).values;
  for (const Vertex v : mesh.vertices()) EXPECT_EQ(evaluate(v).value(), values[v]);
  EXPECT_FALSE(evaluate(Vertex(mesh.vertexCount())).ok());
}

TEST(MedialThickness, NothingFacesAnOpenSheetOrAnInsideOutBody) {
  Shape patch;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) patch.add(x, y, 0);
  patch.face(0, 1, 2);
  patch.face(0, 2, 3);
  EXPECT_EQ(thicknessOf(patch.mesh(OpenEdges::Boundary)).withoutValue, 4u);
  Shape sphere = test::icosphere(2);
  for (std::size_t i = 0; i < sphere.triangles.size(); i += 3) {
    std::swap(sphere.triangles[i], sphere.triangles[i + 1]);
  }
  const SurfaceMesh insideOut = sphere.mesh();
  const ThicknessField field = thicknessOf(insideOut);
  EXPECT_TRUE(field.insideOut);
  EXPECT_EQ(field.withoutValue, static_cast<Index>(field.values.size()));
  EXPECT_NE(thicknessNote(true, 3, 8), "");
  // Laid outside, the balls are in the ball.
  const ThicknessField outside = thicknessOf(insideOut, {kPi / 3, ThicknessSide::Outside});
  for (const double value : outside.values) EXPECT_NEAR(value, 2, 0.1);
}

TEST(MedialThickness, OptionsOutOfRangeAreRefused) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  for (const double angle : {0.0, -1.0, 1.6, std::nan("")}) {
    EXPECT_FALSE(medialThickness(mesh, {angle, {}}).ok()) << angle;
    EXPECT_FALSE(medialThicknessFunction(mesh, {angle, {}}).ok()) << angle;
  }
}

TEST(MedialThickness, StopsWhenTold) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  const std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  const auto field = medialThickness(mesh, {}, context);
  ASSERT_TRUE(field.ok());
  EXPECT_FALSE(field.value().complete);
}

}  // namespace
}  // namespace girth
