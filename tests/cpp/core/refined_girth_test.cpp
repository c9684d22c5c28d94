#include "girth/refined_girth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

#include "geodesic/unfolding.h"
#include "loop_checks.h"
#include "random_meshes.h"
#include "shapes.h"
#include "solver/refined/face_set.h"
#include "solver/solver_factory.h"

namespace girth::test {
namespace {

using geodesic::Unfolding;

/// A random surface with so many faces that bands are searched.
SurfaceMesh fineMesh(std::uint64_t seed) {
  Shape shape = randomMesh(seed).shape;
  while (shape.triangles.size() / 3 < 2'500) shape = subdivided(shape);
  return perturbed(shape, 0.02, seed).mesh(OpenEdges::Boundary);
}

/// The faces within some rings round an exact loop.
FaceSet bandRound(const Unfolding& unfolding, const GirthLoop& loop, int rings) {
  FaceSet band(unfolding);
  band.add(facesOf(unfolding, loop));
  band.grow(rings);
  return band;
}

TEST(FaceSet, growsByTheFacesAtItsVertices) {
  // The faces within one ring of a face, on a torus with a grid of squares cut in two.
  const SurfaceMesh mesh = torus(3, 1, 12, 12).mesh();
  const Unfolding unfolding(mesh);
  FaceSet band(unfolding);
  band.add(Index{0});
  EXPECT_EQ(band.size(), 1u);
  band.grow(1);
  EXPECT_EQ(band.size(), 13u) << "three vertices of valence 6 have 18 - 6 + 1 faces";
  for (Index k = 0; k < 3; ++k) {
    for (const Index h : unfolding.fan(unfolding.crossing(k).from())) {
      EXPECT_TRUE(band.has(faceOfSide(h)));
    }
  }
  // All faces that share a vertex with face 0 are there, but not the neighbours of all of these.
  std::vector<Index> beside;
  for (Index h = 0; h < 3; ++h) {
    for (const Index out : unfolding.fan(unfolding.crossing(h).from())) {
      beside.push_back(faceOfSide(out));
    }
  }
  EXPECT_TRUE(band.reachesRim(beside));
  EXPECT_FALSE(band.reachesRim(std::vector<Index>{0}));
  band.clear();
  EXPECT_EQ(band.size(), 0u);
  EXPECT_FALSE(band.has(0));
}

TEST(LoopWithin, isTheExactOneWhereAllFacesCount) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const RandomMesh random = randomMesh(seed);
    const SurfaceMesh mesh = random.shape.mesh(OpenEdges::Boundary);
    const auto unfolding = std::make_shared<const Unfolding>(mesh);
    GirthSolver solver = SolverFactory::onUnfolding(unfolding);
    const std::vector<std::uint8_t> all(mesh.faceCount(), 1);
    for (const Vertex v : mesh.vertices()) {
      const auto exact = solver.value(v);
      ASSERT_TRUE(exact);
      const auto within =
          SolverFactory::loopWithin(solver, SurfacePoint::atVertex(v), all.data(), {});
      EXPECT_EQ(within.has_value(), exact.value().kind == LoopKind::Loop) << random.history;
      if (within) {
        EXPECT_EQ(within->length, exact.value().length) << random.history;
      }
      // A search within a band says nothing about the next call.
      EXPECT_EQ(solver.value(v).value().length, exact.value().length) << random.history;
    }
  }
}

TEST(LoopWithin, isAGeodesicLoopOfItsLengthInAnyBand) {
  std::size_t loops = 0, equal = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomMesh random = randomMesh(seed);
    const SurfaceMesh mesh = random.shape.mesh(OpenEdges::Boundary);
    const auto unfolding = std::make_shared<const Unfolding>(mesh);
    GirthSolver solver = SolverFactory::onUnfolding(unfolding);
    for (const Vertex v : mesh.vertices()) {
      const auto exact = solver.loop(v);
      ASSERT_TRUE(exact);
      if (exact.value().kind != LoopKind::Loop) continue;
      const FaceSet band = bandRound(*unfolding, exact.value(), 1);
      const auto within =
          SolverFactory::loopWithin(solver, SurfacePoint::atVertex(v), band.data(), {});
      if (!within) continue;
      ++loops;
      expectGeodesicLoop(mesh, *within);
      equal += std::fabs(within->length - exact.value().length) <= 1e-9 * within->length ? 1 : 0;
    }
  }
  EXPECT_GT(loops, 1'000u);
  EXPECT_GT(static_cast<double>(equal), 0.95 * static_cast<double>(loops));
}

TEST(RefinedGirth, fewFacesAreExactAsAWhole) {
  const SurfaceMesh mesh = perturbed(torus(3, 1, 24, 12), 0.05, 7).mesh();
  const auto refined = refinedGirth(mesh);
  ASSERT_TRUE(refined);
  const GirthField exact = girthField(mesh);
  EXPECT_EQ(refined.value().field.values, exact.values);
  EXPECT_EQ(refined.value().field.kinds, exact.kinds);
  EXPECT_EQ(refined.value().count(GirthState::Proved), mesh.vertexCount());
  EXPECT_EQ(refined.value().coarseFaces, 0u);
  const GirthAudit& audit = refined.value().audit;
  EXPECT_EQ(audit.vertices, 200u);
  EXPECT_EQ(audit.equal, 200u);
  EXPECT_EQ(audit.greatest, 0);
  // Wilson's interval for 200 of 200: the lower end is n / (n + z²).
  EXPECT_NEAR(audit.atLeast, 200 / (200 + 1.959963984540054 * 1.959963984540054), 1e-12);
  EXPECT_EQ(audit.atMost, 1);
}

TEST(RefinedGirth, isExactAtNearlyAllVertices) {
  std::size_t vertices = 0, equal = 0, proved = 0;
  for (const std::uint64_t seed : {2, 4, 6}) {
    const SurfaceMesh mesh = fineMesh(seed);
    RefinedOptions options;
    options.audit = 20;
    const auto refined = refinedGirth(mesh, options);
    ASSERT_TRUE(refined);
    const GirthField exact = girthField(mesh);
    for (const Vertex v : mesh.vertices()) {
      const double value = refined.value().field.values[v];
      const bool isEqual = std::fabs(value - exact.values[v]) <= 1e-9 * exact.values[v];
      ++vertices;
      equal += isEqual ? 1 : 0;
      if (refined.value().states[v] != GirthState::Proved) continue;
      ++proved;
      EXPECT_EQ(value, exact.values[v]) << seed;
      EXPECT_EQ(refined.value().field.kinds[v], exact.kinds[v]) << seed;
    }
  }
  EXPECT_GT(static_cast<double>(equal), 0.99 * static_cast<double>(vertices));
  EXPECT_LT(static_cast<double>(proved), 0.5 * static_cast<double>(vertices))
      << "or it is the exact method";
}

TEST(RefinedGirth, sameBitsForAnyNumberOfThreadsAndAnyScale) {
  const SurfaceMesh mesh = perturbed(torus(3, 1, 60, 24), 0.05, 3).mesh();
  ASSERT_GT(mesh.faceCount(), 2'000u);
  ExecutionContext one, three;
  one.threads = 1;
  three.threads = 3;
  std::vector<double> progress;
  three.onProgress = [&](double fraction) { progress.push_back(fraction); };
  const auto a = refinedGirth(mesh, {}, one), b = refinedGirth(mesh, {}, three);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a.value().field.values, b.value().field.values);
  EXPECT_EQ(a.value().states, b.value().states);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1);
  EXPECT_GT(a.value().coarseFaces, 0u);
  // The audit is of what was found before it: drawing others leaves the rest as it is.
  RefinedOptions others;
  others.seed = 2;
  const auto c = refinedGirth(mesh, others, one);
  ASSERT_TRUE(c);
  std::size_t differ = 0;
  for (const Vertex v : mesh.vertices()) {
    differ += a.value().states[v] != c.value().states[v] ? 1 : 0;
  }
  EXPECT_GT(differ, 0u);
  EXPECT_LE(differ, 400u);
}

