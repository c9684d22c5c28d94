// Limbs: prisms of known girth and length, why limbs end, and bad input.
#include "girth/limbs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "analysis/level_rings.h"
#include "analysis/unreached_rest.h"
#include "corpus.h"
#include "fingers.h"
#include "girth/geodesic_solver.h"
#include "girth/girth_field.h"
#include "girth/necks.h"
#include "lathe.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Finger;
using test::Shape;

Limbs limbsOf(const SurfaceMesh& mesh, const std::vector<double>& girth,
              const std::vector<Tip>& tips, const LimbOptions& options = {}) {
  auto limbs = findLimbs(mesh, girth, tips, options);
  EXPECT_TRUE(limbs.ok()) << (limbs.ok() ? "" : limbs.error().message);
  return limbs.ok() ? std::move(limbs).value() : Limbs{};
}

/// Checks rules that must hold for every limb.
void expectConsistent(const SurfaceMesh& mesh, const Limb& limb) {
  GeodesicSolver solver(mesh);
  const std::vector<double> distances = solver.distances(SurfacePoint::atVertex(limb.apex)).value();
  ASSERT_EQ(limb.vertices.size(), limb.distances.size());
  EXPECT_TRUE(std::is_sorted(limb.vertices.begin(), limb.vertices.end()));
  const std::set<Index> inside(limb.vertices.begin(), limb.vertices.end());
  EXPECT_TRUE(inside.contains(limb.apex));
  for (std::size_t i = 0; i < limb.vertices.size(); ++i) {
    EXPECT_EQ(limb.distances[i], distances[limb.vertices[i]]);
  }
  for (const Vertex v : mesh.vertices()) {
    EXPECT_TRUE(!(distances[v] < limb.length) || inside.contains(v));
  }
  GirthSolver loops(mesh);
  double narrowest = std::numeric_limits<double>::infinity();
  const double cap = std::isnan(limb.middle) ? 0 : limb.middle / M_PI;
  for (std::size_t i = 0; i < limb.profile.size(); ++i) {
    const GirthStation& station = limb.profile[i];
    EXPECT_NEAR(station.distance,
                limb.length * static_cast<double>(i + 1) / static_cast<double>(limb.profile.size()),
                1e-12 * limb.length);
    if (std::isnan(station.least)) continue;
    EXPECT_EQ(loops.loop(station.place).value().length, station.least);
    if (cap < limb.length && station.distance < cap) continue;
    narrowest = std::min(narrowest, station.least);
  }
  // Between stations the girth is less by no more than twice the way from the nearer one.
  EXPECT_LE(limb.narrowest, narrowest * (1 + 1e-12));
  EXPECT_GT(limb.narrowest, narrowest - 2 * limb.length / static_cast<double>(limb.profile.size()));
  if (limb.end == LimbEnd::Whole) {
    EXPECT_TRUE(std::isnan(limb.base));
  } else {
    EXPECT_EQ(limb.base, limb.profile.back().least);
  }
}

Vertex vertexAt(const SurfaceMesh& mesh, const Vec3& place) {
  for (const Vertex v : mesh.vertices()) {
    if (norm(mesh.position(v) - place) < 1e-9) return v;
  }
  ADD_FAILURE() << "no vertex there";
  return Vertex(0);
}

Tip tipAt(const SurfaceMesh& mesh, const Vec3& place) {
  Tip tip;
  tip.apex = vertexAt(mesh, place);
  tip.apexDistance = 1;
  return tip;
}

