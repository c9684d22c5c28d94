// The bottleneck between two points: waists of known length, rings that can be gone round on two
// sides, an exhaustive search over fine vertices, boundaries, and bad input.
#include "girth/bottleneck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <vector>

#include "girth/girth_field.h"
#include "girth/necks.h"
#include "lathe.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using test::lathe;
using test::polygonLength;
using test::Ring;
using test::Shape;

SurfacePoint at(Index vertex) { return SurfacePoint::atVertex(Vertex(vertex)); }

Bottleneck between(const SurfaceMesh& mesh, const SurfacePoint& from, const SurfacePoint& to) {
  const auto found = findBottleneck(mesh, girthField(mesh).values, from, to);
  EXPECT_TRUE(found.ok()) << (found.ok() ? "" : found.error().text());
  return found.ok() ? found.value() : Bottleneck{};
}

/// Checks rules that must hold for every answer.
void expectConsistent(const SurfaceMesh& mesh, const Bottleneck& found, const SurfacePoint& from,
                      const SurfacePoint& to) {
  GirthSolver solver(mesh);
  ASSERT_FALSE(found.way.empty());
  EXPECT_LT(norm(positionOf(mesh, found.way.front()) - positionOf(mesh, from)), 1e-9);
  EXPECT_LT(norm(positionOf(mesh, found.way.back()) - positionOf(mesh, to)), 1e-9);
  const double ends = std::min(solver.value(from).value().length, solver.value(to).value().length);
  double least = ends;
  for (const SurfacePoint& point : found.way) {
    least = std::min(least, solver.value(point).value().length);
  }
  // The way is a witness, to the hundredth that its pieces leave open.
  EXPECT_GE(least, found.girth * (1 - 1e-9));
  EXPECT_LE(least, found.girth * 1.02);
  EXPECT_LE(found.girth, ends * (1 + 1e-9));
  double length = 0;
  for (std::size_t i = 0; i + 1 < found.points.size(); ++i) {
    length += norm(positionOf(mesh, found.points[i + 1]) - positionOf(mesh, found.points[i]));
  }
  EXPECT_NEAR(length, found.girth, 1e-9 * length);
  EXPECT_EQ(found.kind == BottleneckKind::Neck, !found.sides.empty());
}

/// Bellies and waists in turns.
const std::vector<Ring> kWaists{{0, 1.8}, {4, 1},      {8.8, 2.2}, {14.8, 0.7},
                                {20, 2},  {23.2, 1.2}, {25, 1.9}};

TEST(Bottleneck, isTheNarrowestWaistBetween) {
  constexpr Index kSides = 8;
  const SurfaceMesh mesh = lathe(kWaists, kSides).mesh();
  struct Case {
    Index from, to;
    std::size_t waist;
  };
  for (const auto& [from, to, waist] :
       {Case{2, 4, 3}, Case{4, 2, 3}, Case{4, 6, 5}, Case{0, 2, 1}, Case{2, 6, 3}, Case{0, 6, 3}}) {
    for (const Index turn : {0u, 3u}) {
      const SurfacePoint a = at(from * kSides), b = at(to * kSides + turn);
      const Bottleneck found = between(mesh, a, b);
      expectConsistent(mesh, found, a, b);
      EXPECT_EQ(found.kind, BottleneckKind::Neck);
      EXPECT_NEAR(found.girth, polygonLength(kWaists[waist].radius, kSides), 1e-9);
      EXPECT_LT(norm(found.centre - Vec3{0, 0, kWaists[waist].z}), 1e-9);
      EXPECT_EQ(found.sides.size(), 2u);
    }
  }
}

TEST(Bottleneck, betweenPointsOfFacesAndOfEdges) {
  constexpr Index kSides = 8;
  const SurfaceMesh mesh = lathe(kWaists, kSides).mesh();
  const Halfedge edge = mesh.outgoing(Vertex(4 * kSides));
  for (const SurfacePoint& a : {SurfacePoint::inFace(Face(2 * kSides), {0.6, 0.3, 0.1}),
                                SurfacePoint::inFace(Face(3 * kSides), {0.5, 0.5, 0}),
                                SurfacePoint::inFace(Face(3 * kSides), {1, 0, 0})}) {
    const SurfacePoint b = SurfacePoint::onHalfedge(edge, 0.1);
    const Bottleneck found = between(mesh, a, b);
    expectConsistent(mesh, found, a, b);
    EXPECT_LE(found.girth, polygonLength(1, kSides) + 1e-9);
  }
  // Both in one face, and the same point twice.
  const SurfacePoint a = SurfacePoint::inFace(Face(5), {0.2, 0.3, 0.5});
  const SurfacePoint b = SurfacePoint::inFace(Face(5), {0.3, 0.3, 0.4});
  expectConsistent(mesh, between(mesh, a, b), a, b);
  const Bottleneck same = between(mesh, a, a);
  EXPECT_EQ(same.kind, BottleneckKind::End);
  EXPECT_EQ(same.girth, GirthSolver(mesh).value(a).value().length);
}

TEST(Bottleneck, noNeckBetweenIsAnAnswer) {
  constexpr Index kSides = 8;
  const SurfaceMesh mesh = lathe(kWaists, kSides).mesh();
  // On the flank of a belly, from which the girth rises all the way; and on the waist itself.
  GirthSolver solver(mesh);
  for (const SurfacePoint& low :
       {SurfacePoint::inFace(Face(2 * 2 * kSides), {0.35, 0.05, 0.6}), at(3 * kSides)}) {
    const Bottleneck found = between(mesh, at(2 * kSides), low);
    expectConsistent(mesh, found, at(2 * kSides), low);
    EXPECT_EQ(found.kind, BottleneckKind::End);
    EXPECT_EQ(found.girth, solver.value(low).value().length);
    EXPECT_LT(norm(positionOf(mesh, found.place) - positionOf(mesh, low)), 1e-12);
    EXPECT_TRUE(found.sides.empty());
  }
}

/// A ring whose sections are regular polygons of different radii round a circle, narrowest at a
/// quarter and at three quarters of it.
Shape unevenRing(double circle, const std::vector<double>& radii, Index across) {
  Shape shape;
  const auto around = static_cast<Index>(radii.size());
  for (Index k = 0; k < around; ++k) {
    const double turn = 2 * kPi * k / around;
    for (Index i = 0; i < across; ++i) {
      const double angle = 2 * kPi * i / across, out = circle + radii[k] * std::cos(angle);
      shape.add(out * std::cos(turn), out * std::sin(turn), radii[k] * std::sin(angle));
    }
  }
  for (Index k = 0; k < around; ++k) {
    for (Index i = 0; i < across; ++i) {
      const Index next = (k + 1) % around, up = (i + 1) % across;
      const Index a = k * across + i, b = next * across + i, c = next * across + up,
                  d = k * across + up;
      // The narrowest sections are planes of symmetry.
      if ((k / (around / 4)) % 2 == 0) {
        shape.face(a, b, c);
        shape.face(a, c, d);
      } else {
        shape.face(a, b, d);
        shape.face(b, c, d);
      }
    }
  }
  return shape;
}

TEST(Bottleneck, goesRoundTheWiderSideOfARing) {
  constexpr Index kAcross = 8;
  // So thick beside the narrow sections that these are narrowest on the ring's outside too.
  const std::vector<double> radii{2, 1.8, 1.5, 0.5, 1.5, 1.8, 2, 1.9, 1.7, 0.8, 1.7, 1.9};
  const SurfaceMesh mesh = unevenRing(4, radii, kAcross).mesh();
  const SurfacePoint a = at(0), b = at(6 * kAcross);
  const Bottleneck found = between(mesh, a, b);
  expectConsistent(mesh, found, a, b);
  EXPECT_EQ(found.kind, BottleneckKind::Neck);
  EXPECT_NEAR(found.girth, polygonLength(0.8, kAcross), 1e-9);
  EXPECT_EQ(found.sides.size(), 1u);  // the ring stays in one piece
}

/// The greatest girth such that all vertices of at least this girth have a way between two of them.
double overVertices(const SurfaceMesh& mesh, const std::vector<double>& girth, Index from,
                    Index to) {
  std::vector<Index> parent(mesh.vertexCount());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto find = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<Index> order = parent;
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return girth[a] > girth[b]; });
  for (const Index v : order) {
    const Halfedge first = mesh.outgoing(Vertex(v));
    for (Halfedge h = first;;) {
      const Vertex other = mesh.to(h);
      if (girth[other] >= girth[v]) parent[find(v)] = find(other);
      h = mesh.twin(SurfaceMesh::previous(h));
      if (h == first) break;
    }
    if (find(from) == find(to)) return girth[v];
  }
  return 0;
}

TEST(Bottleneck, asAnExhaustiveSearchOverFineVertices) {
  const std::vector<Ring> rings{{0, 1}, {1, 2}, {2.5, 1}, {4, 2}, {5, 0.8}, {6.5, 2}, {7, 1}};
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Shape shape = test::perturbed(lathe(rings, 7), 0.15, seed);
    const SurfaceMesh mesh = shape.mesh();
    const Necks necks = findNecks(mesh, girthField(mesh).values).value();
    // Subdivided, it is the same surface, and old vertices keep their numbers.
    const SurfaceMesh fine = test::subdivided(test::subdivided(shape)).mesh();
    const std::vector<double> girth = girthField(fine).values;
    double longest = 0;
    for (const Halfedge h : fine.halfedges()) longest = std::max(longest, fine.length(h));
    test::Random random(seed);
    for (int i = 0; i < 4; ++i) {
      const SurfacePoint a = at(random.below(mesh.vertexCount()));
      const SurfacePoint b = at(random.below(mesh.vertexCount()));
      if (a.element == b.element) continue;
      const Bottleneck found = between(mesh, a, b);
      expectConsistent(mesh, found, a, b);
      // The girth changes by at most twice the distance.
      const double searched = overVertices(fine, girth, a.element, b.element);
      EXPECT_NEAR(found.girth, searched, 2 * longest + 0.01 * searched) << seed;
      if (found.kind == BottleneckKind::Neck) {
        EXPECT_TRUE(std::any_of(necks.necks.begin(), necks.necks.end(), [&](const Neck& neck) {
          return std::fabs(neck.length - found.girth) <= 1e-9 * found.girth;
        }));
      }
    }
  }
}

TEST(Bottleneck, ofOpenSurfaces) {
  constexpr Index kSides = 6;
  const SurfaceMesh hourglass =
      lathe({{0, 2}, {3, 1}, {6, 2}}, kSides, false).mesh(OpenEdges::Boundary);
  const Bottleneck found = between(hourglass, at(0), at(2 * kSides + 3));
  expectConsistent(hourglass, found, at(0), at(2 * kSides + 3));
  EXPECT_EQ(found.kind, BottleneckKind::Neck);
  EXPECT_NEAR(found.girth, polygonLength(1, kSides), 1e-9);
}

TEST(Bottleneck, sameForAnyNumberOfThreads) {
  const SurfaceMesh mesh =
      test::perturbed(lathe({{0, 1}, {1, 2}, {3, 1}, {5, 2}, {6, 1}}, 9), 0.1, 5).mesh();
  const std::vector<double> girth = girthField(mesh).values;
  const Bottleneck one = findBottleneck(mesh, girth, at(9), at(29), {1, nullptr, {}}).value();
  const Bottleneck three = findBottleneck(mesh, girth, at(9), at(29), {3, nullptr, {}}).value();
  EXPECT_EQ(one.girth, three.girth);
  EXPECT_EQ(one.way.size(), three.way.size());
  EXPECT_EQ(one.points.size(), three.points.size());
  EXPECT_EQ(toString(one.kind), toString(three.kind));
}

TEST(Bottleneck, badInput) {
  Shape shape = lathe({{0, 1}, {1, 2}, {3, 1}, {5, 2}, {6, 1}}, 5);
  const Shape other = lathe({{10, 1}, {11, 2}}, 5);
  const Index before = shape.vertexCount();
  for (Index v = 0; v < other.vertexCount(); ++v) {
    shape.add(other.positions[3 * v], other.positions[3 * v + 1], other.positions[3 * v + 2]);
  }
  for (const Index v : other.triangles) shape.triangles.push_back(before + v);
  const SurfaceMesh mesh = shape.mesh();
  const std::vector<double> girth = girthField(mesh).values;
  const auto codeOf = [&](const SurfacePoint& a, const SurfacePoint& b) {
    return findBottleneck(mesh, girth, a, b).error().code;
  };
  EXPECT_EQ(findBottleneck(mesh, std::vector<double>(3), at(0), at(1)).error().code,
            ErrorCode::Usage);
  EXPECT_EQ(codeOf(at(0), at(before)), ErrorCode::InvalidPoint);  // a point of another component
  EXPECT_EQ(codeOf(at(0), at(10'000)), ErrorCode::VertexOutOfRange);
  EXPECT_EQ(codeOf(SurfacePoint::inFace(Face(10'000), {1, 0, 0}), at(0)), ErrorCode::InvalidPoint);
  EXPECT_EQ(codeOf(SurfacePoint::inFace(Face(0), {2, -1, 0}), at(0)), ErrorCode::InvalidPoint);
  EXPECT_EQ(codeOf(at(0), SurfacePoint::inFace(Face(0), {std::nan(""), 0, 1})),
            ErrorCode::InvalidPoint);
  // Where nothing is known, no way leads.
  const std::vector<double> none(mesh.vertexCount(), std::nan(""));
  EXPECT_EQ(findBottleneck(mesh, none, at(5), at(17)).error().code, ErrorCode::InvalidPoint);
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(findBottleneck(mesh, girth, at(5), at(17), {0, &cancel, {}}).error().code,
            ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth
