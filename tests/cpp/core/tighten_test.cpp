// Curves drawn tight: against closed forms, and the conditions that each tight curve satisfies.
#include "girth/tighten.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "girth/geodesic_solver.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth::test {
namespace {

/// Angles of straight curves in points that lie this far apart are known to 1e-7.
constexpr double kApart = 1e-6;

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dotOf(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double normOf(const Vec3& a) { return std::hypot(a.x, a.y, a.z); }
double angleOf(const Vec3& a, const Vec3& b) {
  const Vec3 c{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return std::atan2(normOf(c), dotOf(a, b));
}

bool isIn(const SurfaceMesh& mesh, Face face, const SurfacePoint& point) {
  switch (point.kind) {
    case SurfacePoint::Kind::InFace:
      return point.face() == face;
    case SurfacePoint::Kind::OnEdge: {
      const Halfedge twin = mesh.twin(point.halfedge());
      return SurfaceMesh::faceOf(point.halfedge()) == face ||
             (twin != Halfedge::none && SurfaceMesh::faceOf(twin) == face);
    }
    case SurfacePoint::Kind::AtVertex:
      break;
  }
  const auto corners = mesh.faceVertices(face);
  return std::find(corners.begin(), corners.end(), point.vertex()) != corners.end();
}

/// The angle at a vertex from its first halfedge to a point of one of its faces.
std::optional<double> directionAt(const SurfaceMesh& mesh, Vertex vertex, const SurfacePoint& to) {
  double sum = 0;
  const Halfedge first = mesh.outgoing(vertex);
  for (Halfedge h = first;;) {
    if (isIn(mesh, SurfaceMesh::faceOf(h), to)) {
      const Vec3 v = mesh.position(vertex);
      return sum + angleOf(minus(mesh.position(mesh.to(h)), v), minus(positionOf(mesh, to), v));
    }
    sum += mesh.cornerAngle(h);
    h = mesh.twin(SurfaceMesh::previous(h));
    if (h == Halfedge::none || h == first) return std::nullopt;
  }
}

/// Checks one point of a curve between its neighbours.
void expectStraightAt(const SurfaceMesh& mesh, const SurfacePoint& before,
                      const SurfacePoint& point, const SurfacePoint& after) {
  const Vec3 at = positionOf(mesh, point);
  const Vec3 back = minus(positionOf(mesh, before), at), on = minus(positionOf(mesh, after), at);
  const double size = mesh.meanEdgeLength();
  if (normOf(back) < kApart * size || normOf(on) < kApart * size) return;
  if (point.kind == SurfacePoint::Kind::OnEdge) {
    const Halfedge h = point.halfedge();
    const Vec3 edge = minus(mesh.position(mesh.to(h)), mesh.position(mesh.from(h)));
    const double turn = dotOf(back, edge) / normOf(back) + dotOf(on, edge) / normOf(on);
    EXPECT_NEAR(turn / normOf(edge), 0, 1e-7);
    return;
  }
  ASSERT_EQ(point.kind, SurfacePoint::Kind::AtVertex);
  const auto in = directionAt(mesh, point.vertex(), before);
  const auto out = directionAt(mesh, point.vertex(), after);
  ASSERT_TRUE(in && out);
  const double between = std::fabs(*in - *out);
  EXPECT_GE(between, std::numbers::pi - 1e-7);
  if (!mesh.isBoundary(point.vertex())) {
    EXPECT_GE(mesh.totalAngle(point.vertex()) - between, std::numbers::pi - 1e-7);
  }
}

/// The curve is as long as it says, no longer than before, straight, and stays so when it is drawn
/// tight again.
void expectTight(const SurfaceMesh& mesh, const TightenOptions& options, const TightCurve& curve) {
  EXPECT_NE(curve.promise, TightPromise::Shorter);
  EXPECT_LE(curve.length, curve.lengthBefore * (1 + 1e-12));
  if (curve.kind == TightKind::Point) {
    EXPECT_EQ(curve.length, 0);
    EXPECT_TRUE(curve.points.empty());
    return;
  }
  const std::vector<SurfacePoint>& points = curve.points;
  ASSERT_GE(points.size(), 2u);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += normOf(minus(positionOf(mesh, points[i]), positionOf(mesh, points[i - 1])));
    if (i + 1 < points.size() && !options.fixed) {
      expectStraightAt(mesh, points[i - 1], points[i], points[i + 1]);
    }
  }
  EXPECT_NEAR(length, curve.length, 1e-12 * curve.length);
  if (curve.kind == TightKind::Loop) {
    EXPECT_EQ(normOf(minus(positionOf(mesh, points.front()), positionOf(mesh, points.back()))), 0);
    if (!options.fixed) {
      expectStraightAt(mesh, points[points.size() - 2], points[0], points[1]);
    }
  }
  if (options.fixed) return;
  TightenOptions again;
  again.points = points;
  again.closed = options.closed;
  const TightCurve same = tighten(mesh, again).value();
  EXPECT_EQ(same.kind, curve.kind);
  EXPECT_NEAR(same.length, curve.length, 1e-9 * curve.length);
}

TightCurve tight(const SurfaceMesh& mesh, std::vector<SurfacePoint> points, bool isClosed = false,
                 bool isFixed = false) {
  const TightenOptions options{std::move(points), isClosed, isFixed};
  const auto found = tighten(mesh, options);
  EXPECT_TRUE(found) << found.error().message;
  expectTight(mesh, options, found.value());
  return found.value();
}

std::vector<SurfacePoint> verticesOf(const std::vector<Index>& numbers) {
  std::vector<SurfacePoint> points;
  for (const Index v : numbers) points.push_back(SurfacePoint::atVertex(Vertex(v)));
  return points;
}

SurfacePoint onEdge(const SurfaceMesh& mesh, Index from, Index to, double share) {
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.from(h) == from && mesh.to(h) == to) return SurfacePoint::onHalfedge(h, share);
  }
  ADD_FAILURE() << "no edge";
  return {};
}

