// Fast marching, and what is built on it: IGF-MS, GeoAverage, GeoFarthest.
#include "geodesic/fast_marching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "girth/geodesic_extent.h"
#include "girth/geodesic_solver.h"
#include "girth/girth_field.h"
#include "girth/vertex_areas.h"
#include "mesh/angles.h"
#include "shapes.h"

namespace girth {
namespace {

using geodesic::FastMarching;
using geodesic::MarchingStencils;
using test::Shape;

std::vector<double> marchedFrom(const SurfaceMesh& mesh, Index source) {
  const MarchingStencils stencils(mesh);
  FastMarching march(stencils);
  double last = 0;
  march.run(source, [&](Index vertex, double distance) {
    EXPECT_GE(distance, last) << "vertex " << vertex;
    last = distance;
    return true;
  });
  std::vector<double> distances;
  for (const Vertex v : mesh.vertices()) distances.push_back(march.distance(v));
  return distances;
}

/// A square patch of n × n cells, sheared: by 0, cells cut into two right triangles; by more, into
/// obtuse ones.
SurfaceMesh patch(Index n, double shear) {
  Shape shape;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) shape.add((i + shear * j) / n, static_cast<double>(j) / n, 0);
  }
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      shape.face(a, a + 1, a + n + 2);
      shape.face(a, a + n + 2, a + n + 1);
    }
  }
  return shape.mesh(OpenEdges::Boundary);
}

/// Mean relative error against the exact distances.
double meanError(const SurfaceMesh& mesh, Index source) {
  const std::vector<double> marched = marchedFrom(mesh, source);
  const auto exact = GeodesicSolver(mesh).distances(SurfacePoint::atVertex(Vertex(source)));
  EXPECT_TRUE(exact.ok());
  double sum = 0;
  for (const Vertex v : mesh.vertices()) {
    if (v != source) sum += std::fabs(marched[v] / exact.value()[v] - 1);
  }
  return sum / (mesh.vertexCount() - 1);
}

TEST(FastMarching, IsExactAlongStraightFrontsAndEdges) {
  const SurfaceMesh mesh = patch(4, 0);
  const std::vector<double> distances = marchedFrom(mesh, 0);
  for (Index i = 0; i <= 4; ++i) {
    EXPECT_NEAR(distances[i], i / 4.0, 1e-15);
    EXPECT_NEAR(distances[i * 6], i / 4.0 * std::sqrt(2.0), 1e-15);
  }
}

TEST(FastMarching, TheErrorFallsWithTheMesh) {
  for (const double shear : {0.0, 0.6, -0.6, 2.0}) {
    const double coarse = meanError(patch(10, shear), 0), fine = meanError(patch(40, shear), 0);
    EXPECT_LT(coarse, 0.1) << shear;
    EXPECT_LT(fine, std::max(0.5 * coarse, 0.003)) << shear;
  }
  EXPECT_LT(meanError(test::icosphere(4).mesh(), 0), 0.02);
  EXPECT_LT(meanError(test::perturbed(test::torus(3, 1, 96, 48), 0.2, 1).mesh(), 5), 0.03);
}

TEST(FastMarching, ObtuseCornersAreSplit) {
  // Without the vertices beyond, a front across these triangles is late by a tenth and more.
  EXPECT_LT(meanError(patch(40, 3.0), 0), 0.06);
}

TEST(FastMarching, OtherComponentsAreOutOfReach) {
  Shape two = test::tetrahedron();
  const Shape other = test::moved(test::tetrahedron(), 1, 0, 9);
  for (const double x : other.positions) two.positions.push_back(x);
  for (const Index v : other.triangles) two.triangles.push_back(v + 4);
  const std::vector<double> distances = marchedFrom(two.mesh(), 0);
  for (Index v = 0; v < 4; ++v) EXPECT_FALSE(std::isinf(distances[v]));
  for (Index v = 4; v < 8; ++v) EXPECT_TRUE(std::isinf(distances[v]));
}

