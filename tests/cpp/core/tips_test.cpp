// Tips: shapes whose ends are known, what must hold for every region, and bad input.
#include "girth/tips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "corpus.h"
#include "girth/girth_field.h"
#include "girth/study/surface_changes.h"
#include "girth/study/tip_stability.h"
#include "mesh/angles.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Random;
using test::Shape;

Tips tipsOf(const SurfaceMesh& mesh, const std::vector<double>& values) {
  auto tips = findTips(mesh, values);
  EXPECT_TRUE(tips.ok()) << (tips.ok() ? "" : tips.error().message);
  return tips.ok() ? std::move(tips).value() : Tips{};
}

Tips tipsOf(const SurfaceMesh& mesh) { return tipsOf(mesh, girthField(mesh).values); }

bool isCrossed(const SurfaceMesh& mesh, const std::vector<double>& values, Index h) {
  return std::fabs(values[mesh.from(Halfedge(h))] - values[mesh.to(Halfedge(h))]) >
         2 * mesh.length(Halfedge(h));
}

/// The rim of a region is the contour, neighbours on a line share a face, and every crossed edge
/// belongs to a tip or an arc.
void expectConsistent(const SurfaceMesh& mesh, const std::vector<double>& values,
                      const Tips& tips) {
  std::set<Index> seen;  // one halfedge of each crossed edge that is drawn
  const auto edgeOf = [&](Halfedge h) { return std::min(h, mesh.twin(h)); };
  const auto checkLine = [&](const ContourLine& line) {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Halfedge h = line.points[i].halfedge();
      EXPECT_TRUE(isCrossed(mesh, values, h));
      seen.insert(edgeOf(h));
      if (i == 0 && !line.closed) continue;
      const Halfedge before = (i == 0 ? line.points.back() : line.points[i - 1]).halfedge();
      const auto faces = [&](Halfedge g) {
        return std::set<Index>{SurfaceMesh::faceOf(g), mesh.twin(g) == kNoIndex
                                                           ? kNoIndex - 1 - g
                                                           : SurfaceMesh::faceOf(mesh.twin(g))};
      };
      const auto a = faces(h), b = faces(before);
      EXPECT_TRUE(std::any_of(a.begin(), a.end(), [&](Index f) { return b.contains(f); }));
    }
  };
  double jump = std::numeric_limits<double>::infinity();
  std::vector<std::set<Index>> rims;
  for (const Tip& tip : tips.tips) {
    EXPECT_GT(tip.jump, 0);
    EXPECT_LE(tip.jump, jump) << "ranked";
    jump = tip.jump;
    const std::set<Index> inside(tip.vertices.begin(), tip.vertices.end());
    EXPECT_TRUE(inside.contains(tip.apex));
    EXPECT_GT(tip.area, 0);
    std::size_t points = 0, rim = 0;
    std::set<Index> edges;
    for (const ContourLine& line : tip.contour) {
      checkLine(line);
      points += line.points.size();
      for (const SurfacePoint& point : line.points) edges.insert(edgeOf(point.halfedge()));
    }
    for (const std::set<Index>& other : rims) {
      const auto shared = std::count_if(edges.begin(), edges.end(),
                                        [&](Index edge) { return other.contains(edge); });
      EXPECT_LE(2 * static_cast<std::size_t>(shared), std::max(edges.size(), other.size()));
    }
    rims.push_back(std::move(edges));
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.twin(h) != kNoIndex && mesh.twin(h) < h) continue;
      rim += inside.contains(mesh.from(h)) != inside.contains(mesh.to(h));
    }
    EXPECT_EQ(points, rim);
  }
  for (const OpenArc& arc : tips.arcs) checkLine(arc.line);
  std::size_t crossed = 0;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.twin(h) != kNoIndex && mesh.twin(h) < h) continue;
    crossed += isCrossed(mesh, values, h);
  }
  EXPECT_EQ(seen.size(), crossed);
  EXPECT_EQ(tips.crossedEdges, crossed);
}

TEST(Tips, ASphereHasNone) {
  const SurfaceMesh mesh = test::icosphere(3).mesh();
  const Tips tips = tipsOf(mesh);
  EXPECT_TRUE(tips.tips.empty());
  EXPECT_TRUE(tips.arcs.empty());
  EXPECT_EQ(tips.crossedEdges, 0u);
}