/// A prism of sides of length 1 without caps. Vertex (ring, corner) has the number ring × sides +
/// corner; rings lie 1 apart.
Shape prismTube(Index sides, Index rings) {
  const std::vector<double> polygon = regularPolygon(sides, 1);
  Shape shape;
  for (Index i = 0; i <= rings; ++i) {
    for (Index k = 0; k < sides; ++k) shape.add(polygon[2 * k], polygon[2 * k + 1], i);
  }
  const auto at = [&](Index i, Index k) { return i * sides + k % sides; };
  for (Index i = 0; i < rings; ++i) {
    for (Index k = 0; k < sides; ++k) {
      shape.face(at(i, k), at(i, k + 1), at(i + 1, k + 1));
      shape.face(at(i, k), at(i + 1, k + 1), at(i + 1, k));
    }
  }
  return shape;
}

TEST(Tighten, AClosedCurveRoundAPrismIsItsPerimeter) {
  for (const Index sides : {3u, 4u, 7u}) {
    // With caps and without a vertex between them: nothing holds the curve but that all beside it
    // are as long.
    const SurfaceMesh mesh = prism(regularPolygon(sides, 1), 4, 1).mesh();
    Random random(sides);
    std::vector<SurfacePoint> points;
    for (Index k = 0; k < sides; ++k) {
      points.push_back(onEdge(mesh, k, sides + k, 0.1 + 0.8 * random()));
    }
    const TightCurve curve = tight(mesh, points, true);
    EXPECT_EQ(curve.kind, TightKind::Loop);
    EXPECT_EQ(curve.promise, TightPromise::Local);
    EXPECT_GT(curve.lengthBefore, sides + 0.01);
    EXPECT_NEAR(curve.length, sides, 1e-12 * sides);
  }
  for (const Index sides : {3u, 5u, 8u}) {
    const SurfaceMesh mesh = prism(regularPolygon(sides, 1), 6, 6).mesh();
    std::vector<Index> zigzag;
    for (Index k = 0; k < sides; ++k) zigzag.push_back((2 + k % 2) * sides + k);
    const TightCurve curve = tight(mesh, verticesOf(zigzag), true);
    EXPECT_EQ(curve.kind, TightKind::Loop);
    EXPECT_NEAR(curve.length, sides, 1e-12 * sides);
  }
}

TEST(Tighten, AnOpenCurveWindsAsOftenAsBefore) {
  for (const Index sides : {3u, 6u}) {
    const Index rings = 12;
    const SurfaceMesh mesh = prismTube(sides, rings).mesh(OpenEdges::Boundary);
    for (const int winding : {-2, -1, 1, 2, 3}) {
      for (const Index corner : {0u, 1u}) {
        // Round and round on one ring after the other, and then up.
        std::vector<Index> numbers;
        const int steps = winding * static_cast<int>(sides) + static_cast<int>(corner);
        const int sign = steps < 0 ? -1 : 1;
        int place = 0;
        Index ring = 0;
        numbers.push_back(0);
        for (int k = 0; k < std::abs(steps); ++k) {
          place += sign;
          const auto wrapped =
              static_cast<Index>((place + 100 * static_cast<int>(sides)) % static_cast<int>(sides));
          numbers.push_back(ring * sides + wrapped);
        }
        const Index last = numbers.back();
        for (ring = 1; ring <= 10; ++ring) numbers.push_back(ring * sides + last);
        const TightCurve curve = tight(mesh, verticesOf(numbers));
        const double expected = std::hypot(10.0, std::abs(steps));
        EXPECT_NEAR(curve.length, expected, 1e-12 * expected) << sides << " " << winding;
        EXPECT_EQ(curve.promise, TightPromise::Shortest);
        EXPECT_EQ(curve.kind, TightKind::Path);
      }
    }
  }
}

TEST(Tighten, EndsInFacesAndOnEdgesStay) {
  const Index sides = 4;
  const SurfaceMesh mesh = prismTube(sides, 8).mesh(OpenEdges::Boundary);
  // Twice round: from a point of the first edge of a ring to one of a face four rings higher.
  std::vector<SurfacePoint> points{onEdge(mesh, 2 * sides, 2 * sides + 1, 0.25)};
  for (Index k = 1; k <= 8; ++k) {
    points.push_back(SurfacePoint::atVertex(Vertex(2 * sides + k % sides)));
  }
  for (Index i = 3; i <= 6; ++i) {
    points.push_back(SurfacePoint::atVertex(Vertex(i * sides)));
  }
  // The face (6, 0), (6, 1), (7, 1) has the number 2 · (6 · sides).
  const Face face(2 * 6 * sides);
  ASSERT_EQ(mesh.faceVertices(face)[0], Vertex(6 * sides));
  points.push_back(SurfacePoint::inFace(face, {0.3, 0.5, 0.2}));
  const TightCurve curve = tight(mesh, points);
  // Along the perimeter at 0.7 and 4.2 rings up, begun at 0.25.
  const double expected = std::hypot(4.2, 8 + 0.7 - 0.25);
  EXPECT_NEAR(curve.length, expected, 1e-12 * expected);
  ASSERT_EQ(curve.pieces.size(), 1u);
  EXPECT_EQ(curve.points.back().kind, SurfacePoint::Kind::InFace);
  EXPECT_EQ(curve.points.front().kind, SurfacePoint::Kind::OnEdge);
  EXPECT_EQ(curve.promise, TightPromise::Shortest);
}

TEST(Tighten, ClosedCurvesOnSpheresContract) {
  for (const Shape& shape : {icosphere(3), octasphere(3), tetrahedron(), box(1, 2, 3, 2, 3, 4)}) {
    const SurfaceMesh mesh = shape.mesh();
    Random random(5);
    for (int trial = 0; trial < 5; ++trial) {
      std::vector<Index> numbers;
      for (int k = 0; k < 4; ++k) numbers.push_back(random.below(mesh.vertexCount()));
      const TightCurve curve = tight(mesh, verticesOf(numbers), true);
      // Boxes have closed geodesics that run round without a corner.
      if (mesh.vertexCount() == 54) continue;
      EXPECT_EQ(curve.kind, TightKind::Point);
      EXPECT_EQ(curve.promise, TightPromise::Shortest);
    }
  }
}

/// How often a closed curve runs round a torus: round its axis, and round its tube.
std::pair<int, int> windings(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points,
                             double R) {
  double round = 0, across = 0;
  const auto unwrapped = [](double angle) { return std::remainder(angle, 2 * std::numbers::pi); };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3 a = positionOf(mesh, points[i - 1]), b = positionOf(mesh, points[i]);
    round += unwrapped(std::atan2(b.y, b.x) - std::atan2(a.y, a.x));
    across += unwrapped(std::atan2(b.z, std::hypot(b.x, b.y) - R) -
                        std::atan2(a.z, std::hypot(a.x, a.y) - R));
  }
  return {static_cast<int>(std::lround(round / (2 * std::numbers::pi))),
          static_cast<int>(std::lround(across / (2 * std::numbers::pi)))};
}