TEST(MarchedGirth, ComesNearTheExactOne) {
  // Around a tube: saddles are found at vertices only.
  const SurfaceMesh tube = test::prism(test::regularPolygon(24, 2 * kPi / 24), 12, 45).mesh();
  const GirthField marched = girthField(tube, GirthMethod::Marched);
  EXPECT_TRUE(marched.complete());
  for (const Vertex v : tube.vertices()) {
    if (std::fabs(tube.position(v).z - 6) > 1) continue;
    EXPECT_EQ(marched.kinds[v], LoopKind::Loop);
    EXPECT_NEAR(marched.values[v], 2 * kPi, 0.05 * 2 * kPi);
  }
  const SurfaceMesh torus = test::perturbed(test::torus(3, 1, 60, 30), 0.1, 4).mesh();
  const GirthField exact = girthField(torus), approximate = girthField(torus, GirthMethod::Marched);
  std::vector<double> errors;
  for (const Vertex v : torus.vertices()) {
    errors.push_back(std::fabs(approximate.values[v] / exact.values[v] - 1));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.03);
}

TEST(MarchedGirth, OfARegularBodyIsTwiceTheFarthestVertex) {
  const SurfaceMesh mesh = test::octasphere(2).mesh();
  const GirthField field = girthField(mesh, GirthMethod::Marched);
  const GeodesicExtent extent = geodesicExtent(mesh, DistanceMethod::FastMarching);
  EXPECT_EQ(field.kinds[0], LoopKind::Antipodal);
  EXPECT_EQ(field.values[0], 2 * extent.farthest[0]);
}

TEST(MarchedGirth, ThreadsDoNotMatterAndItStopsWhenTold) {
  const SurfaceMesh mesh = test::perturbed(test::torus(3, 1, 48, 24), 0.2, 9).mesh();
  ExecutionContext one, three;
  one.threads = 1;
  three.threads = 3;
  EXPECT_EQ(girthField(mesh, GirthMethod::Marched, one).values,
            girthField(mesh, GirthMethod::Marched, three).values);
  const std::atomic<bool> cancel{true};
  one.cancel = &cancel;
  EXPECT_EQ(girthField(mesh, GirthMethod::Marched, one).computed, 0u);
  EXPECT_FALSE(geodesicExtent(mesh, DistanceMethod::FastMarching, one).complete);
  EXPECT_FALSE(geodesicExtent(mesh, DistanceMethod::Exact, one).complete);
}

TEST(GeodesicExtent, OfATetrahedron) {
  // Three neighbours one edge away, all four with a quarter of the area.
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  const double edge = std::sqrt(8.0);
  for (const auto method : {DistanceMethod::Exact, DistanceMethod::FastMarching}) {
    const GeodesicExtent extent = geodesicExtent(mesh, method);
    EXPECT_TRUE(extent.complete);
    for (Index v = 0; v < 4; ++v) {
      EXPECT_NEAR(extent.farthest[v], edge, 1e-14);
      EXPECT_NEAR(extent.average[v], 0.75 * edge, 1e-14);
    }
  }
}

TEST(GeodesicExtent, OfASphereTendsToItsMeans) {
  // Mean distance π/2 r, greatest π r.
  const SurfaceMesh mesh = test::icosphere(3).mesh();
  const GeodesicExtent extent = geodesicExtent(mesh, DistanceMethod::FastMarching);
  for (Index v = 0; v < mesh.vertexCount(); v += 7) {
    EXPECT_NEAR(extent.average[v], kPi / 2, 0.05);
    EXPECT_NEAR(extent.farthest[v], kPi, 0.1);
  }
}

TEST(GeodesicExtent, SumsTheExactDistances) {
  const SurfaceMesh mesh = test::perturbed(test::torus(3, 1, 16, 8), 0.2, 9).mesh();
  const GeodesicExtent extent = geodesicExtent(mesh, DistanceMethod::Exact);
  const std::vector<double> areas = vertexAreas(mesh);
  GeodesicSolver solver(mesh);
  for (const Index v : {0u, 17u, 100u}) {
    const auto distances = solver.distances(SurfacePoint::atVertex(Vertex(v)));
    ASSERT_TRUE(distances.ok());
    double sum = 0;
    for (const Vertex u : mesh.vertices()) sum += areas[u] * distances.value()[u];
    EXPECT_NEAR(extent.average[v], sum / mesh.area(), 1e-12);
    EXPECT_EQ(extent.farthest[v],
              *std::max_element(distances.value().begin(), distances.value().end()));
  }
}

}  // namespace
}  // namespace girth