TEST(RefinedGirth, aSphereHasNoLoopsAndIsExact) {
  // Everywhere the frontier vanishes at the far side: only the exact method finds that.
  const SurfaceMesh mesh = octasphere(4).mesh();
  ASSERT_GT(mesh.faceCount(), 2'000u);
  RefinedOptions options;
  options.audit = 5;
  const auto refined = refinedGirth(mesh, options);
  ASSERT_TRUE(refined);
  EXPECT_GT(refined.value().coarseFaces, 0u) << "or bands were not tried";
  EXPECT_EQ(refined.value().count(GirthState::Proved), mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(refined.value().field.kinds[v], LoopKind::Antipodal);
    EXPECT_NEAR(refined.value().field.values[v], 2 * kPi, 0.2);
  }
}

TEST(RefinedGirth, badOptionsAndCancelling) {
  const SurfaceMesh mesh = torus(3, 1, 60, 24).mesh();
  RefinedOptions none;
  none.coarseFaces = 3;
  EXPECT_EQ(refinedGirth(mesh, none).error().code, ErrorCode::InvalidOption);
  std::atomic<bool> cancel{true};
  ExecutionContext stopped;
  stopped.cancel = &cancel;
  EXPECT_EQ(refinedGirth(mesh, {}, stopped).error().code, ErrorCode::Cancelled);
  // In mid-run.
  cancel = false;
  stopped.onProgress = [&](double fraction) { cancel = fraction > 0.3; };
  EXPECT_EQ(refinedGirth(mesh, {}, stopped).error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth::test
