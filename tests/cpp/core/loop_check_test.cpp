#include "solver/search/loop_check.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geodesic/unfolding.h"
#include "girth/geodesic_solver.h"
#include "girth/girth_solver.h"
#include "random_meshes.h"
#include "shapes.h"
#include "solver/solver_factory.h"

namespace girth::test {
namespace {

using geodesic::Unfolding;

/// A random surface, and what searches it.
struct Searched {
  explicit Searched(std::uint64_t seed)
      : random(randomMesh(seed)),
        mesh(random.shape.mesh(OpenEdges::Boundary)),
        solver(SolverFactory::onUnfolding(std::make_shared<const Unfolding>(mesh))),
        check(SolverFactory::propagationOf(solver)),
        ways(mesh) {}

  std::optional<bool> stands(const GirthLoop& loop) {
    return check.stands(loop.base, loop.length, loop.midpoint, {});
  }
  /// How far the midpoint of a loop is from its base, by a search that looks everywhere, as a share
  /// of half the loop.
  double shareOfHalf(const GirthLoop& loop) {
    return ways.path(loop.base, loop.midpoint).value().length / (loop.length / 2);
  }
  /// The length of the edge between two vertices.
  std::optional<double> edgeBetween(Vertex a, Vertex b) const {
    for (const Halfedge h : mesh.halfedges()) {
      const bool isForth = mesh.from(h) == a && mesh.to(h) == b;
      const bool isBack = mesh.from(h) == b && mesh.to(h) == a;
      if (isForth || isBack) return mesh.length(h);
    }
    return std::nullopt;
  }
  /// Loops that are the shortest among some of the faces: many of them are no more than geodesic.
  std::vector<GirthLoop> loopsAmongSomeFaces(std::uint64_t seed) {
    Random chance(seed);
    std::vector<std::uint8_t> band(mesh.faceCount());
    for (std::uint8_t& isIn : band) isIn = chance.below(6) == 0 ? 0 : 1;
    std::vector<GirthLoop> loops;
    for (const Vertex v : mesh.vertices()) {
      if (auto loop =
              SolverFactory::loopWithin(solver, SurfacePoint::atVertex(v), band.data(), {})) {
        loops.push_back(*std::move(loop));
      }
    }
    return loops;
  }

  RandomMesh random;
  SurfaceMesh mesh;
  GirthSolver solver;
  LoopCheck check;
  GeodesicSolver ways;
};

/// Shares nearer to one are left to rounding.
constexpr double kNearOne = 1e-8;

TEST(LoopCheck, exactLoopsStand) {
  std::size_t loops = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Searched on(seed);
    for (const Vertex v : on.mesh.vertices()) {
      const auto loop = on.solver.loop(v);
      ASSERT_TRUE(loop);
      if (loop.value().kind != LoopKind::Loop) continue;
      ++loops;
      EXPECT_EQ(on.stands(loop.value()), std::optional(true)) << on.random.history;
      // The next search of the solver is none the worse for it.
      EXPECT_EQ(on.solver.value(v).value().length, loop.value().length) << on.random.history;
    }
  }
  EXPECT_GT(loops, 300u);
}

TEST(LoopCheck, ofOthersThoseStandThatHaveNoShorterWayToTheirMidpoint) {
  std::size_t standing = 0, others = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Searched on(seed);
    for (const GirthLoop& loop : on.loopsAmongSomeFaces(seed)) {
      const double share = on.shareOfHalf(loop);
      if (share < 1 && share > 1 - kNearOne) continue;
      const bool isShortest = share >= 1;
      EXPECT_EQ(on.stands(loop), std::optional(isShortest)) << on.random.history;
      ++(isShortest ? standing : others);
    }
  }
  EXPECT_GT(standing, 150u);
  EXPECT_GT(others, 100u);
}

TEST(LoopCheck, refutesOnlyLoopsThatDoNotStand) {
  std::size_t refuted = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Searched on(seed);
    const std::vector<GirthLoop> loops = on.loopsAmongSomeFaces(seed);
    for (const GirthLoop& loop : loops) {
      if (on.stands(loop) != std::optional(false)) continue;
      for (const GirthLoop& other : loops) {
        const auto away = on.edgeBetween(loop.base.vertex(), other.base.vertex());
        if (!away) continue;
        if (on.check.refutes(*away, other.length, other.midpoint)) {
          ++refuted;
          EXPECT_LT(on.shareOfHalf(other), 1) << on.random.history;
        } else {
          ++left;
        }
      }
      // The check of the loop itself answers as before.
      EXPECT_TRUE(on.check.refutes(0, loop.length, loop.midpoint));
    }
  }
  EXPECT_GT(refuted, 50u);
  EXPECT_GT(left, 50u);
}

TEST(LoopCheck, cancelledOrBeyondTheBudgetItSaysNothing) {
  Searched on(3);
  const std::vector<GirthLoop> loops = on.loopsAmongSomeFaces(3);
  ASSERT_FALSE(loops.empty());
  const GirthLoop& loop = loops.front();
  std::atomic<bool> cancel{true};
  ExecutionContext stopped;
  stopped.cancel = &cancel;
  EXPECT_EQ(on.check.stands(loop.base, loop.length, loop.midpoint, stopped), std::nullopt);
  on.solver.setBudget(1);
  EXPECT_EQ(on.stands(loop), std::nullopt);
}

}  // namespace
}  // namespace girth::test