TEST(Tighten, OnATorusTheClassStays) {
  constexpr Index kAround = 24, kAcross = 12;
  for (const std::uint64_t seed : {0u, 1u, 2u}) {
    const Shape even = torus(2, 0.8, kAround, kAcross);
    const SurfaceMesh mesh = (seed == 0 ? even : perturbed(even, 0.15, seed)).mesh();
    for (const auto& [p, q] : {std::pair{1, 0}, {0, 1}, {1, 1}, {2, 3}, {3, -2}}) {
      // Vertex (section, corner) has the number section × kAcross + corner.
      std::vector<Index> numbers;
      const int steps = 144;
      for (int k = 0; k < steps; ++k) {
        const int i = p * static_cast<int>(kAround) * k / steps;
        const int j = q * static_cast<int>(kAcross) * k / steps;
        const auto wrap = [](int value, int size) {
          return static_cast<Index>((value % size + size) % size);
        };
        numbers.push_back(wrap(i, kAround) * kAcross + wrap(j, kAcross));
      }
      std::vector<SurfacePoint> points = verticesOf(numbers);
      const TightCurve curve = tight(mesh, points, true);
      points.push_back(points.front());
      const auto before = windings(mesh, points, 2), after = windings(mesh, curve.points, 2);
      EXPECT_EQ(std::abs(before.first), std::abs(p));
      EXPECT_EQ(std::abs(before.second), std::abs(q));
      EXPECT_EQ(before, after) << p << " " << q;
      EXPECT_EQ(curve.kind, TightKind::Loop);
      EXPECT_EQ(curve.promise, TightPromise::Local);
    }
  }
}

TEST(Tighten, RandomCurvesAreTight) {
  int paths = 0, shortest = 0, loops = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Shape shape = seed % 4 == 0   ? perturbed(icosphere(2), 0.3, seed)
                        : seed % 4 == 1 ? perturbed(torus(2, 0.8, 20, 10), 0.2, seed)
                        : seed % 4 == 2 ? perturbed(plate(2), 0.1, seed)
                                        : bumpyRod(12, 20, 6);
    const SurfaceMesh mesh = shape.mesh();
    Random random(seed);
    std::vector<SurfacePoint> points;
    for (int k = 0; k < 6; ++k) {
      const Face face(random.below(mesh.faceCount()));
      const double a = random(), b = random() * (1 - a);
      points.push_back(k % 2 == 0 ? SurfacePoint::inFace(face, {a, b, 1 - a - b})
                                  : SurfacePoint::onHalfedge(SurfaceMesh::side(face, 1), a));
    }
    const TightCurve closed = tight(mesh, points, true);
    if (closed.kind == TightKind::Loop) ++loops;
    const TightCurve open = tight(mesh, points);
    GeodesicSolver solver(mesh);
    const double distance = solver.path(points.front(), points.back()).value().length;
    EXPECT_GE(open.length, distance * (1 - 1e-12));
    ++paths;
    if (open.promise == TightPromise::Shortest) {
      ++shortest;
      EXPECT_NEAR(open.length, distance, 1e-11 * distance);
    }
  }
  EXPECT_GT(shortest, 0);
  EXPECT_LT(shortest, paths);
  EXPECT_GT(loops, 0);
}

TEST(Tighten, CurvesOfAnyPointsEnd) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const SurfaceMesh mesh = randomMesh(seed, 0.01).shape.mesh(OpenEdges::Boundary);
    Random random(seed);
    // In vertices, beside them by less than is told apart and by more, along edges, and anywhere.
    const auto point = [&]() -> SurfacePoint {
      const Face face(random.below(mesh.faceCount()));
      const double little = std::pow(10.0, -4 - 10 * random());
      switch (random.below(5)) {
        case 0:
          return SurfacePoint::atVertex(mesh.faceVertices(face)[0]);
        case 1:
          return SurfacePoint::inFace(face, {1 - 2 * little, little, little});
        case 2:
          return SurfacePoint::inFace(face, {little, 0.4, 0.6 - little});
        case 3:
          return SurfacePoint::onHalfedge(SurfaceMesh::side(face, 2), little);
        default:
          break;
      }
      const double a = random(), b = random() * (1 - a);
      return SurfacePoint::inFace(face, {a, b, 1 - a - b});
    };
    std::vector<SurfacePoint> points;
    const Index count = 2 + random.below(8);
    while (points.size() < count) points.push_back(point());
    for (const bool isClosed : {false, true}) {
      const auto found = tighten(mesh, {points, isClosed, false});
      if (!found) {
        EXPECT_EQ(found.error().code, ErrorCode::InvalidPoint) << found.error().message;
        continue;
      }
      const TightCurve& curve = found.value();
      EXPECT_NE(curve.promise, TightPromise::Shorter) << seed;
      EXPECT_LE(curve.length, curve.lengthBefore * (1 + 1e-12) + 1e-14 * mesh.meanEdgeLength())
          << seed;
    }
  }
}

TEST(Tighten, CurvesOnRandomSurfacesAreTight) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const SurfaceMesh mesh = randomMesh(seed, 0.05).shape.mesh(OpenEdges::Boundary);
    Random random(seed + 7);
    std::vector<SurfacePoint> points;
    for (int k = 0; k < 5; ++k) {
      const Face face(random.below(mesh.faceCount()));
      const double a = 0.1 + 0.8 * random(), b = (1 - a) * (0.1 + 0.8 * random());
      points.push_back(k % 3 == 0   ? SurfacePoint::atVertex(mesh.faceVertices(face)[0])
                       : k % 3 == 1 ? SurfacePoint::onHalfedge(SurfaceMesh::side(face, 0), a)
                                    : SurfacePoint::inFace(face, {a, b, 1 - a - b}));
    }
    for (const bool isClosed : {false, true}) {
      SCOPED_TRACE(seed);
      tight(mesh, points, isClosed);
    }
  }
}

TEST(Tighten, PointsThatStayJoinShortestPaths) {
  const SurfaceMesh mesh = icosphere(3).mesh();
  const std::vector<SurfacePoint> points = verticesOf({0, 3, 100, 7});
  GeodesicSolver solver(mesh);
  for (const bool isClosed : {false, true}) {
    const TightCurve curve = tight(mesh, points, isClosed, true);
    ASSERT_EQ(curve.pieces.size(), isClosed ? 4u : 3u);
    EXPECT_EQ(curve.kind, isClosed ? TightKind::Loop : TightKind::Path);
    EXPECT_EQ(curve.promise, TightPromise::Shortest);
    double sum = 0;
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
      const double length = solver.path(points[i], points[(i + 1) % 4]).value().length;
      EXPECT_NEAR(curve.pieces[i].length, length, 1e-12 * length);
      sum += length;
    }
    EXPECT_NEAR(curve.length, sum, 1e-12 * sum);
    EXPECT_NEAR(curve.lengthBefore, sum, 1e-12 * sum);
  }
}

TEST(Tighten, CurvesWithLittleInThem) {
  const SurfaceMesh mesh = torus(2, 0.8, 12, 8).mesh();
  const auto inFace = SurfacePoint::inFace(Face(3), {0.2, 0.3, 0.5});
  for (const bool isClosed : {false, true}) {
    for (const bool isFixed : {false, true}) {
      for (const SurfacePoint& point :
           {inFace, SurfacePoint::atVertex(Vertex(5)), onEdge(mesh, 0, 1, 0.3)}) {
        for (const std::size_t times : {1u, 2u, 5u}) {
          const std::vector<SurfacePoint> points(times, point);
          const TightCurve curve = tight(mesh, points, isClosed, isFixed);
          EXPECT_EQ(curve.kind, TightKind::Point);
          EXPECT_EQ(curve.lengthBefore, 0);
        }
      }
    }
  }
  // There and back; closed, it contracts, and open it ends where it began.
  EXPECT_EQ(tight(mesh, verticesOf({0, 1, 2, 1, 0})).kind, TightKind::Point);
  EXPECT_EQ(tight(mesh, verticesOf({0, 1, 2, 1, 0}), true).kind, TightKind::Point);
  EXPECT_EQ(tight(mesh, verticesOf({0, 2}), true).kind, TightKind::Point);
  // Round, and back to its end, which stays.
  std::vector<Index> round;
  for (Index k = 0; k <= 8; ++k) round.push_back(k % 8);
  const TightCurve loop = tight(mesh, verticesOf(round));
  EXPECT_EQ(loop.kind, TightKind::Path);
  EXPECT_GT(loop.length, 1);
  EXPECT_EQ(loop.points.front().vertex(), Vertex(0));
  EXPECT_EQ(loop.points.back().vertex(), Vertex(0));
  // Twice through itself.
  std::vector<Index> twice = round;
  twice.insert(twice.end(), round.begin() + 1, round.end());
  EXPECT_NEAR(tight(mesh, verticesOf(twice), true).length,
              2 * tight(mesh, verticesOf(round), true).length, 1e-11);
}

TEST(Tighten, BoundariesHoldCurves) {
  // A plate [0, 3]² with the cell in the middle missing.
  Shape shape;
  for (Index i = 0; i < 4; ++i) {
    for (Index k = 0; k < 4; ++k) shape.add(i, k, 0);
  }
  for (Index i = 0; i < 3; ++i) {
    for (Index k = 0; k < 3; ++k) {
      if (i == 1 && k == 1) continue;
      const Index a = 4 * i + k;
      shape.face(a, a + 4, a + 5);
      shape.face(a, a + 5, a + 1);
    }
  }
  const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
  // Round the rim of the plate it is drawn tight round the hole; along the rim of the hole too.
  const TightCurve far = tight(mesh, verticesOf({0, 4, 8, 12, 13, 14, 15, 11, 7, 3, 2, 1}), true);
  EXPECT_NEAR(far.length, 4, 1e-12);
  EXPECT_EQ(far.promise, TightPromise::Shortest);
  EXPECT_NEAR(tight(mesh, verticesOf({5, 9, 10, 6}), true).length, 4, 1e-12);
  // From corner to corner past the hole, on the side where it was.
  const double past = 2 * std::sqrt(5.0);
  const TightCurve left = tight(mesh, verticesOf({0, 4, 8, 12, 13, 14, 15}));
  EXPECT_NEAR(left.length, past, 1e-12 * past);
  EXPECT_EQ(left.promise, TightPromise::Shortest);
  // This curve goes round the hole once more.
  const TightCurve round = tight(mesh, verticesOf({0, 4, 8, 9, 10, 6, 5, 9, 10, 15}));
  EXPECT_NEAR(round.length, past + 4, 1e-12 * past);
  // Points on the rim itself.
  EXPECT_NEAR(tight(mesh, {onEdge(mesh, 0, 4, 0.5), SurfacePoint::atVertex(Vertex(4)),
                           onEdge(mesh, 4, 8, 0.5)})
                  .length,
              1, 1e-12);
}

TEST(Tighten, ErrorsHaveCodes) {
  const SurfaceMesh mesh = together(tetrahedron(), shifted(tetrahedron(), 9, 0, 0)).mesh();
  const auto codeOf = [&](std::vector<SurfacePoint> points) {
    const auto found = tighten(mesh, {std::move(points), false, false});
    EXPECT_FALSE(found);
    return found.error().code;
  };
  EXPECT_EQ(codeOf({}), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(verticesOf({0, 5})), ErrorCode::InvalidPoint);
  EXPECT_EQ(codeOf(verticesOf({0, 50})), ErrorCode::VertexOutOfRange);
  EXPECT_EQ(codeOf({SurfacePoint::inFace(Face(99), {1, 0, 0})}), ErrorCode::InvalidPoint);
  EXPECT_EQ(codeOf({SurfacePoint::inFace(Face(0), {1, 1, 0})}), ErrorCode::InvalidPoint);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOf({SurfacePoint::onHalfedge(Halfedge(0), nan)}), ErrorCode::InvalidPoint);
  const std::atomic<bool> stopped{true};
  for (const bool isClosed : {false, true}) {
    const auto cancelled =
        tighten(mesh, {verticesOf({0, 1, 2}), isClosed, false}, {1, &stopped, {}});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
  }
}

}  // namespace
}  // namespace girth::test
