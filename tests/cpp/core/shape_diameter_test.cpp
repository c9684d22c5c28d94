// The shape diameter function: shapes with known thickness, rays by brute force, and bad input.
#include "girth/shape_diameter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "descriptors/triangle_tree.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Random;
using test::Shape;

/// Every face, one after the other, by its plane and the sides of its triangle.
std::optional<RayHit> firstHitByTrying(const SurfaceMesh& mesh, const Vec3& origin,
                                       const Vec3& direction, Index vertex) {
  std::optional<RayHit> best;
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.faceVertices(f);
    if (a == vertex || b == vertex || c == vertex) continue;
    const Vec3 p[3] = {mesh.position(Vertex(a)), mesh.position(Vertex(b)),
                       mesh.position(Vertex(c))};
    const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
    const double along = dot(direction, normal);
    const double distance = dot(p[0] - origin, normal) / along;
    if (along == 0 || !(distance > 0) || (best && distance >= best->distance)) continue;
    const Vec3 at = origin + distance * direction;
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      inside &= dot(cross(p[(k + 1) % 3] - p[k], at - p[k]), normal) >= 0;
    }
    if (inside) best = RayHit{distance, f, along > 0};
  }
  return best;
}

Vec3 randomDirection(Random& random) {
  for (;;) {
    const Vec3 d{2 * random() - 1, 2 * random() - 1, 2 * random() - 1};
    const double length = norm(d);
    if (length > 0.1 && length <= 1) return (1 / length) * d;
  }
}

/// Rays of random directions from every vertex, and from random points around.
void expectSameHits(const SurfaceMesh& mesh, std::uint64_t seed) {
  const TriangleTree tree(mesh);
  Random random(seed);
  Index hits = 0;
  for (Index i = 0; i < 600; ++i) {
    const bool fromVertex = i % 2 == 0;
    const Index v = random.below(mesh.vertexCount());
    const Vec3 origin =
        fromVertex ? mesh.position(Vertex(v))
                   : mesh.position(Vertex(v)) + 2 * mesh.meanEdgeLength() * randomDirection(random);
    const Vec3 direction = randomDirection(random);
    const Index skipped = fromVertex ? v : kNoIndex;
    const auto expected = firstHitByTrying(mesh, origin, direction, skipped);
    const auto hit = tree.firstHit(origin, direction, skipped);
    const auto portable = tree.firstHit(origin, direction, skipped, portableRayKernel());
    ASSERT_EQ(hit.has_value(), portable.has_value()) << "ray " << i;
    ASSERT_EQ(hit.has_value(), expected.has_value()) << "ray " << i;
    if (!hit) continue;
    ++hits;
    EXPECT_EQ(hit->distance, portable->distance) << "any number of lanes, ray " << i;
    EXPECT_EQ(hit->face, portable->face) << "ray " << i;
    EXPECT_EQ(hit->fromBehind, portable->fromBehind) << "ray " << i;
    EXPECT_NEAR(hit->distance, expected->distance, 1e-9 * expected->distance) << "ray " << i;
    EXPECT_EQ(hit->fromBehind, expected->fromBehind) << "ray " << i;
  }
  EXPECT_GT(hits, 15u);
}

TEST(TriangleTree, FindsWhatTryingEveryFaceFinds) {
  expectSameHits(test::perturbed(test::icosphere(3), 0.2, 1).mesh(), 1);
  expectSameHits(test::perturbed(test::torus(3, 1, 24, 12), 0.2, 2).mesh(), 2);
  expectSameHits(test::perturbed(test::plate(2), 0.1, 3).mesh(), 3);
  expectSameHits(test::tetrahedron().mesh(), 4);
}

TEST(TriangleTree, IsRightFarFromTheOriginAndAtAnyScale) {
  const Shape shape = test::perturbed(test::icosphere(3), 0.2, 1);
  expectSameHits(test::moved(shape, 1e-6, 0.3, 0).mesh(), 5);
  expectSameHits(test::moved(shape, 1e6, 0.3, 0).mesh(), 6);
  expectSameHits(test::moved(shape, 1, 0.3, 1e4).mesh(), 7);
  // Beyond what single precision holds.
  expectSameHits(test::moved(shape, 1e-50, 0.3, 0).mesh(), 8);
  expectSameHits(test::moved(shape, 1e50, 0.3, 0).mesh(), 9);
}

TEST(TriangleTree, StaysShallowWhereAllFacesLieOverEachOther) {
  // 3000 faces with one centre and one box.
  Shape fan;
  for (int i = 0; i < 3000; ++i) {
    const Index a = fan.add(-1, -1, 0), b = fan.add(1, -1, 0), c = fan.add(0, 2, 0);
    fan.face(a, b, c);
  }
  const SurfaceMesh mesh = fan.mesh(OpenEdges::Boundary);
  const auto hit = TriangleTree(mesh).firstHit({0, 0, 1}, {0, 0, -1}, kNoIndex);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->distance, 1);
  EXPECT_FALSE(hit->fromBehind);
}

ShapeDiameterField fieldOf(const SurfaceMesh& mesh, const ShapeDiameterOptions& options = {}) {
  auto field = shapeDiameter(mesh, options);
  EXPECT_TRUE(field.ok());
  return field.ok() ? std::move(field).value() : ShapeDiameterField{};
}

/// The definition on a shape where a ray at angle t from the axis has the length `lengthAt(t)`.
template <class LengthAt>
double expectedValue(LengthAt lengthAt) {
  std::vector<double> angles, lengths;
  for (int i = 0; i < 30; ++i) {
    angles.push_back((i + 0.5) / 30 * kPi / 3);
    lengths.push_back(lengthAt(angles.back()));
  }
  std::vector<double> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());
  const double median = (sorted[14] + sorted[15]) / 2;
  double mean = 0, squares = 0;
  for (const double l : lengths) mean += l / 30;
  for (const double l : lengths) squares += (l - mean) * (l - mean) / 30;
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (std::fabs(lengths[i] - median) > std::sqrt(squares)) continue;
    sum += lengths[i] / angles[i];
    weight += 1 / angles[i];
  }
  return sum / weight;
}

TEST(ShapeDiameter, OfASphere) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  const double expected = expectedValue([](double t) { return 2 * std::cos(t); });
  EXPECT_NEAR(expected, 1.93, 0.02);
  const ShapeDiameterField field = fieldOf(mesh);
  EXPECT_TRUE(field.complete);
  EXPECT_FALSE(field.insideOut);
  EXPECT_EQ(field.withoutValue, 0u);
  // The fineness of the sphere decides whether one more ray lies within a standard deviation.
  for (const double value : field.values) EXPECT_NEAR(value, expected, 0.05);
}

TEST(ShapeDiameter, OfASlab) {
  const SurfaceMesh mesh = test::box(20, 20, 0.5, 20, 20, 1).mesh();
  const double expected = expectedValue([](double t) { return 0.5 / std::cos(t); });
  EXPECT_NEAR(expected, 0.52, 0.005);
  const ShapeDiameterField field = fieldOf(mesh);
  Index inner = 0;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (p.x < 1.5 || p.x > 18.5 || p.y < 1.5 || p.y > 18.5) continue;
    EXPECT_NEAR(field.values[v], expected, 1e-9);
    ++inner;
  }
  EXPECT_GT(inner, 500u);
}

TEST(ShapeDiameter, OfACylinder) {
  // Rays run across a circle at an angle: between a slab's and a sphere's lengths.
  const SurfaceMesh mesh = test::prism(test::regularPolygon(64, 2 * kPi / 64), 20, 40).mesh();
  const ShapeDiameterField field = fieldOf(mesh);
  Index inner = 0;
  for (const Vertex v : mesh.vertices()) {
    if (std::fabs(mesh.position(v).z - 10) > 5) continue;
    EXPECT_NEAR(field.values[v], 2, 0.1);
    ++inner;
  }
  EXPECT_GT(inner, 500u);
}

TEST(ShapeDiameter, OfATubeIsThatOfItsWall) {
  // An outer and an inner tube, joined by rings: a wall of 0.2.
  Shape tube;
  const Index around = 48, rings = 40;
  for (Index r = 0; r <= rings; ++r) {
    for (const double radius : {1.0, 0.8}) {
      for (Index i = 0; i < around; ++i) {
        const double angle = 2 * kPi * i / around;
        tube.add(radius * std::cos(angle), radius * std::sin(angle), 0.25 * r);
      }
    }
  }
  const auto at = [&](Index ring, Index shell, Index i) {
    return (2 * ring + shell) * around + i % around;
  };
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    tube.face(a, b, c);
    tube.face(a, c, d);
  };
  for (Index i = 0; i < around; ++i) {
    for (Index r = 0; r < rings; ++r) {
      quad(at(r, 0, i), at(r, 0, i + 1), at(r + 1, 0, i + 1), at(r + 1, 0, i));
      quad(at(r, 1, i + 1), at(r, 1, i), at(r + 1, 1, i), at(r + 1, 1, i + 1));
    }
    quad(at(0, 1, i), at(0, 1, i + 1), at(0, 0, i + 1), at(0, 0, i));
    quad(at(rings, 0, i), at(rings, 0, i + 1), at(rings, 1, i + 1), at(rings, 1, i));
  }
  const SurfaceMesh mesh = tube.mesh();
  const ShapeDiameterField field = fieldOf(mesh);
  EXPECT_FALSE(field.insideOut);
  for (const Vertex v : mesh.vertices()) {
    if (std::fabs(mesh.position(v).z - 5) > 3) continue;
    EXPECT_NEAR(field.values[v], 0.21, 0.02);
  }
}

TEST(ShapeDiameter, FollowsScaleAndMotionAndThreadsDoNotMatter) {
  const Shape shape = test::perturbed(test::torus(3, 1, 48, 24), 0.2, 9);
  const ShapeDiameterField field = fieldOf(shape.mesh());
  const ShapeDiameterField twice = fieldOf(test::moved(shape, 2, 0, 0).mesh());
  // A rotated copy sends its rays in other directions around the axis.
  const ShapeDiameterField turned = fieldOf(test::moved(shape, 1, 0.7, 5).mesh());
  double difference = 0;
  for (std::size_t v = 0; v < field.values.size(); ++v) {
    EXPECT_NEAR(twice.values[v], 2 * field.values[v], 1e-12);
    EXPECT_NEAR(turned.values[v], field.values[v], 0.25 * field.values[v]);
    difference += std::fabs(turned.values[v] / field.values[v] - 1);
  }
  EXPECT_LT(difference / static_cast<double>(field.values.size()), 0.02);

  for (const unsigned threads : {1u, 2u, 5u}) {
    ExecutionContext context;
    context.threads = threads;
    const auto again = shapeDiameter(shape.mesh(), {}, context);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again.value().values, field.values);
  }
}

TEST(ShapeDiameter, RaysThatEscapeDoNotCount) {
  // A flat patch has nothing behind it.
  Shape patch;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) patch.add(x, y, 0);
  patch.face(0, 1, 2);
  patch.face(0, 2, 3);
  const ShapeDiameterField field = fieldOf(patch.mesh(OpenEdges::Boundary));
  EXPECT_EQ(field.withoutValue, 4u);
  EXPECT_FALSE(field.insideOut);
  for (const double value : field.values) EXPECT_TRUE(std::isnan(value));
}

TEST(ShapeDiameter, SaysWhenASurfaceIsInsideOut) {
  Shape sphere = test::icosphere(2);
  for (std::size_t i = 0; i < sphere.triangles.size(); i += 3) {
    std::swap(sphere.triangles[i], sphere.triangles[i + 1]);
  }
  const ShapeDiameterField field = fieldOf(sphere.mesh());
  EXPECT_TRUE(field.insideOut);
  EXPECT_EQ(field.withoutValue, static_cast<Index>(field.values.size()));
}

TEST(ShapeDiameter, OfOneBodyInsideAnotherIsThatOfTheShell) {
  // A sphere of radius 1, its inner wall of radius 0.7 looking into the hollow.
  Shape shell = test::icosphere(4);
  const Index count = shell.vertexCount();
  const std::size_t faces = shell.triangles.size();
  for (Index v = 0; v < count; ++v) {
    shell.add(0.7 * shell.positions[3 * v], 0.7 * shell.positions[3 * v + 1],
              0.7 * shell.positions[3 * v + 2]);
  }
  for (std::size_t i = 0; i < faces; i += 3) {
    shell.face(shell.triangles[i] + count, shell.triangles[i + 2] + count,
               shell.triangles[i + 1] + count);
  }
  const ShapeDiameterField field = fieldOf(shell.mesh());
  EXPECT_FALSE(field.insideOut);
  for (const double value : field.values) EXPECT_NEAR(value, 0.32, 0.05);
}

TEST(ShapeDiameter, OptionsOutOfRangeAreRefused) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  for (const double angle : {0.0, -1.0, 4.0, std::nan("")}) {
    EXPECT_FALSE(shapeDiameter(mesh, {angle, 30}).ok()) << angle;
  }
  EXPECT_FALSE(shapeDiameter(mesh, {2, 0}).ok());
  EXPECT_FALSE(shapeDiameter(mesh, {2, 10'001}).ok());
  EXPECT_TRUE(shapeDiameter(mesh, {2, 1}).ok());
}

TEST(ShapeDiameter, StopsWhenTold) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  const std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  const auto field = shapeDiameter(mesh, {}, context);
  ASSERT_TRUE(field.ok());
  EXPECT_FALSE(field.value().complete);
}

}  // namespace
}  // namespace girth
