// Remeshing, carrying values back, and the difference of fields.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "girth/field_difference.h"
#include "girth/girth_field.h"
#include "girth/prepare_surface.h"
#include "girth/remesh.h"
#include "girth/transfer.h"
#include "random_meshes.h"
#include "random_soups.h"

namespace girth::test {
namespace {

double leastAngle(const SurfaceMesh& mesh, Index f) {
  return std::min({mesh.cornerAngle(Halfedge(3 * f)), mesh.cornerAngle(Halfedge(3 * f + 1)),
                   mesh.cornerAngle(Halfedge(3 * f + 2))}) *
         180 / M_PI;
}

/// Topology as before, the number met.
void expectSameTopology(const SurfaceMesh& original, const SurfaceMesh& mesh, Index wanted,
                        double tolerance = 0.02) {
  EXPECT_NEAR(mesh.faceCount(), wanted, tolerance * wanted);
  EXPECT_EQ(mesh.componentCount(), original.componentCount());
  Index genus = 0, genusBefore = 0, boundaries = 0, boundariesBefore = 0;
  for (Index c = 0; c < original.componentCount(); ++c) {
    genus += mesh.genus(c);
    genusBefore += original.genus(c);
    boundaries += mesh.boundaryCount(c);
    boundariesBefore += original.boundaryCount(c);
  }
  EXPECT_EQ(genus, genusBefore);
  EXPECT_EQ(boundaries, boundariesBefore);
}

/// Also vertices on the original, and angles good.
void expectGood(const SurfaceMesh& original, const RemeshedSurface& out, Index wanted,
                double tolerance = 0.02) {
  const SurfaceMesh& mesh = out.mesh;
  expectSameTopology(original, mesh, wanted, tolerance);
  Index thin = 0;
  for (const Face f : mesh.faces()) thin += leastAngle(mesh, f) < 20 ? 1 : 0;
  EXPECT_LE(thin, mesh.faceCount() / 50);
  ASSERT_EQ(out.onOriginal.size(), mesh.vertexCount());
  Index off = 0;
  for (const Vertex v : mesh.vertices()) {
    const Vec3 p = mesh.position(v), q = positionOf(original, out.onOriginal[v]);
    if (std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) > 1e-9 * mesh.meanEdgeLength()) ++off;
  }
  EXPECT_LE(off, mesh.vertexCount() / 100);
}

RemeshedSurface remeshed(const SurfaceMesh& mesh, Index faces,
                         RemeshMethod method = RemeshMethod::Even) {
  auto out = remesh(mesh, {faces, method});
  EXPECT_TRUE(out.ok()) << out.error().message;
  return std::move(out).value();
}

/// The farthest that a vertex lies from the surface it was made of, in shares of its size.
double farthestOff(const SurfaceMesh& original, const RemeshedSurface& out) {
  double farthest = 0;
  for (const Vertex v : out.mesh.vertices()) {
    const Vec3 p = out.mesh.position(v), q = positionOf(original, out.onOriginal[v]);
    farthest = std::max(farthest, std::hypot(p.x - q.x, p.y - q.y, p.z - q.z));
  }
  return farthest / std::sqrt(original.area());
}

TEST(Remesh, FittingKeepsTheShape) {
  const Shape sphere = icosphere(5), ring = torus(3, 1, 100, 50);
  for (const Shape& shape : {sphere, ring}) {
    const SurfaceMesh mesh = shape.mesh();
    const Index faces = mesh.faceCount() / 10;
    SCOPED_TRACE(std::to_string(mesh.faceCount()) + " to " + std::to_string(faces));
    const RemeshedSurface out = remeshed(mesh, faces, RemeshMethod::Fitting);
    expectSameTopology(mesh, out.mesh, faces);
    EXPECT_NEAR(out.mesh.area() / mesh.area(), 1, 4e-3);
    EXPECT_LT(farthestOff(mesh, out), 4e-3);
  }
  // The ball would lose four times as much of its area to chords.
  const SurfaceMesh mesh = sphere.mesh();
  const auto lost = [&](RemeshMethod method) {
    return std::fabs(1 - remeshed(mesh, 500, method).mesh.area() / mesh.area());
  };
  EXPECT_LT(4 * lost(RemeshMethod::Fitting), lost(RemeshMethod::Even));
}

TEST(Remesh, FittingKeepsFlatSidesAndCornersExactly) {
  const SurfaceMesh mesh = box(1, 2, 3, 8, 16, 24).mesh();
  const RemeshedSurface out = remeshed(mesh, 200, RemeshMethod::Fitting);
  expectSameTopology(mesh, out.mesh, 200);
  EXPECT_NEAR(out.mesh.area(), 22, 0.02);
  for (int corner = 0; corner < 8; ++corner) {
    double nearest = 1;
    for (const Vertex v : out.mesh.vertices()) {
      const Vec3& p = out.mesh.position(v);
      nearest = std::min(nearest, std::hypot(p.x - (corner & 1), p.y - 2 * (corner >> 1 & 1),
                                             p.z - 3 * (corner >> 2)));
    }
    EXPECT_LT(nearest, 1e-2) << corner;
  }
}

TEST(Remesh, FittingAnyRandomSurface) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const RandomMesh made = randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.history);
    const SurfaceMesh mesh = made.shape.mesh(OpenEdges::Boundary);
    const Index faces = std::max<Index>(4, mesh.faceCount() / 3);
    const auto out = remesh(mesh, {faces});
    ASSERT_TRUE(out.ok()) << out.error().message;
    EXPECT_EQ(out.value().mesh.genus(0), mesh.genus(0));
    EXPECT_EQ(out.value().mesh.boundaryCount(0), mesh.boundaryCount(0));
    EXPECT_LE(out.value().mesh.faceCount(), mesh.faceCount());
    for (const Vertex v : out.value().mesh.vertices()) {
      ASSERT_TRUE(std::isfinite(out.value().mesh.position(v).x));
    }
  }
}

TEST(Remesh, FittingKeepsSharpPointsThatLoopsHangOn) {
  // A ball with a fine spike: the loops of its half all go round the spike, small as it is.
  Shape shape = icosphere(5);
  const SurfaceMesh smooth = shape.mesh();
  const Vertex tip(5000);
  const Vec3 p = smooth.position(tip);
  for (Index k = 0; k < 3; ++k) shape.positions[3 * tip + k] *= 1.2;
  const SurfaceMesh mesh = shape.mesh();
  ASSERT_LT(mesh.totalAngle(Vertex(tip)), M_PI);
  const RemeshedSurface out = remeshed(mesh, 600, RemeshMethod::Fitting);
  double sharpest = 2 * M_PI;
  for (const Vertex v : out.mesh.vertices()) {
    const Vec3& q = out.mesh.position(v);
    if (q.x * p.x + q.y * p.y + q.z * p.z > 1.1) {
      sharpest = std::min(sharpest, out.mesh.totalAngle(v));
    }
  }
  EXPECT_NEAR(sharpest, mesh.totalAngle(Vertex(tip)), 0.2);
}

TEST(Remesh, FittingToTheFewestFaces) {
  EXPECT_EQ(remeshed(icosphere(3).mesh(), 4, RemeshMethod::Fitting).mesh.faceCount(), 4u);
  // More than there are: even triangles.
  const SurfaceMesh mesh = icosphere(2).mesh();
  expectGood(mesh, remeshed(mesh, 2000, RemeshMethod::Fitting), 2000);
}

TEST(Remesh, KeepsTopologyAndMeetsTheNumber) {
  for (const Shape& shape : {icosphere(4), torus(3, 1, 40, 20), plate(2), octasphere(1)}) {
    const SurfaceMesh mesh = shape.mesh();
    for (const Index faces : {1200u, 5000u}) {
      SCOPED_TRACE(std::to_string(mesh.faceCount()) + " to " + std::to_string(faces));
      expectGood(mesh, remeshed(mesh, faces), faces);
    }
  }
}

TEST(Remesh, FromNeedles) {
  // A few long triangles: a tall prism, and one drawn out.
  for (const double stretch : {1.0, 6.0}) {
    Shape shape = prism(regularPolygon(5, 1), 12, 1);
    for (std::size_t i = 0; i < shape.positions.size(); i += 3) shape.positions[i] *= stretch;
    const SurfaceMesh mesh = shape.mesh();
    expectGood(mesh, remeshed(mesh, 3000), 3000);
  }
}

TEST(Remesh, SharpEdgesAndCornersStay) {
  const SurfaceMesh mesh = box(1, 2, 3, 4, 8, 12).mesh();
  const RemeshedSurface out = remeshed(mesh, 900);
  expectGood(mesh, out, 900);
  EXPECT_NEAR(out.mesh.area(), 22, 1e-9);
  for (int corner = 0; corner < 8; ++corner) {
    bool found = false;
    for (const Vertex v : out.mesh.vertices()) {
      const Vec3& p = out.mesh.position(v);
      found = found ||
              (p.x == (corner & 1) && p.y == 2 * (corner >> 1 & 1) && p.z == 3 * (corner >> 2));
    }
    EXPECT_TRUE(found) << corner;
  }
}

TEST(Remesh, LinesThatBendBack) {
  // Flat stars, twisted: the middle of an edge of the outline may be nearest to another tooth of
  // it.
  for (const int teeth : {8, 12, 20}) {
    for (const double height : {0.02, 0.1}) {
      std::vector<double> star;
      for (int i = 0; i < 2 * teeth; ++i) {
        const double radius = i % 2 == 0 ? 1 : 0.2, angle = M_PI * i / teeth;
        star.insert(star.end(), {radius * std::cos(angle), radius * std::sin(angle)});
      }
      Shape shape = prism(star, height, 3);
      for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
        const double x = shape.positions[i], y = shape.positions[i + 1];
        const double turn = 0.6 * shape.positions[i + 2] / height;
        shape.positions[i] = x * std::cos(turn) - y * std::sin(turn);
        shape.positions[i + 1] = x * std::sin(turn) + y * std::cos(turn);
      }
      const SurfaceMesh mesh = shape.mesh();
      for (const Index faces : {50u, 100u, 200u, 400u}) {
        SCOPED_TRACE(std::to_string(teeth) + " teeth, " + std::to_string(faces) + " faces");
        const auto out = remesh(mesh, {faces, RemeshMethod::Even});
        ASSERT_TRUE(out.ok()) << out.error().message;
        EXPECT_EQ(out.value().mesh.genus(0), 0u);
      }
    }
  }
}

TEST(Remesh, BoundariesStay) {
  // A flat square with a square hole, both rims kept to.
  Shape shape;
  const Index n = 12;
  for (Index i = 0; i <= n * (n + 2); ++i) shape.add(i % (n + 1), i / (n + 1), 0);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      if (i >= 4 && i < 8 && j >= 4 && j < 8) continue;
      const Index a = j * (n + 1) + i;
      shape.face(a, a + 1, a + n + 2);
      shape.face(a, a + n + 2, a + n + 1);
    }
  }
  const SurfaceMesh mesh = withoutLoneVertices(shape).mesh(OpenEdges::Boundary);
  for (const Index faces : {80u, 2000u}) {
    const RemeshedSurface out = remeshed(mesh, faces);
    expectGood(mesh, out, faces, 0.1);
    double rim = 0;
    for (const Halfedge h : out.mesh.halfedges()) {
      if (out.mesh.twin(h) == kNoIndex) rim += out.mesh.length(h);
    }
    EXPECT_NEAR(rim, 64, 1e-9) << "its corners stay";
    EXPECT_NEAR(out.mesh.area(), 128, 1e-9);
  }
  const RemeshedSurface fitted = remeshed(mesh, 40, RemeshMethod::Fitting);
  expectSameTopology(mesh, fitted.mesh, 40, 0.1);
  double rim = 0;
  for (const Halfedge h : fitted.mesh.halfedges()) {
    if (fitted.mesh.twin(h) == kNoIndex) rim += fitted.mesh.length(h);
  }
  EXPECT_NEAR(rim, 64, 1e-2);
  EXPECT_NEAR(fitted.mesh.area(), 128, 1e-2);
}

TEST(Remesh, AnyRandomSurface) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const RandomMesh made = randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.history);
    const SurfaceMesh mesh = made.shape.mesh(OpenEdges::Boundary);
    const auto out = remesh(mesh, {1000, RemeshMethod::Even});
    ASSERT_TRUE(out.ok()) << out.error().message;
    EXPECT_EQ(out.value().mesh.genus(0), mesh.genus(0));
    EXPECT_EQ(out.value().mesh.boundaryCount(0), mesh.boundaryCount(0));
    EXPECT_NEAR(out.value().mesh.faceCount(), 1000, 60);
  }
}

/// The component of the original that a point lies on.
Index componentOf(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const Index halfedge =
      point.kind == SurfacePoint::Kind::InFace ? 3 * point.element : point.element;
  return mesh.componentOf(point.kind == SurfacePoint::Kind::AtVertex
                              ? Vertex(point.element)
                              : mesh.from(Halfedge(halfedge)));
}

/// Expects that each component has become one of the same topology, which lies on it.
void expectSameComponents(const SurfaceMesh& original, const RemeshedSurface& out) {
  const SurfaceMesh& mesh = out.mesh;
  ASSERT_EQ(mesh.componentCount(), original.componentCount());
  std::vector<Index> origin(mesh.componentCount(), kNoIndex);
  for (const Vertex v : mesh.vertices()) {
    Index& from = origin[mesh.componentOf(v)];
    const Index here = componentOf(original, out.onOriginal[v]);
    if (from == kNoIndex) from = here;
    ASSERT_EQ(from, here) << "vertex " << v;
  }
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    EXPECT_EQ(mesh.genus(c), original.genus(origin[c])) << "component " << origin[c];
    EXPECT_EQ(mesh.boundaryCount(c), original.boundaryCount(origin[c]))
        << "component " << origin[c];
  }
  std::sort(origin.begin(), origin.end());
  EXPECT_EQ(std::unique(origin.begin(), origin.end()), origin.end());
}

void expectRemeshable(std::uint64_t seed, Index most) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Shape shape = randomLeftovers(seed, most);
  const auto prepared = prepareSurface({shape.positions, shape.triangles});
  if (!prepared) return;
  const SurfaceMesh& mesh = prepared.value().mesh;
  // Few and many, fewer and more than there are.
  Random random(seed + 1);
  const auto faces = static_cast<Index>(4 * std::pow(most, random()));
  for (const RemeshMethod method : {RemeshMethod::Fitting, RemeshMethod::Even}) {
    const auto out = remesh(mesh, {faces, method});
    ASSERT_TRUE(out.ok()) << out.error().message << ", " << mesh.faceCount() << " to " << faces;
    expectSameComponents(mesh, out.value());
  }
}

TEST(Remesh, WhateverModelsLeaveBehind) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    expectRemeshable(seed, 600);
    if (HasFailure()) return;
  }
}

TEST(Remesh, ComponentsOfTwoFacesStayAsTheyAre) {
  Shape shape = icosphere(1);
  for (Index i = 0; i < 3; ++i) shape.add(5 + (i == 1), i == 2, 0);
  shape.face(42, 43, 44);
  shape.face(42, 44, 43);
  const SurfaceMesh mesh = shape.mesh();
  for (const RemeshMethod method : {RemeshMethod::Fitting, RemeshMethod::Even}) {
    const RemeshedSurface out = remeshed(mesh, 3000, method);
    expectSameComponents(mesh, out);
    EXPECT_GT(out.mesh.faceCount(), 2000u);
  }
}

TEST(Remesh, OfAnySizeAndShape) {
  for (const double scale : {1e-250, 1e-70, 1e70, 1e250}) {
    SCOPED_TRACE(scale);
    const SurfaceMesh mesh = moved(icosphere(2), scale, 0, 0).mesh();
    const RemeshedSurface out = remeshed(mesh, 1000);
    EXPECT_NEAR(out.mesh.faceCount(), 1000, 20);
    EXPECT_NEAR(out.mesh.meanEdgeLength() / scale, 0.16, 0.03);
    const RemeshedSurface fitted = remeshed(mesh, 100, RemeshMethod::Fitting);
    EXPECT_EQ(fitted.mesh.faceCount(), 100u);
    EXPECT_NEAR(fitted.mesh.meanEdgeLength() / scale, 0.53, 0.05);
  }
  // A spike, a million times as long as it is thick.
  Shape spike = prism(regularPolygon(3, 1), 1e6, 1);
  const auto out = remesh(spike.mesh(), {2000});
  ASSERT_TRUE(out.ok()) << out.error().message;
  EXPECT_LT(out.value().mesh.faceCount(), 9000u);
}

TEST(Remesh, TheSameEveryTime) {
  const SurfaceMesh mesh = perturbed(torus(3, 1, 20, 10), 0.2, 4).mesh();
  const RemeshedSurface one = remeshed(mesh, 700), two = remeshed(mesh, 700);
  ASSERT_EQ(one.mesh.vertexCount(), two.mesh.vertexCount());
  for (const Vertex v : one.mesh.vertices()) {
    EXPECT_EQ(one.mesh.position(v).x, two.mesh.position(v).x);
  }
  // As far from the origin as coordinates allow.
  const SurfaceMesh away = moved(icosphere(4), 1, 1e6, 0).mesh();
  EXPECT_LT(farthestOff(away, remeshed(away, 500, RemeshMethod::Fitting)), 1e-2);
}

TEST(Remesh, StopsAndSaysWhatIsWrong) {
  const SurfaceMesh mesh = icosphere(2).mesh();
  EXPECT_EQ(remesh(mesh, {3}).error().code, ErrorCode::InvalidOption);
  const std::atomic<bool> stop{true};
  ExecutionContext context;
  context.cancel = &stop;
  EXPECT_EQ(remesh(mesh, {1000}, context).error().code, ErrorCode::Cancelled);
  const SurfaceMesh dense = icosphere(5).mesh();
  EXPECT_EQ(remesh(dense, {1000}, context).error().code, ErrorCode::Cancelled);
  // In the midst, too.
  for (const RemeshMethod method : {RemeshMethod::Fitting, RemeshMethod::Even}) {
    std::atomic<bool> later{false};
    ExecutionContext begun;
    begun.cancel = &later;
    begun.onProgress = [&](double fraction) {
      EXPECT_LT(fraction, 1);
      later = true;
    };
    EXPECT_EQ(remesh(dense, {1000, method}, begun).error().code, ErrorCode::Cancelled);
  }
  double last = 0;
  ExecutionContext watched;
  watched.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  EXPECT_TRUE(remesh(mesh, {1000}, watched).ok());
  EXPECT_EQ(last, 1);
  last = 0;
  EXPECT_TRUE(remesh(dense, {1000}, watched).ok());
  EXPECT_EQ(last, 1);
}

TEST(Transfer, LinearValuesComeBack) {
  // A linear function on a box: exact wherever the nearest point lies in the right face.
  const SurfaceMesh mesh = box(1, 2, 3, 3, 5, 7).mesh();
  const RemeshedSurface out = remeshed(mesh, 1500);
  std::vector<double> values;
  for (const Vertex v : out.mesh.vertices()) {
    const Vec3& p = out.mesh.position(v);
    values.push_back(p.x + 2 * p.y - p.z);
  }
  const auto places = nearestPoints(out.mesh, mesh);
  const auto back = interpolated(out.mesh, values, places);
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    EXPECT_NEAR(back[v], p.x + 2 * p.y - p.z, 1e-9);
  }
  // Where values jump, that of the nearest corner is taken.
  for (double& value : values) value = value > 1 ? 100 : 0;
  for (const double value : interpolated(out.mesh, values, places, 2)) {
    EXPECT_NEAR(std::fabs(value - 50), 50, 1e-9) << value;
  }
}

TEST(Transfer, NotThroughThinWalls) {
  const SurfaceMesh mesh = box(10, 10, 0.01, 6, 6, 1).mesh();
  std::vector<double> values;
  for (const Vertex v : mesh.vertices()) values.push_back(mesh.position(v).z > 0 ? 1 : 0);
  Shape shifted = box(10, 10, 0.01, 5, 5, 1);
  for (std::size_t i = 2; i < shifted.positions.size(); i += 3) shifted.positions[i] -= 0.008;
  const SurfaceMesh other = shifted.mesh();
  const auto back = interpolated(mesh, values, nearestPoints(mesh, other));
  for (const Vertex v : other.vertices()) {
    const Vec3& p = other.position(v);
    if (p.x < 1 || p.x > 9 || p.y < 1 || p.y > 9) continue;  // inside the two sides
    EXPECT_NEAR(back[v], p.z > -0.005 ? 1 : 0, 1e-9);
  }
}

TEST(FieldDifference, ClosedForms) {
  const SurfaceMesh small = icosphere(2).mesh(), large = moved(icosphere(3), 5, 0.3, 1).mesh();
  const std::vector<double> one(small.vertexCount(), 2 * std::sqrt(small.area()));
  const std::vector<double> same(large.vertexCount(), 2 * std::sqrt(large.area()));
  EXPECT_NEAR(fieldDifference(small, one, large, same), 0, 1e-12) << "size does not matter";
  const std::vector<double> more(large.vertexCount(), 2.5 * std::sqrt(large.area()));
  EXPECT_NEAR(fieldDifference(small, one, large, more), 0.5, 1e-12) << "all values moved by 0.5";
  EXPECT_NEAR(fieldDifference(large, more, small, one), 0.5, 1e-12);
  const std::vector<double> none(small.vertexCount(), std::nan(""));
  EXPECT_TRUE(std::isnan(fieldDifference(small, none, large, same)));
}

TEST(Remesh, TheGirthStaysNearlyTheSame) {
  const SurfaceMesh mesh = torus(2, 0.8, 40, 20).mesh();
  const GirthField field = girthField(mesh);
  const auto differenceTo = [&](const RemeshedSurface& out) {
    return fieldDifference(mesh, field.values, out.mesh, girthField(out.mesh).values);
  };
  EXPECT_LT(differenceTo(remeshed(mesh, 1000)), 1e-2);
  EXPECT_LT(differenceTo(remeshed(mesh, 400, RemeshMethod::Fitting)), 5e-3);
}

}  // namespace
}  // namespace girth::test
