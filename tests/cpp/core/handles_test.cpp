// Handles and tunnels: tori of known lengths, plates with holes, knots, boundaries, components, and
// shortest systems of loops along edges.
#include "girth/handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <queue>

#include "girth/cut_surface.h"
#include "girth/girth_field.h"
#include "lathe.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"
#include "tubes.h"

namespace girth {
namespace {

using test::polygonLength;
using test::Shape;

constexpr HandleOptions kAllVertices{std::numeric_limits<std::size_t>::max()};

Handles handlesOf(const SurfaceMesh& mesh, const HandleOptions& options = {}) {
  auto handles = findHandles(mesh, options);
  EXPECT_TRUE(handles.ok()) << (handles.ok() ? "" : handles.error().message);
  return handles.ok() ? std::move(handles).value() : Handles{};
}

std::vector<double> lengthsOf(const Handles& handles, HandleKind kind) {
  std::vector<double> lengths;
  for (const Handle& handle : handles.handles) {
    if (handle.kind == kind) lengths.push_back(handle.length);
  }
  return lengths;
}

/// Checks rules that must hold for all: as many as the genus promises, in order, as long as they
/// say, and round one side of the surface alone.
void expectConsistent(const SurfaceMesh& mesh, const Handles& found) {
  EXPECT_EQ(found.unresolved, 0u);
  Index genus = 0;
  for (Index c = 0; c < mesh.componentCount(); ++c) genus += mesh.genus(c);
  EXPECT_EQ(found.handles.size(), 2 * genus);
  double last = 0;
  for (const Handle& handle : found.handles) {
    EXPECT_GE(handle.length, last);
    last = handle.length;
    ASSERT_GE(handle.points.size(), 4u);
    EXPECT_EQ(handle.points.front().element, handle.points.back().element);
    double length = 0;
    for (std::size_t i = 0; i + 1 < handle.points.size(); ++i) {
      length += norm(positionOf(mesh, handle.points[i + 1]) - positionOf(mesh, handle.points[i]));
    }
    EXPECT_NEAR(length, handle.length, 1e-9 * length);
    EXPECT_LE(handle.area, length * length / (4 * kPi) * (1 + 1e-9));
    const auto sides = sidesOf(mesh, handle.points);
    if (sides.ok()) {
      EXPECT_EQ(sides.value().size(), 1u);
    }
  }
}

void expectKinds(const SurfaceMesh& mesh, const Handles& found) {
  Index genus = 0;
  for (Index c = 0; c < mesh.componentCount(); ++c) genus += mesh.genus(c);
  EXPECT_EQ(lengthsOf(found, HandleKind::Handle).size(), genus);
  EXPECT_EQ(lengthsOf(found, HandleKind::Tunnel).size(), genus);
}

/// The linking number of two closed polylines, by Gauss's integral over fine pieces.
double linkingNumber(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      const Vec3 r = 0.5 * (a[i] + a[i + 1]) - 0.5 * (b[k] + b[k + 1]);
      sum += dot(r, cross(a[i + 1] - a[i], b[k + 1] - b[k])) / (norm(r) * norm(r) * norm(r));
    }
  }
  return sum / (4 * kPi);
}

/// The lengths of a shortest system of loops along edges of which no sum bounds, by all loops of a
/// vertex, its tree of shortest paths and one edge more (Erickson and Whittlesey 2005). Sums of
/// faces' rims are taken out by elimination over all edges.
std::vector<double> shortestBasisAlongEdges(const SurfaceMesh& mesh) {
  std::vector<std::size_t> edgeOf(mesh.halfedgeCount());
  std::size_t edges = 0;
  for (const Halfedge h : mesh.halfedges()) {
    edgeOf[h] = mesh.twin(h) < h ? edgeOf[mesh.twin(h)] : edges++;
  }
  using Bits = std::vector<bool>;
  std::vector<std::pair<std::size_t, Bits>> rows;
  const auto isNew = [&](Bits bits) {
    for (const auto& [pivot, row] : rows) {
      if (!bits[pivot]) continue;
      for (std::size_t i = 0; i < edges; ++i) bits[i] = bits[i] != row[i];
    }
    const auto one = std::find(bits.begin(), bits.end(), true);
    if (one == bits.end()) return false;
    rows.emplace_back(one - bits.begin(), std::move(bits));
    return true;
  };
  for (const Face f : mesh.faces()) {
    Bits bits(edges, false);
    for (Index k = 0; k < 3; ++k) bits[edgeOf[SurfaceMesh::side(f, k)]] = true;
    isNew(bits);
  }
  struct Loop {
    double length;
    Bits bits;
  };
  std::vector<Loop> loops;
  for (const Vertex base : mesh.vertices()) {
    std::vector<double> distance(mesh.vertexCount(), std::numeric_limits<double>::infinity());
    std::vector<Bits> path(mesh.vertexCount(), Bits(edges, false));
    std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
                        std::greater<>>
        queue;
    distance[base] = 0;
    queue.emplace(0, base);
    while (!queue.empty()) {
      const auto [reached, v] = queue.top();
      queue.pop();
      if (reached > distance[v]) continue;
      for (const Halfedge h : mesh.halfedges()) {
        if (mesh.from(h) != Vertex(v)) continue;
        const Vertex to = mesh.to(h);
        if (!(reached + mesh.length(h) < distance[to])) continue;
        distance[to] = reached + mesh.length(h);
        path[to] = path[v];
        path[to][edgeOf[h]] = true;
        queue.emplace(distance[to], to);
      }
    }
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.twin(h) < h) continue;
      Loop loop{distance[mesh.from(h)] + mesh.length(h) + distance[mesh.to(h)], path[mesh.from(h)]};
      for (std::size_t i = 0; i < edges; ++i) {
        loop.bits[i] = loop.bits[i] != path[mesh.to(h)][i];
      }
      loop.bits[edgeOf[h]] = !loop.bits[edgeOf[h]];
      loops.push_back(std::move(loop));
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
  std::vector<double> lengths;
  for (const Loop& loop : loops) {
    if (lengths.size() == 2 * mesh.genus(0)) break;
    if (isNew(loop.bits)) lengths.push_back(loop.length);
  }
  return lengths;
}

TEST(Handles, ofATorus) {
  // Round the hole the inner equator; round the tube what the girth is where it is least.
  constexpr Index kAround = 12, kAcross = 8;
  for (const auto& [R, r] : {std::pair{3.0, 1.0}, {1.3, 1.0}}) {
    const SurfaceMesh mesh = test::torus(R, r, kAround, kAcross).mesh();
    const Handles found = handlesOf(mesh);
    expectConsistent(mesh, found);
    expectKinds(mesh, found);
    EXPECT_NEAR(lengthsOf(found, HandleKind::Tunnel)[0], polygonLength(R - r, kAround), 1e-9);
    const double handle = lengthsOf(found, HandleKind::Handle)[0];
    EXPECT_LE(handle, polygonLength(r, kAcross) * (1 + 1e-9));
    if (R < 2) continue;
    const std::vector<double> girth = girthField(mesh).values;
    EXPECT_NEAR(handle, *std::min_element(girth.begin(), girth.end()), 1e-9);
  }
}

TEST(Handles, roundBarsAndHolesOfPlates) {
  // Holes of 1 × 1 in plates of thickness 1/2, in bars 1 wide.
  for (const Index holes : {1u, 2u, 3u}) {
    const SurfaceMesh mesh = test::plate(1, holes).mesh();
    const Handles found = handlesOf(mesh, kAllVertices);
    expectConsistent(mesh, found);
    expectKinds(mesh, found);
    for (const double length : lengthsOf(found, HandleKind::Handle)) EXPECT_NEAR(length, 3, 1e-9);
    for (const double length : lengthsOf(found, HandleKind::Tunnel)) EXPECT_NEAR(length, 4, 1e-9);
  }
}

