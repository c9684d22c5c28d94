#include "solver/refined/known_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "mesh/vector.h"
#include "shapes.h"
#include "solver/refined/verification_queue.h"

namespace girth::test {
namespace {

/// The graph of a surface whose vertices keep their numbers.
BaseGraph graphOf(const SurfaceMesh& mesh) {
  std::vector<Index> numbers(mesh.vertexCount());
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return {mesh, numbers};
}

KnownLoop loopOfLength(double length) {
  KnownLoop loop;
  loop.length = length;
  loop.kind = LoopKind::Loop;
  loop.faces = {0};
  return loop;
}

TEST(KnownLoop, isPulledByWhatItsLengthChanges) {
  // Unrolled, the loop at slant height s of a pyramid is the base of an equal-sided triangle with
  // the total angle θ at the apex: 2 s sin(θ/2).
  constexpr Index kSides = 8, kRings = 6;
  constexpr double kAngle = 2;
  const SurfaceMesh mesh = pyramid(kSides, kAngle, kRings).mesh(OpenEdges::Boundary);
  const Vec3 apex = mesh.position(Vertex(0));
  for (Index ring = 1; ring < 4; ++ring) {
    const Vertex v(1 + ring * kSides);
    const auto loop = girthLoop(mesh, v);
    ASSERT_TRUE(loop);
    ASSERT_EQ(loop.value().kind, LoopKind::Loop);
    const Vec3 up = apex - mesh.position(v);
    ASSERT_NEAR(loop.value().length, 2 * norm(up) * std::sin(kAngle / 2), 1e-12);
    EXPECT_NEAR(dot(pullOf(mesh, loop.value()), up), loop.value().length, 1e-12);
  }
}

TEST(KnownLoop, ofNoPointsHasNoPull) {
  const SurfaceMesh mesh = octasphere(0).mesh();
  KnownLoop none = loopOfLength(9), own = loopOfLength(1);
  none.pull = pullOf(mesh, GirthLoop{});
  EXPECT_TRUE(std::isnan(none.pull.x));
  // A loop without a pull is looked for always.
  EXPECT_FALSE(isNoGain(own, none, {0.1, 0, 0}));
}

TEST(KnownLoop, isLookedForWhereItMayBeShorter) {
  KnownLoop own = loopOfLength(10), beside = loopOfLength(10.05);
  own.pull = {0, 1, 0};
  beside.pull = {1, 0, 0};
  // From the neighbour in the direction of its pull it loses the length of the step: 9.95.
  EXPECT_FALSE(isNoGain(own, beside, {0.1, 0, 0}));
  // In the other one it becomes longer.
  EXPECT_TRUE(isNoGain(own, beside, {-0.1, 0, 0}));
  // One that moves along without a change is the own one.
  beside.pull = own.pull;
  beside.length = 10;
  EXPECT_TRUE(isNoGain(own, beside, {0.1, 0, 0}));
  // With the same difference, but another direction, it is another one.
  beside.pull = {0, -1, 0};
  EXPECT_FALSE(isNoGain(own, beside, {0.1, 0, 0}));
}

TEST(KnownLoop, contradictionsAskFirstWhetherTheShortOneStands) {
  const SurfaceMesh mesh = octasphere(0).mesh();
  const BaseGraph graph = graphOf(mesh);
  const double edge = std::sqrt(2);
  std::vector<KnownLoop> known(mesh.vertexCount(), loopOfLength(5));
  const auto questions = [&] {
    std::vector<Question> all;
    for (Index base = 0; base < known.size(); ++base) {
      all.push_back(questionAt(base, known, graph));
    }
    return all;
  };
  const auto howMany = [&](Question question) {
    const auto all = questions();
    return std::count(all.begin(), all.end(), question);
  };
  EXPECT_EQ(howMany(Question::None), 6);
  known[0] = loopOfLength(5 - 2 * edge * (1 - 1e-6));
  EXPECT_EQ(howMany(Question::None), 6) << "so much may be between neighbours";
  known[0] = loopOfLength(5 - 2 * edge * (1 + 1e-6));
  EXPECT_EQ(questions()[0], Question::DoesItStand);
  EXPECT_EQ(howMany(Question::None), 5);
  // It does: then its four neighbours are to be computed, and the opposite corner is not.
  known[0].stands = true;
  EXPECT_EQ(questions()[0], Question::None);
  EXPECT_EQ(howMany(Question::WhatIsIt), 4);
  // A question is answered by asking; what is proved is asked no more.
  for (KnownLoop& loop : known) loop.isProved = true;
  EXPECT_EQ(howMany(Question::None), 6);
  known.assign(known.size(), loopOfLength(5));
  known[1].isDoubted = true;
  EXPECT_EQ(questions()[1], Question::DoesItStand);
  known[1].stands = true;
  EXPECT_EQ(questions()[1], Question::None);
  known[1] = {};
  EXPECT_EQ(questions()[1], Question::WhatIsIt);
  EXPECT_EQ(howMany(Question::None), 5);
}

TEST(VerificationQueue, areTakenShortOnesFirstAndApart) {
  const SurfaceMesh mesh = torus(3, 1, 20, 20).mesh();
  const BaseGraph graph = graphOf(mesh);
  VerificationQueue queue(mesh.vertexCount());
  Random random(5);
  std::vector<double> lengths(mesh.vertexCount());
  for (Index base = 0; base < lengths.size(); ++base) {
    lengths[base] = random();
    queue.add(base, lengths[base]);
    queue.add(base, lengths[base]);  // once is enough
  }
  std::vector<int> times(lengths.size(), 0);
  std::size_t rounds = 0;
  for (; !queue.empty(); ++rounds) {
    const auto taken = queue.take(16, graph, [](Index base) { return base % 7 != 0; });
    ASSERT_LE(taken.size(), 16u);
    EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end(),
                               [&](Index a, Index b) { return lengths[a] < lengths[b]; }));
    for (const Index base : taken) {
      ++times[base];
      for (const Neighbour& beside : graph.neighbours(base)) {
        EXPECT_EQ(std::count(taken.begin(), taken.end(), beside.base), 0);
        for (const Neighbour& next : graph.neighbours(beside.base)) {
          EXPECT_EQ(std::count(taken.begin(), taken.end(), next.base), next.base == base ? 1 : 0);
        }
      }
    }
  }
  for (Index base = 0; base < times.size(); ++base) {
    EXPECT_EQ(times[base], base % 7 == 0 ? 0 : 1) << base;
  }
  EXPECT_GT(rounds, 20u);
}

TEST(VerificationQueue, whatHasNoLoopComesLast) {
  const SurfaceMesh mesh = torus(3, 1, 20, 20).mesh();
  const BaseGraph graph = graphOf(mesh);
  VerificationQueue queue(mesh.vertexCount());
  queue.add(0, std::nan(""));
  queue.add(210, 5);
  EXPECT_EQ(queue.take(2, graph, [](Index) { return true; }), (std::vector<Index>{210, 0}));
}

}  // namespace
}  // namespace girth::test