TEST(Limbs, FingersHaveTheirGirthAndEndAtTheirBase) {
  const std::vector<Finger> all{{4, {}},         {5, {0.6}}, {3, {}},          {4.5, {-0.5}},
                                {6, {0.4, 0.4}}, {4, {}},    {5, {-0.4, 0.8}}, {3.5, {0.3}}};
  // Other fingers in each pose, the odd ones bent to the other side.
  for (const std::size_t count : {2u, 3u, 4u, 5u, 6u, 7u, 8u}) {
    std::vector<Finger> fingers;
    for (std::size_t f = 0; f < count; ++f) {
      fingers.push_back(all[(f + 3 * count) % all.size()]);
      if (count % 2 == 0) continue;
      for (double& bend : fingers.back().bends) bend = -bend;
    }
    SCOPED_TRACE(count);
    const Index cells = count == 8 ? 3 : 2;
    const SurfaceMesh mesh = test::fingersOnBox(fingers, cells).mesh();
    const std::vector<double> girth = girthField(mesh).values;
    const auto tips = findTips(mesh, girth);
    ASSERT_TRUE(tips.ok());
    const Limbs limbs = limbsOf(mesh, girth, tips.value().tips);
    ASSERT_EQ(limbs.limbs.size(), count);
    for (const Limb& limb : limbs.limbs) {
      expectConsistent(mesh, limb);
      EXPECT_NEAR(limb.narrowest, 4, 1e-9);
      EXPECT_NEAR(limb.median, 4, 1e-6);
      EXPECT_NEAR(limb.base, 4, 0.05);
      EXPECT_EQ(limb.end, LimbEnd::Spreads);
    }
    GeodesicSolver solver(mesh);
    std::set<Index> found;
    for (std::size_t f = 0; f < count; ++f) {
      // Around each corner of the base the surface has π/2 more than a plane, and behind it rings
      // grow by as much. From the second corner on, and no more than the third, that is at least π.
      const std::vector<Vertex> corners = test::baseCorners(mesh, f);
      ASSERT_EQ(corners.size(), 4u);
      const auto fromCorner = solver.distances(SurfacePoint::atVertex(corners[0])).value();
      const auto limb = std::min_element(
          limbs.limbs.begin(), limbs.limbs.end(), [&](const Limb& one, const Limb& two) {
            return fromCorner[one.apex] - one.length < fromCorner[two.apex] - two.length;
          });
      found.insert(limb->apex);
      const auto distances = solver.distances(SurfacePoint::atVertex(limb->apex)).value();
      std::vector<double> ways;
      for (const Vertex corner : corners) ways.push_back(distances[corner]);
      std::sort(ways.begin(), ways.end());
      EXPECT_GE(limb->length, ways[1] - 0.05);
      EXPECT_LE(limb->length, ways[2] + 0.05);
      if (fingers[f].bends.empty()) {
        // Up to half of the end's width on top of the prism's own length.
        EXPECT_GE(limb->length, fingers[f].length);
        EXPECT_LE(limb->length, fingers[f].length + 0.6);
      }
    }
    EXPECT_EQ(found.size(), count);
  }
}

TEST(Limbs, AStraightFingerIsAsLongAsTheWayToTheCornersOfItsBase) {
  // From the middle of the end over its side and down to a corner, the faces laid flat.
  const double length = 4, way = std::hypot(length + 0.5, 0.5);
  for (const Index cells : {2u, 4u}) {
    const SurfaceMesh mesh = test::fingersOnBox({{length, {}}, {length, {}}}, cells).mesh();
    const Limbs limbs =
        limbsOf(mesh, girthField(mesh).values, {tipAt(mesh, {1.5, 0.5, 1 + length})});
    ASSERT_EQ(limbs.limbs.size(), 1u);
    EXPECT_NEAR(limbs.limbs[0].length, way, 0.01);
  }
}

TEST(Limbs, APyramidHasTheGirthOfItsCone) {
  for (const double angle : {0.5, 1.0}) {
    const Shape shape = test::pyramid(12, angle, 24);
    for (const bool open : {false, true}) {
      Shape one = shape;
      if (open) {
        // Without the base and its middle, the last vertex.
        const Index middle = one.vertexCount() - 1;
        std::vector<Index> kept;
        for (std::size_t i = 0; i < one.triangles.size(); i += 3) {
          const Index* face = &one.triangles[i];
          if (std::find(face, face + 3, middle) == face + 3)
            kept.insert(kept.end(), face, face + 3);
        }
        one.triangles = kept;
        one.positions.resize(3 * middle);
      }
      const SurfaceMesh mesh = one.mesh(OpenEdges::Boundary);
      const std::vector<double> girth = girthField(mesh).values;
      std::vector<Tip> tips = findTips(mesh, girth).value().tips;
      std::erase_if(tips, [](const Tip& tip) { return tip.apex != 0; });
      const Limbs limbs = limbsOf(mesh, girth, tips);
      ASSERT_EQ(limbs.limbs.size(), 1u);
      const Limb& limb = limbs.limbs[0];
      expectConsistent(mesh, limb);
      EXPECT_EQ(limb.apex, 0u);
      EXPECT_EQ(limb.end, open ? LimbEnd::Boundary : LimbEnd::Whole);
      EXPECT_EQ(std::isnan(limb.base), !open);
      // All corners of the base are 1 away.
      if (open) {
        EXPECT_NEAR(limb.length, 1, 1e-12);
      } else {
        EXPECT_GT(limb.length, 1);
      }
      for (const GirthStation& station : limb.profile) {
        if (station.distance < 0.1 || station.distance > 0.7) continue;
        EXPECT_NEAR(station.least, 2 * station.distance * std::sin(angle / 2),
                    0.05 * station.least);
        EXPECT_NEAR(station.median, station.least, 0.05 * station.least);
        EXPECT_NEAR(station.ring, station.distance * angle, 0.02 * station.ring);
      }
    }
  }
}

/// Two sheets over a rectangle of unit squares but those left out, joined along their rims. Each
/// square is cut into four, and those into triangles round their middles.
template <class IsLeftOut>
Shape sheets(int width, int height, IsLeftOut isLeftOut) {
  constexpr int n = 2;
  const auto isThere = [&](int x, int z) {
    return x >= 0 && z >= 0 && x < n * width && z < n * height && !isLeftOut(x / n, z / n);
  };
  Shape shape;
  std::map<std::array<int, 3>, Index> corners;
  for (const int side : {0, 1}) {
    const auto at = [&](int x, int z) {
      // On the rim not all four squares are there, and both sheets share the vertex.
      const bool inside =
          isThere(x, z) && isThere(x - 1, z) && isThere(x, z - 1) && isThere(x - 1, z - 1);
      const auto [entry, isNew] = corners.try_emplace({x, z, inside ? side : 0}, 0);
      if (isNew) {
        entry->second = shape.add(static_cast<double>(x) / n, 0, static_cast<double>(z) / n);
      }
      return entry->second;
    };
    for (int x = 0; x < n * width; ++x) {
      for (int z = 0; z < n * height; ++z) {
        if (!isThere(x, z)) continue;
        const Index middle = shape.add((x + 0.5) / n, 0, (z + 0.5) / n);
        const std::array<Index, 4> rim{at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1)};
        for (std::size_t i = 0; i < 4; ++i) {
          const Index a = rim[i], b = rim[(i + 1) % 4];
          if (side == 0) {
            shape.face(a, b, middle);
          } else {
            shape.face(b, a, middle);
          }
        }
      }
    }
  }
  return shape;
}

/// A bar of girth 4 along z.
Shape barOf(double length) { return test::box(1, 1, length, 2, 2, static_cast<Index>(2 * length)); }

/// The place where, seen from z = 0, loops slip over the corner of a gap: sheets are 3 wide, with a
/// gap of 1 from 8 on. From the rim over this corner and back on the other sheet is shorter than
/// round both sheets, 6, as soon as the corner is nearer than 3.
const double slipsOverGap = 8 - std::sqrt(9 - 1);

TEST(Limbs, TheHandleOfAForkEndsWhereItSplits) {
  // 3 wide and 8 long, then two prongs of 1 × 6 with a gap of 1.
  const SurfaceMesh fork = sheets(3, 14, [](int x, int z) { return x == 1 && z >= 8; }).mesh();
  const std::vector<double> girth = girthField(fork).values;
  const Limbs limbs = limbsOf(fork, girth, {tipAt(fork, {1.5, 0, 0}), tipAt(fork, {0.5, 0, 14})});
  ASSERT_EQ(limbs.limbs.size(), 2u);
  const bool handleFirst = limbs.limbs[0].tips[0] == 0;
  const Limb &handle = limbs.limbs[handleFirst ? 0 : 1], &prong = limbs.limbs[handleFirst ? 1 : 0];
  expectConsistent(fork, handle);
  expectConsistent(fork, prong);
  EXPECT_EQ(handle.end, LimbEnd::Splits);
  EXPECT_NEAR(handle.narrowest, 6, 1e-9);
  EXPECT_NEAR(handle.median, 6, 0.01);
  EXPECT_NEAR(handle.length, slipsOverGap, 0.5);
  EXPECT_NEAR(prong.narrowest, 2, 1e-9);
  EXPECT_GE(prong.length, std::hypot(6, 0.5) - 1e-9) << "to the corner of the gap";
  EXPECT_LE(prong.length, 7);
}

TEST(Limbs, ANeedleEndsAtItsEye) {
  const SurfaceMesh needle =
      sheets(3, 12, [](int x, int z) { return x == 1 && (z == 8 || z == 9); }).mesh();
  const Limbs limbs = limbsOf(needle, girthField(needle).values, {tipAt(needle, {1.5, 0, 0})});
  ASSERT_EQ(limbs.limbs.size(), 1u);
  expectConsistent(needle, limbs.limbs[0]);
  EXPECT_EQ(limbs.limbs[0].end, LimbEnd::Handle);
  EXPECT_NEAR(limbs.limbs[0].narrowest, 6, 1e-9);
  EXPECT_NEAR(limbs.limbs[0].length, slipsOverGap, 0.5);
}