TEST(Handles, fewBasePointsFindAsManyAndNoneShorter) {
  for (const std::uint64_t seed : {1u, 2u}) {
    const SurfaceMesh mesh = test::perturbed(test::plate(2, 2), 0.1, seed).mesh();
    const Handles all = handlesOf(mesh, kAllVertices);
    for (const std::size_t points : {1u, 4u, 32u}) {
      const Handles few = handlesOf(mesh, {points});
      expectConsistent(mesh, few);
      expectKinds(mesh, few);
      for (const HandleKind kind : {HandleKind::Handle, HandleKind::Tunnel}) {
        const auto least = lengthsOf(all, kind), lengths = lengthsOf(few, kind);
        ASSERT_EQ(least.size(), lengths.size());
        for (std::size_t i = 0; i < least.size(); ++i) {
          EXPECT_GE(lengths[i], least[i] * (1 - 1e-9));
          if (points == 32) {
            EXPECT_LE(lengths[i], least[i] * (1 + 1e-9));
          }
        }
      }
    }
  }
}

TEST(Handles, neverLongerThanTheShortestAlongEdges) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Shape shape = seed % 2 == 0 ? test::plate(1, 2) : test::torus(2.5, 1, 8, 6);
    const SurfaceMesh mesh = test::perturbed(shape, 0.15, seed).mesh();
    const Handles found = handlesOf(mesh, kAllVertices);
    expectConsistent(mesh, found);
    expectKinds(mesh, found);
    const std::vector<double> along = shortestBasisAlongEdges(mesh);
    ASSERT_EQ(found.handles.size(), along.size());
    for (std::size_t i = 0; i < along.size(); ++i) {
      EXPECT_LE(found.handles[i].length, along[i] * (1 + 1e-9)) << i;
      EXPECT_GE(found.handles[i].length, 0.5 * along[i]) << i;
    }
  }
}

TEST(Handles, ofAKnottedTube) {
  const SurfaceMesh mesh = test::tube(test::trefoil, 0.4, 60, 6).mesh();
  const Handles found = handlesOf(mesh);
  expectConsistent(mesh, found);
  expectKinds(mesh, found);
  ASSERT_EQ(found.handles.size(), 2u);
  constexpr int kPieces = 2000;
  std::vector<Vec3> core;
  for (int i = 0; i <= kPieces; ++i)
    core.push_back(test::trefoil(static_cast<double>(i) / kPieces));
  for (const Handle& handle : found.handles) {
    std::vector<Vec3> fine;
    for (std::size_t i = 0; i + 1 < handle.points.size(); ++i) {
      const Vec3 a = positionOf(mesh, handle.points[i]), b = positionOf(mesh, handle.points[i + 1]);
      for (int k = 0; k < 10; ++k) fine.push_back(a + (k / 10.0) * (b - a));
    }
    fine.push_back(fine.front());
    // Round the tube once; along it so that it is not linked with it, and bounds outside.
    EXPECT_NEAR(std::fabs(linkingNumber(fine, core)), handle.kind == HandleKind::Handle ? 1 : 0,
                0.02);
  }
  EXPECT_LE(lengthsOf(found, HandleKind::Handle)[0], polygonLength(0.4, 6) * (1 + 1e-9));
  EXPECT_GT(lengthsOf(found, HandleKind::Tunnel)[0], 15);
}

TEST(Handles, doNotDependOnNumbersScaleOrSides) {
  const Shape shape = test::perturbed(test::plate(1, 2), 0.1, 3);
  const Handles found = handlesOf(shape.mesh(), kAllVertices);
  std::vector<Index> number;
  Shape other = test::moved(test::relabelled(shape, 7, number), 3, 0.4, 2);
  for (std::size_t i = 0; i < other.triangles.size(); i += 3) {
    std::swap(other.triangles[i], other.triangles[i + 1]);  // inside out
  }
  const SurfaceMesh mesh = other.mesh();
  const Handles again = handlesOf(mesh, kAllVertices);
  expectConsistent(mesh, again);
  ASSERT_EQ(again.handles.size(), found.handles.size());
  for (std::size_t i = 0; i < found.handles.size(); ++i) {
    EXPECT_NEAR(again.handles[i].length, 3 * found.handles[i].length, 1e-9);
    EXPECT_EQ(again.handles[i].kind, found.handles[i].kind);
    EXPECT_NEAR(again.handles[i].area, 9 * found.handles[i].area, 1e-9);
  }
}

TEST(Handles, boundaryCurvesAreNone) {
  // A torus with two faces missing on its outside, an open tube, and a sphere.
  Shape shape = test::torus(3, 1, 12, 8);
  const Handles whole = handlesOf(shape.mesh());
  shape.triangles.erase(shape.triangles.begin(), shape.triangles.begin() + 3);
  shape.triangles.erase(shape.triangles.begin() + 240, shape.triangles.begin() + 243);
  const SurfaceMesh open = shape.mesh(OpenEdges::Boundary);
  ASSERT_EQ(open.boundaryCount(0), 2u);
  const Handles found = handlesOf(open);
  expectConsistent(open, found);
  expectKinds(open, found);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found.handles[i].kind, whole.handles[i].kind);
    EXPECT_NEAR(found.handles[i].length, whole.handles[i].length, 1e-9);
  }
  const SurfaceMesh tube =
      test::lathe({{0, 1}, {3, 0.5}, {6, 1}}, 6, false).mesh(OpenEdges::Boundary);
  EXPECT_TRUE(handlesOf(tube).handles.empty());
  EXPECT_TRUE(handlesOf(test::octasphere(1).mesh()).handles.empty());
}

TEST(Handles, everyComponentCountsByItself) {
  // A torus within the tube of another, and a sphere within both.
  const Shape outer = test::torus(4, 2, 14, 8), inner = test::torus(4, 1, 14, 8);
  const SurfaceMesh mesh = test::together(test::together(outer, inner), test::octasphere(1)).mesh();
  const Handles found = handlesOf(mesh);
  expectConsistent(mesh, found);
  for (const Index component : {0u, 1u}) {
    const Handles alone = handlesOf((component == 0 ? outer : inner).mesh());
    for (const Handle& expected : alone.handles) {
      const auto one = std::find_if(
          found.handles.begin(), found.handles.end(),
          [&](const Handle& h) { return h.component == component && h.kind == expected.kind; });
      ASSERT_NE(one, found.handles.end());
      EXPECT_NEAR(one->length, expected.length, 1e-9);
    }
  }
}

TEST(Handles, ofASurfaceWithoutAnInsideAreUnknown) {
  // Two disks joined by three bands, each turned by half: its one boundary curve is a trefoil knot,
  // and no cone closes it without crossing the surface.
  Shape shape;
  for (const double z : {0.0, 3.0}) {
    for (Index k = 0; k < 6; ++k) {
      const double angle = M_PI / 3 * (k / 2 * 2 + (k % 2 == 0 ? -0.3 : 0.3));
      shape.add(2 * std::cos(angle), 2 * std::sin(angle), z);
    }
    shape.add(0, 0, z);
  }
  for (Index disk = 0; disk < 2; ++disk) {
    for (Index k = 0; k < 6; ++k) shape.face(7 * disk + 6, 7 * disk + k, 7 * disk + (k + 1) % 6);
  }
  for (Index band = 0; band < 3; ++band) {
    const double angle = M_PI / 3 * (2 * band);
    const Index a = shape.add(2.5 * std::cos(angle), 2.5 * std::sin(angle), 1.5);
    const Index b = shape.add(1.5 * std::cos(angle), 1.5 * std::sin(angle), 1.5);
    const Index p0 = 2 * band, p1 = 2 * band + 1, q0 = 7 + 2 * band, q1 = 7 + 2 * band + 1;
    shape.face(p1, p0, a);
    shape.face(p1, a, b);
    shape.face(b, a, q1);
    shape.face(b, q1, q0);
  }
  const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
  ASSERT_EQ(mesh.genus(0), 1u);
  ASSERT_EQ(mesh.boundaryCount(0), 1u);
  const Handles found = handlesOf(mesh);
  expectConsistent(mesh, found);
  for (const Handle& handle : found.handles) EXPECT_EQ(handle.kind, HandleKind::Unknown);
}

TEST(Handles, theShortestIsFoundWhereverItIs) {
  for (const Index narrow : {3, 36, 77, 90, 121, 160}) {
    const SurfaceMesh mesh = test::wavyRing(narrow, 8).mesh();
    const Handles found = handlesOf(mesh, {2, 4'000'000});
    expectConsistent(mesh, found);
    ASSERT_EQ(found.handles.size(), 2u);
    EXPECT_NEAR(found.handles[0].length, polygonLength(0.8, 8), 1e-9) << narrow;
    EXPECT_EQ(found.handles[0].kind, HandleKind::Handle);
    EXPECT_EQ(found.handles[0].mayBeShorterBy, 0) << narrow;
  }
}

TEST(Handles, whatIsNotProvenHasABound) {
  const SurfaceMesh mesh = test::wavyRing(77, 4).mesh();
  const Handles all = handlesOf(mesh, kAllVertices);
  ASSERT_EQ(all.handles.size(), 2u);
  for (const Handle& handle : all.handles) EXPECT_EQ(handle.mayBeShorterBy, 0);
  double last = std::numeric_limits<double>::infinity();
  for (const std::size_t windows : {0, 100'000, 1'000'000, 10'000'000}) {
    const Handles some = handlesOf(mesh, {2, windows});
    ASSERT_EQ(some.handles.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Handle& handle = some.handles[i];
      EXPECT_LE(handle.length - handle.mayBeShorterBy, all.handles[i].length * (1 + 1e-9));
      EXPECT_GE(handle.length, all.handles[i].length * (1 - 1e-9));
    }
    if (windows == 0) {
      EXPECT_GT(some.handles[0].mayBeShorterBy, 0);
    }
    EXPECT_LE(some.handles[1].mayBeShorterBy, last);
    last = some.handles[1].mayBeShorterBy;
  }
}

TEST(Handles, sameForAnyNumberOfThreads) {
  const SurfaceMesh mesh = test::perturbed(test::plate(2, 2), 0.1, 5).mesh();
  const Handles one = findHandles(mesh, {6}, {1, nullptr, {}}).value();
  const Handles three = findHandles(mesh, {6}, {3, nullptr, {}}).value();
  ASSERT_EQ(one.handles.size(), three.handles.size());
  for (std::size_t i = 0; i < one.handles.size(); ++i) {
    EXPECT_EQ(one.handles[i].length, three.handles[i].length);
    EXPECT_EQ(one.handles[i].mayBeShorterBy, three.handles[i].mayBeShorterBy);
    EXPECT_EQ(one.handles[i].points.size(), three.handles[i].points.size());
  }
}

TEST(Handles, areCancelledAtAnyTime) {
  const SurfaceMesh mesh = test::perturbed(test::plate(2, 2), 0.1, 5).mesh();
  for (const double share : {0.0, 0.2, 0.5, 0.8}) {
    std::atomic<bool> cancel{false};
    ExecutionContext context{2, &cancel, {}};
    context.onProgress = [&](double fraction) {
      if (fraction >= share) cancel = true;
    };
    const auto found = findHandles(mesh, {}, context);
    ASSERT_FALSE(found.ok()) << share;
    EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
  }
}

TEST(Handles, badInput) {
  const SurfaceMesh mesh = test::torus(3, 1, 6, 5).mesh();
  EXPECT_EQ(findHandles(mesh, {0}).error().code, ErrorCode::InvalidOption);
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(findHandles(mesh, {}, {0, &cancel, {}}).error().code, ErrorCode::Cancelled);
  double last = 0;
  ExecutionContext context;
  context.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  EXPECT_TRUE(findHandles(mesh, {}, context).ok());
  EXPECT_EQ(last, 1);
  for (const HandleKind kind : {HandleKind::Handle, HandleKind::Tunnel, HandleKind::Unknown}) {
    EXPECT_FALSE(toString(kind).empty());
  }
}

}  // namespace
}  // namespace girth
