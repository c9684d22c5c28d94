// SurfaceMesh: what it accepts, what it refuses and how, and what it says of a surface.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "girth/surface_mesh.h"
#include "mesh/angles.h"
#include "shapes.h"

namespace girth::test {
namespace {

Error errorOf(const Shape& shape) {
  const auto result = SurfaceMesh::fromArrays(shape.positions, shape.triangles);
  EXPECT_FALSE(result.ok());
  return result ? Error{} : result.error();
}

TEST(SurfaceMesh, KnowsATetrahedron) {
  const SurfaceMesh mesh = tetrahedron().mesh();
  EXPECT_EQ(mesh.vertexCount(), 4u);
  EXPECT_EQ(mesh.faceCount(), 4u);
  EXPECT_EQ(mesh.edgeCount(), 6u);
  EXPECT_EQ(mesh.componentCount(), 1u);
  EXPECT_EQ(mesh.genus(0), 0u);
  EXPECT_NEAR(mesh.area(), 8 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(mesh.meanEdgeLength(), std::sqrt(8.0), 1e-14);
  for (Index v = 0; v < 4; ++v) EXPECT_NEAR(mesh.totalAngle(Vertex(v)), kPi, 1e-14);
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(mesh.twin(mesh.twin(h)), h);
    EXPECT_EQ(mesh.from(mesh.twin(h)), mesh.to(h));
    EXPECT_EQ(mesh.length(mesh.twin(h)), mesh.length(h));
  }
}

TEST(SurfaceMesh, CountsHandlesAndComponents) {
  EXPECT_EQ(torus(2, 0.5, 8, 6).mesh().genus(0), 1u);
  EXPECT_EQ(plate(2).mesh().genus(0), 4u);
  Shape two = tetrahedron();
  const Shape ring = torus(9, 0.5, 8, 6);
  for (const double x : ring.positions) two.positions.push_back(x);
  for (const Index v : ring.triangles) two.triangles.push_back(v + 4);
  const SurfaceMesh mesh = two.mesh();
  ASSERT_EQ(mesh.componentCount(), 2u);
  EXPECT_EQ(mesh.genus(0), 0u);
  EXPECT_EQ(mesh.genus(1), 1u);
  EXPECT_EQ(mesh.componentOf(Vertex(3)), 0u);
  EXPECT_EQ(mesh.componentOf(Vertex(4)), 1u);
}

TEST(SurfaceMesh, SatisfiesGaussBonnet) {
  for (const Shape& shape : {perturbed(octasphere(2), 0.2, 1), perturbed(plate(2), 0.1, 2)}) {
    const SurfaceMesh mesh = shape.mesh();
    double curvature = 0;
    for (const Vertex v : mesh.vertices()) curvature += 2 * kPi - mesh.totalAngle(v);
    EXPECT_NEAR(curvature, 2 * kPi * (2 - 2.0 * mesh.genus(0)), 1e-10);
  }
}

TEST(SurfaceMesh, RefusesWithTheElement) {
  EXPECT_EQ(errorOf({}).code, ErrorCode::EmptyMesh);

  Shape shape = tetrahedron();
  shape.positions[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errorOf(shape).code, ErrorCode::NonFinitePosition);
  EXPECT_EQ(errorOf(shape).element, 2);
  shape.positions[7] = -1.0001e300;  // finite, but sums of such lengths may not be
  EXPECT_EQ(errorOf(shape).code, ErrorCode::LimitExceeded);
  EXPECT_EQ(errorOf(shape).element, 2);

  shape = tetrahedron();
  shape.triangles[10] = 4;
  EXPECT_EQ(errorOf(shape).code, ErrorCode::IndexOutOfRange);
  EXPECT_EQ(errorOf(shape).element, 3);

  shape = tetrahedron();
  shape.triangles[4] = 0;
  EXPECT_EQ(errorOf(shape).code, ErrorCode::DegenerateFace);
  EXPECT_EQ(errorOf(shape).element, 1);

  shape = tetrahedron();  // vertex 3 on the middle of edge 0-2: face 1 has no area
  shape.positions = {1, 1, 1, 1, -1, -1, -1, 1, -1, 0, 1, 0};
  EXPECT_EQ(errorOf(shape).code, ErrorCode::DegenerateFace);
  EXPECT_EQ(errorOf(shape).element, 1);

  shape = tetrahedron();
  shape.triangles.resize(9);
  EXPECT_EQ(errorOf(shape).code, ErrorCode::OpenEdge);
  EXPECT_EQ(errorOf(shape).element, 1);
  EXPECT_NE(errorOf(shape).message.find("edge 1-2 of face 0"), std::string::npos);
  EXPECT_FALSE(errorOf(shape).hint.empty());

  shape = tetrahedron();
  std::swap(shape.triangles[0], shape.triangles[1]);
  EXPECT_EQ(errorOf(shape).code, ErrorCode::InconsistentOrientation);

  shape = tetrahedron();  // a second tetrahedron on edge 0-1
  shape.positions.insert(shape.positions.end(), {5, 0, 0, 5, 1, 0});
  for (const Index v : {0, 1, 4, 0, 4, 5, 0, 5, 1, 1, 5, 4}) {
    shape.triangles.push_back(static_cast<Index>(v));
  }
  EXPECT_EQ(errorOf(shape).code, ErrorCode::NonManifoldEdge);
  EXPECT_EQ(errorOf(shape).element, 0);

  shape = tetrahedron();  // a fin that touches vertex 0 only
  shape.positions.insert(shape.positions.end(), {5, 0, 0, 5, 1, 0, 5, 0, 1});
  for (const Index v : {0, 4, 5, 0, 5, 6, 0, 6, 4, 4, 6, 5}) {
    shape.triangles.push_back(static_cast<Index>(v));
  }
  EXPECT_EQ(errorOf(shape).code, ErrorCode::NonManifoldVertex);
  EXPECT_EQ(errorOf(shape).element, 0);

  shape = tetrahedron();
  shape.add(9, 9, 9);
  EXPECT_EQ(errorOf(shape).code, ErrorCode::UnreferencedVertex);
  EXPECT_EQ(errorOf(shape).element, 4);
}

TEST(SurfaceMesh, TakesCoordinatesOfAnySize) {
  for (const double scale : {1e-150, 1e150}) {
    const SurfaceMesh mesh = moved(octasphere(1), scale, 0, 0).mesh();
    EXPECT_NEAR(mesh.length(Halfedge(0)) / scale, octasphere(1).mesh().length(Halfedge(0)), 1e-12);
    EXPECT_NEAR(mesh.totalAngle(Vertex(0)), octasphere(1).mesh().totalAngle(Vertex(0)), 1e-12);
  }
}

TEST(Angles, AgreeWithTheLibrary) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::ldexp(2 * random() - 1, static_cast<int>(random.below(40)) - 20);
    const double y = std::ldexp(random(), static_cast<int>(random.below(40)) - 20);
    EXPECT_NEAR(angleOf(x, y), std::atan2(y, x), 2e-15);
    const double angle = kPi * random();
    EXPECT_NEAR(cosSin(angle).cos, std::cos(angle), 2e-15);
    EXPECT_NEAR(cosSin(angle).sin, std::sin(angle), 2e-15);
  }
  EXPECT_EQ(angleOf(1, 0), 0);
  EXPECT_EQ(angleOf(-1, 0), kPi);
  EXPECT_NEAR(angleOf(0, 1), kPi / 2, 1e-16);
}

}  // namespace
}  // namespace girth::test
