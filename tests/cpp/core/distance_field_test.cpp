// The distance from points as a field, where it is known.

#include "girth/distance_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "girth/fields.h"
#include "girth/geodesic_solver.h"
#include "mesh/vector.h"
#include "print_shapes.h"
#include "shapes.h"

namespace girth {
namespace {

/// A plate of one layer of cells beside another, which lies apart.
SurfaceMesh bodiesApart() {
  return test::blocks({0, 1, 2, 10, 12}, {0, 3}, {0, 4}, [](int i, int, int) { return i != 2; })
      .mesh();
}

std::vector<double> distanceValues(const SurfaceMesh& mesh, const DistanceFieldOptions& distance,
                                   double scale = 1, unsigned threads = 1) {
  FieldOptions options;
  options.distance = distance;
  options.distance.radius *= scale;
  return fieldValues(mesh, "distance", options, {threads, nullptr, {}}).value().values;
}

TEST(DistanceField, OnAFaceIsTheStraightDistanceAndOtherComponentsAreInfinite) {
  const SurfaceMesh mesh = bodiesApart();
  const SurfacePoint from = SurfacePoint::atVertex(Vertex(0));
  const Vec3 source = mesh.position(Vertex(0));
  const std::vector<double> found = distanceValues(mesh, {{from}});
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (mesh.componentOf(v) != mesh.componentOf(Vertex(0))) {
      EXPECT_EQ(found[v], std::numeric_limits<double>::infinity());
    } else if (p.x == source.x || p.y == source.y || p.z == source.z) {
      EXPECT_NEAR(found[v], norm(p - source), 1e-12);
    } else {
      EXPECT_GT(found[v], norm(p - source));
    }
  }
  EXPECT_EQ(distanceValues(mesh, {}), found);  // by default: from the first vertex
  EXPECT_EQ(distanceValues(mesh, {{from}}, 1, 3), found);
}

TEST(DistanceField, OfSeveralPointsIsThatToTheNearestWithinTheRadius) {
  const SurfaceMesh mesh = bodiesApart();
  const SurfacePoint one = SurfacePoint::atVertex(Vertex(0)),
                     other = SurfacePoint::inFace(Face(mesh.faceCount() - 1), {0.5, 0.25, 0.25});
  const std::vector<double> both = distanceValues(mesh, {{one, other}}),
                            first = distanceValues(mesh, {{one}}),
                            second = distanceValues(mesh, {{other}}),
                            near = distanceValues(mesh, {{one, other}, 3});
  for (const Vertex v : mesh.vertices()) {
    EXPECT_NEAR(both[v], std::min(first[v], second[v]), 1e-12);
    EXPECT_EQ(near[v], both[v] <= 3 ? both[v] : std::numeric_limits<double>::infinity());
  }
  EXPECT_EQ(both, GeodesicSolver(mesh).distances(std::vector{one, other}).value());
}

TEST(DistanceField, GrowsWithTheSurface) {
  const test::Shape shape = test::box(4, 3, 1, 4, 3, 1);
  test::Shape large = shape;
  for (double& x : large.positions) x *= 8;
  const DistanceFieldOptions options{{SurfacePoint::inFace(Face(5), {0.5, 0.25, 0.25})}, 3};
  const auto found = distanceValues(shape.mesh(), options),
             scaled = distanceValues(large.mesh(), options, 8);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(scaled[i], 8 * found[i]);
}

TEST(DistanceField, RefusesPointsAndRadiiThatAreNone) {
  const SurfaceMesh mesh = bodiesApart();
  const auto code = [&](const DistanceFieldOptions& options) {
    const auto function = distanceFunction(mesh, options);
    EXPECT_FALSE(function);
    return function.error().code;
  };
  EXPECT_EQ(code({{SurfacePoint::atVertex(Vertex(1'000))}}), ErrorCode::VertexOutOfRange);
  EXPECT_EQ(code({{SurfacePoint::inFace(Face(0), {1, 1, 1})}}), ErrorCode::InvalidPoint);
  EXPECT_EQ(code({{}, -1}), ErrorCode::InvalidRadius);
  EXPECT_EQ(code({{}, std::nan("")}), ErrorCode::InvalidRadius);
}

}  // namespace
}  // namespace girth