TEST(Tips, APyramidHasOneWhereItsAngleIsBelowPi) {
  // The loop at distance d from the apex is 2 d sin(angle/2) long; at the apex there is none so
  // near.
  for (const double angle : {0.5, 1.0, 2.0}) {
    const SurfaceMesh mesh = test::pyramid(12, angle, 12).mesh();
    const std::vector<double> girth = girthField(mesh).values;
    const Tips tips = tipsOf(mesh, girth);
    expectConsistent(mesh, girth, tips);
    ASSERT_GE(tips.tips.size(), 1u);
    const auto sharp = std::find_if(tips.tips.begin(), tips.tips.end(),
                                    [](const Tip& tip) { return tip.apex == 0; });
    ASSERT_NE(sharp, tips.tips.end());
    EXPECT_EQ(sharp->vertices, std::vector<Vertex>{Vertex(0)});
    ASSERT_EQ(sharp->contour.size(), 1u);
    EXPECT_TRUE(sharp->contour[0].closed);
    EXPECT_EQ(sharp->contour[0].points.size(), 12u);
    // Twelve faces with sides of 1/12: a quarter of each lies inside, its base halfway up.
    const double side = 1.0 / 12, each = angle / 12;
    EXPECT_NEAR(sharp->area, 12 * 0.5 * side * side * std::sin(each) / 4, 1e-12);
    EXPECT_NEAR(sharp->boundaryLength, 12 * side * std::sin(each / 2), 1e-12);
    EXPECT_NEAR(sharp->apexDistance, side / 2, 1e-12);
  }
}

TEST(Tips, EveryCornerBelowPiIsOne) {
  // Two pyramids base to base; a triangle of two sheets, whose corners are cones of 2π/3.
  Shape spindle;
  const Index sides = 12, rings = 6;
  const Shape half = test::pyramid(sides, 1.0, rings);
  const Index shared = 1 + (rings - 1) * sides, bottom = half.vertexCount() - 1;
  std::vector<Index> mirrored;
  for (Index v = 0; v < bottom; ++v) {
    spindle.add(half.positions[3 * v], half.positions[3 * v + 1], half.positions[3 * v + 2]);
  }
  for (Index v = 0; v < bottom; ++v) {
    mirrored.push_back(v >= shared ? v
                                   : spindle.add(half.positions[3 * v], half.positions[3 * v + 1],
                                                 -half.positions[3 * v + 2]));
  }
  for (std::size_t i = 0; i < half.triangles.size(); i += 3) {
    const Index a = half.triangles[i], b = half.triangles[i + 1], c = half.triangles[i + 2];
    if (a == bottom) continue;
    spindle.face(a, b, c);
    spindle.face(mirrored[a], mirrored[c], mirrored[b]);
  }
  Shape sheets;
  const double height = std::sqrt(3.0) / 2;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.5, height}}) sheets.add(x, y, 0);
  // So that the two sheets differ, one of them has its middle as a vertex.
  const Index middle = sheets.add(0.5, height / 3, 0);
  sheets.face(0, 2, 1);
  for (Index i = 0; i < 3; ++i) sheets.face(i, (i + 1) % 3, middle);
  for (int level = 0; level < 4; ++level) sheets = test::subdivided(sheets);

  for (const Shape& shape : {spindle, sheets}) {
    const SurfaceMesh mesh = shape.mesh();
    std::set<Index> sharp, apexes;
    for (const Vertex v : mesh.vertices()) {
      if (mesh.totalAngle(v) < kPi - 1e-9) sharp.insert(v);
    }
    const Tips tips = tipsOf(mesh);
    for (const Tip& tip : tips.tips) apexes.insert(tip.apex);
    EXPECT_EQ(apexes, sharp);
    EXPECT_EQ(tips.tips.size(), sharp.size());
    EXPECT_EQ(sharp.size(), shape.vertexCount() == spindle.vertexCount() ? 2u : 3u);
  }
}

TEST(Tips, ATetrahedronHasNoneAndABoxNeither) {
  // Total angles of π and 3π/2.
  EXPECT_TRUE(tipsOf(test::tetrahedron().mesh()).tips.empty());
  EXPECT_TRUE(tipsOf(test::box(4, 4, 4, 8, 8, 8).mesh()).tips.empty());
}

/// A field that is `high` over the vertices for which `inside` says so, and 0 elsewhere.
template <class Inside>
std::vector<double> steps(const SurfaceMesh& mesh, double high, Inside inside) {
  std::vector<double> values;
  for (const Vertex v : mesh.vertices()) {
    values.push_back(inside(mesh.position(v)) ? high : 0);
  }
  return values;
}

