// The girth of surfaces with boundary, as files bring them: closed forms of prepared surfaces,
// brute force on small ones, and the naive method on all.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "brute_force.h"
#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "random_meshes.h"

namespace girth::test {
namespace {

/// The surface that prepareSurface makes of a shape whose corners are all vertices of their own and
/// whose faces are turned at random.
PreparedSurface preparedSoup(const Shape& shape, std::uint64_t seed) {
  Random random(seed);
  TriangleSoup soup;
  for (std::size_t f = 0; f < shape.triangles.size() / 3; ++f) {
    const bool turned = random() < 0.3;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = shape.triangles[3 * f + (turned ? 2 - k : k)];
      for (std::size_t i = 0; i < 3; ++i) soup.positions.push_back(shape.positions[3 * v + i]);
      soup.triangles.push_back(static_cast<Index>(soup.triangles.size()));
    }
  }
  auto prepared = prepareSurface(std::move(soup));
  EXPECT_TRUE(prepared.ok());
  return std::move(prepared).value();
}

Index vertexAt(const SurfaceMesh& mesh, double x, double y, double z = 0) {
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (std::fabs(p.x - x) + std::fabs(p.y - y) + std::fabs(p.z - z) < 1e-9) return v;
  }
  ADD_FAILURE() << "no vertex at " << x << ", " << y << ", " << z;
  return 0;
}

/// A grid of a × b unit squares without those that `cut` names.
Shape grid(Index a, Index b, const std::function<bool(Index, Index)>& cut) {
  Shape shape;
  for (Index j = 0; j <= b; ++j) {
    for (Index i = 0; i <= a; ++i) shape.add(i, j, 0);
  }
  for (Index j = 0; j < b; ++j) {
    for (Index i = 0; i < a; ++i) {
      if (cut(i, j)) continue;
      const Index p = j * (a + 1) + i, q = p + a + 1;
      shape.face(p, p + 1, q + 1);
      shape.face(p, q + 1, q);
    }
  }
  return withoutLoneVertices(shape);
}

bool nowhere(Index, Index) { return false; }
bool oneHole(Index i, Index j) { return i == 2 && j == 2; }
bool twoHoles(Index i, Index j) { return (i == 2 || i == 6) && j == 2; }

/// A flat ring of `around` trapezoids between regular polygons of circumradii r and R.
Shape annulus(double r, double R, Index around, Index rings) {
  Shape shape;
  for (Index k = 0; k <= rings; ++k) {
    const double rho = r + (R - r) * k / rings;
    for (Index i = 0; i < around; ++i) {
      const double angle = 2 * M_PI * i / around;
      shape.add(rho * std::cos(angle), rho * std::sin(angle), 0);
    }
  }
  for (Index k = 0; k < rings; ++k) {
    for (Index i = 0; i < around; ++i) {
      const Index a = k * around + i, b = k * around + (i + 1) % around;
      shape.face(a, a + around, b + around);
      shape.face(a, b + around, b);
    }
  }
  return shape;
}

Shape openTube() {
  Shape tube = prism(regularPolygon(4, 1, 2), 6, 8);
  tube.triangles.resize(tube.triangles.size() - std::size_t{2} * 8 * 3);  // no caps
  return withoutLoneVertices(tube);
}

TEST(OpenSurfaces, AnOpenTube) {
  const PreparedSurface tube = preparedSoup(openTube(), 1);
  EXPECT_EQ(tube.report.boundaryCurves, 2u);
  EXPECT_EQ(tube.report.components, 1u);
  GirthSolver solver(tube.mesh);
  for (const Vertex v : tube.mesh.vertices()) {
    const GirthValue value = solver.value(v).value();
    EXPECT_EQ(value.kind, LoopKind::Loop);
    EXPECT_NEAR(value.length, 4, 1e-12) << "its perimeter, also at its ends";
  }
}

TEST(OpenSurfaces, ADisk) {
  const Index around = 24, rings = 3;
  Shape disk = annulus(0.25, 1, around, rings);
  const Index centre = disk.add(0, 0, 0);
  for (Index i = 0; i < around; ++i) disk.face(centre, i, (i + 1) % around);
  const PreparedSurface prepared = preparedSoup(disk, 2);
  EXPECT_EQ(prepared.report.boundaryCurves, 1u);
  GirthSolver solver(prepared.mesh);
  for (const Vertex v : prepared.mesh.vertices()) {
    const GirthValue value = solver.value(v).value();
    EXPECT_EQ(value.kind, LoopKind::Antipodal);
    const Vec3& p = prepared.mesh.position(v);
    // Out to the corner on the other side: vertices lie on lines through the centre to corners.
    EXPECT_NEAR(value.length, 2 * (1 + std::hypot(p.x, p.y)), 1e-12);
  }
}

TEST(OpenSurfaces, APlateWithAHole) {
  const PreparedSurface plate = preparedSoup(grid(5, 5, oneHole), 3);
  EXPECT_EQ(plate.report.boundaryCurves, 2u);
  GirthSolver solver(plate.mesh);
  // From a corner of the hole: along its boundary. From outside: over two corners of the square.
  for (const double x : {2.0, 3.0}) {
    for (const double y : {2.0, 3.0}) {
      EXPECT_NEAR(solver.value(Vertex(vertexAt(plate.mesh, x, y))).value().length, 4, 1e-12);
    }
  }
  const GirthValue outside = solver.value(Vertex(vertexAt(plate.mesh, 0, 2))).value();
  EXPECT_EQ(outside.kind, LoopKind::Loop);
  // On the line of a side, both ways: 3 along it, 1 down, and back to (0, 2) over (2, 3).
  EXPECT_NEAR(outside.length, 3 + 1 + 1 + std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(solver.value(Vertex(vertexAt(plate.mesh, 0, 0))).value().length,
              2 * std::sqrt(13.0) + 2, 1e-12);
}

TEST(OpenSurfaces, APlateWithTwoHoles) {
  const PreparedSurface plate = preparedSoup(grid(9, 5, twoHoles), 4);
  EXPECT_EQ(plate.report.boundaryCurves, 3u);
  GirthSolver solver(plate.mesh);
  // Round the nearer hole.
  for (const bool right : {false, true}) {
    const double mirror = right ? 9 : 0, sign = right ? -1 : 1;
    for (const auto& [x, y, length] : {std::array<double, 3>{2, 2, 4},
                                       {0, 2, 5 + std::sqrt(5.0)},
                                       {0, 0, 2 * std::sqrt(13.0) + 2},
                                       {4, 2, 4 + std::sqrt(2.0)}}) {
      const GirthValue value =
          solver.value(Vertex(vertexAt(plate.mesh, mirror + sign * x, y))).value();
      EXPECT_EQ(value.kind, LoopKind::Loop);
      EXPECT_NEAR(value.length, length, 1e-12) << x << ", " << y;
    }
  }
}

TEST(OpenSurfaces, AnAnnulus) {
  const Index around = 12;
  const double side = 2 * std::sin(M_PI / around);
  const PreparedSurface ring = preparedSoup(annulus(1, 3, around, 4), 5);
  EXPECT_EQ(ring.report.boundaryCurves, 2u);
  GirthSolver solver(ring.mesh);
  EXPECT_NEAR(solver.value(Vertex(vertexAt(ring.mesh, 1, 0))).value().length, around * side, 1e-12)
      << "along the inner rim";
  // From farther out: two tangents to the inner polygon, over its corners.
  for (const double rho : {1.5, 2.0, 2.5, 3.0}) {
    Index k = 0;  // the first corner at which a line to (rho, 0) leaves the polygon behind
    double best = 0;
    for (Index i = 1; i < around / 2; ++i) {
      const double angle = 2 * M_PI * i / around;
      const double turn = std::atan2(std::sin(angle), rho - std::cos(angle));
      if (turn > best) {
        best = turn;
        k = i;
      }
    }
    const double angle = 2 * M_PI * k / around;
    const double tangent = std::hypot(rho - std::cos(angle), std::sin(angle));
    EXPECT_NEAR(solver.value(Vertex(vertexAt(ring.mesh, rho, 0))).value().length,
                2 * tangent + (around - 2 * k) * side, 1e-12)
        << rho;
  }
}

TEST(OpenSurfaces, AgainstBruteForce) {
  const std::pair<Shape, double> shapes[] = {
      {openTube(), 0.05},
      {grid(4, 4, nowhere), 0.15},
      {grid(5, 5, oneHole), 0.1},
      {grid(7, 4, [](Index i, Index j) { return (i == 1 || i == 4) && j >= 1 && j < 3; }), 0.1},
      {annulus(1, 2, 8, 2), 0.1}};
  for (const auto& [drawn, noise] : shapes) {
    const SurfaceMesh mesh = perturbed(drawn, noise, 23).mesh(OpenEdges::Boundary);
    SCOPED_TRACE(std::to_string(mesh.faceCount()) + " faces");
    GirthSolver solver(mesh);
    for (const Vertex v : mesh.vertices()) {
      SCOPED_TRACE("vertex " + std::to_string(v));
      const GirthLoop loop = solver.loop(v).value();
      const BruteForce all(mesh, v, loop.length * 1.02);
      ASSERT_TRUE(all.complete());
      EXPECT_NEAR(all.distanceTo(loop.midpoint), loop.length / 2, 1e-9);
      const auto shortest = all.shortestLoop();
      if (loop.kind == LoopKind::Loop) {
        ASSERT_TRUE(shortest.has_value());
        EXPECT_NEAR(loop.length, *shortest, 1e-9);
        continue;
      }
      EXPECT_GE(shortest.value_or(loop.length), loop.length * (1 - 1e-9));
      for (const Face f : mesh.faces()) {
        EXPECT_LE(all.distanceTo(SurfacePoint::inFace(f, {1.0 / 3, 1.0 / 3, 1.0 / 3})),
                  loop.length / 2 * (1 + 1e-9));
      }
    }
  }
}

TEST(OpenSurfaces, ExactIsNaive) {
  // Random heights over a grid with holes, and surfaces with random holes.
  std::size_t loops = 0, antipodal = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Shape shape;
    if (seed % 2 == 0) {
      const double share = 0.3 * random();
      shape = grid(6, 6, [&](Index i, Index j) {
        return i > 0 && i < 5 && j > 0 && j < 5 && random() < share;
      });
      const double height = 2 * random();
      for (std::size_t i = 2; i < shape.positions.size(); i += 3) {
        shape.positions[i] = height * random();
      }
    } else {
      const RandomMesh made = randomMesh(seed);
      if (made.closed) continue;
      shape = made.shape;
    }
    // Holes that touch at corners are cut apart there.
    auto prepared = prepareSurface({shape.positions, shape.triangles});
    ASSERT_TRUE(prepared.ok()) << prepared.error().message;
    const SurfaceMesh& mesh = prepared.value().mesh;
    GirthSolver solver(mesh);
    for (const Vertex v : mesh.vertices()) {
      const GirthValue exact = solver.value(v).value(), naive = study::naiveGirth(mesh, v).value();
      EXPECT_NEAR(exact.length / naive.length, 1, 1e-9) << "vertex " << v;
      EXPECT_EQ(exact.kind, naive.kind) << "vertex " << v;
      ++(exact.kind == LoopKind::Loop ? loops : antipodal);
    }
  }
  EXPECT_GT(loops, 300u);
  EXPECT_GT(antipodal, 200u);
}

}  // namespace
}  // namespace girth::test