TEST(Limbs, AProngThatIsNoLongerThanThickIsPassedBy) {
  // One prong of the fork is 1 long; the handle is 6 / π thick.
  const SurfaceMesh fork =
      sheets(3, 14, [](int x, int z) { return (x == 1 && z >= 8) || (x == 0 && z >= 9); }).mesh();
  const Limbs limbs = limbsOf(fork, girthField(fork).values, {tipAt(fork, {1.5, 0, 0})});
  ASSERT_EQ(limbs.limbs.size(), 1u);
  expectConsistent(fork, limbs.limbs[0]);
  EXPECT_EQ(limbs.limbs[0].end, LimbEnd::Whole);
  EXPECT_NEAR(limbs.limbs[0].narrowest, 2, 1e-9);
  EXPECT_GE(limbs.limbs[0].length, 14);
}

TEST(UnreachedRest, IsDividedByAFork) {
  const SurfaceMesh fork = sheets(3, 14, [](int x, int z) { return x == 1 && z >= 8; }).mesh();
  GeodesicSolver solver(fork);
  const Vertex apex = vertexAt(fork, {1.5, 0, 0});
  const auto heights = solver.distances(SurfacePoint::atVertex(apex)).value();
  const UnreachedRest rest = unreachedRest(fork, heights, apex);
  EXPECT_EQ(rest.handle, Vertex::none);
  EXPECT_EQ(rest.boundary, Vertex::none);
  const auto deep = std::find_if(rest.splits.begin(), rest.splits.end(),
                                 [](const RestSplit& split) { return split.depth > 1; });
  ASSERT_NE(deep, rest.splits.end());
  EXPECT_EQ(deep->vertex, vertexAt(fork, {1.5, 0, 8}));
  const double farthest = heights[vertexAt(fork, {0, 0, 14})];
  EXPECT_NEAR(deep->depth, farthest - 8, 1e-9);
  EXPECT_EQ(heights[rest.last], farthest);
  // One prong is the main part's, the other has left it where they part.
  const double one = rest.leaves[vertexAt(fork, {0.5, 0, 14})],
               other = rest.leaves[vertexAt(fork, {2.5, 0, 14})];
  EXPECT_TRUE(std::isinf(std::max(one, other)));
  EXPECT_NEAR(std::min(one, other), 8, 1e-9);
  const double level = 10;
  EXPECT_NEAR(ringLengths(fork, heights, rest.leaves, {&level, 1})[0], 2, 0.1)
      << "the ring before the main part alone";
}

TEST(UnreachedRest, HasAHandleRoundAHole) {
  const SurfaceMesh eye =
      sheets(3, 12, [](int x, int z) { return x == 1 && (z == 8 || z == 9); }).mesh();
  GeodesicSolver solver(eye);
  const Vertex apex = vertexAt(eye, {1.5, 0, 0});
  const auto heights = solver.distances(SurfacePoint::atVertex(apex)).value();
  EXPECT_EQ(unreachedRest(eye, heights, apex).handle, vertexAt(eye, {1.5, 0, 8}));
  // A torus has none in its first half only.
  const SurfaceMesh torus = test::torus(3, 1, 24, 12).mesh();
  GeodesicSolver around(torus);
  const auto distances = around.distances(SurfacePoint::atVertex(Vertex(0))).value();
  const Vertex handle = unreachedRest(torus, distances, Vertex(0)).handle;
  ASSERT_NE(handle, Vertex::none);
  EXPECT_NEAR(2 * distances[handle], girthLoop(torus, Vertex(0)).value().length, 0.5);
}

TEST(Limbs, ABumpEndsNone) {
  Shape bumpy = test::prism(test::regularPolygon(16, 0.25), 12, 48);
  for (Index v = 0; v < bumpy.vertexCount(); ++v) {
    double* p = &bumpy.positions[3 * v];
    const double angle = std::atan2(p[1], p[0]), height = p[2] - 6;
    const double scale = 1 + 0.4 * std::exp(-4 * (angle * angle + height * height));
    p[0] *= scale;
    p[1] *= scale;
  }
  const SurfaceMesh mesh = bumpy.mesh();
  const Limbs limbs = limbsOf(mesh, girthField(mesh).values, {tipAt(mesh, {0, 0, 0})});
  ASSERT_EQ(limbs.limbs.size(), 1u);
  expectConsistent(mesh, limbs.limbs[0]);
  EXPECT_EQ(limbs.limbs[0].end, LimbEnd::Whole);
  EXPECT_NEAR(limbs.limbs[0].narrowest, 4, 1e-6);
  EXPECT_GE(limbs.limbs[0].length, 12);
  EXPECT_EQ(limbs.limbs[0].vertices.size(), mesh.vertexCount());
}

TEST(Limbs, TipsOfOneEndEndOneLimb) {
  const SurfaceMesh mesh = test::fingersOnBox({{4, {}}, {4, {}}}, 3).mesh();
  const std::vector<double> girth = girthField(mesh).values;
  const Tip tips[] = {tipAt(mesh, {1, 0, 5}), tipAt(mesh, {2, 1, 5}), tipAt(mesh, {3, 0, 5})};
  const Limbs limbs = limbsOf(mesh, girth, {tips[0], tips[1], tips[2]});
  ASSERT_EQ(limbs.limbs.size(), 2u);
  std::multiset<std::size_t> counts;
  for (const Limb& limb : limbs.limbs) {
    counts.insert(limb.tips.size());
    EXPECT_EQ(limb.apex, tips[limb.tips[0]].apex);
  }
  EXPECT_EQ(counts, (std::multiset<std::size_t>{1, 2}));
}

TEST(Limbs, ABodyIsNoneBesideItsOnlyArm) {
  // A ball with a finger: the disk that grows from opposite the finger reaches everything.
  constexpr Index kSides = 24;
  std::vector<test::Ring> rings;
  for (int i = 1; i < 14; ++i) {
    const double angle = kPi * i / 15;
    rings.push_back({-3 * std::cos(angle), 3 * std::sin(angle)});
  }
  const double wrist = rings.back().z;
  for (int i = 1; i < 16; ++i) rings.push_back({wrist + 0.5 * i, 0.5});
  rings.push_back({wrist + 7.7, 0.45});
  rings.push_back({wrist + 7.9, 0.2});
  const SurfaceMesh mesh = test::lathe(rings, kSides).mesh();
  const std::vector<double> girth = girthField(mesh).values;
  Tip opposite, finger;
  opposite.apex = Vertex(mesh.vertexCount() - 2);
  finger.apex = Vertex(mesh.vertexCount() - 1);
  const Limbs limbs = limbsOf(mesh, girth, {opposite, finger});
  ASSERT_EQ(limbs.limbs.size(), 1u);
  EXPECT_EQ(limbs.limbs[0].apex, finger.apex);
  EXPECT_NEAR(limbs.limbs[0].narrowest, test::polygonLength(0.5, kSides), 1e-9);
  EXPECT_EQ(limbs.tipsWithoutLimb, std::vector<Index>{0});
}

TEST(Limbs, ASphereHasNoneAndACubeNeither) {
  const SurfaceMesh sphere = test::icosphere(3).mesh();
  Tip tip;
  tip.apex = Vertex(0);
  const Limbs none = limbsOf(sphere, girthField(sphere).values, {tip});
  EXPECT_TRUE(none.limbs.empty());
  EXPECT_EQ(none.tipsWithoutLimb, std::vector<Index>{0});

  const SurfaceMesh cube = test::box(4, 4, 4, 4, 4, 4).mesh();
  const Limbs blunt = limbsOf(cube, girthField(cube).values, {tipAt(cube, {0, 0, 0})});
  EXPECT_TRUE(blunt.limbs.empty());
}

TEST(Limbs, TheNumberOfStationsIsFree) {
  const SurfaceMesh mesh = barOf(8).mesh();
  const std::vector<double> girth = girthField(mesh).values;
  const Tip tip = tipAt(mesh, {0.5, 0.5, 0});
  for (const Index stations : {1u, 7u, 200u}) {
    const Limbs limbs = limbsOf(mesh, girth, {tip}, {stations});
    ASSERT_EQ(limbs.limbs.size(), 1u);
    EXPECT_EQ(limbs.limbs[0].profile.size(), stations);
  }
  for (const Index stations : {0u, 10'001u}) {
    const auto refused = findLimbs(mesh, girth, std::vector{tip}, {stations});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidOption);
  }
}

TEST(Limbs, AreTheSameAtAnyScaleAndOnAnyThreads) {
  const Shape shape = test::fingersOnBox({{4, {0.5}}, {3, {}}}, 2);
  const SurfaceMesh mesh = shape.mesh();
  const std::vector<double> girth = girthField(mesh).values;
  const std::vector<Tip> tips = findTips(mesh, girth).value().tips;
  ASSERT_EQ(tips.size(), 2u);
  ExecutionContext context;
  double last = 0;
  context.onProgress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  context.threads = 2;
  const auto limbs = findLimbs(mesh, girth, tips, {}, context);
  EXPECT_EQ(last, 1);
  context = {};
  context.threads = 1;
  const auto alone = findLimbs(mesh, girth, tips, {}, context);
  const SurfaceMesh large = test::moved(shape, 8, 0, 0).mesh();
  const std::vector<double> largeGirth = girthField(large).values;
  const auto scaled = findLimbs(large, largeGirth, findTips(large, largeGirth).value().tips);
  ASSERT_TRUE(limbs.ok() && alone.ok() && scaled.ok());
  ASSERT_EQ(scaled.value().limbs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Limb &one = limbs.value().limbs[i], &two = alone.value().limbs[i],
               &three = scaled.value().limbs[i];
    EXPECT_EQ(one.length, two.length);
    EXPECT_EQ(one.median, two.median);
    EXPECT_EQ(one.narrowest, two.narrowest);
    EXPECT_EQ(one.vertices, two.vertices);
    EXPECT_NEAR(three.length, 8 * one.length, 1e-9 * three.length);
    EXPECT_NEAR(three.median, 8 * one.median, 1e-9 * three.median);
    EXPECT_EQ(three.end, one.end);
  }
}

TEST(Limbs, OtherComponentsAreLeftAlone) {
  // A second bar beside the first; a limb never leaves its own.
  Shape bars = barOf(8);
  const Index count = bars.vertexCount();
  const Shape other = bars;
  for (Index v = 0; v < count; ++v) {
    const double* p = &other.positions[3 * v];
    bars.add(p[0] + 3, p[1], p[2]);
  }
  for (const Index v : other.triangles) bars.triangles.push_back(v + count);
  const SurfaceMesh mesh = bars.mesh();
  const Limbs limbs = limbsOf(mesh, girthField(mesh).values, {tipAt(mesh, {0.5, 0.5, 0})});
  ASSERT_EQ(limbs.limbs.size(), 1u);
  expectConsistent(mesh, limbs.limbs[0]);
  EXPECT_EQ(limbs.limbs[0].end, LimbEnd::Whole);
  EXPECT_NEAR(limbs.limbs[0].length, 9, 1e-9) << "from the middle of one end to that of the other";
  EXPECT_EQ(limbs.limbs[0].vertices.size(), count);
  EXPECT_NEAR(limbs.limbs[0].narrowest, 4, 1e-9);
}

TEST(Limbs, AnySurfaceHasConsistentOnes) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Shape shapes[] = {test::bentRod(8, 30), test::pyramid(9, 1.5, 9),
                            test::torus(3, 1, 18, 10), test::fingersOnBox({{3, {0.4}}}, 2)};
    for (const Shape& shape : shapes) {
      const SurfaceMesh mesh = test::perturbed(shape, 0.15, seed).mesh();
      const std::vector<double> girth = girthField(mesh).values;
      const std::vector<Tip> tips = findTips(mesh, girth).value().tips;
      const Limbs limbs = limbsOf(mesh, girth, tips, {16});
      std::size_t counted = limbs.tipsWithoutLimb.size();
      double length = std::numeric_limits<double>::infinity();
      for (const Limb& limb : limbs.limbs) {
        expectConsistent(mesh, limb);
        EXPECT_LE(limb.length, length) << "longest first";
        length = limb.length;
        counted += limb.tips.size();
        EXPECT_LT(limb.narrowest, std::numeric_limits<double>::infinity());
        ++found;
      }
      EXPECT_EQ(counted, tips.size());
    }
  }
  EXPECT_GT(found, 12u);
}

TEST(Limbs, WithoutAnyGirthThereAreNone) {
  const SurfaceMesh mesh = barOf(8).mesh();
  const std::vector<double> girth(mesh.vertexCount(), std::nan(""));
  const Limbs limbs = limbsOf(mesh, girth, {tipAt(mesh, {0.5, 0.5, 0})});
  EXPECT_TRUE(limbs.limbs.empty());
  EXPECT_EQ(limbs.tipsWithoutLimb.size(), 1u);
  EXPECT_TRUE(limbsOf(mesh, girth, {}).limbs.empty());
}

TEST(Limbs, WhatIsHandedOverIsChecked) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  const std::vector<double> girth(4, 1);
  EXPECT_FALSE(findLimbs(mesh, std::vector<double>(3), {}).ok());
  Tip tip;
  tip.apex = Vertex(4);
  const auto refused = findLimbs(mesh, girth, std::vector{tip});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::VertexOutOfRange);

  tip.apex = Vertex(0);
  const std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  const auto stopped = findLimbs(mesh, girth, std::vector{tip}, {}, context);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

TEST(Limbs, TheNarrowestPlaceIsANeckHoweverItIsNumbered) {
  // A body, and a limb that tapers to a waist, before a knob.
  std::vector<test::Ring> rings;
  for (int k = 1; k < 14; ++k) {
    const double angle = M_PI * k / 16;
    rings.push_back({-6 * std::cos(angle), 6 * std::sin(angle)});
  }
  for (int k = 0; k <= 12; ++k) rings.push_back({7.0 + k, 2.2 - k / 12.0});
  for (const auto& [z, radius] : {std::pair{19.6, 1.5}, {20.3, 1.8}, {21.7, 1.5}, {22.1, 0.9}}) {
    rings.push_back({z, radius});
  }
  const Shape shape = test::lathe(rings, 12);
  std::vector<double> first;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    std::vector<Index> numbers;
    const double scale = seed % 2 == 0 ? 1 : 0.01;
    const SurfaceMesh mesh = test::moved(test::relabelled(shape, seed, numbers), scale,
                                         0.7 * static_cast<double>(seed), 3)
                                 .mesh();
    const std::vector<double> girth = girthField(mesh).values;
    const Limbs limbs = limbsOf(mesh, girth, findTips(mesh, girth).value().tips);
    ASSERT_EQ(limbs.limbs.size(), 1u);
    const Limb& limb = limbs.limbs[0];
    expectConsistent(mesh, limb);
    EXPECT_NEAR(limb.narrowest, findNecks(mesh, girth).value().necks[0].length,
                1e-9 * limb.narrowest);
    EXPECT_NEAR(limb.narrowest / scale, test::polygonLength(1.2, 12), 0.01);
    std::vector<double> here{limb.narrowest, limb.narrowestDistance, limb.median, limb.length};
    for (const GirthStation& station : limb.profile) {
      if (!std::isnan(station.least)) here.push_back(station.least);
    }
    if (first.empty()) {
      for (const double value : here) first.push_back(value / scale);
    }
    ASSERT_EQ(here.size(), first.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
      EXPECT_NEAR(here[i] / scale, first[i], 1e-9 * first[i]);
    }
  }
}

/// The only limb of a surface, with other numbers, size and place, by the size it had.
Limb limbMoved(const Shape& shape, std::uint64_t seed, Index stations,
               const std::optional<Tip>& tip = std::nullopt) {
  std::vector<Index> numbers;
  const double scale = seed % 2 == 0 ? 1 : 0.013;
  const SurfaceMesh mesh =
      test::moved(test::relabelled(shape, seed, numbers), scale, 0.7 * static_cast<double>(seed), 3)
          .mesh(OpenEdges::Boundary);
  const std::vector<double> girth = girthField(mesh).values;
  std::vector<Tip> tips = findTips(mesh, girth).value().tips;
  if (tip) {
    tips = {*tip};
    tips[0].apex = Vertex(numbers[tip->apex]);
    tips[0].apexDistance *= scale;
  }
  const Limbs limbs = limbsOf(mesh, girth, tips, {stations});
  EXPECT_EQ(limbs.limbs.size(), 1u);
  if (limbs.limbs.empty()) return {};
  Limb limb = limbs.limbs[0];
  expectConsistent(mesh, limb);
  limb.narrowest /= scale;
  limb.narrowestDistance /= scale;
  limb.middle /= scale;
  limb.length /= scale;
  return limb;
}

TEST(Limbs, AConeIsNarrowestWhereItsCapEnds) {
  // At distance t from the apex of a cone of total angle θ < π the loop is 2 t sin(θ / 2) long. A
  // ring is a chord of each face, whose middle is nearest.
  constexpr Index kSides = 7;
  constexpr double kTotal = 1, kFrom = 0.1;
  Tip tip;
  tip.apex = Vertex(0);
  tip.apexDistance = kFrom;
  const double growth = 2 * std::cos(kTotal / kSides / 2) * std::sin(kTotal / 2);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    for (const Index stations : {5u, 64u}) {
      const Limb limb = limbMoved(test::pyramid(kSides, kTotal, 11), seed, stations, tip);
      EXPECT_NEAR(limb.middle, growth * limb.length / 2, 1e-9 * limb.length);
      const double cap = limb.middle / M_PI;
      EXPECT_GT(cap, kFrom);
      EXPECT_NEAR(limb.narrowestDistance, cap, 1e-9 * cap);
      EXPECT_NEAR(limb.narrowest, growth * cap, 1e-9 * growth * cap);
    }
  }
}

/// A tube of height 12 open at z = 0, whose radius changes evenly to that of its hemispherical end.
Shape openTube(double rootRadius, double endRadius, Index sides) {
  constexpr int kRings = 12, kEnd = 6;
  std::vector<test::Ring> rings;
  for (int k = 0; k <= kRings; ++k) {
    rings.push_back({static_cast<double>(k), rootRadius + (endRadius - rootRadius) * k / kRings});
  }
  for (int k = 1; k < kEnd; ++k) {
    const double angle = M_PI / 2 * k / kEnd;
    rings.push_back({kRings + endRadius * std::sin(angle), endRadius * std::cos(angle)});
  }
  rings.push_back({kRings + endRadius, endRadius / 100});
  Shape shape = test::lathe(rings, sides, false);
  const Index last = shape.vertexCount() - sides;
  const Index apex = shape.add(0, 0, kRings + endRadius);
  for (Index i = 0; i < sides; ++i) shape.face(last + i, last + (i + 1) % sides, apex);
  return shape;
}

TEST(Limbs, ANeedleOnTheCapIsNotTheNarrowestPlace) {
  // A finger of radius 1 and length 12, a pointed end of length 2, on it a needle of radius 0.05.
  constexpr Index kSides = 12;
  std::vector<test::Ring> rings;
  for (int k = 0; k <= 12; ++k) rings.push_back({static_cast<double>(k), 1.2 - 0.2 * k / 12});
  rings.push_back({14, 0.05});
  rings.push_back({14.5, 0.05});
  Shape shape = test::lathe(rings, kSides, false);
  const Index last = shape.vertexCount() - kSides, apex = shape.add(0, 0, 14.51);
  for (Index i = 0; i < kSides; ++i) shape.face(last + i, last + (i + 1) % kSides, apex);
  const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
  const std::vector<double> girth = girthField(mesh).values;
  Tip tip;
  tip.apex = Vertex(apex);
  tip.apexDistance = 0.1;
  const Limbs limbs = limbsOf(mesh, girth, {tip});
  ASSERT_EQ(limbs.limbs.size(), 1u);
  const Limb& limb = limbs.limbs[0];
  expectConsistent(mesh, limb);
  EXPECT_GT(limb.middle, test::polygonLength(1, kSides));
  EXPECT_NEAR(limb.narrowestDistance, limb.middle / M_PI, 1e-9);
  EXPECT_GT(limb.narrowest, 10 * test::polygonLength(0.05, kSides));
}

TEST(Limbs, ATubeThatTapersToItsOpenRootIsNarrowestThere) {
  const double expected = test::polygonLength(1.2, 12);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    for (const Index stations : {17u, 64u}) {
      const Limb limb = limbMoved(openTube(1.2, 1.7, 12), seed, stations);
      EXPECT_NEAR(limb.narrowest, expected, 1e-9 * expected);
    }
  }
}

TEST(Limbs, TheNarrowestPlaceWithoutANeckIsTheSameWhereverItLies) {
  const Shape shapes[] = {openTube(2.2, 1.2, 12), openTube(1.7, 1.2, 4),
                          test::perturbed(openTube(1.7, 1.2, 12), 0.1, 3)};
  for (const Shape& shape : shapes) {
    const Limb first = limbMoved(shape, 2, 64);
    for (const std::uint64_t seed : {1u, 3u, 4u}) {
      const Limb limb = limbMoved(shape, seed, 64);
      EXPECT_NEAR(limb.narrowest, first.narrowest, 1e-9 * first.narrowest);
      EXPECT_NEAR(limb.narrowestDistance, first.narrowestDistance, 1e-8 * first.length);
    }
  }
  // On even shapes any number of stations finds it.
  const double expected = limbMoved(shapes[0], 2, 64).narrowest;
  EXPECT_NEAR(limbMoved(shapes[0], 1, 17).narrowest, expected, 1e-9 * expected);
}

TEST(Limbs, AHorseHasFourLegsAndAHead) {
  if (!test::corpusIsThere()) GTEST_SKIP() << "no corpus";
  const SurfaceMesh mesh = test::corpusModel("horse_6000f.off");
  const std::vector<double> girth = girthField(mesh).values;
  const Limbs limbs = limbsOf(mesh, girth, findTips(mesh, girth).value().tips);
  ASSERT_EQ(limbs.limbs.size(), 5u);
  for (const Limb& limb : limbs.limbs) expectConsistent(mesh, limb);
  EXPECT_NEAR(limbs.limbs[0].median, 0.078, 0.003) << "head and neck";
  EXPECT_EQ(limbs.limbs[0].end, LimbEnd::Slips);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(limbs.limbs[i].median, 0.025, 0.004) << "a leg";
    EXPECT_NEAR(limbs.limbs[i].narrowest, 0.019, 0.001);
    EXPECT_NEAR(limbs.limbs[i].length, 0.07, 0.02);
  }
}

TEST(Limbs, AnApexOnABoundaryEndsNone) {
  Shape patch;
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i) patch.add(i, j, 0);
  }
  for (Index j = 0; j < 8; ++j) {
    for (Index i = 0; i < 8; ++i) {
      const Index a = j * 9 + i;
      patch.face(a, a + 1, a + 10);
      patch.face(a, a + 10, a + 9);
    }
  }
  const SurfaceMesh mesh = patch.mesh(OpenEdges::Boundary);
  Tip tip;
  tip.apex = Vertex(0);
  EXPECT_TRUE(limbsOf(mesh, girthField(mesh).values, {tip}).limbs.empty());
}

}  // namespace
}  // namespace girth