TEST(Tips, NestedContoursGiveNestedTips) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  std::vector<double> values = steps(mesh, 5, [](const Vec3& p) { return p.z > 0.4; });
  for (const Vertex v : mesh.vertices()) {
    if (mesh.position(v).z > 0.8) values[v] = 20;
  }
  const Tips tips = tipsOf(mesh, values);
  expectConsistent(mesh, values, tips);
  ASSERT_EQ(tips.tips.size(), 2u);
  EXPECT_EQ(tips.tips[0].jump, 15);
  EXPECT_EQ(tips.tips[1].jump, 5);
  EXPECT_NEAR(tips.tips[0].area, 2 * kPi * 0.2, 0.15);
  EXPECT_NEAR(tips.tips[1].area, 2 * kPi * 0.6, 0.15);
  EXPECT_GT(mesh.position(Vertex(tips.tips[0].apex)).z, 0.99);
  EXPECT_NEAR(tips.tips[1].apexDistance, std::acos(0.4), 0.1);
}

TEST(Tips, APieceOnTheContourMakesNoSecondTip) {
  // A step from 0 to 20, and a patch halfway up at the step: with the upper side or without, what
  // is cut off is the same tip.
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  std::vector<double> values = steps(mesh, 20, [](const Vec3& p) { return p.z > 0.4; });
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (values[v] > 0 && p.z < 0.55 && p.x > 0 && std::fabs(p.y) < 0.3) values[v] = 10;
  }
  const Tips tips = tipsOf(mesh, values);
  expectConsistent(mesh, values, tips);
  ASSERT_EQ(tips.tips.size(), 1u);
  EXPECT_EQ(tips.tips[0].jump, 20);
  ASSERT_EQ(tips.arcs.size(), 1u) << "the patch's other side";
  EXPECT_EQ(tips.arcs[0].jump, 10);
}

TEST(Tips, ARingAroundAHandleIsCutOffByTwoLines) {
  const SurfaceMesh mesh = test::torus(3, 1, 48, 24).mesh();
  const std::vector<double> values = steps(mesh, 50, [](const Vec3& p) { return p.x > 1; });
  const Tips tips = tipsOf(mesh, values);
  expectConsistent(mesh, values, tips);
  ASSERT_EQ(tips.tips.size(), 1u);
  EXPECT_EQ(tips.tips[0].contour.size(), 2u);
  for (const ContourLine& line : tips.tips[0].contour) EXPECT_TRUE(line.closed);
}

TEST(Tips, ALineThatCutsNothingOffIsAnArc) {
  // A jump that fades: from 10 at the rim of a cut to nothing on both ends.
  const SurfaceMesh mesh = test::box(10, 10, 1, 20, 20, 2).mesh();
  std::vector<double> values;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    const double fade = std::max(0.0, 3 - std::fabs(p.x - 5));
    values.push_back(p.y > 5.1 ? fade * std::max(0.0, 1 - (p.y - 5.1) / 4) : 0);
  }
  const Tips tips = tipsOf(mesh, values);
  expectConsistent(mesh, values, tips);
  EXPECT_TRUE(tips.tips.empty());
  ASSERT_GE(tips.arcs.size(), 1u);
  EXPECT_FALSE(tips.arcs[0].line.closed);
  EXPECT_GT(tips.arcs[0].length, 1);
}

TEST(Tips, ABoundaryEndsALine) {
  Shape patch;
  const Index n = 12;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) patch.add(i, j, 0);
  }
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      patch.face(a, a + 1, a + n + 2);
      patch.face(a, a + n + 2, a + n + 1);
    }
  }
  const SurfaceMesh mesh = patch.mesh(OpenEdges::Boundary);
  for (const bool corner : {false, true}) {
    const std::vector<double> values =
        steps(mesh, 9, [&](const Vec3& p) { return p.x > 8.5 && (!corner || p.y > 8.5); });
    const Tips tips = tipsOf(mesh, values);
    expectConsistent(mesh, values, tips);
    ASSERT_EQ(tips.tips.size(), 1u);
    ASSERT_EQ(tips.tips[0].contour.size(), 1u);
    EXPECT_FALSE(tips.tips[0].contour[0].closed);
    EXPECT_NEAR(tips.tips[0].area, corner ? 3.5 * 3.5 : 3.5 * 12, 0.3);
  }
}

TEST(TipTrials, TheSharpEndOfAPyramidIsFoundAgain) {
  const SurfaceMesh mesh = test::pyramid(16, 1.0, 8).mesh();
  const std::vector<Tip> tips = tipsOf(mesh).tips;
  ASSERT_GE(tips.size(), 1u);
  const auto trials = study::tipTrials(mesh, tips);
  ASSERT_TRUE(trials.ok());
  ASSERT_EQ(trials.value().size(), 4u);
  EXPECT_FALSE(trials.value()[0].noise.has_value());
  EXPECT_EQ(trials.value()[0].tips, tips.size()) << "the same surface";
  EXPECT_EQ(trials.value()[3].noise, 0.25);
  for (const study::TipTrial& trial : trials.value()) {
    EXPECT_FALSE(trial.failed.has_value());
    EXPECT_EQ(trial.foundAgain(), tips.size());
    EXPECT_GE(trial.tips, tips.size());
  }
}

TEST(TipTrials, WhatIsNotFoundAgainIsTold) {
  // A tip that is none: a step that the values alone have.
  const SurfaceMesh mesh = test::icosphere(2).mesh();
  const std::vector<double> values = steps(mesh, 20, [](const Vec3& p) { return p.z > 0.4; });
  const std::vector<Tip> tips = tipsOf(mesh, values).tips;
  ASSERT_EQ(tips.size(), 1u);
  study::TipTrialOptions options;
  options.noise = {0.1};
  const auto trials = study::tipTrials(mesh, tips, options);
  ASSERT_TRUE(trials.ok());
  ASSERT_EQ(trials.value().size(), 2u);
  for (const study::TipTrial& trial : trials.value()) EXPECT_EQ(trial.foundAgain(), 0u);
}

TEST(TipTrials, AreTheSameOnAnyThreadsAndStopWhenTold) {
  const SurfaceMesh mesh = test::pyramid(12, 1.0, 6).mesh();
  const std::vector<Tip> tips = tipsOf(mesh).tips;
  std::vector<std::vector<Index>> counts;
  for (const unsigned threads : {1u, 2u}) {
    ExecutionContext context;
    context.threads = threads;
    double last = 0;
    context.onProgress = [&](double done) {
      EXPECT_GE(done, last);
      last = done;
    };
    const auto trials = study::tipTrials(mesh, tips, {}, context);
    ASSERT_TRUE(trials.ok());
    EXPECT_EQ(last, 1);
    counts.emplace_back();
    for (const study::TipTrial& trial : trials.value()) counts.back().push_back(trial.tips);
  }
  EXPECT_EQ(counts[0], counts[1]);

  const std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  const auto stopped = study::tipTrials(mesh, tips, {}, context);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  for (const double noise : {-0.1, 1.01 * study::kMostNoise, std::nan("")}) {
    study::TipTrialOptions options;
    options.noise = {noise};
    const auto refused = study::tipTrials(mesh, tips, options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidOption);
  }
}

TEST(Tips, AnyValuesGiveConsistentRegions) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const SurfaceMesh mesh = test::perturbed(test::torus(3, 1, 24, 12), 0.2, seed).mesh();
    Random random(seed);
    std::vector<double> values;
    for (Index v = 0; v < mesh.vertexCount(); ++v) values.push_back(1.5 * random());
    expectConsistent(mesh, values, tipsOf(mesh, values));
  }
}

TEST(Tips, ValuesThatWereNotComputedAreNoContour) {
  const SurfaceMesh mesh = test::pyramid(12, 1.0, 12).mesh();
  std::vector<double> values = girthField(mesh).values;
  values[0] = std::nan("");
  for (const Tip& tip : tipsOf(mesh, values).tips) EXPECT_NE(tip.apex, 0u);
  EXPECT_TRUE(tipsOf(mesh, std::vector<double>(mesh.vertexCount(), std::nan(""))).tips.empty());
}

TEST(Tips, TheNumberOfValuesIsChecked) {
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  EXPECT_FALSE(findTips(mesh, std::vector<double>(3)).ok());
}

TEST(Tips, StopsWhenTold) {
  const SurfaceMesh mesh = test::pyramid(12, 1.0, 12).mesh();
  const std::vector<double> values = girthField(mesh).values;
  const std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  const auto tips = findTips(mesh, values, context);
  ASSERT_FALSE(tips.ok());
  EXPECT_EQ(tips.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth
