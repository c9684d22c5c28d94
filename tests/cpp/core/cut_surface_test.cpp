// Cutting: areas add up, Euler characteristics are right, rims lie on the curve, caps close, and
// what cannot be cut is refused.
#include "girth/cut_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "girth/girth_field.h"
#include "girth/necks.h"
#include "lathe.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"
#include "small_handles.h"

namespace girth {
namespace {

using test::lathe;
using test::Ring;
using test::Shape;
using test::volumeOf;

CutSurface cut(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves, bool cap = false) {
  auto result = cutSurface(mesh, curves, {cap});
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().text());
  if (result.ok()) return std::move(result).value();
  return CutSurface{test::tetrahedron().mesh(), {}, {}};
}

int eulerCharacteristic(const SurfaceMesh& mesh) {
  return static_cast<int>(mesh.vertexCount()) - static_cast<int>(mesh.edgeCount()) +
         static_cast<int>(mesh.faceCount());
}

/// Checks rules that must hold for every cut without caps.
void expectConsistent(const SurfaceMesh& mesh, const CutSurface& parts) {
  EXPECT_NEAR(parts.mesh.area(), mesh.area(), 1e-9 * mesh.area());
  // Cutting along closed curves leaves the characteristic as it is, also where they touch
  // boundaries.
  EXPECT_EQ(eulerCharacteristic(parts.mesh), eulerCharacteristic(mesh));
  ASSERT_EQ(parts.points.size(), parts.mesh.vertexCount());
  ASSERT_EQ(parts.faces.size(), parts.mesh.faceCount());
  std::vector<double> areas(mesh.faceCount(), 0);
  for (const Face f : parts.mesh.faces()) {
    ASSERT_NE(parts.faces[f], Face::none);
    areas[parts.faces[f]] += parts.mesh.area(f);
  }
  for (const Face f : mesh.faces()) EXPECT_NEAR(areas[f], mesh.area(f), 1e-9 * mesh.area(f));
  for (const Vertex v : parts.mesh.vertices()) {
    EXPECT_EQ(norm(positionOf(mesh, parts.points[v]) - parts.mesh.position(v)), 0);
  }
}

SurfaceCurve loopAt(const SurfaceMesh& mesh, const SurfacePoint& point) {
  return GirthSolver(mesh).loop(point).value().points;
}

TEST(CutSurface, anHourglassAtItsNeck) {
  const SurfaceMesh mesh = lathe({{0, 2}, {3, 1}, {7, 2.5}}, 6).mesh();
  const Necks necks = findNecks(mesh, girthField(mesh).values).value();
  ASSERT_EQ(necks.necks.size(), 1u);
  const CutSurface parts = cut(mesh, {necks.necks[0].points});
  expectConsistent(mesh, parts);
  // Along edges: nothing new but the copies.
  EXPECT_EQ(parts.mesh.faceCount(), mesh.faceCount());
  EXPECT_EQ(parts.mesh.vertexCount(), mesh.vertexCount() + 6);
  EXPECT_EQ(parts.mesh.componentCount(), 2u);

  const CutSurface bodies = cut(mesh, {necks.necks[0].points}, true);
  EXPECT_EQ(bodies.mesh.componentCount(), 2u);
  for (Index c = 0; c < 2; ++c) EXPECT_EQ(bodies.mesh.boundaryCount(c), 0u);
  EXPECT_NEAR(volumeOf(bodies.mesh), volumeOf(mesh), 1e-9);
  EXPECT_NEAR(bodies.mesh.area(), mesh.area() + 2 * necks.necks[0].area, 1e-9);

  const auto sides = sidesOf(mesh, necks.necks[0].points).value();
  const auto components = componentsOf(bodies.mesh);
  ASSERT_EQ(sides.size(), 2u);
  ASSERT_EQ(components.size(), 2u);
  EXPECT_GT(sides[0].area, sides[1].area);
  EXPECT_NEAR(sides[0].area + sides[1].area, mesh.area(), 1e-9);
  std::vector<double> volumes{volumeOf(components[0].mesh), volumeOf(components[1].mesh)};
  std::sort(volumes.begin(), volumes.end());
  EXPECT_NEAR(sides[0].volume, volumes[1], 1e-9);
  EXPECT_NEAR(sides[1].volume, volumes[0], 1e-9);
  for (const SurfaceComponent& component : components) {
    for (const Vertex v : component.mesh.vertices()) {
      EXPECT_EQ(norm(component.mesh.position(v) - bodies.mesh.position(component.vertices[v])), 0);
    }
    EXPECT_EQ(component.faces.size(), component.mesh.faceCount());
  }
}

TEST(CutSurface, acrossFaces) {
  // A bar whose neck in the middle crosses every face of a ring.
  const SurfaceMesh mesh = lathe({{0, 2}, {3, 1}, {6, 1}, {9, 2}}, 7).mesh();
  const Necks necks = findNecks(mesh, girthField(mesh).values).value();
  ASSERT_EQ(necks.necks.size(), 1u);
  const SurfaceCurve& curve = necks.necks[0].points;
  const CutSurface parts = cut(mesh, {curve});
  expectConsistent(mesh, parts);
  EXPECT_EQ(parts.mesh.componentCount(), 2u);
  // Each crossed face becomes a triangle and a quadrilateral.
  EXPECT_EQ(parts.mesh.faceCount(), mesh.faceCount() + 2 * 14);
  for (const Vertex v : parts.mesh.vertices()) {
    EXPECT_EQ(parts.mesh.isBoundary(v), std::fabs(parts.mesh.position(v).z - 4.5) < 1e-9);
  }
}

TEST(CutSurface, aTorusAlongAMeridianIsATube) {
  const SurfaceMesh mesh = test::torus(4, 1, 9, 8).mesh();
  const SurfaceCurve meridian = loopAt(mesh, SurfacePoint::inFace(Face{5}, {0.2, 0.3, 0.5}));
  const CutSurface parts = cut(mesh, {meridian});
  expectConsistent(mesh, parts);
  EXPECT_EQ(parts.mesh.componentCount(), 1u);
  EXPECT_EQ(parts.mesh.genus(0), 0u);
  EXPECT_EQ(parts.mesh.boundaryCount(0), 2u);
  EXPECT_EQ(sidesOf(mesh, meridian).value().size(), 1u);
  EXPECT_EQ(cut(mesh, {meridian}, true).mesh.boundaryCount(0), 0u);
  // Twice along the same curve is once.
  EXPECT_EQ(cut(mesh, {meridian, meridian}).mesh.faceCount(), parts.mesh.faceCount());
}

TEST(CutSurface, manyLoopsOfUnevenSurfaces) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Shape shape = test::perturbed(
        test::subdivided(lathe({{0, 1}, {2, 2}, {5, 1}, {8, 2}, {9, 1}}, 6)), 0.1, seed);
    const SurfaceMesh mesh = shape.mesh();
    test::Random random(seed);
    for (int k = 0; k < 20; ++k) {
      const auto face = Face(random.below(mesh.faceCount()));
      double a = random(), b = random();
      if (a + b > 1) a = 1 - a, b = 1 - b;
      GirthSolver solver(mesh);
      const GirthLoop loop = solver.loop(SurfacePoint::inFace(face, {a, b, 1 - a - b})).value();
      if (loop.kind != LoopKind::Loop) continue;
      const CutSurface parts = cut(mesh, {loop.points});
      expectConsistent(mesh, parts);
      EXPECT_EQ(parts.mesh.componentCount(), 2u);
    }
  }
}

TEST(CutSurface, pointsNearVerticesAreMovedToThem) {
  const SurfaceMesh mesh = lathe({{0, 1}, {2, 1}, {4, 1}}, 5).mesh();
  SurfaceCurve curve;
  for (Index i = 0; i <= 5; ++i) {
    // Just beside the corners of the middle ring, on the edges that lead up from them.
    const Vertex v(5 + i % 5);
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.from(h) == v && mesh.to(h) == v + 5) {
        curve.push_back(SurfacePoint::onHalfedge(h, 1e-7));
        break;
      }
    }
  }
  ASSERT_EQ(curve.size(), 6u);
  const CutSurface parts = cut(mesh, {curve});
  expectConsistent(mesh, parts);
  EXPECT_EQ(parts.mesh.faceCount(), mesh.faceCount());
  EXPECT_EQ(parts.mesh.componentCount(), 2u);
}

TEST(CutSurface, aLoopThroughOneVertexTwice) {
  const SurfaceMesh mesh = test::torus(4, 1, 9, 8).mesh();
  // Round two faces that have nothing but a vertex in common, in one curve: both come off.
  const Halfedge first = mesh.outgoing(Vertex(20));
  std::vector<Halfedge> around;
  for (Halfedge h = first;;) {
    around.push_back(h);
    h = mesh.twin(SurfaceMesh::previous(h));
    if (h == first) break;
  }
  ASSERT_GE(around.size(), 4u);
  SurfaceCurve eight;
  for (const Halfedge h : {around[0], around[2]}) {
    eight.push_back(SurfacePoint::atVertex(mesh.from(h)));
    eight.push_back(SurfacePoint::atVertex(mesh.to(h)));
    eight.push_back(SurfacePoint::atVertex(mesh.from(SurfaceMesh::previous(h))));
  }
  eight.push_back(eight.front());
  const CutSurface parts = cut(mesh, {eight});
  EXPECT_NEAR(parts.mesh.area(), mesh.area(), 1e-9);
  EXPECT_EQ(parts.mesh.componentCount(), 3u);
  EXPECT_EQ(parts.mesh.faceCount(), mesh.faceCount());
  const auto sides = sidesOf(mesh, eight).value();
  ASSERT_EQ(sides.size(), 3u);
  EXPECT_NEAR(sides[0].area + sides[1].area + sides[2].area, mesh.area(), 1e-9);
  // Round the tube and along it, through one vertex both times: what is left is a disk.
  SurfaceCurve both;
  for (Index i = 0; i < 8; ++i) both.push_back(SurfacePoint::atVertex(Vertex(i)));
  for (Index k = 0; k < 9; ++k) both.push_back(SurfacePoint::atVertex(Vertex(8 * k)));
  both.push_back(both.front());
  const CutSurface disk = cut(mesh, {both});
  EXPECT_NEAR(disk.mesh.area(), mesh.area(), 1e-9);
  EXPECT_EQ(disk.mesh.componentCount(), 1u);
  EXPECT_EQ(disk.mesh.genus(0), 0u);
  EXPECT_EQ(disk.mesh.boundaryCount(0), 1u);
}

TEST(CutSurface, curvesThatTouch) {
  const SurfaceMesh mesh = test::torus(4, 1, 9, 8).mesh();
  const Halfedge first = mesh.outgoing(Vertex(20));
  std::vector<SurfaceCurve> faces;  // round each face at a vertex
  for (Halfedge h = first;;) {
    faces.emplace_back();
    for (const Vertex v : mesh.faceVertices(SurfaceMesh::faceOf(h))) {
      faces.back().push_back(SurfacePoint::atVertex(v));
    }
    faces.back().push_back(faces.back().front());
    h = mesh.twin(SurfaceMesh::previous(h));
    if (h == first) break;
  }
  // In a vertex, along an edge, and both; the same curve twice is once.
  for (const auto& [curves, parts] :
       {std::pair<std::vector<SurfaceCurve>, Index>{{faces[0], faces[2]}, 3},
        {{faces[0], faces[1]}, 3},
        {{faces[0], faces[1], faces[3]}, 4},
        {{faces[0], faces[0]}, 2}}) {
    const CutSurface pieces = cut(mesh, curves);
    EXPECT_EQ(pieces.mesh.componentCount(), parts);
    EXPECT_EQ(pieces.mesh.faceCount(), mesh.faceCount());
    EXPECT_NEAR(pieces.mesh.area(), mesh.area(), 1e-9);
  }
  // A loop round the tube and a face beside it: what is left is a tube without the face.
  SurfaceCurve meridian;
  for (Index i = 0; i < 8; ++i) meridian.push_back(SurfacePoint::atVertex(Vertex(i)));
  meridian.push_back(meridian.front());
  const Face beside = SurfaceMesh::faceOf(mesh.outgoing(Vertex(0)));
  SurfaceCurve face;
  for (const Vertex v : mesh.faceVertices(beside)) face.push_back(SurfacePoint::atVertex(v));
  face.push_back(face.front());
  const CutSurface tube = cut(mesh, {meridian, face});
  EXPECT_EQ(tube.mesh.componentCount(), 2u);
  EXPECT_NEAR(tube.mesh.area(), mesh.area(), 1e-9);
}

TEST(CutSurface, curvesThatCrossAtVertices) {
  // Two equators of an octahedron meet at two of its corners: four quarters.
  const SurfaceMesh mesh = test::octasphere(0).mesh();
  ASSERT_EQ(mesh.faceCount(), 8u);
  const auto through = [](const std::array<Index, 4>& corners) {
    SurfaceCurve curve;
    for (const Index v : corners) curve.push_back(SurfacePoint::atVertex(Vertex(v)));
    curve.push_back(curve.front());
    return curve;
  };
  const std::vector<SurfaceCurve> equators{through({0, 1, 3, 4}), through({0, 2, 3, 5})};
  const CutSurface quarters = cut(mesh, equators);
  EXPECT_EQ(quarters.mesh.componentCount(), 4u);
  EXPECT_EQ(quarters.mesh.vertexCount(), 16u);
  EXPECT_NEAR(quarters.mesh.area(), mesh.area(), 1e-12);
  for (Index c = 0; c < 4; ++c) EXPECT_EQ(quarters.mesh.boundaryCount(c), 1u);
  const auto capped = cutSurface(mesh, equators, {true});
  ASSERT_TRUE(capped.ok());
  EXPECT_EQ(capped.value().mesh.componentCount(), 4u);
  for (Index c = 0; c < 4; ++c) EXPECT_EQ(capped.value().mesh.boundaryCount(c), 0u);
}

/// A dumbbell of revolution, and within it a smaller one, turned inside out: its cavity.
Shape hollowDumbbell(Index sides) {
  const auto dumbbell = [](double wall) {
    std::vector<test::Ring> rings;
    for (int k = 0; k <= 40; ++k) {
      const double z = (10 - wall) * (k - 20) / 20.0;
      rings.push_back({z, (3 + 2 * std::cos(M_PI * std::fabs(z) / 10 + M_PI)) - wall / 2});
    }
    return rings;
  };
  Shape shape = test::lathe(dumbbell(0), sides);
  const Shape cavity = test::lathe(dumbbell(1), sides + 2);
  const auto before = static_cast<Index>(shape.positions.size() / 3);
  shape.positions.insert(shape.positions.end(), cavity.positions.begin(), cavity.positions.end());
  for (std::size_t i = 0; i < cavity.triangles.size(); i += 3) {
    shape.face(before + cavity.triangles[i], before + cavity.triangles[i + 2],
               before + cavity.triangles[i + 1]);
  }
  return shape;
}

TEST(CutSurface, aHollowBodyIsCutWithItsCavity) {
  const SurfaceMesh mesh = test::moved(hollowDumbbell(12), 0.3, 1.1, 2).mesh();
  ASSERT_EQ(mesh.componentCount(), 2u);
  const auto necks = findNecks(mesh, girthField(mesh).values);
  ASSERT_EQ(necks.value().necks.size(), 2u);
  const std::vector<SurfaceCurve> both{necks.value().necks[0].points,
                                       necks.value().necks[1].points};
  // Either curve alone, and both, cut the same: a ring between two polygons on both sides.
  const double ring =
      0.09 * (12 * std::sin(2 * M_PI / 12) / 2 - 0.25 * 14 * std::sin(2 * M_PI / 14) / 2);
  for (const std::size_t first : {0u, 1u}) {
    for (const std::size_t count : {1u, 2u}) {
      const auto curves = std::span(both).subspan(first, std::min(count, 2 - first));
      const CutSurface cut = cutSurface(mesh, curves, {true}).value();
      ASSERT_EQ(cut.mesh.componentCount(), 2u);
      const auto parts = componentsOf(cut.mesh);
      for (const SurfaceComponent& part : parts) {
        EXPECT_EQ(part.mesh.boundaryCount(0), 0u);
        EXPECT_EQ(part.mesh.genus(0), 0u);
        EXPECT_NEAR(part.mesh.area(), mesh.area() / 2 + ring, 1e-6);
        EXPECT_NEAR(test::volumeOf(part.mesh), test::volumeOf(mesh) / 2, 1e-6);
      }
    }
  }
  EXPECT_EQ(cutSurface(mesh, both, {true, false}).value().mesh.componentCount(), 4u);
}

TEST(CutSurface, aCavityBesideTheCutIsThatOfThePartRoundIt) {
  const SurfaceMesh hourglass = lathe({{0, 2}, {3, 1}, {7, 2.5}}, 6).mesh();
  const double whole = test::volumeOf(hourglass);
  // Bubbles in the upper half, one with a body within it.
  Shape shape = lathe({{0, 2}, {3, 1}, {7, 2.5}}, 6);
  const auto addBall = [&](double radius, const Vec3& at, bool isCavity) {
    const Shape ball = test::octasphere(1);
    const Index before = shape.vertexCount();
    for (Index v = 0; v < ball.vertexCount(); ++v) {
      const double* p = &ball.positions[3 * v];
      shape.add(radius * p[0] + at.x, radius * p[1] + at.y, radius * p[2] + at.z);
    }
    for (std::size_t i = 0; i < ball.triangles.size(); i += 3) {
      const Index* f = &ball.triangles[i];
      shape.face(before + f[0], before + f[isCavity ? 2 : 1], before + f[isCavity ? 1 : 2]);
    }
  };
  addBall(0.5, {0.6, 0, 6}, true);
  addBall(0.5, {-0.6, 0, 6}, true);
  addBall(0.3, {-0.6, 0, 6}, false);
  const double ball = test::volumeOf(test::octasphere(1).mesh());
  const SurfaceMesh mesh = shape.mesh();
  const auto necks = findNecks(hourglass, girthField(hourglass).values).value().necks;
  const std::vector<SurfaceCurve> curve{loopAt(mesh, necks[0].points[0])};
  const CutSurface cut = cutSurface(mesh, curve, {true}).value();
  const auto parts = partsOf(cut.mesh);
  ASSERT_EQ(parts.size(), 3u) << "two halves, and the body in the bubble";
  std::vector<double> volumes;
  for (const SurfaceComponent& part : parts) volumes.push_back(test::volumeOf(part.mesh));
  std::sort(volumes.begin(), volumes.end());
  EXPECT_NEAR(volumes[0], 0.027 * ball, 1e-12);
  EXPECT_NEAR(volumes[0] + volumes[1] + volumes[2], whole - 0.223 * ball, 1e-9);
  EXPECT_EQ(componentsOf(cut.mesh).size(), 5u);
}

TEST(CutSurface, aBodyWithinAnotherIsNoCavity) {
  Shape shape = hollowDumbbell(12);
  // The inner one faces outwards now.
  for (std::size_t i = 0; i < shape.triangles.size(); i += 3) {
    if (shape.triangles[i] >= 41u * 12 + 2)
      std::swap(shape.triangles[i + 1], shape.triangles[i + 2]);
  }
  const SurfaceMesh mesh = shape.mesh();
  const auto necks = findNecks(mesh, girthField(mesh).values).value().necks;
  const std::vector<SurfaceCurve> outer{necks.back().points};
  EXPECT_EQ(cutSurface(mesh, outer, {true}).value().mesh.componentCount(), 3u);
}

TEST(CutSurface, isCancelled) {
  const SurfaceMesh mesh = test::torus(4, 1, 9, 8).mesh();
  const SurfaceCurve meridian = loopAt(mesh, SurfacePoint::atVertex(Vertex(3)));
  std::atomic<bool> cancel{true};
  const ExecutionContext context{1, &cancel, {}};
  EXPECT_EQ(cutSurface(mesh, std::span(&meridian, 1), {}, context).error().code,
            ErrorCode::Cancelled);
  cancel = false;
  EXPECT_TRUE(cutSurface(mesh, std::span(&meridian, 1), {}, context).ok());
}

TEST(CutSurface, whatCannotBeCut) {
  const SurfaceMesh mesh = test::torus(4, 1, 9, 8).mesh();
  const auto refused = [&](const SurfaceCurve& curve) {
    const auto result = cutSurface(mesh, std::span(&curve, 1));
    EXPECT_FALSE(result.ok());
    return result.ok() ? ErrorCode::Internal : result.error().code;
  };
  const auto vertex = [](Index v) { return SurfacePoint::atVertex(Vertex(v)); };
  EXPECT_EQ(refused({vertex(0), vertex(9999), vertex(0)}), ErrorCode::InvalidPoint);
  EXPECT_EQ(refused({vertex(0), vertex(30), vertex(0)}), ErrorCode::InvalidPoint);
  EXPECT_EQ(refused({SurfacePoint::inFace(Face{0}, {std::nan(""), 0.5, 0.5}), vertex(0)}),
            ErrorCode::InvalidPoint);
  EXPECT_EQ(refused({SurfacePoint::inFace(Face{0}, {0.2, 0.2, 0.6}),
                     SurfacePoint::inFace(Face{0}, {0.6, 0.2, 0.2}),
                     SurfacePoint::inFace(Face{0}, {0.2, 0.6, 0.2}),
                     SurfacePoint::inFace(Face{0}, {0.2, 0.2, 0.6})}),
            ErrorCode::InvalidOption);
  // Two ways through one face that cross each other.
  const std::vector<SurfaceCurve> crossing{
      {SurfacePoint::onHalfedge(Halfedge{0}, 0.2), SurfacePoint::onHalfedge(Halfedge{1}, 0.8)},
      {SurfacePoint::onHalfedge(Halfedge{0}, 0.8), SurfacePoint::onHalfedge(Halfedge{2}, 0.2)}};
  EXPECT_EQ(cutSurface(mesh, crossing).error().code, ErrorCode::InvalidOption);
  // No curve, or one of a single point, cuts nothing.
  EXPECT_EQ(cut(mesh, {}).mesh.faceCount(), mesh.faceCount());
  EXPECT_EQ(cut(mesh, {{vertex(3), vertex(3)}}).mesh.vertexCount(), mesh.vertexCount());
}

}  // namespace
}  // namespace girth
