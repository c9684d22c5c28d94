// The textbook method itself: closed forms, brute force, and what must not change its answers.

#include "textbook_mmp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "brute_force.h"
#include "shapes.h"

namespace girth::test {
namespace {

constexpr double kExact = 1e-13;

std::vector<Shape> triangulations(const Shape& shape) {
  return {shape, retriangulated(shape, 1), retriangulated(shape, 2), subdivided(shape)};
}

/// The vertex at a place, which there must be.
Index vertexAt(const SurfaceMesh& mesh, double x, double y, double z) {
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (std::fabs(p.x - x) + std::fabs(p.y - y) + std::fabs(p.z - z) < 1e-12) return v;
  }
  ADD_FAILURE() << "no vertex at " << x << " " << y << " " << z;
  return 0;
}

TEST(TextbookMmp, MeasuresStraightLinesOnAFlatFace) {
  // A grid: rays end on flat vertices, and edges lie in line.
  for (const Shape& shape : triangulations(box(1, 1, 9, 8, 8, 4))) {
    const SurfaceMesh mesh = shape.mesh();
    TextbookMmp mmp(mesh);
    for (const auto& [x, y] : {std::pair(0.5, 0.5), {0.0, 0.0}, {0.25, 0.75}}) {
      mmp.propagate(SurfacePoint::atVertex(Vertex(vertexAt(mesh, x, y, 0))));
      for (const Vertex v : mesh.vertices()) {
        const Vec3& p = mesh.position(v);
        if (p.z > 0) continue;
        EXPECT_NEAR(mmp.distanceTo(SurfacePoint::atVertex(v)), std::hypot(p.x - x, p.y - y),
                    kExact);
      }
      for (const Face f : mesh.faces()) {
        const auto point = SurfacePoint::inFace(f, {0.2, 0.3, 0.5});
        const Vec3 p = positionOf(mesh, point);
        if (p.z > 0) continue;
        EXPECT_NEAR(mmp.distanceTo(point), std::hypot(p.x - x, p.y - y), kExact);
        const auto onSide = SurfacePoint::onHalfedge(Halfedge(3 * f + 1), 0.3);
        const Vec3 e = positionOf(mesh, onSide);
        if (e.z == 0) {
          EXPECT_NEAR(mmp.distanceTo(onSide), std::hypot(e.x - x, e.y - y), kExact);
        }
      }
    }
  }
}

TEST(TextbookMmp, UnfoldsBoxesTetrahedraAndOctahedra) {
  for (const Shape& shape : triangulations(box(1, 2, 4, 2, 4, 8))) {
    const SurfaceMesh mesh = shape.mesh();
    TextbookMmp mmp(mesh);
    mmp.propagate(SurfacePoint::atVertex(Vertex(vertexAt(mesh, 0, 0, 0))));
    // To the opposite corner: over the two smaller sides unrolled, (a + b)² + c².
    EXPECT_NEAR(mmp.distanceTo(SurfacePoint::atVertex(Vertex(vertexAt(mesh, 1, 2, 4)))), 5, kExact);
  }
  // Kotani's point: on a 1 × 1 × 2 box the farthest point from a corner is not the opposite one.
  const SurfaceMesh kotani = box(1, 1, 2, 4, 4, 8).mesh();
  TextbookMmp mmp(kotani);
  mmp.propagate(SurfacePoint::atVertex(Vertex(vertexAt(kotani, 0, 0, 0))));
  EXPECT_NEAR(mmp.distanceTo(SurfacePoint::atVertex(Vertex(vertexAt(kotani, 1, 1, 2)))),
              std::sqrt(8.0), kExact);
  EXPECT_NEAR(mmp.distanceTo(SurfacePoint::atVertex(Vertex(vertexAt(kotani, 0.75, 0.75, 2)))),
              std::sqrt(130.0) / 4, kExact);

  const SurfaceMesh four = tetrahedron().mesh();
  TextbookMmp onFour(four);
  onFour.propagate(SurfacePoint::atVertex(Vertex(0)));
  const double side = std::sqrt(8.0);
  for (Index v = 1; v < 4; ++v) {
    EXPECT_NEAR(onFour.distanceTo(SurfacePoint::atVertex(Vertex(v))), side, kExact);
  }
  EXPECT_NEAR(onFour.distanceTo(SurfacePoint::inFace(Face(3), {1.0 / 3, 1.0 / 3, 1.0 / 3})),
              2 * side / std::sqrt(3.0), kExact);
  const SurfaceMesh eight = octasphere(0).mesh();
  TextbookMmp onEight(eight);
  onEight.propagate(SurfacePoint::atVertex(Vertex(0)));
  EXPECT_NEAR(onEight.distanceTo(SurfacePoint::atVertex(Vertex(3))), std::sqrt(6.0), kExact);
}

TEST(TextbookMmp, UnrollsPrismsAndCones) {
  const Index sides = 6, parts = 2, corners = sides * parts, rings = 12;
  for (const Shape& shape : triangulations(prism(regularPolygon(sides, 1, parts), 24, rings))) {
    const SurfaceMesh mesh = shape.mesh();
    TextbookMmp mmp(mesh);
    const Index source = 6 * corners + 1;  // mid-height, in the middle of a side
    mmp.propagate(SurfacePoint::atVertex(Vertex(source)));
    for (Index ring = 5; ring <= 7; ++ring) {
      for (Index i = 0; i < corners; ++i) {
        const Index steps = std::min((i + corners - 1) % corners, (corners + 1 - i) % corners);
        EXPECT_NEAR(mmp.distanceTo(SurfacePoint::atVertex(Vertex(ring * corners + i))),
                    std::hypot(2 * (static_cast<double>(ring) - 6), 0.5 * steps), kExact);
      }
    }
  }
  // A cone: on both ways round the apex, the law of cosines.
  const double theta = 2.0;
  for (const Shape& shape : triangulations(pyramid(5, theta, 10))) {
    const SurfaceMesh mesh = shape.mesh();
    TextbookMmp mmp(mesh);
    mmp.propagate(SurfacePoint::atVertex(Vertex(1 + 2 * 5)));  // slant distance 0.3
    for (Index ring = 1; ring <= 4; ++ring) {
      for (Index i = 0; i < 5; ++i) {
        const double d = 0.1 * ring, turn = theta / 5 * std::min(i, 5 - i);
        EXPECT_NEAR(mmp.distanceTo(SurfacePoint::atVertex(Vertex(1 + (ring - 1) * 5 + i))),
                    std::sqrt(0.09 + d * d - 0.6 * d * std::cos(turn)), kExact);
      }
    }
  }
}

TEST(TextbookMmp, AgreesWithBruteForce) {
  const std::vector<std::pair<Shape, double>> shapes = {
      {tetrahedron(), 0.1},         {octasphere(1), 0.1},     {icosphere(1), 0.3},
      {torus(2, 0.7, 10, 6), 0.1},  {plate(1), 0.1},          {plate(2), 0.03},
      {box(1, 1, 1, 2, 2, 2), 0.3}, {pyramid(7, 2, 6), 0.05}, {torus(2, 0.7, 10, 6), 0.5}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE("shape " + std::to_string(i));
    const SurfaceMesh mesh = perturbed(shapes[i].first, shapes[i].second, 23).mesh();
    TextbookMmp mmp(mesh);
    Random random(i);
    for (int round = 0; round < 5; ++round) {
      const Index source = random.below(mesh.vertexCount());
      mmp.propagate(SurfacePoint::atVertex(Vertex(source)));
      const double reach = 4 * mesh.meanEdgeLength();
      const BruteForce all(mesh, source, reach);
      ASSERT_TRUE(all.complete());
      const auto compare = [&](const SurfacePoint& point) {
        const double distance = mmp.distanceTo(point), brute = all.distanceTo(point);
        if (distance < reach * 0.999 || brute < reach) {
          EXPECT_NEAR(distance / brute, 1, 1e-12) << "vertex " << source;
        }
      };
      for (const Vertex v : mesh.vertices()) {
        if (v != source) compare(SurfacePoint::atVertex(v));
      }
      for (const Face f : mesh.faces()) {
        const double a = random(), b = random() * (1 - a);
        compare(SurfacePoint::inFace(f, {a, b, 1 - a - b}));
        compare(SurfacePoint::onHalfedge(Halfedge(3 * f + random.below(3)), random()));
      }
    }
  }
}

TEST(TextbookMmp, IsSymmetricBetweenPointsOfAnyKind) {
  for (const Shape& shape : {perturbed(plate(2), 0.3, 3), box(1, 1, 1, 3, 3, 3),
                             perturbed(torus(2, 0.7, 12, 8), 0.5, 3), octasphere(2)}) {
    const SurfaceMesh mesh = shape.mesh();
    TextbookMmp there(mesh), back(mesh);
    Random random(5);
    const auto anyPoint = [&]() {
      switch (random.below(3)) {
        case 0:
          return SurfacePoint::atVertex(Vertex(random.below(mesh.vertexCount())));
        case 1:
          return SurfacePoint::onHalfedge(Halfedge(random.below(mesh.halfedgeCount())), random());
        default: {
          const double a = random(), b = random() * (1 - a);
          return SurfacePoint::inFace(Face(random.below(mesh.faceCount())), {a, b, 1 - a - b});
        }
      }
    };
    for (int i = 0; i < 60; ++i) {
      const SurfacePoint a = anyPoint(), b = anyPoint();
      there.propagate(a);
      back.propagate(b);
      EXPECT_NEAR(there.distanceTo(b), back.distanceTo(a), kExact);
      EXPECT_NEAR(there.distanceTo(a), 0, kExact);
    }
  }
}

TEST(TextbookMmp, DoesNotDependOnTheTriangulationOrTheRadius) {
  for (const Shape& shape : {perturbed(plate(1), 0.3, 3), box(1, 1, 1, 3, 3, 3),
                             perturbed(torus(2, 0.7, 12, 8), 0.5, 3)}) {
    const SurfaceMesh mesh = shape.mesh();
    const SurfaceMesh fine = subdivided(subdivided(shape)).mesh();
    const SurfaceMesh other = retriangulated(subdivided(shape), 7).mesh();
    TextbookMmp mmp(mesh), onFine(fine), onOther(other), near(mesh);
    for (Index source = 0; source < mesh.vertexCount(); source += 9) {
      const SurfacePoint from = SurfacePoint::atVertex(Vertex(source));
      mmp.propagate(from);
      onFine.propagate(from);
      onOther.propagate(from);
      const double radius = 3 * mesh.meanEdgeLength();
      near.propagate(from, radius);
      for (const Vertex v : mesh.vertices()) {
        const SurfacePoint to = SurfacePoint::atVertex(v);
        const double distance = mmp.distanceTo(to);
        EXPECT_NEAR(onFine.distanceTo(to), distance, kExact);
        EXPECT_NEAR(onOther.distanceTo(to), distance, kExact);
        if (distance <= radius) {
          EXPECT_EQ(near.distanceTo(to), distance);
        } else {
          EXPECT_GE(near.distanceTo(to), distance * (1 - kExact));
        }
      }
    }
  }
}

TEST(TextbookMmp, KeepsItsDigitsOnNeedlesAndAtAnySize) {
  // A wire of needles, and a cube of 1e±150.
  const SurfaceMesh wire = box(1, 1e-4, 1e-4, 20, 1, 1).mesh();
  TextbookMmp mmp(wire);
  mmp.propagate(SurfacePoint::atVertex(Vertex(vertexAt(wire, 0, 0, 0))));
  EXPECT_NEAR(mmp.distanceTo(SurfacePoint::atVertex(Vertex(vertexAt(wire, 1, 1e-4, 1e-4)))),
              std::hypot(1, 2e-4), 1e-12);
  const Shape cube = box(1, 1, 1, 3, 3, 3);
  const Index corner = vertexAt(cube.mesh(), 0, 0, 0);
  for (const double scale : {1e-150, 1e150}) {
    const SurfaceMesh mesh = moved(cube, scale, 0, 0).mesh();
    TextbookMmp scaled(mesh);
    scaled.propagate(SurfacePoint::atVertex(Vertex(corner)));
    double farthest = 0;
    for (const Vertex v : mesh.vertices()) {
      farthest = std::max(farthest, scaled.distanceTo(SurfacePoint::atVertex(v)) / scale);
    }
    EXPECT_NEAR(farthest, std::sqrt(5.0), kExact);
  }
}

TEST(TextbookMmp, LeavesOtherComponentsAlone) {
  Shape two = tetrahedron();
  for (const double x : tetrahedron().positions) two.positions.push_back(x + 10);
  for (const Index v : tetrahedron().triangles) two.triangles.push_back(v + 4);
  const SurfaceMesh mesh = two.mesh();
  TextbookMmp mmp(mesh);
  mmp.propagate(SurfacePoint::atVertex(Vertex(1)));
  EXPECT_TRUE(std::isfinite(mmp.distanceTo(SurfacePoint::inFace(Face(2), {0.2, 0.2, 0.6}))));
  EXPECT_TRUE(std::isinf(mmp.distanceTo(SurfacePoint::inFace(Face(5), {0.2, 0.2, 0.6}))));
  EXPECT_TRUE(std::isinf(mmp.distanceTo(SurfacePoint::atVertex(Vertex(6)))));
}

}  // namespace
}  // namespace girth::test
